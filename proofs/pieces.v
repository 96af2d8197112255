(******************************************************************************)
(* Pieces (T9): what has come off after a cut.                                *)
(*      dual M C == the dual graph minus C: cells are joined by common facets *)
(*                  that are not in C. A piece of M is a component of dual M  *)
(*                  set0, that is of adjacent M (pieces in the C++).          *)
(*     T9_pieces T9_count == the pieces after unglue are the components of    *)
(*                  the dual graph minus all of C, shut facets included       *)
(*     T9_vertex == in a cut-regular complex cells that share a vertex belong *)
(*                  to one piece: no two pieces hang together by a hinge      *)
(*        T9_fem == so after any cut cells that share a vertex are connected  *)
(*                  without crossing C; fem.v draws the conclusion that the   *)
(*                  stiffness matrix is block diagonal                        *)
(* T9_pieces needs 0 < n: for n = 0 a facet is the empty set, which no copy   *)
(* of a vertex can open.                                                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling copies opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Pieces.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

Definition dual C : rel T := fun t u => adjacent M t u && (common M t u \notin C).

Lemma connect_dual C x y : connect (glue M C) x y -> connect (dual C) x.2 y.2.
Proof.
apply: connect_homo => a b /and4P[_ _ ab nC].
by apply: connect1; rewrite /dual ab.
Qed.

(* T9: the pieces after the cut are the components of the dual graph minus C. *)
Theorem T9_pieces C : 0 < n -> connect (adjacent (unglue M C)) =2 connect (dual C).
Proof.
move=> n_gt0 t u; apply/idP/idP; last first.
  by apply: connect_sub => a b /andP[ab nC]; apply/connect1/T3_only.
apply: connect_sub => a b; rewrite T3_adjacent => /andP[ab /forall_inP same].
have /card_gt0P[v vi] : 0 < #|common M a b| by rewrite (eqP ab).
exact: connect_dual (same v vi).
Qed.

(* T9: hence there are as many.                                               *)
Theorem T9_count C : 0 < n -> n_comp (adjacent (unglue M C)) T = n_comp (dual C) T.
Proof. by move=> n_gt0; apply/eq_n_comp/T9_pieces. Qed.

(* T9: in a cut-regular complex cells that share a vertex are in one piece.   *)
Theorem T9_vertex v t u : cut_regular M -> v \in M t -> v \in M u -> connect (adjacent M) t u.
Proof.
move=> r vt vu; have := connect_dual (r v t u vt vu).
by apply: connect_sub => a b /andP[/connect1].
Qed.

End Pieces.

(* T9: after any cut of any complex, cells that share a vertex are connected
   without crossing the cut.                                                  *)
Theorem T9_fem n (V T : finType) (M : complex n V T) (C : {set {set V}}) w t u :
  0 < n -> w \in unglue M C t -> w \in unglue M C u -> connect (dual M C) t u.
Proof.
by move=> n0 wt wu; rewrite -T9_pieces //; apply: T9_vertex wt wu; exact: T4_cut_regular.
Qed.
