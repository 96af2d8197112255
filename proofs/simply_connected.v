(******************************************************************************)
(* Theorem B for a whole body.  Around a ridge the number of selected facets  *)
(* is even where the rim stays away (dual_edge.v); that is not enough for the *)
(* selected facets to be those between two sets of cells: a ring that is cut  *)
(* once across opens and stays in one piece (hole.v).  It is enough if the    *)
(* body has no hole through it, which is said here by walks from cell to      *)
(* cell, as star_opening.v says it of the star of a vertex.                   *)
(*    simply_connected M == any parity of the steps from cell to cell that is *)
(*                          even on the loop around each ridge is even on     *)
(*                          every closed walk: the first cohomology of the    *)
(*                          body modulo two is nil.  A ball has none, nor a   *)
(*                          hollow ball; that is not proved here              *)
(* Main theorems:                                                             *)
(* theoremB_even_simply_connected == then a cut that has an even number of    *)
(*                          facets at each ridge with one loop of cells is    *)
(*                          all facets between two sets of cells              *)
(* theoremB_simply_connected == the same of the facets that sweeps select     *)
(*   theoremB_rim_simply_connected == so it is if the rim avoids, at each     *)
(*                          such ridge, the triangles that some point spans   *)
(*                          with the steps of its loop                        *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary parity dual_edge star_opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section SimplyConnected.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (r : {set V}) (s : seq T) (C : {set {set V}}).

Definition simply_connected :=
  forall x : T -> T -> bool, (forall t u, x t u = x u t) ->
  (forall r s, #|r|.+1 = n -> dual_loop M r s -> loop_parity x s = false) ->
  even_walks (adjacent M) x.

Hypotheses (pm : pseudo_manifold M) (sc : simply_connected).

(* Theorem B, the whole body: if it is simply connected, a cut with an even   *)
(* number of facets at every ridge inside is all facets between two sets of   *)
(* cells.                                                                     *)
Theorem theoremB_even_simply_connected C :
  (forall r s, #|r|.+1 = n -> dual_loop M r s -> ~~ odd (degree M C r)) ->
  exists lab, coboundary M C lab.
Proof.
move=> even; have walks : even_walks (adjacent M) (marks M C).
  apply: sc => [t u|r s cr loop]; first exact: marks_sym.
  by rewrite -(degree_loop C pm cr loop); apply: negbTE; exact: even loop.
have [||lab labE] := (labellingP _ _).1 walks; first exact: adjacentC.
  by move=> t u _; exact: marks_sym.
exists lab => t u tu; rewrite -[_ \in C]/(marks M C t u) labE //.
by case: (lab t) (lab u) => [] [].
Qed.

(* Theorem B, the same of a parity of crossings, ridge by ridge.              *)
Theorem theoremB_simply_connected (x : T -> T -> bool) : (forall t u, x t u = x u t) ->
  (forall r s, #|r|.+1 = n -> dual_loop M r s -> ~~ odd #|dual_cut M x :&: facets_along M s|) ->
  exists lab, coboundary M (dual_cut M x) lab.
Proof.
move=> x_sym even; have sym : symmetric_parity M x by move=> t u _; exact: x_sym.
apply/(theoremB_labelling pm sym); apply: sc => // r s cr loop; have [around_r _] := loop.
by have := even r s cr loop; rewrite (theoremB_loop pm around_r sym) => /negbTE.
Qed.

(* Theorem B, by the rim: at each ridge inside some point o, which may be     *)
(* another one at each ridge, spans with the steps of the loop of dual points *)
(* only triangles that the rim does not pass through.                         *)
Theorem theoremB_rim_simply_connected (P : Type) (cross : P -> P -> bool) (c : T -> P) :
  (forall p q, cross p q = cross q p) ->
  (forall r s, #|r|.+1 = n -> dual_loop M r s ->
     exists o, forall t, t \in s -> closes cross o (c t) (c (next s t))) ->
  exists lab, coboundary M (dual_cut M (towards cross c)) lab.
Proof.
move=> cross_sym rim; apply: theoremB_simply_connected => [t u|r s cr loop].
  exact: cross_sym.
have [[o avoids] [around_r _]] := (rim r s cr loop, loop).
exact: (theoremB_even pm cross_sym around_r avoids).
Qed.
End SimplyConnected.
