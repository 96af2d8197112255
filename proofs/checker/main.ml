(* cleave-certify: is `after` what unglue makes of `before` and `cut`?

   The program decides with certify_exec and unglue_exec, which are extracted from Coq and proved
   equal to the specification (proofs/certify_exec.v, proofs/unglue_exec.v). Trusted are: Coq's
   kernel and its extraction to OCaml, OCaml's compiler and runtime, and the glue in this folder,
   which reads numbers and prints verdicts.

   A certificate:

     cleave-certificate 1
     dimension 3
     cells 2
     before
     1 2 3 4
     2 3 4 5
     cut 1
     2 3 4
     after
     1 2 3 4
     6 7 8 5
     end

   Tokens are separated by blanks and newlines; a line that starts with # is a comment. Numbers are
   decimals up to 4294967295. `before` has as many rows as `cells` says, `after` has rows until
   `end`; a row of these has dimension + 1 vertices, a row of the cut has dimension of them.

   cleave-certify FILE            one certificate; - is the standard input. Prints one line:
                                  accepted | rejected: CLAUSE: where, with CLAUSE one of cells,
                                  parent, uncut, connected: the first one that fails in this order.
                                  Exit status: 0 accepted, 1 rejected, 2 usage, 3 malformed, or a
                                  file that cannot be read or written, 4 the checker itself failed,
                                  out of memory say. From 2 on there is a message on stderr and no
                                  verdict on stdout. Death by a signal is no verdict either: where
                                  the runtime or the system cannot go on, they end the program so.
   cleave-certify --unglue FILE   prints unglue(before, cut) as a partition of corners, whatever
                                  `after` says: `classes N`, N the number of cells, then a row for
                                  each cell with the class of each of its corners. A class is named
                                  by its least corner; corner i of cell c is (dimension + 1) c + i.
   --batch                        FILE holds any number of certificates one after another. For each
                                  it prints what the single mode prints, but a malformed one gets a
                                  line `malformed: FILE:LINE: what` on stdout, and reading goes on
                                  at the next `cleave-certificate`. Exit status: the worst one. What
                                  was printed before a failure stands. *)

open Certificate
module V = Verified

let help =
  "usage: cleave-certify [--unglue] [--batch] FILE\n\
   \n\
   Checks that the certificate in FILE (- is the standard input) is right: that `after` is\n\
   unglue(before, cut) up to renaming of vertices. Extracted from a proof in Coq.\n\
   \n\
   \  --unglue  print unglue(before, cut), the class of each corner, instead\n\
   \  --batch   FILE holds any number of certificates\n\
   \  --help    print this and stop\n\
   \n\
   Exit status: 0 accepted, 1 rejected, 2 usage, 3 malformed, or not to be read or written,\n\
   4 the checker itself failed, so there is no verdict; nor is there after death by a signal.\n"

(* Where a corner is. *)

type corner = { cell : int; index : int }

let corner certificate c =
  let k = int_of_positive c - 1 and size = certificate.dimension + 1 in
  { cell = k / size; index = k mod size }

let vertex { rows; _ } { cell; index } = int_of_positive (List.nth (List.nth rows cell) index) - 1

(* A problem as the line and what is wrong there. *)
let problem certificate =
  let line_of c = certificate.before.lines.((corner certificate c).cell) in
  let cell c = (corner certificate c).cell in
  function
  | V.Wrong_length -> (certificate.line, "a row has the wrong length")
  | V.Repeated_vertex (c, d) ->
      ( line_of c,
        Printf.sprintf "cell %d has vertex %d twice" (cell d)
          (vertex certificate.before (corner certificate c)) )
  | V.Same_vertices (c, d) ->
      (line_of d, Printf.sprintf "cells %d and %d have the same vertices" (cell c) (cell d))
  | V.Facet_in_three_cells (c, d) ->
      ( line_of d,
        Printf.sprintf "a facet of cell %d, also in cell %d, is in three cells" (cell d) (cell c) )
  | V.Not_a_facet k ->
      (certificate.cut.lines.(int_of_positive k - 1), "a row of the cut is no facet of `before`")

let malformed certificate p =
  let line, what = problem certificate p in
  raise (Malformed (line, what))

(* What to print, and the exit status. *)
let verdict certificate =
  let { dimension; before; cut; after; _ } = certificate in
  let corner = corner certificate in
  match V.certify_exec (nat_of_int dimension) before.rows cut.rows after.rows with
  | V.Malformed p -> malformed certificate p
  | V.Accepted -> ("accepted\n", 0)
  | V.Not_comparable ->
      ( Printf.sprintf "rejected: cells: before has %d, after has %d\n"
          (Array.length before.lines) (Array.length after.lines), 1 )
  | V.No_parent (c, d) ->
      let c = corner c and d = corner d in
      ( Printf.sprintf
          "rejected: parent: vertex %d of after is vertex %d of before in cell %d, %d in cell %d\n"
          (vertex after c) (vertex before c) c.cell (vertex before d) d.cell, 1 )
  | V.Uncut_mates_apart (c, d) ->
      let c = corner c and d = corner d in
      ( Printf.sprintf
          "rejected: uncut: cells %d and %d share an uncut facet with vertex %d, after: %d and %d\n"
          c.cell d.cell (vertex before c) (vertex after c) (vertex after d), 1 )
  | V.Class_not_connected (c, d) ->
      let c = corner c and d = corner d in
      ( Printf.sprintf
          "rejected: connected: no chain of uncut facets at vertex %d joins cells %d and %d, \
           after: both %d\n"
          (vertex before c) c.cell d.cell (vertex after c), 1 )

let partition certificate =
  let { dimension; before; cut; _ } = certificate in
  match V.unglue_exec (nat_of_int dimension) before.rows cut.rows with
  | V.Inl p -> malformed certificate p
  | V.Inr classes ->
      let text = Buffer.create 65536 in
      Printf.bprintf text "classes %d\n" (Array.length before.lines);
      let number p = string_of_int (int_of_positive p - 1) in
      let row names =
        Buffer.add_string text (String.concat " " (List.map number names));
        Buffer.add_char text '\n'
      in
      List.iter row classes;
      (Buffer.contents text, 0)

let single answer file source =
  match answer (read_only source) with
  | text, status -> print_string text; status
  | exception Malformed (line, what) ->
      Printf.eprintf "cleave-certify: %s:%d: %s\n" file line what;
      3

let rec batch worst answer file source =
  match Option.map answer (read_next source) with
  | None -> worst
  | Some (text, status) -> print_string text; batch (max worst status) answer file source
  | exception Malformed (line, what) ->
      Printf.printf "malformed: %s:%d: %s\n" file line what;
      skip source;
      batch 3 answer file source

let complain what = Printf.eprintf "cleave-certify: %s\n" what

(* What a run returns once its output is written, or the status of what kept it from that. Only a
   verdict may end in 0 or 1, and OCaml's own status for an exception, 2, would look like usage. *)
let guarded run =
  let failed what = complain (what ^ "; no verdict"); 4 in
  match let status = run () in flush stdout; status with
  | status -> status
  | exception Sys_error what -> complain what; 3
  | exception Out_of_memory -> failed "out of memory"
  | exception Stack_overflow -> failed "out of stack"
  | exception other -> failed ("a defect of the checker: " ^ Printexc.to_string other)

let run answer many file =
  let read channel =
    let source = of_channel channel in
    if many then batch 0 answer file source else single answer file source
  in
  if file = "-" then read stdin
  else
    let channel = open_in_bin file in
    Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> read channel)

let usage what =
  complain (what ^ "\nusage: cleave-certify [--unglue] [--batch] FILE");
  2

let rec main answer many file = function
  | "--help" :: _ -> print_string help; 0
  | "--unglue" :: rest -> main partition many file rest
  | "--batch" :: rest -> main answer true file rest
  | word :: _ when word <> "-" && word <> "" && word.[0] = '-' -> usage ("unknown option " ^ word)
  | word :: rest when file = None -> main answer many (Some word) rest
  | _ :: _ -> usage "more than one FILE"
  | [] -> ( match file with Some file -> run answer many file | None -> usage "which FILE?")

(* Fewer, larger collections: the maps of a large mesh live until the verdict. *)
let () = Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl 22; space_overhead = 400 }

let () =
  let words = List.tl (Array.to_list Sys.argv) in
  exit (guarded (fun () -> main verdict false None words))
