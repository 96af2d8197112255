(*******************************************************************************)
(* The stiffness matrix of elasticity, block by block (T9). The C++ operator   *)
(* never stores it; cell_stiffness computes the same blocks.                   *)
(*           shape B t i == the gradient of the i-th shape function of cell t  *)
(*         block B t i j == the block of the i-th and the j-th vertex of t:    *)
(*                          volume (mu ((g_i.g_j) I + g_j g_i^T)               *)
(*                          + lambda g_i g_j^T), with g = shape B t            *)
(*       element B t v w == the block of the vertices v and w in cell t, zero  *)
(*                          unless both belong to it                           *)
(* Theorems: T9_stiffness_matrix (K u is the product of the assembled blocks   *)
(* with u), T9_element_symmetric, T9_elastic_block (one block for each piece). *)
(* In C++: cleave::fem::ElasticOperator::cell_stiffness, assemble_stiffness.   *)
(*******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue fem elasticity rigid_motion elastic_kernel.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Matrix.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T) (B : body R M).
Implicit Types (t s : T) (v w : V) (u : V -> 'cV[R]_n) (i j : 'I_n.+1).

Definition shape t i : 'cV[R]_n :=
  col i (closed (invmx (edges (order B) (position B) t))^T).
Definition block t i j : 'M[R]_n :=
  let g := shape t in
  volume B t *: (lame_mu B t *: ((dot (g i) (g j))%:M + g j *m (g i)^T)
                 + lame_lambda B t *: (g i *m (g j)^T)).
Definition element t v w : 'M[R]_n :=
  \sum_(i | order B t i == v) \sum_(j | order B t j == w) block t i j.

Lemma mul_col_mx1 (x : 'cV[R]_n) (q : 'M[R]_1) : x *m q = \tr q *: x.
Proof. by rewrite [q in LHS]mx11_scalar mul_mx_scalar trace_mx11. Qed.

Lemma outer_mul (x y z : 'cV[R]_n) : x *m y^T *m z = dot y z *: x.
Proof. by rewrite -mulmxA mul_col_mx1. Qed.

(* The forces of a cell at its i-th vertex are the stress times the gradient of the *)
(* i-th shape function, and so is the gradient of a displacement made of them.      *)
Lemma col_closed (S F : 'M[R]_n) i : col i (closed (S *m F)) = S *m col i (closed F).
Proof.
rewrite -col_mulmx; apply/matrixP => a k; rewrite !mxE; case: unliftP => [j|] ->.
  by rewrite mxE; apply: eq_bigr => c _; rewrite mxE liftK.
under eq_bigr do rewrite mxE; rewrite exchange_big -sumrN; apply: eq_bigr => c _.
by rewrite mxE unlift_none mulrN mulr_sumr.
Qed.

Lemma gradE u t : grad (order B) (position B) u t = \sum_j u (order B t j) *m (shape t j)^T.
Proof.
rewrite big_ord_recl /=.
have -> : (shape t ord0)^T = - \sum_j (shape t (lift ord0 j))^T.
  apply/matrixP => a b; rewrite !mxE unlift_none summxE; congr (- _).
  by apply: eq_bigr => j _; rewrite !mxE liftK mxE.
rewrite mulmxN mulmx_sumr addrC -sumrB; apply/matrixP => a b; rewrite mxE summxE.
apply: eq_bigr => j _; rewrite -mulmxBl [RHS]mxE big_ord1.
by rewrite !mxE liftK mxE.
Qed.

Lemma block_mul t i j (x : 'cV[R]_n) (E := x *m (shape t j)^T) :
  block t i j *m x =
  volume B t *: ((lame_mu B t *: (E + E^T) + (lame_lambda B t * \tr E)%:M) *m shape t i).
Proof.
rewrite -scalemxAl; congr (_ *: _); rewrite !mulmxDl -!scalemxAl !mulmxDl.
rewrite mul_scalar_mx !outer_mul /E trmx_mul trmxK !outer_mul mul_scalar_mx.
by rewrite scalerA mxtrace_mulC [dot x _]dotC [dot (shape t j) (shape t i)]dotC.
Qed.

(* The forces of a cell at its i-th vertex are the blocks times the displacements. *)
Lemma cell_forceE u t i :
  col i (closed (cell_forces B u t)) = \sum_j block t i j *m u (order B t j).
Proof.
under eq_bigr do rewrite block_mul; rewrite -scaler_sumr -mulmx_suml big_split /=.
rewrite -scaler_sumr big_split /= -!raddf_sum -mulr_sumr -!raddf_sum -gradE.
rewrite /cell_forces /forces scalemxAl col_closed -scalemxAl; congr (_ *: (_ *m _)).
by rewrite /stress /strain scalerA mulrAC divff ?pnatr_eq0 // mul1r mxtrace_strain.
Qed.

(* T9: the stiffness operator is the product with the assembled blocks. *)
Theorem T9_stiffness_matrix u v : stiffness B u v = \sum_w assembled element v w *m u w.
Proof.
under [RHS]eq_bigr do rewrite mulmx_suml; rewrite exchange_big; apply: eq_bigr => t _ /=.
under eq_bigr do rewrite cell_forceE; under [RHS]eq_bigr do rewrite mulmx_suml.
rewrite [RHS]exchange_big; apply: eq_bigr => i _ /=.
under [RHS]eq_bigr do rewrite mulmx_suml big_mkcond; rewrite [RHS]exchange_big.
apply: eq_bigr => j _ /=; rewrite -big_mkcond (big_pred1 (order B t j)) // => w.
exact: eq_sym.
Qed.

Lemma trmx_block t i j : (block t i j)^T = block t j i.
Proof.
rewrite /block linearZ /= linearD /= linearZ /= [in LHS]linearZ /= [(_ + _)^T]linearD /=.
by rewrite tr_scalar_mx !trmx_mul !trmxK dotC.
Qed.

Lemma eq_stiffness u (w : V -> 'cV[R]_n) v : u =1 w -> stiffness B u v = stiffness B w v.
Proof.
move=> e; rewrite (T9_stiffness_matrix u) (T9_stiffness_matrix w).
by apply: eq_bigr => y _; rewrite e.
Qed.

Lemma stiffness_linear a u (w : V -> 'cV[R]_n) v :
  stiffness B (fun y => a *: u y + w y) v = a *: stiffness B u v + stiffness B w v.
Proof.
rewrite T9_stiffness_matrix (T9_stiffness_matrix u) (T9_stiffness_matrix w).
rewrite scaler_sumr -big_split; apply: eq_bigr => y _ /=.
by rewrite mulmxDr scalemxAr.
Qed.

(* T9: blocks (v, w) and (w, v) are the transposes of each other. *)
Theorem T9_element_symmetric t v w : (element t v w)^T = element t w v.
Proof.
rewrite /element exchange_big !raddf_sum; apply: eq_bigr => i _ /=.
by rewrite raddf_sum; apply: eq_bigr => j _ /=; apply: trmx_block.
Qed.

Lemma element_local : local M element.
Proof.
move=> t v w; apply: contraR; rewrite negb_and => /orP[vt|wt]; apply/eqP.
  by apply: big1 => i /eqP e; case/negP: vt; rewrite -e (mem_order (order_vertices B)).
apply: big1 => i _; apply: big1 => j /eqP e; case/negP: wt.
by rewrite -e (mem_order (order_vertices B)).
Qed.

(* T9: in a cut-regular complex the elastic stiffness matrix is block diagonal, one *)
(* block for each piece.                                                            *)
Theorem T9_elastic_block v w t s : cut_regular M ->
  v \in M t -> w \in M s -> ~~ connect (adjacent M) t s -> assembled element v w = 0.
Proof. exact/T9_block/element_local. Qed.

End Matrix.
