(* oriented_boundary.v : T10, the oriented boundary of a coherently oriented mesh is a     *)
(* cycle; hence also after unglue.  Tested against alternating cochains.       *)
From mathcomp Require Import all_ssreflect all_algebra fingroup perm.
From Cleave Require Import complex unglue orientation chain.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Alt.
Variables (V : finType) (R : numDomainType).
Definition alternating m (phi : m.-tuple V -> R) := forall a (s : 'S_m),
  phi [tuple tnth a (s i) | i < m] = (-1) ^+ odd_perm s * phi a.
Definition face m (a : m.+1.-tuple V) (i : 'I_m.+1) : m.-tuple V :=
  [tuple tnth a (lift i j) | j < m].
Definition bdryT m (phi : m.-tuple V -> R) (a : m.+1.-tuple V) : R :=
  \sum_(i < m.+1) (-1) ^+ i * phi (face a i).

Lemma perm_minor m (s : 'S_m.+1) i : exists r : 'S_m,
  (forall j, lift (s i) (r j) = s (lift i j)) /\ s = lift_perm i (s i) r.
Proof.
pose f j := odflt j (unlift (s i) (s (lift i j))).
have fE j : lift (s i) (f j) = s (lift i j).
  rewrite /f; have ne : s i != s (lift i j) by rewrite (inj_eq perm_inj) neq_lift.
  by have [k -> ->] := unlift_some ne.
have finj : injective f.
  by move=> j k e; apply: (@lift_inj _ i); apply: (@perm_inj _ s); rewrite -!fE e.
exists (perm finj); split=> [j|]; first by rewrite permE.
apply/permP => k; have [j ->|->] := unliftP i k; last by rewrite lift_perm_id.
by rewrite lift_perm_lift permE.
Qed.

Lemma bdry_alternating m (phi : m.-tuple V -> R) : alternating phi -> alternating (bdryT phi).
Proof.
move=> alt a s; rewrite /bdryT mulr_sumr [RHS](reindex_inj (@perm_inj _ s)) /=.
apply: eq_bigr => i _; have [r [rE sE]] := perm_minor s i.
have -> : face [tuple tnth a (s i0) | i0 < m.+1] i =
          [tuple tnth (face a (s i)) (r j) | j < m].
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
End Alt.

Section Cycle.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : ordering M) (R : numDomainType).
Hypothesis co : coherent o.
Variable psi : n.-tuple V -> R.
Hypothesis alt : alternating psi.
Definition ev (a : osimplex n V) : R := (-1) ^+ a.1 * psi a.2.
Let cf (x : T * 'I_n.+1) := ofac o x.1 x.2.
Definition interior x := [exists y, osame (mate (cf x)) (cf y)].

Lemma ev_same a b : osame a b -> ev a = ev b.
Proof.
case: a b => e a [f b] /existsP[s /andP[/= /eqP-> /eqP->]].
by rewrite /ev /= alt signr_addb -mulrA [(-1) ^+ odd_perm s * _]mulrA -signr_addb addbb mul1r.
Qed.
Lemma ev_mate a : ev (mate a) = - ev a.
Proof. by case: a => -[] a; rewrite /ev /= ?expr0 ?expr1 ?mul1r ?mulN1r ?opprK. Qed.

Lemma osame_sym a b : @osame n V a b -> osame b a.
Proof.
case/existsP=> s /andP[/eqP e1 /eqP e2]; apply/existsP; exists s^-1%g.
rewrite odd_permV e2 -addbA addbb addbF eqxx andbT.
by apply/eqP/eq_from_tnth => i; rewrite tnth_mktuple e1 tnth_mktuple permKV.
Qed.
Lemma osame_trans a b c : @osame n V a b -> osame b c -> osame a c.
Proof.
case/existsP=> s /andP[/eqP e1 /eqP e2] /existsP[r /andP[/eqP f1 /eqP f2]].
apply/existsP; exists (r * s)%g; rewrite odd_permM f2 e2 -addbA [odd_perm s (+) _]addbC eqxx andbT.
by apply/eqP/eq_from_tnth => i; rewrite f1 !tnth_mktuple e1 tnth_mktuple permM.
Qed.
Lemma osame_mates a b : @osame n V (mate a) b -> osame (mate b) a.
Proof.
move/osame_sym => /existsP[s /andP[/eqP e1 /eqP e2]]; apply/existsP; exists s.
by rewrite -e1 eqxx /=; move: e2 => /= /(congr1 negb); rewrite negbK => ->; rewrite addNb.
Qed.

Theorem interior_cancel :
  \sum_x ev (cf x) = \sum_(x | ~~ interior x) ev (cf x).
Proof.
pose g x := odflt x [pick y | osame (mate (cf x)) (cf y)].
have gP x : interior x -> osame (mate (cf x)) (cf (g x)).
  by move=> /existsP[y yP]; rewrite /g; case: pickP => [z //|/(_ y)]; rewrite yP.
have gI x : interior x -> interior (g x).
  by move=> /gP/osame_mates h; apply/existsP; exists x.
have ggx x : interior x -> g (g x) = x.
  move=> ix; have h1 := osame_mates (gP _ ix); have h2 := gP _ (gI _ ix).
  have := osame_trans (osame_sym h2) h1; have [inj _] := coherent_unique o.
  by move/(inj co); rewrite -!surjective_pairing.
rewrite (bigID interior) /= [X in X + _](_ : _ = 0) ?add0r //.
apply/eqP; rewrite -eqNr -sumrN; apply/eqP; rewrite [RHS](reindex_onto g g) //=.
apply: eq_big => [x|x ix]; last by rewrite -ev_mate; apply: ev_same; exact: gP.
apply/idP/andP => [ix|[igx /eqP gg]]; first by rewrite gI // ggx.
case ix: (interior x) => //; have gx : g x = x; last by move: igx; rewrite gx ix.
rewrite /g; case: pickP => // y yP; move/negbT/existsP: ix => []; by exists y.
Qed.
End Cycle.

Theorem T10_oriented n (V T : finType) (M : complex n.+1 V T) (o : ordering M)
  (R : numDomainType) (phi : n.-tuple V -> R) : coherent o -> alternating phi ->
  \sum_(x | ~~ interior o x) (-1) ^+ odd x.2 * bdryT phi (fac o x.1 x.2) = 0.
Proof.
move=> co alt; rewrite -[LHS](interior_cancel co (bdry_alternating alt)).
rewrite -(pair_bigA _ (fun t i => ev (bdryT phi) (ofac o t i))) /= big1 // => t _.
rewrite -[RHS](bdryT_bdryT phi (o t)); apply: eq_bigr => i _.
by rewrite /ev /= signr_odd.
Qed.

Corollary T10_oriented_unglue n (V T : finType) (M : complex n.+1 V T) (o : ordering M) C
  (R : numDomainType) (phi : n.-tuple (prod_finType V T) -> R) :
  coherent o -> alternating phi ->
  \sum_(x | ~~ interior (rord o (copyK M C)) x)
    (-1) ^+ odd x.2 * bdryT phi (fac (rord o (copyK M C)) x.1 x.2) = 0.
Proof. by move=> co; apply: T10_oriented; exact: T2_coherent. Qed.
