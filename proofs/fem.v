(*******************************************************************************)
(* The stiffness matrix after a cut (T9). A finite element method gives each   *)
(* cell an element matrix and adds them up. This file knows nothing of         *)
(* elasticity: an entry is any value that can be added, for instance the 3 x 3 *)
(* block of two vertices; stiffness_matrix.v is about the elastic one.         *)
(*            k t v w == the entry of the vertices v, w in the element matrix  *)
(*                       of the cell t                                         *)
(*          local M k == the entry is zero unless both are vertices of t       *)
(*      assembled k v w == the entry of v, w in the stiffness matrix: the sum  *)
(*                       over the cells                                        *)
(*              hinge == two tetrahedra that share one vertex                  *)
(* Theorems: T9_sparse (section 2 of the paper: an entry is non-zero only if   *)
(* the two vertices are in some cell together), T9_block (in a cut-regular     *)
(* complex the matrix is block diagonal, one block per piece), T9_translations *)
(* (each block takes a translation of its piece to zero), T9_block_unglue      *)
(* (after any cut the blocks are the components of the dual graph without the  *)
(* cut facets), T9_hinge (what happens without cut-regularity).                *)
(* In C++: cleave::fem::assemble_stiffness.                                    *)
(*******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Assembly.
Variables (n : nat) (V T : finType) (M : complex n V T) (R : zmodType).
Variable k : T -> V -> V -> R.
Implicit Types (t u : T) (v w : V).

Definition local := forall t v w, k t v w != 0 -> (v \in M t) && (w \in M t).
Definition assembled v w : R := \sum_t k t v w.

Hypothesis k_local : local.

(* T9: an entry is non-zero only if the two vertices are in some cell together. *)
Theorem T9_sparse v w : assembled v w != 0 -> exists t, (v \in M t) && (w \in M t).
Proof.
move=> nz; apply/existsP; apply: contraR nz; rewrite negb_exists => /forallP none.
rewrite /assembled big1 // => t _; apply/eqP/negPn/negP => /k_local e.
by have := none t; rewrite e.
Qed.

(* T9: in a cut-regular complex, entries between two pieces vanish. *)
Theorem T9_block v w t u : cut_regular M ->
  v \in M t -> w \in M u -> ~~ connect (adjacent M) t u -> assembled v w = 0.
Proof.
move=> reg vt wu apart; apply/eqP/negPn/negP => /T9_sparse[s /andP[vs ws]].
move/negP: apart; apply; apply: connect_trans (T9_vertex reg vt vs) _.
exact: T9_vertex reg ws wu.
Qed.

(* T9: if every row of every element matrix adds up to zero (F_0 = - F_1 - .. - F_n), *)
(* then so does every row over one piece: a translation of a piece causes no force.   *)
Theorem T9_translations (t0 : T) v : cut_regular M -> (forall t v, \sum_w k t v w = 0) ->
  \sum_(w | [exists t, (w \in M t) && connect (adjacent M) t0 t]) assembled v w = 0.
Proof.
move=> reg rows; rewrite /assembled exchange_big big1 // => t _ /=.
have [near|far] := boolP (connect (adjacent M) t0 t).
  rewrite -[RHS](rows t v) big_mkcond; apply: eq_bigr => w _; case: ifP => //.
  move/negbT; rewrite negb_exists => /forallP/(_ t); rewrite near andbT => wt.
  by apply/esym/eqP/negPn/negP => /k_local/andP[_]; apply/negP.
rewrite big1 // => w /existsP[u /andP[wu u_near]].
apply/eqP/negPn/negP => /k_local/andP[_ wt].
by move/negP: far; apply; apply: connect_trans u_near (T9_vertex reg wu wt).
Qed.

End Assembly.

(* T9: after any cut, of any complex, the matrix is block diagonal: one block for each *)
(* component of the dual graph without the cut facets.                                 *)
Corollary T9_block_unglue n (V T : finType) (M : complex n V T) C (R : zmodType)
    (k : T -> V * T -> V * T -> R) v w t u :
  (0 < n)%N -> local (unglue M C) k -> v \in unglue M C t -> w \in unglue M C u ->
  ~~ connect (dual M C) t u -> assembled k v w = 0.
Proof.
move=> n_gt0 k_local vt wu apart; apply: (T9_block k_local _ vt wu).
  exact: T4_cut_regular.
by rewrite T9_pieces.
Qed.

(* The hinge: tetrahedra {0,1,2,3} and {3,4,5,6}.  They share vertex 3, but a walk *)
(* through facets does not lead from one to the other.                             *)
Section Hinge.

Definition hinge_cell (t : bool) : {set 'I_7} :=
  if t then [set i : 'I_7 | (3 <= i)%N] else [set i : 'I_7 | (i <= 3)%N].

Lemma card_hinge_cell t : #|hinge_cell t| = 4%N.
Proof.
by case: t; rewrite -sum1_card big_mkcond !big_ord_recl big_ord0 /= !inE.
Qed.

Lemma hinge_cell_inj : injective hinge_cell.
Proof.
by case=> [] [] // /setP/(_ ord0); rewrite !inE.
Qed.

Definition hinge : complex 3 [finType of 'I_7] bool_finType :=
  Complex card_hinge_cell hinge_cell_inj.

(* T9: without cut-regularity one vertex can be in two pieces, and then the vertices *)
(* do not fall into one block for each piece.                                        *)
Theorem T9_hinge : let v : 'I_7 := inord 3 in
  [/\ v \in hinge false, v \in hinge true, ~~ connect (adjacent hinge) false true &
      ~ cut_regular hinge].
Proof.
move=> v; have alone t u : adjacent hinge t u = false.
  have [->|tu] := eqVneq t u; first exact: adjacent_irr.
  apply/negbTE; rewrite /adjacent -sum1_card big_mkcond !big_ord_recl big_ord0 /=.
  by case: t u tu => [] [] // _; rewrite !inE.
have apart : ~~ connect (adjacent hinge) false true.
  by apply/connectP => -[[|u p] //= /andP[]]; rewrite alone.
have [v0 v1] : v \in hinge false /\ v \in hinge true by rewrite !inE inordK.
by split=> // /T9_vertex reg; move: apart; rewrite (reg _ _ _ v0 v1).
Qed.

End Hinge.
