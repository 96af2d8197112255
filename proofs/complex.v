(* complex.v : pure simplicial complexes, adjacency, vertex relabelling.      *)
(* Dimension n is arbitrary (n = 3: tetrahedral mesh, n = 2: triangle mesh).  *)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---------- generic facts about connect / root ---------------------------- *)
Section Connect.
Variables (A B : finType) (e : rel A) (e' : rel B) (f : A -> B).

Lemma connect_homo :
  (forall x y, e x y -> connect e' (f x) (f y)) ->
  forall x y, connect e x y -> connect e' (f x) (f y).
Proof.
move=> fe x y /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[exz zs].
exact: connect_trans (fe _ _ exz) (IHs _ zs).
Qed.
End Connect.

(* ---------- meshes -------------------------------------------------------- *)
Record complex (n : nat) (V T : finType) := Complex {
  vertices :> T -> {set V};
  card_vertices : forall t, #|vertices t| = n.+1;
  vertices_inj : injective vertices }.

Section Complex.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (f : {set V}) (C : {set {set V}}) (x y : V * T).

Definition used : {set V} := [set v | [exists t, v \in M t]].
Definition star v : {set T} := [set t | v \in M t].
Definition cofaces f : {set T} := [set t | f \subset M t].
Definition pseudo_manifold := forall f, #|f| = n -> #|cofaces f| <= 2.
Definition common t u : {set V} := M t :&: M u.
Definition adjacent t u := #|common t u| == n.
Definition corner : pred (V * T) := fun x => x.1 \in M x.2.

(* the gluing relation on corners, for a cut C                                *)
Definition glue C : rel (V * T) := fun x y =>
  [&& x.1 == y.1, x.1 \in common x.2 y.2, adjacent x.2 y.2 & common x.2 y.2 \notin C].

(* C-regular; cut-regular of the paper (Def. 4) is regular set0               *)
Definition regular C := forall v t u, v \in M t -> v \in M u ->
  connect (glue C) (v, t) (v, u).
Definition cut_regular := regular set0.

Lemma usedP v : reflect (exists t, v \in M t) (v \in used).
Proof. by rewrite inE; apply: (iffP existsP). Qed.

Lemma commonC t u : common t u = common u t. Proof. exact: setIC. Qed.
Lemma adjacentC t u : adjacent t u = adjacent u t. Proof. by rewrite /adjacent commonC. Qed.
Lemma adjacent_irr t : adjacent t t = false.
Proof. by rewrite /adjacent /common setIid card_vertices eqn_leq ltnn. Qed.
Lemma adjacent_neq t u : adjacent t u -> t != u.
Proof. by apply: contraTneq => ->; rewrite adjacent_irr. Qed.

Lemma card_common t u : t != u -> #|common t u| <= n.
Proof.
move=> tu; rewrite -ltnS -(card_vertices M t); apply: proper_card.
rewrite properE subsetIl /=; apply: contra tu => s1.
apply/eqP; apply: (vertices_inj (c := M)); apply/eqP.
by rewrite eqEcard (subset_trans s1 (subsetIr _ _)) !card_vertices /=.
Qed.

(* two distinct cells through an n-set f: f is exactly their intersection     *)
Lemma common_facet f t u : #|f| = n -> t != u ->
  f \subset M t -> f \subset M u -> common t u = f.
Proof.
move=> cf tu ft fu; apply/esym/eqP; rewrite eqEcard cf card_common // andbT.
by rewrite subsetI ft.
Qed.

Lemma adjacentP t u : reflect (exists f, [/\ #|f| = n, t != u, f \subset M t & f \subset M u])
                         (adjacent t u).
Proof.
apply: (iffP idP) => [a|[f [cf tu ft fu]]]; last by rewrite /adjacent (common_facet cf) ?cf.
by exists (common t u); rewrite (eqP a) adjacent_neq // subsetIl subsetIr.
Qed.

Lemma glue_sym C : symmetric (glue C).
Proof.
move=> [v t] [w u]; rewrite /glue /= eq_sym [in RHS]adjacentC [in RHS]commonC.
by case: eqP => // ->.
Qed.
Lemma glue_csym C : connect_sym (glue C).
Proof. exact/sym_connect_sym/glue_sym. Qed.

Lemma connect_fst C x y : connect (glue C) x y -> x.1 = y.1.
Proof.
move=> /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[/and4P[/eqP-> *]].
exact: IHs.
Qed.

Lemma connect_corner C x y : connect (glue C) x y -> corner x -> corner y.
Proof.
move=> /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[/and4P[/eqP e xi _ _] zs] _.
by apply: IHs zs _; move: xi; rewrite inE /corner -e => /andP[].
Qed.

Lemma glue_subrel C C' : C \subset C' -> subrel (glue C') (glue C).
Proof.
move=> /subsetP sCC' x y /and4P[e xi a nC]; rewrite /glue e xi a /=.
by apply: contra nC => /sCC'.
Qed.

Lemma connect_subset C C' x y : C \subset C' ->
  connect (glue C') x y -> connect (glue C) x y.
Proof.
by move=> sCC'; apply: connect_sub => z w /(glue_subrel sCC')/connect1.
Qed.

Lemma regularS C C' : C \subset C' -> regular C' -> regular C.
Proof. by move=> s r v t u vt vu; apply: connect_subset s _; exact: r. Qed.

End Complex.

(* Isomorphism over the identity of cells (objects persist in the paper).     *)
Definition isomorphic n (V W T : finType) (M : complex n V T) (N : complex n W T) :=
  exists2 f : V -> W, {in used M &, injective f} & forall t, N t = f @: M t.

Section Iso.
Variables (n : nat) (T : finType).
Lemma isomorphic_refl (V : finType) (M : complex n V T) : isomorphic M M.
Proof. by exists id => // t; rewrite imset_id. Qed.

Lemma isomorphic_trans (V W X : finType) (M : complex n V T) (N : complex n W T) (P : complex n X T) :
  isomorphic M N -> isomorphic N P -> isomorphic M P.
Proof.
case=> f fi fM [g gi gN]; exists (g \o f); last by move=> t; rewrite gN fM imset_comp.
have fu v : v \in used M -> f v \in used N.
  by move=> /usedP[t vt]; apply/usedP; exists t; rewrite fM imset_f.
by move=> v w vM wM /= /gi e; apply: fi => //; apply: e; exact: fu.
Qed.

Lemma isomorphic_sym (V W : finType) (M : complex n V T) (N : complex n W T) :
  T -> isomorphic M N -> isomorphic N M.
Proof.
move=> t0 [f fi fM].
have /card_gt0P[v0 _] : 0 < #|M t0| by rewrite card_vertices.
have NuP w : w \in used N -> exists2 v, v \in used M & f v = w.
  move=> /usedP[t]; rewrite fM => /imsetP[v vt ->]; exists v => //.
  by apply/usedP; exists t.
pose g w := odflt v0 [pick v in used M | f v == w].
have gK v : v \in used M -> g (f v) = v.
  move=> vM; rewrite /g; case: pickP => [u /andP[uM /eqP/fi->//]|/(_ v)].
  by rewrite vM eqxx.
exists g => [w1 w2 /NuP[v1 v1M <-] /NuP[v2 v2M <-]|t]; first by rewrite !gK // => ->.
rewrite fM -imset_comp; rewrite -[LHS]imset_id; apply: eq_in_imset => v vt /=.
by rewrite gK //; apply/usedP; exists t.
Qed.
End Iso.

(* ---------- relabelling: every "vertex splitting" of a mesh ---------------- *)
(* p : new vertex -> old vertex (the paper's "copy of N"), lab assigns a new   *)
(* vertex to each corner.  unglue, partial unglue, glue-back are instances.    *)
Section Relabel.
Variables (n : nat) (V T : finType) (M : complex n V T).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

Definition relabelled t := [set lab (v, t) | v in M t].

Lemma p_relabelled t : p @: relabelled t = M t.
Proof. by rewrite -imset_comp -[RHS]imset_id; apply: eq_imset => v /=; rewrite pK. Qed.

Lemma lab_inj t : injective (fun v => lab (v, t)).
Proof. by move=> v w /(congr1 p); rewrite !pK. Qed.

Lemma mem_relabelled w t : (w \in relabelled t) = (p w \in M t) && (lab (p w, t) == w).
Proof.
apply/imsetP/andP => [[v vt ->]|[pw /eqP e]]; first by rewrite pK.
by exists (p w).
Qed.

Lemma lab_relabelled v t u : (lab (v, u) \in relabelled t) = (v \in M t) && (lab (v, t) == lab (v, u)).
Proof. by rewrite mem_relabelled pK. Qed.

Lemma card_relabelled t : #|relabelled t| = n.+1.
Proof. by rewrite card_imset ?card_vertices //; exact: lab_inj. Qed.

Lemma relabelled_inj : injective relabelled.
Proof. by move=> t u e; apply: (vertices_inj (c := M)); rewrite -!p_relabelled e. Qed.

(* P1 *)
Definition relabel : complex n W T := Complex card_relabelled relabelled_inj.

Lemma p_inj_in t : {in relabelled t &, injective p}.
Proof.
move=> w1 w2; rewrite !mem_relabelled => /andP[_ /eqP e1] /andP[_ /eqP e2] e.
by rewrite -e1 -e2 e.
Qed.

(* T2_pseudo_manifold *)
Lemma relabel_pseudo_manifold : pseudo_manifold M -> pseudo_manifold relabel.
Proof.
move=> pm f cf; case: (set_0Vmem (cofaces relabel f)) => [->|[t]]; first by rewrite cards0.
rewrite inE => ft; have cpf : #|p @: f| = n.
  by rewrite card_in_imset // => w1 w2 /(subsetP ft) i1 /(subsetP ft) i2; apply: p_inj_in i1 i2.
apply: leq_trans (pm _ cpf); apply: subset_leq_card; apply/subsetP=> u.
by rewrite !inE => /(imsetS p); rewrite p_relabelled.
Qed.

Lemma p_common t u : p @: common relabel t u = [set v in common M t u | lab (v, t) == lab (v, u)].
Proof.
apply/setP=> v; rewrite !inE; apply/imsetP/andP => [[w]|[/andP[vt vu] e]].
  rewrite !inE !mem_relabelled => /andP[/andP[wt /eqP e1] /andP[wu /eqP e2]] ->.
  by rewrite wt wu e1 e2.
exists (lab (v, t)); rewrite ?pK // inE lab_relabelled vt eqxx /=.
by rewrite lab_relabelled vu (eqP e) eqxx.
Qed.

Lemma card_common_relabel t u :
  #|common relabel t u| = #|[set v in common M t u | lab (v, t) == lab (v, u)]|.
Proof.
rewrite -p_common card_in_imset // => w1 w2; rewrite !inE => /andP[i1 _] /andP[i2 _].
exact: p_inj_in i1 i2.
Qed.

(* P3, core: a new adjacency is an old one all of whose corners stay together  *)
Lemma adjacent_relabel t u :
  adjacent relabel t u = adjacent M t u && [forall v in common M t u, lab (v, t) == lab (v, u)].
Proof.
have [->|tu] := eqVneq t u; first by rewrite !adjacent_irr.
apply/eqP/andP => [|[/eqP a /forall_inP same]].
  rewrite card_common_relabel => c.
  have s : [set v in common M t u | lab (v, t) == lab (v, u)] \subset common M t u.
    by apply/subsetP=> v; rewrite inE => /andP[].
  have a : #|common M t u| = n.
    by apply/eqP; rewrite eqn_leq (card_common _ tu) -{1}c subset_leq_card.
  split; first exact/eqP; apply/forall_inP => v vi.
  suff : v \in [set v in common M t u | lab (v, t) == lab (v, u)] by rewrite inE => /andP[].
  by rewrite (_ : [set _ in _ | _] = common M t u) //; apply/eqP; rewrite eqEcard s a c /=.
rewrite card_common_relabel -[RHS]a; apply: eq_card => v; rewrite inE.
by case vi: (v \in common M t u) => //=; rewrite same.
Qed.

Lemma adjacent_relabel_sub t u : adjacent relabel t u -> adjacent M t u.
Proof. by rewrite adjacent_relabel => /andP[]. Qed.

Lemma p_common_adjacent t u : adjacent relabel t u -> p @: common relabel t u = common M t u.
Proof.
rewrite adjacent_relabel p_common => /andP[_ /forall_inP same]; apply/setP=> v.
by rewrite inE; case vi: (v \in common M t u) => //=; rewrite same.
Qed.

Definition lifted C : {set {set W}} := [set f : {set W} | p @: f \in C].

Lemma in_lifted C f : (f \in lifted C) = (p @: f \in C). Proof. by rewrite inE. Qed.

(* admissible relabelling: only facets of C may come apart                     *)
Definition respects C := forall x y, glue M C x y -> lab x = lab y.

Lemma respects_connect C : respects C ->
  forall x y, connect (glue M C) x y -> lab x = lab y.
Proof.
move=> r x y /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[/r->].
exact: IHs.
Qed.

Lemma respects_adjacent C t u : respects C -> adjacent M t u -> common M t u \notin C -> adjacent relabel t u.
Proof.
move=> r a nC; rewrite adjacent_relabel a; apply/forall_inP => v vi.
by apply/eqP/r; rewrite /glue eqxx vi a.
Qed.

(* "only these triangles": what opens is in C, and this is equivalent to respects *)
Lemma respectsP C :
  respects C <-> (forall t u, adjacent M t u -> ~~ adjacent relabel t u -> common M t u \in C).
Proof.
split=> [r t u a|only x y /and4P[/eqP e xi a nC]].
  by apply: contraR => nC; exact: respects_adjacent r a nC.
have := only _ _ a; rewrite (negPf nC) adjacent_relabel a /=.
case: x y e xi {a nC only} => v t [w u] /= <- vi.
case: forall_inP => [/(_ v vi)/eqP //|_ /(_ isT)//].
Qed.

Definition up x : W * T := (lab x, x.2).
Definition down (y : W * T) : V * T := (p y.1, y.2).
Lemma upK : cancel up down. Proof. by case=> v t; rewrite /down /up /= pK. Qed.

Lemma glue_up C x y : respects C -> glue M C x y -> glue relabel (lifted C) (up x) (up y).
Proof.
move=> r g; have e := r _ _ g; case/and4P: g => /eqP xy xi a nC.
have ar := respects_adjacent r a nC.
rewrite /glue /up /= e eqxx ar in_lifted p_common_adjacent // nC /= andbT.
move: xi; rewrite !inE => /andP[xt xu]; case: x y xy e {a nC ar} xt xu => v t [w u] /= <-.
by move=> e vt vu; rewrite -{1}e !lab_relabelled vt vu !eqxx.
Qed.

Lemma glue_down C (x y : W * T) :
  glue relabel (lifted C) x y -> glue M C (down x) (down y).
Proof.
case: x y => w t [w' u] /and4P[/= /eqP<- wi a]; rewrite in_lifted p_common_adjacent // => nC.
rewrite /glue /= eqxx (adjacent_relabel_sub a) nC andbT /=.
by rewrite -(p_common_adjacent a) imset_f.
Qed.

(* components computed on the relabelled mesh = components of the old mesh     *)
Lemma connect_relabel C x y : respects C ->
  connect (glue relabel (lifted C)) (up x) (up y) = connect (glue M C) x y.
Proof.
move=> r; apply/idP/idP => [c|]; last first.
  by apply: connect_homo => a b g; exact/connect1/glue_up.
rewrite -[x]upK -[y]upK; apply: connect_homo c => a b g.
exact/connect1/glue_down.
Qed.

(* T12: gluing back along p gives the original mesh                            *)
Lemma stitch t : p @: relabel t = M t. Proof. exact: p_relabelled. Qed.

Lemma used_relabel : used relabel = [set lab x | x in [pred x : V * T | corner M x]].
Proof.
apply/setP=> w; apply/usedP/imsetP => [[t /imsetP[v vt ->]]|[[v t] vt ->]].
  by exists (v, t).
by exists t; rewrite imset_f.
Qed.

End Relabel.

Lemma relabel_iso n (V T : finType) (M : complex n V T)
  (W1 W2 : finType) p1 p2 (l1 : V * T -> W1) (l2 : V * T -> W2)
  (pK1 : forall x, p1 (l1 x) = x.1) (pK2 : forall x, p2 (l2 x) = x.1) (t0 : T) :
  (forall x y, corner M x -> corner M y -> (l1 x == l1 y) = (l2 x == l2 y)) ->
  isomorphic (relabel M pK1) (relabel M pK2).
Proof.
move=> same.
pose f w := if [pick x | corner M x && (l1 x == w)] is Some x then l2 x else l2 (p1 w, t0).
have fE x : corner M x -> f (l1 x) = l2 x.
  move=> cx; rewrite /f; case: pickP => [y /andP[cy]|/(_ x)]; last by rewrite cx eqxx.
  by rewrite same // => /eqP.
exists f => [w1 w2|t].
  rewrite !used_relabel => /imsetP[x cx ->] /imsetP[y cy ->]; rewrite !fE //.
  by move/eqP; rewrite -same // => /eqP.
rewrite /= /relabelled -imset_comp; apply: eq_in_imset => v vt /=.
by rewrite fE.
Qed.
