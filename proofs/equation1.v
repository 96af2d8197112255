(*********************************************************************************)
(* Equation (1) of the paper, as printed and mended. Section 2 gives the         *)
(* elastic forces of one tetrahedron as E = U X^-1 and                           *)
(*    (F_1|F_2|F_3) = volume X^-T (2 mu E + lambda trace(E) I).                  *)
(* Two misprints: the strain must be (E + E^T) / 2, and X^-T must stand on the   *)
(* right. As printed, a rotation produces forces on every cell, and the          *)
(* stiffness of a cell is not symmetric, unless X is symmetric or skew. Mended,  *)
(* neither happens on any cell. Each misprint does its own harm: mending one of  *)
(* them is not enough.                                                           *)
(*     printed vol mu la P U == the right-hand side of Equation (1) as printed,  *)
(*                       for the edge matrix P (the paper's X) and U             *)
(*  left_strain vol mu la P U == the same, with only the strain mended           *)
(*  right_gradient vol mu la P U == with only the place of X^-T mended           *)
(*      forces vol mu la P U == the mended form (elasticity.v)                   *)
(*          shear i j == the cell whose edges are the unit vectors, but for the  *)
(*                       j-th, which is e_j + e_i                                *)
(* The stiffness is symmetric when dot (F U) W = dot (F W) U: the forces of U do *)
(* the same work along W as the forces of W along U.                             *)
(* Theorems: equation1_printed_rotation, equation1_printed_symmetric (exactly    *)
(* when), equation1_printed_asymmetric and equation1_sheared_tetrahedron         *)
(* (explicit cells), equation1_printed_unit, equation1_mended_rotation,          *)
(* equation1_mended_symmetric, equation1_left_strain, equation1_right_gradient.  *)
(* In C++: cleave::fem::ElasticOperator applies the mended form.                 *)
(*********************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import elasticity.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Equation1.
Variables (R : realFieldType) (n : nat).
Implicit Types (A P Q U W : 'M[R]_n) (vol mu la : R) (i j k a b c d : 'I_n).

Definition printed vol mu la P U : 'M[R]_n :=
  vol *: ((invmx P)^T *m stress mu la (gradient P U)).
Definition left_strain vol mu la P U : 'M[R]_n :=
  vol *: ((invmx P)^T *m stress mu la (strain (gradient P U))).
Definition right_gradient vol mu la P U : 'M[R]_n :=
  vol *: (stress mu la (gradient P U) *m (invmx P)^T).
Definition shear i j : 'M[R]_n := 1%:M + delta_mx i j.

(* A skew matrix A moves every edge x of the cell by A x: an infinitesimal rotation. *)
Lemma gradient_linear A P : P \in unitmx -> gradient P (A *m P) = A.
Proof. by move=> unit; rewrite /gradient mulmxK. Qed.

Lemma skew_trace A : A^T = - A -> \tr A = 0.
Proof.
move=> skew; have /eqP := mxtrace_tr A.
by rewrite skew linearN /= eq_sym -addr_eq0 -mulr2n mulrn_eq0 => /eqP.
Qed.

Lemma stress_skew mu la A : A^T = - A -> stress mu la A = (2%:R * mu) *: A.
Proof. by move=> skew; rewrite /stress skew_trace // mulr0 raddf0 addr0. Qed.

(* As printed, an infinitesimal rotation produces forces, whatever the cell. *)
Theorem equation1_printed_rotation vol mu la P A : P \in unitmx -> A^T = - A -> A != 0 ->
  vol != 0 -> mu != 0 -> printed vol mu la P (A *m P) != 0.
Proof.
move=> unit skew nzA nzv nzmu; rewrite /printed gradient_linear // stress_skew //.
rewrite -scalemxAr !scaler_eq0 mulf_eq0 pnatr_eq0 (negbTE nzv) (negbTE nzmu) /=.
apply: contra nzA => /eqP e; have unitT : P^T \in unitmx by rewrite unitmx_tr.
by rewrite -[A](mulKVmx unitT) -trmx_inv e mulmx0.
Qed.

(* Mended, it produces none, whatever the cell. *)
Theorem equation1_mended_rotation vol mu la P A : P \in unitmx -> A^T = - A ->
  forces vol mu la P (A *m P) = 0.
Proof.
by move=> unit skew; apply: T9_forces_eq0; apply/T9_strain_eq0; rewrite gradient_linear.
Qed.

(* Mended, the stiffness is symmetric, whatever the cell. *)
Theorem equation1_mended_symmetric vol mu la P U W :
  dot (forces vol mu la P U) W = dot (forces vol mu la P W) U.
Proof. exact: T9_work_symmetric. Qed.

Lemma delta_mulmx i j Q a k :
  (delta_mx i j *m Q) a k = (a == i)%:R * Q j k.
Proof.
rewrite mxE (bigD1 j) //= big1 => [|l lj]; first by rewrite mxE eqxx andbT addr0.
by rewrite mxE (negbTE lj) andbF mul0r.
Qed.

Lemma mulmx_delta i j Q a k :
  (Q *m delta_mx i j) a k = Q a i * (k == j)%:R.
Proof.
rewrite mxE (bigD1 i) //= big1 => [|l li]; first by rewrite mxE eqxx addr0.
by rewrite mxE (negbTE li) mulr0.
Qed.

Lemma trace_delta a b Q : \tr (delta_mx a b *m Q) = Q b a.
Proof.
rewrite /mxtrace (bigD1 a) //= big1 => [|k ka]; first by rewrite delta_mulmx eqxx mul1r addr0.
by rewrite delta_mulmx (negbTE ka) mul0r.
Qed.

Lemma dot_deltar a b Q : dot Q (delta_mx a b) = Q a b.
Proof. by rewrite dotC /dot trmx_delta trace_delta. Qed.

Lemma dot_delta a b c d Q :
  dot (delta_mx a b *m Q) (Q *m delta_mx c d) = Q a c * Q b d.
Proof.
have e : delta_mx b a *m (Q *m delta_mx c d) = Q a c *: delta_mx b d.
  apply/matrixP => i k; rewrite delta_mulmx mulmx_delta !mxE.
  by rewrite mulrCA -mulnb natrM.
by rewrite /dot trmx_mul trmx_delta -mulmxA e -scalemxAr mxtraceZ mxtrace_mulC trace_delta mxE.
Qed.

(* The work of the printed forces; only its first term is not symmetric. *)
Lemma printed_work vol mu la P U W : let Q := invmx P in
  dot (printed vol mu la P U) W =
  vol * (2%:R * mu * dot (U *m Q) (Q *m W) + la * (\tr (U *m Q) * \tr (W *m Q))).
Proof.
move=> Q; rewrite /printed dotZl; congr (_ * _).
have -> : dot (Q^T *m stress mu la (U *m Q)) W = dot (stress mu la (U *m Q)) (Q *m W).
  by rewrite /dot trmx_mul trmxK mulmxA.
by rewrite dot_stress mulrA [\tr (Q *m W)]mxtrace_mulC.
Qed.

(* As printed, the stiffness of a cell is symmetric if and only if its edge matrix is *)
(* symmetric or skew.  An invertible skew matrix has an even size, so for a           *)
(* tetrahedron: if and only if its edge matrix is symmetric.                          *)
Theorem equation1_printed_symmetric vol mu la P : P \in unitmx -> vol != 0 -> mu != 0 ->
  (forall U W, dot (printed vol mu la P U) W = dot (printed vol mu la P W) U) <->
  P^T = P \/ P^T = - P.
Proof.
move=> unit nzv nzmu; set Q := invmx P.
have nz2 : 2%:R * mu != 0 by rewrite mulf_eq0 pnatr_eq0.
have symE U W : dot (printed vol mu la P U) W = dot (printed vol mu la P W) U <->
                dot (U *m Q) (Q *m W) = dot (W *m Q) (Q *m U).
  rewrite !printed_work -/Q [_ * \tr (U *m Q)]mulrC; split=> [/(mulfI nzv)/addIr|->] //.
  exact: mulfI.
split=> [sym|PT U W]; last first.
  have [s QT] : exists s : R, Q^T = s *: Q.
    case: PT => e; [exists 1 | exists (-1)]; rewrite /Q trmx_inv e ?scale1r //.
    by rewrite -[- P]scaleN1r invmxZ ?invrN1 // unitmxZ ?unitrN1.
  apply/symE; rewrite /dot -[RHS]mxtrace_tr !trmx_mul !trmxK !mulmxA [RHS]mxtrace_mulC.
  by rewrite !mulmxA QT -!(scalemxAl, scalemxAr).
have entry a b c d : Q a c * Q b d = Q c a * Q d b.
  by have := (symE _ _).1 (sym (delta_mx a b) (delta_mx c d)); rewrite !dot_delta.
have PQ : P = invmx Q by rewrite invmxK.
have [[b d] /= nz|Q0] := pickP (fun p : 'I_n * 'I_n => Q p.1 p.2 != 0); last first.
  left; rewrite PQ (_ : Q = 0) ?trmx_inv ?trmx0 //; apply/matrixP => a c.
  by apply/eqP; rewrite mxE; have /negbFE := Q0 (a, c).
have from_sign (s : R) : Q d b = s * Q b d -> Q = s *: Q^T.
  move=> e; apply/matrixP => a c; rewrite !mxE; apply: (mulIf nz).
  by rewrite entry e mulrCA mulrA.
have : Q d b ^+ 2 = Q b d ^+ 2 by rewrite !expr2 entry.
move/eqP; rewrite eqf_sqr => /orP[]/eqP e; [left | right].
  by rewrite PQ trmx_inv {2}(from_sign 1) ?scale1r ?mul1r.
rewrite PQ trmx_inv {2}(from_sign (-1)) ?mulN1r // -[- invmx _]scaleN1r.
rewrite invmxZ ?invrN1 ?scalerA ?mulrNN ?mulr1 ?scale1r // unitmxZ ?unitrN1 //.
by rewrite unitmx_tr unitmx_inv.
Qed.

(* The smallest cells: all edges unit vectors, but one that is the sum of two. *)
Lemma shearK i j : i != j -> shear i j *m (1%:M - delta_mx i j) = 1%:M.
Proof.
move=> ij; rewrite mulmxDl !mulmxBr !mul1mx mulmx1 mul_delta_mx_0 1?eq_sym //.
by rewrite subr0 subrK.
Qed.

Lemma shear_unit i j : i != j -> shear i j \in unitmx.
Proof. by move=> /shearK/mulmx1_unit[]. Qed.

Lemma shear_inv i j : i != j -> invmx (shear i j) = 1%:M - delta_mx i j.
Proof.
by move=> ij; rewrite -[RHS](mulKmx (shear_unit ij)) shearK // mulmx1.
Qed.

Lemma shear_inv_entries i j (Q := invmx (shear i j)) : i != j ->
  [/\ Q i i = 1, Q i j = -1 & Q j i = 0].
Proof.
move=> ij; rewrite /Q shear_inv // !mxE !eqxx (negbTE ij) [j == i]eq_sym (negbTE ij) /=.
by rewrite subr0 sub0r subrr.
Qed.

(* On a sheared cell, move vertex i along e_i, then along e_j.  The printed forces of *)
(* each displacement do different work along the other.                               *)
Theorem equation1_printed_shear vol mu la i j (P := shear i j) : i != j ->
  dot (printed vol mu la P (delta_mx i i)) (delta_mx j i) = - (vol * (2%:R * mu + la)) /\
  dot (printed vol mu la P (delta_mx j i)) (delta_mx i i) = - (vol * la).
Proof.
move=> ij; have [ii ijE ji] := shear_inv_entries ij.
rewrite !printed_work !dot_delta !trace_delta ii ijE ji !mulr1 !mul1r.
by rewrite mulr0 add0r !mulrN1 -opprD !mulrN.
Qed.

(* So the printed stiffness of a sheared cell is not symmetric. *)
Corollary equation1_printed_asymmetric vol mu la i j (P := shear i j) :
  i != j -> vol != 0 -> mu != 0 ->
  dot (printed vol mu la P (delta_mx i i)) (delta_mx j i) !=
  dot (printed vol mu la P (delta_mx j i)) (delta_mx i i).
Proof.
move=> ij nzv nzmu; have [-> ->] := equation1_printed_shear vol mu la ij.
rewrite eqr_opp -subr_eq0 -mulrBr addrK !mulf_eq0 pnatr_eq0.
by rewrite (negbTE nzv) (negbTE nzmu).
Qed.

(* On the cell whose edges are the unit vectors, the printed forces of a rotation are *)
(* the rotation itself, times 2 volume mu.                                            *)
Corollary equation1_printed_unit vol mu la A : A^T = - A ->
  printed vol mu la 1%:M A = (2%:R * (vol * mu)) *: A.
Proof.
move=> skew; rewrite /printed /gradient invmx1 mulmx1 trmx1 mul1mx stress_skew //.
by rewrite scalerA mulrCA.
Qed.

(* Each misprint does its own harm.  With only the strain mended, the stiffness of a *)
(* sheared cell is still not symmetric ...                                           *)
Theorem equation1_left_strain vol mu la i j (P := shear i j) :
  i != j -> vol != 0 -> mu != 0 ->
  dot (left_strain vol mu la P (delta_mx i i)) (delta_mx j i) !=
  dot (left_strain vol mu la P (delta_mx j i)) (delta_mx i i).
Proof.
move=> ij nzv nzmu; set Q := invmx P; have [ii ijE ji] := shear_inv_entries ij.
have work U W : dot (left_strain vol mu la P U) W = vol *
  (mu * (dot (U *m Q) (Q *m W) + \tr (U *m Q *m (Q *m W))) + la * (\tr (U *m Q) * \tr (W *m Q))).
  rewrite dotZl; congr (_ * _).
  have -> : dot (Q^T *m stress mu la (strain (U *m Q))) W =
            dot (stress mu la (strain (U *m Q))) (Q *m W).
    by rewrite /dot trmx_mul trmxK mulmxA.
  rewrite dot_stress mxtrace_strain mulrA [\tr (Q *m W)]mxtrace_mulC; congr (_ + _).
  rewrite dotZl dotDl [dot _^T _]/dot trmxK mulrA; congr (_ * _).
  by rewrite mulrAC divff ?mul1r ?pnatr_eq0.
have sq : (Q *m Q) i j = - 2%:R.
  rewrite /Q shear_inv // mulmxBl mul1mx mulmxBr mulmx1 mul_delta_mx_0 1?eq_sym // subr0.
  by rewrite !mxE !eqxx (negbTE ij) sub0r -opprD.
rewrite !work !dot_delta !trace_delta -!mulmxA !trace_delta !mulmxA !mulmx_delta.
rewrite sq ii ijE ji !eqxx [j == i]eq_sym (negbTE ij) !(mulr0, mul0r, mulr1, mul1r) addr0.
rewrite -subr_eq0 -mulrBr mulr0 add0r addrK.
by rewrite !mulf_eq0 (negbTE nzv) (negbTE nzmu) /= -opprD oppr_eq0 -(natrD _ 1) pnatr_eq0.
Qed.

(* ... and with only the place of X^-T mended, the stiffness is symmetric, but a *)
(* rotation still produces forces, whatever the cell.                            *)
Theorem equation1_right_gradient vol mu la P A :
  P \in unitmx -> A^T = - A -> A != 0 -> vol != 0 -> mu != 0 ->
  right_gradient vol mu la P (A *m P) != 0.
Proof.
move=> unit skew nzA nzv nzmu; rewrite /right_gradient gradient_linear // stress_skew //.
rewrite -scalemxAl !scaler_eq0 mulf_eq0 pnatr_eq0 (negbTE nzv) (negbTE nzmu) /=.
apply: contra nzA => /eqP e; have unitT : P^T \in unitmx by rewrite unitmx_tr.
by rewrite -[A](mulmxKV unitT) -trmx_inv e mul0mx.
Qed.

(* The place of X^-T alone makes the stiffness symmetric. *)
Theorem equation1_right_gradient_symmetric vol mu la P U W :
  dot (right_gradient vol mu la P U) W = dot (right_gradient vol mu la P W) U.
Proof.
have work U' W' : dot (right_gradient vol mu la P U') W' =
                  vol * dot (stress mu la (gradient P U')) (gradient P W').
  rewrite dotZl; congr (_ * _).
  by rewrite /dot trmx_mul trmxK -mulmxA mxtrace_mulC -mulmxA.
by rewrite !work !dot_stress [dot (gradient _ _) _]dotC [la * _ * _]mulrAC.
Qed.

End Equation1.

(* The smallest counterexample: the tetrahedron (0,0,0), (1,0,0), (1,1,0), (0,0,1) of *)
(* volume 1/6, with mu = lambda = 1.  Move vertex 1 by (1,0,0): the printed force on  *)
(* it has y-component -1/2.  Move it by (0,1,0): the x-component is -1/6.             *)
Corollary equation1_sheared_tetrahedron (P : 'M[rat]_3 := shear _ 0 1) :
  printed 6%:R^-1 1 1 P (delta_mx 0 0) 1 0 = - 2%:R^-1 /\
  printed 6%:R^-1 1 1 P (delta_mx 1 0) 0 0 = - 6%:R^-1.
Proof.
have ne : (0 : 'I_3) != 1 by [].
have [] := equation1_printed_shear (6%:R^-1 : rat_realFieldType) 1 1 ne.
by rewrite !dot_deltar => -> ->.
Qed.
