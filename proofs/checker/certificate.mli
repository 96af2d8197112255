(* Certificates as text: what `cleave cut --certificate` writes. The format is described at the top
   of main.ml. Numbers come as Coq's positives: vertex v of the file is the positive v + 1. *)

type rows = { rows : Verified.positive list list; lines : int array (* where each row starts *) }

type t = {
  line : int;  (* of its first token *)
  dimension : int;
  before : rows;
  cut : rows;
  after : rows;
}

exception Malformed of int * string (* line, what is wrong *)

type source

val of_channel : in_channel -> source

(* The one certificate that a source holds; text after it is malformed. *)
val read_only : source -> t

(* The next certificate of a source that may hold many, or None at its end. *)
val read_next : source -> t option

(* After Malformed: forget what is left of the broken certificate. *)
val skip : source -> unit

val positive_of_int : int -> Verified.positive
val int_of_positive : Verified.positive -> int
val nat_of_int : int -> Verified.nat
