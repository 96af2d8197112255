(********************************************************************************)
(* The elastic energy of one cell, by matrices alone. A cell of R^n with        *)
(* vertices X_0 .. X_n that move by u_0 .. u_n is the two n x n matrices of     *)
(* section 2 of the paper,                                                      *)
(*     P = (X_1 - X_0 | .. | X_n - X_0),  U = (u_1 - u_0 | .. | u_n - u_0).     *)
(* The scalars form any ordered field: rational numbers, real numbers, ...      *)
(*            dot A B == the sum of the products of the entries of A and B      *)
(*       gradient P U == U P^-1, the gradient of the displacement (the paper's  *)
(*                       E)                                                     *)
(*           strain E == (E + E^T) / 2                                          *)
(*      stress mu la S == 2 mu S + la trace(S) I, the stress at strain S        *)
(*  energy_density mu la S == mu S.S + la/2 trace(S)^2, the energy per volume   *)
(*     elastic n mu la == mu > 0 and n la + 2 mu > 0; la may be negative        *)
(*                       (for n = 3 the condition of the C++ struct Lame)       *)
(*  forces vol mu la P U == (F_1 | .. | F_n) of Equation (1), mended: the       *)
(*                       elastic forces at the vertices 1 .. n; equation1.v     *)
(*                       says why mended                                        *)
(*           closed F == (F_0 | F_1 | .. | F_n) with F_0 = - (F_1 + .. + F_n)   *)
(* Theorems: T9_energy_ge0, T9_energy_eq0 (the energy is never negative, and    *)
(* zero only without strain), T9_elastic_exact (the condition on mu and la is   *)
(* the exact one), T9_strain_eq0 (no strain: the gradient is skew, a rotation), *)
(* T9_work, T9_work_symmetric, T9_work_self (the forces are symmetric, and the  *)
(* work is twice the energy), T9_forces_eq0 (no strain, no forces).             *)
(* In C++: cleave::fem::ElasticOperator.                                        *)
(********************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Dot.
Variables (R : realFieldType) (m n : nat).
Implicit Types A B C : 'M[R]_(m, n).

Definition dot A B := \tr (A^T *m B).

Lemma dotE A B : dot A B = \sum_j \sum_i A i j * B i j.
Proof.
by rewrite /dot /mxtrace; apply: eq_bigr => j _; rewrite mxE; apply: eq_bigr => i _; rewrite mxE.
Qed.

Lemma dotC A B : dot A B = dot B A.
Proof. by rewrite /dot -mxtrace_tr trmx_mul trmxK. Qed.

Lemma dotDl A B C : dot (A + B) C = dot A C + dot B C.
Proof. by rewrite /dot linearD mulmxDl mxtraceD. Qed.

Lemma dotDr A B C : dot A (B + C) = dot A B + dot A C.
Proof. by rewrite /dot mulmxDr mxtraceD. Qed.

Lemma dotNl A B : dot (- A) B = - dot A B.
Proof. by rewrite /dot linearN mulNmx linearN. Qed.

Lemma dotNr A B : dot A (- B) = - dot A B.
Proof. by rewrite /dot mulmxN linearN. Qed.

Lemma dotZl a A B : dot (a *: A) B = a * dot A B.
Proof. by rewrite /dot linearZ -scalemxAl mxtraceZ. Qed.

Lemma dotZr a A B : dot A (a *: B) = a * dot A B.
Proof. by rewrite dotC dotZl dotC. Qed.

Lemma dot0l B : dot 0 B = 0.
Proof. by rewrite /dot trmx0 mul0mx mxtrace0. Qed.

Lemma dot_ge0 A : 0 <= dot A A.
Proof.
by rewrite dotE; apply: sumr_ge0 => j _; apply: sumr_ge0 => i _; rewrite -expr2 sqr_ge0.
Qed.

Lemma dot_eq0 A : (dot A A == 0) = (A == 0).
Proof.
apply/eqP/eqP => [|->]; last exact: dot0l.
have sq i j : 0 <= A i j * A i j by rewrite -expr2 sqr_ge0.
rewrite dotE => /psumr_eq0P colj; apply/matrixP => i j; rewrite mxE.
have /psumr_eq0P entry : \sum_i A i j * A i j = 0.
  by apply: colj => // k _; apply: sumr_ge0.
by apply/eqP; rewrite -sqrf_eq0 expr2 entry.
Qed.

End Dot.

Section Cell.
Variables (R : realFieldType) (n : nat).
Implicit Types (E S P U W A : 'M[R]_n) (vol mu la : R).

Definition gradient P U := U *m invmx P.
Definition strain E := 2%:R^-1 *: (E + E^T).
Definition stress mu la S := (2%:R * mu) *: S + (la * \tr S)%:M.
Definition energy_density mu la S := mu * dot S S + la / 2%:R * \tr S ^+ 2.
Definition elastic mu la := (0 < mu) && (0 < n%:R * la + 2%:R * mu).
Definition forces vol mu la P U :=
  vol *: (stress mu la (strain (gradient P U)) *m (invmx P)^T).
Definition closed (F : 'M[R]_n) : 'M[R]_(n, n.+1) :=
  \matrix_(a, i) (if unlift ord0 i is Some j then F a j else - \sum_j F a j).

Lemma half_double (x : R) : 2%:R^-1 * (x + x) = x.
Proof. by rewrite -mulr2n -[x *+ 2]mulr_natl mulKf // pnatr_eq0. Qed.

Lemma trmx_strain E : (strain E)^T = strain E.
Proof. by rewrite /strain linearZ /= linearD /= trmxK addrC. Qed.

Lemma mxtrace_strain E : \tr (strain E) = \tr E.
Proof. by rewrite mxtraceZ mxtraceD mxtrace_tr half_double. Qed.

(* T9: no strain means that the gradient is skew: an infinitesimal rotation. *)
Theorem T9_strain_eq0 E : strain E = 0 <-> E^T = - E.
Proof.
split=> [/eqP|skewE]; last by rewrite /strain skewE subrr scaler0.
by rewrite scaler_eq0 invr_eq0 pnatr_eq0 /= addrC addr_eq0 => /eqP.
Qed.

Lemma dot_scalar_mx a S : dot S a%:M = a * \tr S.
Proof. by rewrite /dot mul_mx_scalar mxtraceZ mxtrace_tr. Qed.

Lemma dot_strain S E : S^T = S -> dot S (strain E) = dot S E.
Proof.
move=> symS; have e : dot S E^T = dot S E by rewrite dotC /dot trmxK mxtrace_mulC symS.
by rewrite dotZr dotDr e half_double.
Qed.

Lemma trmx_stress mu la S : S^T = S -> (stress mu la S)^T = stress mu la S.
Proof. by move=> symS; rewrite linearD linearZ /= symS tr_scalar_mx. Qed.

Lemma dot_stress mu la S E :
  dot (stress mu la S) E = 2%:R * mu * dot S E + la * \tr S * \tr E.
Proof. by rewrite dotDl dotZl [dot _%:M _]dotC dot_scalar_mx. Qed.

Lemma dot_stress_self mu la S : dot (stress mu la S) S = 2%:R * energy_density mu la S.
Proof.
rewrite dot_stress mulrDr mulrA; congr (_ + _).
by rewrite mulrA [2%:R * _]mulrC divfK ?pnatr_eq0 // -mulrA.
Qed.

(* The energy as two squares: that of the deviator (the strain without its trace) *)
(* and that of the trace.  The C++ operator computes it in this form.             *)
Lemma energy_densityE mu la S : (0 < n)%N ->
  let D := S - (\tr S / n%:R)%:M in
  energy_density mu la S =
  mu * dot D D + (n%:R * la + 2%:R * mu) / (2%:R * n%:R) * \tr S ^+ 2.
Proof.
move=> n_gt0 D; have nz : n%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
have trD : \tr D = 0 by rewrite linearB /= mxtrace_scalar -[_ *+ n]mulr_natr divfK // subrr.
have -> : dot D D = dot S S - \tr S ^+ 2 / n%:R.
  rewrite {2}/D dotDr dotNr dot_scalar_mx trD mulr0 subr0 dotDl dotNl.
  by rewrite [dot _%:M _]dotC dot_scalar_mx mulrAC -expr2.
rewrite /energy_density mulrBr -addrA; congr (_ + _).
rewrite [_ / (_ * _)]mulrDl mulrDl addrCA; set t2 := _ ^+ 2.
rewrite invfM; have e1 : n%:R * la * (2%:R^-1 / n%:R) = la / 2%:R.
  by rewrite [_^-1 * _]mulrC mulrA [n%:R * _]mulrC mulfK.
have e2 : 2%:R * mu * (2%:R^-1 / n%:R) = mu / n%:R.
  by rewrite mulrA [2%:R * _]mulrC mulfK // pnatr_eq0.
by rewrite e1 e2 mulrA [mu * t2 / _]mulrAC addNr addr0.
Qed.

Lemma mx_dim0 S : n = 0%N -> S = 0.
Proof. by move=> n0; apply/matrixP => i; have := ltn_ord i; rewrite {2}n0. Qed.

(* T9: the energy of a cell is never negative ... *)
Theorem T9_energy_ge0 mu la S : elastic mu la -> 0 <= energy_density mu la S.
Proof.
case/andP => mu_gt0 bulk.
have [n0|n_gt0] := posnP n.
  by rewrite (mx_dim0 S n0) /energy_density dot0l mxtrace0 !mulr0 expr0n mulr0 addr0.
have c_gt0 : 0 < (n%:R * la + 2%:R * mu) / (2%:R * n%:R).
  by rewrite divr_gt0 ?mulr_gt0 ?ltr0n.
by rewrite energy_densityE // addr_ge0 // mulr_ge0 ?dot_ge0 ?sqr_ge0 // ltW.
Qed.

(* ... and zero only when there is no strain. *)
Theorem T9_energy_eq0 mu la S : elastic mu la -> energy_density mu la S = 0 -> S = 0.
Proof.
case/andP => mu_gt0 bulk.
have [n0 _|n_gt0] := posnP n; first exact: mx_dim0.
have c_gt0 : 0 < (n%:R * la + 2%:R * mu) / (2%:R * n%:R).
  by rewrite divr_gt0 ?mulr_gt0 ?ltr0n.
rewrite energy_densityE // => /eqP; rewrite paddr_eq0; first last.
- by rewrite mulr_ge0 ?sqr_ge0 ?ltW.
- by rewrite mulr_ge0 ?dot_ge0 ?ltW.
case/andP; rewrite mulf_eq0 (gt_eqF mu_gt0) dot_eq0 /= => dev.
rewrite mulf_eq0 (gt_eqF c_gt0) sqrf_eq0 /= => /eqP tr0; move: dev.
by rewrite tr0 mul0r raddf0 subr0 => /eqP.
Qed.

(* T9: in two or more dimensions the condition on mu and la is the exact one: the *)
(* energy is positive for every strain that is not zero if and only if it holds.  *)
Theorem T9_elastic_exact mu la : (1 < n)%N ->
  (forall S, S^T = S -> S != 0 -> 0 < energy_density mu la S) <-> elastic mu la.
Proof.
move=> n_gt1; have n_gt0 : (0 < n)%N := ltnW n_gt1.
split=> [pos|el S _ nzS]; last first.
  rewrite lt_neqAle T9_energy_ge0 // andbT eq_sym; apply: contra nzS => /eqP e0.
  exact/eqP/(T9_energy_eq0 el).
apply/andP; split; last first.
  have one0 : (1%:M : 'M[R]_n) != 0.
    by apply/eqP => /matrixP/(_ (Ordinal n_gt0) (Ordinal n_gt0)); rewrite !mxE eqxx => /eqP;
       rewrite oner_eq0.
  have := pos 1%:M (tr_scalar_mx _ _) one0.
  rewrite /energy_density dot_scalar_mx mul1r mxtrace1.
  have -> : mu * n%:R + la / 2%:R * n%:R ^+ 2 = n%:R / 2%:R * (n%:R * la + 2%:R * mu).
    rewrite mulrDr addrC; congr (_ + _); last by rewrite mulrA divfK ?pnatr_eq0 // mulrC.
    by rewrite [RHS]mulrACA [RHS]mulrC [_^-1 * la]mulrC expr2.
  by rewrite pmulr_rgt0 // divr_gt0 ?ltr0n.
pose i := Ordinal n_gt0; pose j := Ordinal n_gt1.
pose S : 'M[R]_n := delta_mx i j + delta_mx j i.
have symS : S^T = S by rewrite linearD /= !trmx_delta addrC.
have nzS : S != 0.
  by apply/eqP => /matrixP/(_ i j); rewrite !mxE !eqxx addr0 => /eqP; rewrite oner_eq0.
have trS : \tr S = 0.
  rewrite mxtraceD /mxtrace !big1 ?addr0 // => k _; rewrite mxE.
    by apply/eqP; rewrite pnatr_eq0 eqb0; apply/andP => -[/eqP-> /eqP/(congr1 val)].
  by apply/eqP; rewrite pnatr_eq0 eqb0; apply/andP => -[/eqP-> /eqP/(congr1 val)].
have := pos S symS nzS; rewrite /energy_density trS expr0n mulr0 addr0.
by move=> e_gt0; rewrite -(pmulr_lgt0 _ (x := dot S S)) // lt_neqAle dot_ge0 eq_sym dot_eq0 nzS.
Qed.

(* T9: the work of the forces of one displacement along another depends only on the *)
(* two strains, and in the same way on both: the stiffness of a cell is symmetric.  *)
Theorem T9_work vol mu la P U W :
  dot (forces vol mu la P U) W =
  vol * dot (stress mu la (strain (gradient P U))) (strain (gradient P W)).
Proof.
rewrite /forces dotZl; congr (_ * _); rewrite dot_strain ?trmx_stress ?trmx_strain //.
by rewrite /dot trmx_mul trmxK -mulmxA mxtrace_mulC -mulmxA.
Qed.

(* T9: hence the forces of U do the same work along W as the forces of W along U. *)
Theorem T9_work_symmetric vol mu la P U W :
  dot (forces vol mu la P U) W = dot (forces vol mu la P W) U.
Proof. by rewrite !T9_work !dot_stress [dot (strain _) _]dotC [la * _ * _]mulrAC. Qed.

(* T9: along its own displacement the work of the forces is twice the energy. *)
Theorem T9_work_self vol mu la P U :
  dot (forces vol mu la P U) U = 2%:R * (vol * energy_density mu la (strain (gradient P U))).
Proof. by rewrite T9_work dot_stress_self mulrCA. Qed.

(* T9: without strain there are no forces. *)
Theorem T9_forces_eq0 vol mu la P U : strain (gradient P U) = 0 -> forces vol mu la P U = 0.
Proof.
by move=> e0; rewrite /forces e0 /stress mxtrace0 mulr0 scaler0 raddf0 addr0 mul0mx scaler0.
Qed.

(* The work at all n + 1 vertices is that of F_1 .. F_n along w_1 - w_0 .. w_n - w_0. *)
Lemma work_closed (F : 'M[R]_n) (w : 'I_n.+1 -> 'cV[R]_n) :
  \sum_i dot (col i (closed F)) (w i) =
  dot F (\matrix_(a, j) (w (lift ord0 j) - w ord0) a 0).
Proof.
have dot_col v i : dot (col i (closed F)) v = \sum_a closed F a i * v a 0.
  by rewrite dotE big_ord1; apply: eq_bigr => a _; rewrite mxE.
rewrite big_ord_recl /= !dot_col dotE.
under [X in _ + X = _]eq_bigr do rewrite dot_col.
have -> : \sum_a closed F a ord0 * w ord0 a 0 = - \sum_j \sum_a F a j * w ord0 a 0.
  rewrite exchange_big -sumrN; apply: eq_bigr => a _.
  by rewrite mxE unlift_none mulNr mulr_suml.
rewrite addrC -sumrB; apply: eq_bigr => j _; rewrite -sumrB; apply: eq_bigr => a _.
by rewrite !mxE liftK mulrBr.
Qed.

End Cell.
