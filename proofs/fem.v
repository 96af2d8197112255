(* fem.v : T9_pieces consequences for the assembled stiffness matrix.  Entries live   *)
(* in any ring R (R = 3x3 matrices for 3-D elasticity).                        *)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Fem.
Variables (n : nat) (V T : finType) (M : complex n V T) (R : ringType).
Variable k : T -> V -> V -> R.                 (* element matrices              *)
Hypothesis k_local : forall t v w, k t v w != 0 -> (v \in M t) && (w \in M t).
Definition K v w : R := \sum_t k t v w.        (* assembly                      *)

(* non-zero entry => some common cell (Section 2)                              *)
Lemma K_sparse v w : K v w != 0 -> exists t, (v \in M t) && (w \in M t).
Proof.
move=> Knz; apply/existsP; apply: contraR Knz; rewrite negb_exists => /forallP no.
rewrite /K big1 // => t _; apply/eqP/negPn/negP => /k_local e.
by have := no t; rewrite e.
Qed.

(* block-diagonal: entries between different components vanish                 *)
Theorem K_block (creg : cut_regular M) v w t u :
  v \in M t -> w \in M u -> ~~ connect (adjacent M) t u -> K v w = 0.
Proof.
move=> vt wu nc; apply/eqP/negPn/negP => /K_sparse[s /andP[vs ws]].
move/negP: nc; apply; apply: connect_trans (T9_vertex creg vt vs) _.
exact: T9_vertex creg ws wu.
Qed.

(* F0 = - sum Fj : zero row sums of element matrices.  Then, per component,    *)
(* translations are in the kernel, whatever was cut.                           *)
Hypothesis k_rows : forall t v, \sum_w k t v w = 0.
Theorem K_kernel (creg : cut_regular M) (t0 : T) v :
  \sum_(w | [exists t, (w \in M t) && connect (adjacent M) t0 t]) K v w = 0.
Proof.
rewrite /K exchange_big big1 // => t _ /=.
have [c|nc] := boolP (connect (adjacent M) t0 t).
  rewrite -[RHS](k_rows t v) big_mkcond; apply: eq_bigr => w _; case: ifP => //.
  move/negbT; rewrite negb_exists => /forallP/(_ t); rewrite c andbT => wt.
  by apply/esym/eqP/negPn/negP => /k_local/andP[_]; apply/negP.
rewrite big1 // => w /existsP[u /andP[wu cu]]; apply/eqP/negPn/negP => /k_local/andP[_ wt].
by move/negP: nc; apply; apply: connect_trans cu (T9_vertex creg wu wt).
Qed.
End Fem.

(* after any cut the hypothesis cut_regular is free                            *)
Corollary K_block_unglue n (V T : finType) (M : complex n V T) C (R : ringType)
    (k : T -> V * T -> V * T -> R) :
  (forall t v w, k t v w != 0 -> (v \in unglue M C t) && (w \in unglue M C t)) ->
  forall v w t u, (0 < n)%N -> v \in unglue M C t -> w \in unglue M C u ->
    ~~ connect (dual M C) t u -> K k v w = 0.
Proof.
move=> kl v w t u n0 vt wu nc; apply: (K_block kl (@T4_cut_regular _ _ _ M C) vt wu).
by rewrite T9_pieces.
Qed.
