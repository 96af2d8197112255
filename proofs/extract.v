(******************************************************************************)
(* The programs of certify_exec.v and unglue_exec.v as OCaml, in verified.ml. *)
(* Numbers stay Coq's binary positives; only booleans, pairs, lists and       *)
(* options become those of OCaml. checker/build.sh runs this file.            *)
(******************************************************************************)
From Coq Require Import Extraction ExtrOcamlBasic.
From Cleave Require certify_exec unglue_exec.
Extraction "verified.ml" certify_exec.certify_exec unglue_exec.unglue_exec.
