(******************************************************************************)
(* The oriented boundary of a coherent complex is a cycle (T10).              *)
(* Chains are tested against alternating cochains: functions of the order of  *)
(* m vertices that change sign with it. R is any ordered ring, for instance   *)
(* the integers: in it x = - x implies x = 0.                                 *)
(*   alternating phi == phi is alternating                                    *)
(*         value phi a == phi on the oriented simplex a                       *)
(*          face a i == the ordered simplex a without its i-th vertex         *)
(*    bdryT phi a    == phi on the boundary of a (bdry, for tuples)           *)
(*   T10_boundary_chain == the boundaries of all cells sum up to the oriented *)
(*                      boundary: interior half-facets cancel with their      *)
(*                      mates                                                 *)
(*   T10_oriented    == the oriented boundary is a cycle                      *)
(*   T10_oriented_unglue == so it is after unglue, for any cut                *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra fingroup perm.
From Cleave Require Import complex unglue orientation chain.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Alternating.
Variables (V : finType) (R : numDomainType).

Definition alternating m (phi : m.-tuple V -> R) := forall a (s : 'S_m),
  phi [tuple tnth a (s i) | i < m] = (-1) ^+ odd_perm s * phi a.

Definition face m (a : m.+1.-tuple V) (i : 'I_m.+1) : m.-tuple V :=
  [tuple tnth a (lift i j) | j < m].

Definition bdryT m (phi : m.-tuple V -> R) (a : m.+1.-tuple V) : R :=
  \sum_(i < m.+1) (-1) ^+ i * phi (face a i).

(* Leaving out the i-th element, a permutation is one of the others.          *)
Lemma perm_minor m (s : 'S_m.+1) i : exists2 r : 'S_m,
  forall j, lift (s i) (r j) = s (lift i j) & s = lift_perm i (s i) r.
Proof.
pose f j := odflt j (unlift (s i) (s (lift i j))).
have fE j : lift (s i) (f j) = s (lift i j).
  have ne : s i != s (lift i j) by rewrite (inj_eq perm_inj) neq_lift.
  by rewrite /f; have [k -> ->] := unlift_some ne.
have finj : injective f.
  by move=> j k e; apply: (@lift_inj _ i); apply: (@perm_inj _ s); rewrite -!fE e.
exists (perm finj) => [j|]; first by rewrite permE.
apply/permP => k; have [j ->|->] := unliftP i k; last by rewrite lift_perm_id.
by rewrite lift_perm_lift permE.
Qed.

Lemma bdry_alternating m (phi : m.-tuple V -> R) : alternating phi -> alternating (bdryT phi).
Proof.
move=> alt a s; rewrite /bdryT mulr_sumr [RHS](reindex_inj (@perm_inj _ s)) /=.
apply: eq_bigr => i _; have [r rE sE] := perm_minor s i.
have -> : face [tuple tnth a (s j) | j < m.+1] i = [tuple tnth (face a (s i)) (r j) | j < m].
  by apply: eq_from_tnth => j; rewrite !tnth_mktuple rE.
rewrite alt !mulrA; congr (_ * _).
have -> : odd_perm s = odd i (+) odd (s i) (+) odd_perm r by rewrite {1}sE odd_lift_perm.
rewrite -(signr_odd _ i) -(signr_odd _ (s i)) -!signr_addb; congr ((-1) ^+ nat_of_bool _).
by case: (odd i); case: (odd (s i)); case: (odd_perm r).
Qed.

Lemma face_del m (a : m.+1.-tuple V) i : face a i = del i a :> seq V.
Proof.
have x0 : V := tnth a ord0.
apply: (@eq_from_nth _ x0) => [|k].
  rewrite size_tuple /del size_cat size_take size_drop size_tuple ltn_ord.
  by rewrite subSS subnKC // -ltnS.
rewrite size_tuple => km; have -> : nth x0 (face a i) k = tnth (face a i) (Ordinal km).
  by rewrite (tnth_nth x0).
rewrite tnth_mktuple (tnth_nth x0) /= /del nth_cat size_take size_tuple ltn_ord /bump.
case: ltnP => ki; first by rewrite add0n nth_take.
by rewrite nth_drop addSn add1n subnKC.
Qed.

Lemma bdryT_bdryT m (phi : m.-tuple V -> R) a : bdryT (bdryT phi) a = 0.
Proof.
pose psi (s : seq V) : R := if insub s is Some t then phi t else 0.
rewrite -[RHS](bdry_bdry m psi a) /bdryT /bdry.
apply: eq_bigr => i _; congr (_ * _); apply: eq_bigr => j _; congr (_ * _).
by rewrite -face_del -face_del /psi valK.
Qed.

Definition value m (phi : m.-tuple V -> R) (a : osimplex m V) : R := (-1) ^+ a.1 * phi a.2.

Lemma value_osame m (phi : m.-tuple V -> R) a b :
  alternating phi -> osame a b -> value phi a = value phi b.
Proof.
move=> alt /existsP[s /andP[/eqP eV /eqP sgn]]; rewrite /value eV sgn alt signr_addb.
by rewrite -mulrA [(-1) ^+ odd_perm s * _]mulrA -signr_addb addbb mul1r.
Qed.

Lemma value_mate m (phi : m.-tuple V -> R) a : value phi (mate a) = - value phi a.
Proof. by rewrite /value /= signrN mulNr. Qed.

End Alternating.

Section Cycle.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : orientation M).
Hypothesis co : coherent o.
Variables (R : numDomainType).
Local Notation hf x := (half_facet o x.1 x.2).

(* T10: interior half-facets cancel with their mates in the sum of the
   boundaries of all cells; what remains is the oriented boundary.            *)
Theorem T10_boundary_chain (psi : n.-tuple V -> R) : alternating psi ->
  \sum_(x : T * 'I_n.+1) value psi (hf x) =
  \sum_(x : T * 'I_n.+1 | oset (hf x) \in boundary M) value psi (hf x).
Proof.
move=> alt; pose interior x := [exists y : T * 'I_n.+1, osame (mate (hf x)) (hf y)].
have interiorE x : interior x = (oset (hf x) \notin boundary M).
  rewrite half_facet_set boundaryP ?corner_tnth // negbK.
  apply/existsP/existsP => -[y xy].
    by exists (tnth (o y.1) y.2, y.1); rewrite -half_facet_mates.
  have cy : corner M y by case/and4P: xy.
  by have [k yE] := tnth_corner o cy; exists (y.2, k); rewrite half_facet_mates // -yE.
pose g x := odflt x [pick y | osame (mate (hf x)) (hf y)].
have gP x : interior x -> osame (mate (hf x)) (hf (g x)).
  by move=> /existsP[y yP]; rewrite /g; case: pickP => [z //|/(_ y)]; rewrite yP.
have gI x : interior x -> interior (g x).
  by move=> /gP xg; apply/existsP; exists x; rewrite osame_mate osame_sym.
have gK x : interior x -> g (g x) = x.
  move=> ix; have /coherent_each_in_one_cell one := co.
  have : osame (hf (g (g x))) (hf x).
    rewrite osame_sym; apply: osame_trans (gP _ (gI _ ix)).
    by rewrite -osame_mate; exact: gP.
  by move/one; rewrite -!surjective_pairing.
rewrite (bigID interior) /= [X in X + _](_ : _ = 0) ?add0r.
  by apply: eq_bigl => x; rewrite interiorE negbK.
apply/eqP; rewrite -eqNr -sumrN; apply/eqP; rewrite [RHS](reindex_onto g g) //=.
apply: eq_big => [x|x ix]; last by rewrite -value_mate; apply: value_osame => //; exact: gP.
apply/idP/andP => [ix|[igx /eqP gg]]; first by rewrite gI // gK.
by rewrite -gg; apply: gI.
Qed.

End Cycle.

(* T10: the oriented boundary has no boundary.                                *)
Theorem T10_oriented n (V T : finType) (M : complex n.+1 V T) (o : orientation M)
    (R : numDomainType) (phi : n.-tuple V -> R) : coherent o -> alternating phi ->
  \sum_(x : T * 'I_n.+2 | oset (half_facet o x.1 x.2) \in boundary M)
     value (bdryT phi) (half_facet o x.1 x.2) = 0.
Proof.
move=> co alt; rewrite -(T10_boundary_chain co (bdry_alternating alt)).
rewrite -(pair_bigA _ (fun t i => value (bdryT phi) (half_facet o t i))) /= big1 // => t _.
rewrite /value /half_facet /=; under eq_bigr do rewrite signr_addb -mulrA signr_odd.
by rewrite -mulr_sumr [X in _ * X](bdryT_bdryT phi (o t)) mulr0.
Qed.

(* T10: nor has it after unglue, for any cut.                                 *)
Theorem T10_oriented_unglue n (V T : finType) (M : complex n.+1 V T) (o : orientation M) C
    (R : numDomainType) (phi : n.-tuple (prod_finType V T) -> R) :
  let o' := relabelled_orientation o (copyK M C) in coherent o -> alternating phi ->
  \sum_(x : T * 'I_n.+2 | oset (half_facet o' x.1 x.2) \in boundary (unglue M C))
     value (bdryT phi) (half_facet o' x.1 x.2) = 0.
Proof. by move=> o' co; apply: T10_oriented; exact: T2_coherent. Qed.
