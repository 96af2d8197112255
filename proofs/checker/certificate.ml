open Verified

type rows = { rows : positive list list; lines : int array }
type t = { line : int; dimension : int; before : rows; cut : rows; after : rows }

exception Malformed of int * string

(* Tokens. [line] is the line being read, [words] what is left of it. *)

type source = { channel : in_channel; mutable line : int; mutable words : string list;
                positives : (int, positive) Hashtbl.t }

let of_channel channel = { channel; line = 0; words = []; positives = Hashtbl.create 1024 }

let words_of line =
  if line <> "" && line.[0] = '#' then []
  else
    String.map (function '\t' | '\r' -> ' ' | c -> c) line
    |> String.split_on_char ' '
    |> List.filter (fun word -> word <> "")

(* The next token, which stays to be read; None at the end of the text. *)
let rec peek source =
  match source.words with
  | word :: _ -> Some word
  | [] -> (
      match input_line source.channel with
      | line ->
          source.line <- source.line + 1;
          source.words <- words_of line;
          peek source
      | exception End_of_file -> None)

let drop source = source.words <- List.tl source.words
let fail source what = raise (Malformed (max 1 source.line, what))

let quote word =
  if String.length word <= 40 then "'" ^ String.escaped word ^ "'"
  else "'" ^ String.escaped (String.sub word 0 40) ^ "...'"

let found = function Some word -> quote word | None -> "the end of the text"

let expect source keyword =
  match peek source with
  | Some word when word = keyword -> drop source
  | other -> fail source ("expected '" ^ keyword ^ "', found " ^ found other)

(* Numbers. *)

let largest = 4294967295

let number source what =
  match peek source with
  | Some word when String.for_all (fun c -> '0' <= c && c <= '9') word ->
      let digit value c =
        let value = (10 * value) + Char.code c - Char.code '0' in
        if value <= largest then value
        else fail source ("the number " ^ quote word ^ " is too large")
      in
      let value = Seq.fold_left digit 0 (String.to_seq word) in
      drop source;
      value
  | other -> fail source ("expected " ^ what ^ ", found " ^ found other)

let rec positive_of_int n =
  if n = 1 then XH
  else if n land 1 = 1 then XI (positive_of_int (n lsr 1))
  else XO (positive_of_int (n lsr 1))

let rec int_of_positive = function
  | XH -> 1
  | XO p -> 2 * int_of_positive p
  | XI p -> (2 * int_of_positive p) + 1

let rec nat_of_int n = if n = 0 then O else S (nat_of_int (n - 1))

(* The same number is the same block of memory each time: meshes repeat their vertices. *)
let vertex source =
  let n = number source "a vertex" + 1 in
  match Hashtbl.find_opt source.positives n with
  | Some p -> p
  | None ->
      let p = positive_of_int n in
      Hashtbl.add source.positives n p;
      p

(* Rows. [more k] says whether to read another row after the first k. *)

let row source length = List.init length (fun _ -> vertex source)

let rows source length more =
  let rec go count rows lines =
    if more count then
      let line = ignore (peek source); source.line in
      go (count + 1) (row source length :: rows) (line :: lines)
    else { rows = List.rev rows; lines = Array.of_list (List.rev lines) }
  in
  go 0 [] []

let certificate source =
  expect source "cleave-certificate";
  let line = source.line in
  if number source "the version of the format" <> 1 then fail source "expected version 1";
  expect source "dimension";
  let dimension = number source "the dimension" in
  if dimension < 1 || dimension > 4 then fail source "the dimension must be 1, 2, 3 or 4";
  expect source "cells";
  let cells = number source "the number of cells" in
  expect source "before";
  let before = rows source (dimension + 1) (fun count -> count < cells) in
  expect source "cut";
  let facets = number source "the number of facets" in
  let cut = rows source dimension (fun count -> count < facets) in
  expect source "after";
  let after = rows source (dimension + 1) (fun _ -> peek source <> Some "end") in
  expect source "end";
  { line; dimension; before; cut; after }

let read_next source =
  Hashtbl.reset source.positives;
  if peek source = None then None else Some (certificate source)

let read_only source =
  let only = certificate source in
  match peek source with
  | None -> only
  | Some word -> fail source ("text after 'end': " ^ quote word)

let rec skip source =
  match peek source with
  | None | Some "cleave-certificate" -> ()
  | Some _ -> drop source; skip source
