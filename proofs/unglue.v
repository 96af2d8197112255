(* unglue.v : Algorithm 3 as a relabelling; P1-T6_local, T8, T9_pieces, T12, T13.          *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Export connectivity complex isomorphism relabelling.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Unglue.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

Definition copy C x : V * T := root (glue M C) x.
Lemma copyK C x : (copy C x).1 = x.1.
Proof. by rewrite -(connect_fst (connect_root (glue M C) x)). Qed.

Lemma copy_eq C x y : (copy C x == copy C y) = connect (glue M C) x y.
Proof. by rewrite (root_connect (glue_csym M C)). Qed.

(* new vertices live in V * T; fst is the projection "copy of"                *)
Definition unglue C : complex n (prod_finType V T) T := relabel M (copyK C).

Lemma unglueE C t : unglue C t = [set copy C (v, t) | v in M t]. Proof. by []. Qed.

Lemma mem_copy C v t : v \in M t -> copy C (v, t) \in unglue C t.
Proof. by move=> vt; rewrite unglueE; apply/imsetP; exists v. Qed.

(* P1 is carried by the type of unglue: card n.+1, injective, same T.         *)
Theorem T1_card C t : #|unglue C t| = n.+1. Proof. exact: card_vertices. Qed.
Theorem T1_inj C : injective (unglue C). Proof. exact: vertices_inj. Qed.
Theorem T1_proj C t : fst @: unglue C t = M t. Proof. exact: stitch. Qed.

(* T2_pseudo_manifold *)
Theorem T2_pseudo_manifold C : pseudo_manifold M -> pseudo_manifold (unglue C).
Proof. exact: relabel_pseudo_manifold. Qed.

Lemma copy_respects C : respects M (copy C) C.
Proof. by move=> x y g; apply/eqP; rewrite copy_eq; exact: connect1. Qed.

(* P3 : exact boundary characterisation                                       *)
Theorem T3_adjacent C t u :
  adjacent (unglue C) t u =
  adjacent M t u && [forall v in common M t u, connect (glue M C) (v, t) (v, u)].
Proof.
rewrite adjacent_relabel; congr (_ && _); apply: eq_forallb => v.
by rewrite copy_eq.
Qed.

(* a facet of t, given by its opposite vertex v, is a boundary facet          *)
Definition boundary_facet (W : finType) (N : complex n W T) t (f : {set W}) :=
  [&& f \subset N t, #|f| == n & [forall u, (u != t) ==> ~~ (f \subset N u)]].

Lemma boundary_facetP (W : finType) (N : complex n W T) t (f : {set W}) :
  f \subset N t -> #|f| = n ->
  boundary_facet N t f = ~~ [exists u, adjacent N t u && (common N t u == f)].
Proof.
move=> ft cf; rewrite /boundary_facet ft cf eqxx /= negb_exists; apply: eq_forallb => u.
have [->|ut /=] := eqVneq u t; first by rewrite adjacent_irr.
congr (~~ _); apply/idP/andP => [fu|[a /eqP<-]]; last exact: subsetIr.
have e : common N t u = f by apply: (common_facet cf) => //; rewrite eq_sym.
by rewrite /adjacent e cf !eqxx.
Qed.

Theorem T3_boundary C t (f : {set V * T}) : f \subset unglue C t -> #|f| = n ->
  boundary_facet (unglue C) t f =
  [forall u, (adjacent M t u && (common M t u == fst @: f)) ==>
     [exists v in fst @: f, ~~ connect (glue M C) (v, t) (v, u)]].
Proof.
move=> ft cf; rewrite boundary_facetP // negb_exists; apply: eq_forallb => u.
rewrite T3_adjacent; case a: (adjacent M t u) => //=.
rewrite negb_and -implybE.
have [e|ne] /= := eqVneq (common M t u) (fst @: f); last first.
  apply/implyP => /forall_inP same; apply: contra ne => /eqP <-; apply/eqP.
  apply/esym/p_common_adjacent; rewrite adjacent_relabel a; apply/forall_inP => v vi.
  by rewrite copy_eq same.
rewrite -negb_forall_in -e; case: forall_inP => //= same.
rewrite /common /= (_ : common (unglue C) t u == f) //.
have au : adjacent (unglue C) t u by rewrite T3_adjacent a; apply/forall_inP.
rewrite eq_sym eqEcard (eqP au) cf leqnn andbT.
apply/subsetP => w wf; rewrite inE (subsetP ft) //=.
have pw : w.1 \in common M t u by rewrite e imset_f.
have := subsetP ft _ wf; rewrite (mem_relabelled M (copyK C)) => /andP[_ /eqP we].
rewrite (mem_relabelled M (copyK C)); have := pw; rewrite inE => /andP[_ ->] /=.
by rewrite -[X in _ == X]we copy_eq glue_csym same.
Qed.

(* "only these triangles": *)
Corollary T3_only C t u : adjacent M t u -> common M t u \notin C -> adjacent (unglue C) t u.
Proof. by move=> a nC; apply: (respects_adjacent (copyK C) (@copy_respects C)). Qed.
Corollary T3_old C t u : adjacent (unglue C) t u -> adjacent M t u.
Proof. exact: adjacent_relabel_sub. Qed.

(* Universal property = Definition 2: unglue is the finest vertex splitting   *)
(* among those that open only facets of C.                                    *)
Theorem T7_universal C (W : finType) (p : W -> V) (lab : V * T -> W)
  (pK : forall x, p (lab x) = x.1) :
  (forall t u, adjacent M t u -> ~~ adjacent (relabel M pK) t u -> common M t u \in C) ->
  exists h : V * T -> W, forall x, lab x = h (copy C x).
Proof.
move=> /(respectsP M pK) r; exists lab => x.
by apply: (respects_connect r); exact: connect_root.
Qed.

Corollary T7_shut C (W : finType) (p : W -> V) (lab : V * T -> W)
  (pK : forall x, p (lab x) = x.1) t u :
  (forall t u, adjacent M t u -> ~~ adjacent (relabel M pK) t u -> common M t u \in C) ->
  adjacent (unglue C) t u -> adjacent (relabel M pK) t u.
Proof.
move=> H; have [h hE] := T7_universal H.
rewrite !adjacent_relabel => /andP[-> /forall_inP same]; apply/forall_inP => v vi.
by rewrite !hE (eqP (same _ vi)).
Qed.

(* T4_cut_regular : the result is regular for the lifted cut, a fortiori cut-regular      *)
Theorem T4_lifted C : regular (unglue C) (lifted fst C).
Proof.
move=> w t u /imsetP[v vt ->] /imsetP[v' v'u e].
have vv' : v = v' by have := congr1 fst e; rewrite !copyK.
subst v'; have := connect_relabel (copyK C) (v, t) (v, u) (@copy_respects C).
by rewrite /up /= -e -copy_eq e eqxx => ->.
Qed.
Theorem T4_cut_regular C : cut_regular (unglue C).
Proof. exact: regularS (sub0set _) (@T4_lifted C). Qed.

(* T5_empty_cut *)
Theorem T5_regular C : regular M C -> isomorphic (unglue C) M.
Proof.
move=> r; exists fst; last by move=> t; rewrite T1_proj.
move=> w1 w2; rewrite !used_relabel => /imsetP[[v t] vt ->] /imsetP[[v' u] v'u ->].
rewrite !copyK /= => e; subst v'; apply/eqP; rewrite copy_eq; exact: r.
Qed.
Corollary T5_empty_cut : cut_regular M -> isomorphic (unglue set0) M. Proof. exact: T5_regular. Qed.

(* converse: fst is an isomorphism only if M is C-regular                     *)
Theorem T5_converse C : {in used (unglue C) &, injective fst} -> regular M C.
Proof.
move=> inj v t u vt vu; rewrite -copy_eq; apply/eqP/inj; rewrite ?copyK //.
  by apply/usedP; exists t; exact: mem_copy.
by apply/usedP; exists u; exact: mem_copy.
Qed.

(* T6_local : locality *)
Theorem T6_local C v : cut_regular M -> (forall f, f \in C -> v \notin f) ->
  {in star M v &, forall t u, copy C (v, t) = copy C (v, u)}.
Proof.
move=> r off t u; rewrite !inE => vt vu; apply/eqP.
by rewrite copy_eq connect_local //; apply: r.
Qed.

(* T6_local counting *)
Definition ncopies C v := #|[set copy C (v, t) | t in star M v]|.
Theorem T6_count C : #|used (unglue C)| = \sum_(v in used M) ncopies C v.
Proof.
rewrite -sum1_card (partition_big fst (mem (used M))) /=; last first.
  move=> w; rewrite used_relabel => /imsetP[[v t] vt ->]; rewrite copyK.
  by apply/usedP; exists t.
apply: eq_bigr => v vM; rewrite sum1_card /ncopies; apply: eq_card => w.
rewrite unfold_in; apply/andP/imsetP => [[]|[t]].
  move=> /usedP[t /imsetP[v' vt ->]] /eqP; rewrite copyK /= => e; subst v'.
  by exists t; rewrite ?inE.
rewrite inE => vt ->; rewrite copyK; split=> //.
by apply/usedP; exists t; exact: mem_copy.
Qed.

Corollary T6_new C : #|used (unglue C)| =
  #|used M| + \sum_(v in used M) (ncopies C v).-1.
Proof.
rewrite T6_count -sum1_card -big_split; apply: eq_bigr => v /usedP[t vt] /=.
rewrite add1n prednK //; apply/card_gt0P; exists (copy C (v, t)).
by apply/imsetP; exists t; rewrite ?inE.
Qed.

(* T8 : monotonicity                                                          *)
Theorem T8_mono C C' x y : C \subset C' -> copy C' x = copy C' y -> copy C x = copy C y.
Proof.
move=> s /eqP; rewrite copy_eq => c; apply/eqP; rewrite copy_eq.
exact: connect_subset s c.
Qed.

(* facets that really open                                                    *)
Definition closed C f := [exists t, exists u,
   [&& adjacent (unglue C) t u & common M t u == f]].
Definition opened C : {set {set V}} := [set f in C | ~~ closed C f].

(* removing from the cut the facets that stay closed changes nothing          *)
Theorem opened_same C x y : pseudo_manifold M ->
  connect (glue M (opened C)) x y = connect (glue M C) x y.
Proof.
move=> pm; have oC : opened C \subset C by apply/subsetP=> f; rewrite inE => /andP[].
apply/idP/idP; last exact: connect_subset.
apply: connect_sub => {x y} [[v t] [w u]] /and4P[/= /eqP<- vi a].
rewrite inE; case: (boolP (_ \in C)) => [iC|nC _] /=; last first.
  by apply: connect1; rewrite /glue /= eqxx vi a.
rewrite negbK => /existsP[t' /existsP[u' /andP[a' /eqP e]]].
have vi' : v \in common M t' u' by rewrite e.
have ca := T3_old a'.
have /forall_inP/(_ _ vi') c : [forall v in common M t' u', connect (glue M C) (v, t') (v, u')].
  by move: a'; rewrite T3_adjacent => /andP[].
have tu := adjacent_neq a; have tu' := adjacent_neq ca.
have sub2 : [set t; u] = cofaces M (common M t u) .
  apply/eqP; rewrite eqEcard; apply/andP; split.
    by apply/subsetP => z; rewrite !inE => /orP[]/eqP->; rewrite ?subsetIl ?subsetIr.
  by rewrite cards2 tu; apply: pm; exact/eqP.
have t'i : t' \in [set t; u] by rewrite sub2 inE -e subsetIl.
have u'i : u' \in [set t; u] by rewrite sub2 inE -e subsetIr.
move: t'i u'i tu' c; rewrite !inE => /orP[]/eqP-> /orP[]/eqP->; rewrite ?eqxx //.
by move=> _; rewrite glue_csym.
Qed.

(* T9_pieces : connected components                                                  *)
Definition dual C : rel T := fun t u => adjacent M t u && (common M t u \notin C).

Lemma connect_dual C x y : connect (glue M C) x y -> connect (dual C) x.2 y.2.
Proof.
apply: (@connect_homo _ _ _ _ snd) => a b /and4P[_ _ ab nC].
by apply: connect1; rewrite /dual ab.
Qed.

Theorem T9_pieces C : 0 < n ->
  connect (adjacent (unglue C)) =2 connect (dual C).
Proof.
move=> n0 t u; apply/idP/idP; last first.
  by apply: connect_sub => a b /andP[ab nC]; apply/connect1/T3_only.
apply: connect_sub => a b; rewrite T3_adjacent => /andP[ab /forall_inP same].
have /card_gt0P[v vi] : 0 < #|common M a b| by rewrite (eqP ab).
by have := connect_dual (same v vi).
Qed.

(* sharing a vertex => same component, in a cut-regular mesh                  *)
Theorem T9_vertex v t u : cut_regular M -> v \in M t -> v \in M u ->
  connect (adjacent M) t u.
Proof.
move=> r vt vu; have := connect_dual (r v t u vt vu); apply: connect_sub => a b.
by move=> /andP[/connect1].
Qed.

(* T13 : the flood at v from t                                                *)
Definition flood v t : {set T} := [set u | connect (glue M set0) (v, t) (v, u)].
Theorem T13_flood : cut_regular M <->
  (forall v t, v \in M t -> flood v t = star M v).
Proof.
split=> [r v t vt|fl v t u vt vu].
  apply/setP=> u; rewrite !inE; apply/idP/idP => [c|vu]; last exact: r.
  exact: (connect_corner c).
by have := fl v t vt => /setP/(_ u); rewrite !inE vu.
Qed.

End Unglue.

(* Combined consequence for the FE kernel: after any cut, two cells sharing   *)
(* a vertex are in the same component of the dual graph minus the cut.        *)
Corollary T9_fem n (V T : finType) (M : complex n V T) (C : {set {set V}}) w t u :
  0 < n -> w \in unglue M C t -> w \in unglue M C u -> connect (dual M C) t u.
Proof.
move=> n0 wt wu; rewrite -T9_pieces //; apply: T9_vertex wt wu; exact: T4_cut_regular.
Qed.

Section Composition.
Variables (n : nat) (V T : finType) (M : complex n V T) (t0 : T).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.

(* staged cutting with a PERSISTENT cut set                                   *)
Theorem staged (C : {set {set V}}) : respects M lab C ->
  isomorphic (unglue (relabel M pK) (lifted p C)) (unglue M C).
Proof.
move=> r; pose R := relabel M pK.
have E x y : corner M x -> corner M y ->
   (copy R (lifted p C) (up lab x) == copy R (lifted p C) (up lab y)) = (copy M C x == copy M C y).
  by move=> _ _; rewrite !copy_eq connect_relabel.
pose l1 x := copy R (lifted p C) (up lab x).
pose p1 (w : prod_finType W T) := p w.1.
have pK1 x : p1 (l1 x) = x.1 by rewrite /p1 /l1 copyK /= pK.
have i := @relabel_iso n V T M _ _ p1 fst l1 (copy M C) pK1 (copyK M C) t0 E.
apply: isomorphic_trans i.
exists id => // t; rewrite imset_id /= /relabelled /l1; apply/setP=> w.
apply/imsetP/imsetP => [[v vt ->]|[w' w't ->]].
  by exists (lab (v, t)) => //; apply/imsetP; exists v.
by case/imsetP: w't => v vt ->; exists v.
Qed.
End Composition.

(* idempotence with the lifted cut                                            *)
Theorem T5_idempotent n (V T : finType) (M : complex n V T) (C : {set {set V}}) :
  isomorphic (unglue (unglue M C) (lifted fst C)) (unglue M C).
Proof. exact/T5_regular/T4_lifted. Qed.

(* sequential = simultaneous when the earlier cut is remembered               *)
Theorem T8_staged n (V T : finType) (M : complex n V T) (t0 : T) (C1 C : {set {set V}}) :
  C1 \subset C ->
  isomorphic (unglue (unglue M C1) (lifted fst C)) (unglue M C).
Proof.
move=> s; apply: (staged t0) => x y /(glue_subrel s); exact: copy_respects.
Qed.

(* a forgetful second cut: exact result                                       *)
Theorem T8_sequential n (V T : finType) (M : complex n V T) (t0 : T) (C1 C2 : {set {set V}}) :
  pseudo_manifold M ->
  isomorphic (unglue (unglue M C1) (lifted fst C2)) (unglue M (opened M C1 :|: C2)).
Proof.
move=> pm; set D := opened M C1 :|: C2.
have r : respects M (copy M C1) D.
  move=> x y /(glue_subrel (subsetUl _ C2)) g; apply/eqP.
  by rewrite copy_eq -(opened_same C1 x y pm); exact: connect1.
have E : glue (unglue M C1) (lifted fst C2) =2 glue (unglue M C1) (lifted fst D).
  move=> x y; rewrite /glue; case: (x.1 == y.1) => //=.
  case: (_ \in _) => //=; case a: (adjacent _ _ _) => //=.
  have pe : fst @: common (unglue M C1) x.2 y.2 = common M x.2 y.2 by exact: p_common_adjacent.
  rewrite !in_lifted pe; congr (~~ _); rewrite /D inE orbC.
  case: (_ \in C2) => //=; apply/esym/negbTE; rewrite inE negb_and negbK.
  by apply/orP; right; apply/existsP; exists x.2; apply/existsP; exists y.2; rewrite a eqxx.
apply: isomorphic_trans (staged t0 (copyK M C1) r).
exists id => // t; rewrite imset_id !unglueE; apply: eq_imset => v.
rewrite /copy /root; congr odflt; apply: eq_pick => z /=.
by rewrite /(connect _) //=; apply/esym/(eq_connect E).
Qed.

(* a cut that opens nothing leaves no trace for the next one                  *)
Corollary T8_forgets n (V T : finType) (M : complex n V T) (t0 : T) (C1 C2 : {set {set V}}) :
  regular M C1 -> isomorphic (unglue (unglue M C1) (lifted fst C2)) (unglue M C2).
Proof.
move=> r; apply: (staged t0) => x y g; apply/eqP; rewrite copy_eq.
have xy := connect_fst (connect1 g).
have [_ + _ _] := and4P g; rewrite inE; case: x y xy {g} => v t [w u] /= <- /andP[vt vu].
exact: r.
Qed.
