(* orientation.v : T2 and Algorithm 5 (T13).                                  *)
From mathcomp Require Import all_ssreflect fingroup perm.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* signed ordered simplexes; osame = same oriented simplex                    *)
Section OSimplex.
Variables (n : nat) (V : finType).
Definition osimplex := (bool * n.-tuple V)%type.
Implicit Types (a b : osimplex).
Definition osame (a b : osimplex) :=
  [exists s : 'S_n, (b.2 == [tuple tnth a.2 (s i) | i < n]) && (b.1 == a.1 (+) odd_perm s)].
Definition mate (a : osimplex) : osimplex := (~~ a.1, a.2).
Definition oset (a : osimplex) : {set V} := [set x in a.2].

Lemma osame_oset a b : osame a b -> oset a = oset b.
Proof.
case/existsP=> s /andP[/eqP e _]; apply/setP=> x; rewrite !inE e.
apply/tnthP/tnthP => [[i ->]|[i ->]]; last by exists (s i); rewrite tnth_mktuple.
by exists (s^-1 i)%g; rewrite tnth_mktuple permKV.
Qed.

(* sign is determined on duplicate-free tuples                                *)
Lemma osame_mate a b : uniq a.2 -> osame a b -> osame (mate a) b -> False.
Proof.
move=> /tuple_uniqP ua /existsP[s /andP[/eqP e1 /eqP e2]] /existsP[r /andP[/eqP f1 /eqP f2]].
suff sr : s = r by move: f2; rewrite /= e2 sr; case: a.1; case: odd_perm.
apply/permP => i; apply: ua.
have := congr1 (fun z : n.-tuple V => tnth z i) e1; rewrite f1 !tnth_mktuple /=.
by move=> ->.
Qed.

Lemma osame_refl a : osame a a.
Proof.
apply/existsP; exists 1%g; rewrite odd_perm1 addbF eqxx andbT.
by apply/eqP/eq_from_tnth => i; rewrite tnth_mktuple perm1.
Qed.

Lemma osame_or_mate a b : uniq a.2 -> uniq b.2 -> oset a = oset b ->
  osame a b || osame (mate a) b.
Proof.
move=> ua ub /setP ab.
have /tuple_permP[s es] : perm_eq b.2 a.2.
  by apply: uniq_perm => // x; have := ab x; rewrite !inE => ->.
have e : b.2 = [tuple tnth a.2 (s i) | i < n] by apply: val_inj.
case E: (b.1 == a.1 (+) odd_perm s).
  by apply/orP; left; apply/existsP; exists s; rewrite E {1}e eqxx.
apply/orP; right; apply/existsP; exists s; rewrite {1}e eqxx /=.
by move: E; case: b.1; case: a.1; case: odd_perm.
Qed.
End OSimplex.

Section Oriented.
Variables (n : nat) (V T : finType) (M : complex n V T).

Record ordering := Ordering {
  ord_of :> T -> n.+1.-tuple V;
  ord_set : forall t, [set x in ord_of t] = M t }.
Variable o : ordering.

Lemma ord_uniq t : uniq (o t).
Proof.
apply/card_uniqP; rewrite size_tuple; apply: etrans (card_vertices M t).
by rewrite -(ord_set o t); apply: eq_card => x; rewrite !inE.
Qed.

Definition fac t (i : 'I_n.+1) : n.-tuple V := [tuple tnth (o t) (lift i j) | j < n].
Definition ofac t (i : 'I_n.+1) : osimplex n V := (odd i, fac t i).

Lemma fac_uniq t i : uniq (fac t i).
Proof.
apply/tuple_uniqP => j k; rewrite !tnth_mktuple.
by have /tuple_uniqP inj := ord_uniq t; move=> /inj/lift_inj.
Qed.

Lemma ofac_uniq t i : uniq (ofac t i).2. Proof. exact: fac_uniq. Qed.

Lemma fac_set t i : oset (ofac t i) = M t :\ tnth (o t) i.
Proof.
have /tuple_uniqP inj := ord_uniq t.
apply/setP=> x; rewrite -(ord_set o t) !inE; apply/tnthP/andP => [[j ->]|[xi /tnthP[k e]]].
  rewrite tnth_mktuple mem_tnth; split=> //; apply/eqP=> /inj/eqP.
  by rewrite eq_sym (negPf (neq_lift _ _)).
have ki : i != k by apply: contra xi => /eqP->; rewrite e.
by case: (unlift_some ki) => j kj _; exists j; rewrite tnth_mktuple -kj.
Qed.

Lemma fac_index t i j : oset (ofac t i) = oset (ofac t j) -> i = j.
Proof.
rewrite !fac_set => e; have /tuple_uniqP inj := ord_uniq t.
apply: inj; apply/eqP; apply/negPn/negP => ne.
have : tnth (o t) i \in M t :\ tnth (o t) j.
  by rewrite !inE ne -(ord_set o t) inE mem_tnth.
by rewrite -e !inE eqxx.
Qed.

(* coherent: shared facets get opposite orientations                          *)
Definition coherent := forall t i u j, t != u ->
  oset (ofac t i) = oset (ofac u j) -> osame (mate (ofac t i)) (ofac u j).

(* "each oriented triangle is part of precisely one tetrahedron"               *)
Definition ofac_injective := forall t i u j,
  osame (ofac t i) (ofac u j) -> (t, i) = (u, j).

Theorem coherent_unique : coherent <-> ofac_injective.
Proof.
split=> [co t i u j s|inj t i u j tu e].
  have e := osame_oset s.
  have [tu|tu] := eqVneq t u; first by subst u; rewrite (fac_index e).
  by case: (osame_mate (ofac_uniq t i) s (co _ _ _ _ tu e)).
have /orP[s|//] := osame_or_mate (ofac_uniq t i) (ofac_uniq u j) e.
by case: (inj _ _ _ _ s) tu => -> _; rewrite eqxx.
Qed.

(* Algorithm 5: look up the mate of facet j of t, return the backlink         *)
Definition neighbour t j : option T :=
  omap fst [pick x : T * 'I_n.+1 | osame (mate (ofac t j)) (ofac x.1 x.2)].

Theorem T13_alg5 t j u : coherent ->
  (neighbour t j = Some u) <-> (u != t /\ M t :\ tnth (o t) j \subset M u).
Proof.
move=> co; rewrite /neighbour; split.
  case: pickP => // -[u' k] /= s [<-].
  have e : oset (ofac t j) = oset (ofac u' k) := osame_oset s.
  split; last by rewrite -fac_set e fac_set subsetDl.
  apply/eqP => tu; subst u'; have jk := fac_index e; subst k.
  exact: osame_mate (ofac_uniq t j) (osame_refl _) s.
move=> [ut sub].
have [k e] : exists k, oset (ofac t j) = oset (ofac u k).
  have c1 : #|M u :\: (M t :\ tnth (o t) j)| = 1.
    have tj : tnth (o t) j \in M t by rewrite -(ord_set o t) inE mem_tnth.
    have := cardsD1 (tnth (o t) j) (M t); rewrite tj card_vertices add1n => -[c].
    by rewrite cardsD (setIidPr sub) card_vertices -c subSnn.
  have /cards1P[x xE] : #|M u :\: (M t :\ tnth (o t) j)| == 1 by rewrite c1.
  have /tnthP[k xk] : x \in o u.
    have : x \in M u :\: (M t :\ tnth (o t) j) by rewrite xE inE.
    by rewrite inE => /andP[_]; rewrite -(ord_set o u) inE.
  exists k; rewrite !fac_set -xk -xE; apply/setP=> y; rewrite !inE.
  case yu: (y \in M u); rewrite ?andbT ?andbF ?negbK //.
  by apply: contraFF yu => yt; rewrite (subsetP sub) // !inE.
have s := co t j u k; rewrite eq_sym in s; have {}s := s ut e.
case: pickP => [[u' k'] /= s'|/(_ (u, k))]; last by rewrite /= s.
have e' : oset (ofac t j) = oset (ofac u' k') := osame_oset s'.
have [-> //|u'u] := eqVneq u' u.
have ee : oset (ofac u' k') = oset (ofac u k) by rewrite -e' e.
have s'' := co _ _ _ _ u'u ee.
case: (existsP s) => r /andP[/eqP r1 /eqP r2].
case: (existsP s') => r' /andP[/eqP r1' /eqP r2'].
case: (existsP s'') => q /andP[/eqP q1 /eqP q2].
(* fac u k = fac t j o r ; fac u' k' = fac t j o r' ; fac u k = fac u' k' o q *)
have /tuple_uniqP inj := fac_uniq t j.
have rq : r = (q * r')%g.
  apply/permP => i; rewrite permM; apply: inj.
  have hr : tnth (ofac u k).2 i = tnth (ofac t j).2 (r i) by rewrite r1 tnth_mktuple.
  have hq : tnth (ofac u k).2 i = tnth (ofac u' k').2 (q i) by rewrite q1 tnth_mktuple.
  have hr' : tnth (ofac u' k').2 (q i) = tnth (ofac t j).2 (r' (q i)).
    by rewrite r1' tnth_mktuple.
  by have := hr; rewrite hq hr'.
have : (ofac u k).1 = ~~ (ofac u' k').1 (+) odd_perm q := q2.
rewrite r2 r2' rq odd_permM /=.
by case: (odd j); case: (odd_perm q); case: (odd_perm r').
Qed.

Corollary T13_unique_neighbour t j u w : coherent ->
  u != t -> w != t -> M t :\ tnth (o t) j \subset M u -> M t :\ tnth (o t) j \subset M w ->
  u = w.
Proof.
move=> co ut wt su sw.
have /(T13_alg5 _ _ _ co) e1 : u != t /\ M t :\ tnth (o t) j \subset M u by [].
have /(T13_alg5 _ _ _ co) e2 : w != t /\ M t :\ tnth (o t) j \subset M w by [].
by move: e1; rewrite e2 => -[].
Qed.
End Oriented.

(* T2: unglue (any relabelling) keeps a coherent orientation coherent, and the *)
(* oriented facets keep their (cell, index) names: no object is created.       *)
Section Preserve.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : ordering M).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.
Let R := relabel M pK.

Lemma rord_set t : [set x in [tuple lab (tnth (o t) i, t) | i < n.+1]] = R t.
Proof.
apply/setP=> w; rewrite inE; apply/tnthP/imsetP => [[i ->]|[v]].
  by exists (tnth (o t) i); rewrite ?tnth_mktuple // -(ord_set o t) inE mem_tnth.
by rewrite -(ord_set o t) inE => /tnthP[i ->] ->; exists i; rewrite tnth_mktuple.
Qed.
Definition rord : ordering R := Ordering rord_set.

Lemma rfac t i k : tnth (fac rord t i) k = lab (tnth (fac o t i) k, t).
Proof. by rewrite !tnth_mktuple. Qed.

Theorem T2_coherent : coherent o -> coherent rord.
Proof.
move=> co t i u j tu e.
have mem v u1 j1 : (v \in oset (ofac o u1 j1)) = (lab (v, u1) \in oset (ofac rord u1 j1)).
  rewrite !inE /=; apply/tnthP/tnthP => [[k ->]|[k]]; first by exists k; rewrite rfac.
  by rewrite rfac => /(congr1 p); rewrite !pK /= => ->; exists k.
have same v : v \in oset (ofac o u j) -> v \in oset (ofac o t i) /\ lab (v, u) = lab (v, t).
  rewrite mem -e inE /= => /tnthP[k]; rewrite rfac => q.
  have := congr1 p q; rewrite !pK /= => vE; rewrite q -vE; split=> //.
  by rewrite inE /= vE mem_tnth.
have same' v : v \in oset (ofac o t i) -> v \in oset (ofac o u j).
  rewrite mem e inE /= => /tnthP[k]; rewrite rfac => q.
  by have := congr1 p q; rewrite !pK /= => ->; rewrite inE /= mem_tnth.
have e0 : oset (ofac o t i) = oset (ofac o u j).
  by apply/setP=> v; apply/idP/idP => [/same'//|/same[]].
have /existsP[s /andP[/eqP s1 s2]] := co t i u j tu e0.
apply/existsP; exists s; rewrite s2 andbT; apply/eqP/eq_from_tnth => k.
rewrite [RHS]tnth_mktuple [(ofac rord u j).2]/(fac rord u j) !rfac.
have kE : tnth (fac o u j) k = tnth (fac o t i) (s k).
  have -> : fac o u j = (ofac o u j).2 by [].
  by rewrite s1 tnth_mktuple.
rewrite -kE; apply: (same _ _).2; by rewrite inE mem_tnth.
Qed.

Theorem T2_half_facets t i u j : coherent o ->
  osame (ofac rord t i) (ofac rord u j) <-> osame (ofac o t i) (ofac o u j).
Proof.
move=> co; have [i1 _] := coherent_unique o; have [i2 _] := coherent_unique rord.
split=> [/(i2 (T2_coherent co)) [-> ->]|/(i1 co) [-> ->]]; exact: osame_refl.
Qed.
End Preserve.

Section More.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : ordering M).
Hypothesis co : coherent o.

Lemma facet_index t (f : {set V}) : #|f| = n -> f \subset M t ->
  exists j, f = M t :\ tnth (o t) j.
Proof.
move=> cf ft.
have /cards1P[x xE] : #|M t :\: f| == 1 by rewrite cardsD (setIidPr ft) card_vertices cf subSnn.
have xt : x \in M t :\: f by rewrite xE inE.
have /tnthP[j xj] : x \in o t by move: xt; rewrite inE -(ord_set o t) inE => /andP[].
exists j; rewrite -xj -xE; apply/setP=> y; rewrite !inE.
case yt: (y \in M t); rewrite ?andbT ?andbF ?negbK //.
by apply: contraFF yt => /(subsetP ft).
Qed.

(* an orientable (coherently ordered) mesh is a pseudo-manifold                *)
Theorem coherent_pseudo_manifold : pseudo_manifold M.
Proof.
move=> f cf; case: (set_0Vmem (cofaces M f)) => [->|[t]]; first by rewrite cards0.
rewrite inE => ft; have [j fj] := facet_index cf ft.
rewrite (cardsD1 t) inE ft add1n ltnS; apply/card_le1P => u.
rewrite !inE => /andP[ut fu] w; rewrite !inE; apply/andP/eqP => [[wt fw]|->//].
by apply: (T13_unique_neighbour co (j := j) wt ut); rewrite -fj.
Qed.

(* Step 2 of Algorithm 3: the flood driven by Algorithm 5                      *)
Definition flood_step v : rel T := fun t u =>
  [exists j, (v \in M t :\ tnth (o t) j) && (neighbour o t j == Some u)].
Theorem flood_step_glue v t u :
  flood_step v t u = glue M set0 (v, t) (v, u).
Proof.
apply/existsP/idP => [[j /andP[vf /eqP/(T13_alg5 _ _ _ co)[ut sub]]]|/and4P[_ /= vi a _]].
  have cf : #|M t :\ tnth (o t) j| = n.
    have := cardsD1 (tnth (o t) j) (M t); rewrite card_vertices.
    by rewrite -(ord_set o t) inE mem_tnth add1n => -[].
  have e : common M t u = M t :\ tnth (o t) j.
    by apply: (common_facet cf) => //; rewrite ?subsetDl // eq_sym.
  by rewrite /glue /adjacent /= e eqxx vf cf eqxx inE.
have [j fj] := facet_index (eqP a) (subsetIl _ _ : common M t u \subset M t).
exists j; rewrite -fj vi; apply/eqP/(T13_alg5 _ _ _ co).
by rewrite eq_sym (adjacent_neq a) -fj subsetIr.
Qed.
End More.
