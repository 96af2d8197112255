(******************************************************************************)
(* Relabellings: all ways of splitting vertices. A relabelling gives every    *)
(* corner a new vertex, which is a copy of the old one. unglue, a cut that    *)
(* has got half way, several cuts in a row and a stitch are all relabellings, *)
(* so what holds for all of them is proved once, here.                        *)
(*              parent == the old vertex that a new one is a copy of          *)
(*                        (Relabelling::parent). New vertices are named by    *)
(*                        pairs (old vertex, something), so it is fst; the    *)
(*                        general theory takes any map p : W -> V.            *)
(*        relabel M pK == the complex M after the relabelling: lab x : W is   *)
(*                        the new vertex of the corner x, and pK proves that  *)
(*                        it is a copy of the old one, p (lab x) = x.1        *)
(*            up lab x == the corner, or half-facet, x under its new name     *)
(*            down p y == the old name of the new corner y                    *)
(*          lifted p C == the cut C on the relabelled complex: the sets of    *)
(*                        new vertices whose parents form a set of C. The     *)
(*                        paper's algorithm carries C along as objects that   *)
(*                        persist.                                            *)
(*    respects M lab C == glued corners get the same new vertex; equivalently *)
(*                        only facets of C come apart (respectsP)             *)
(* For every relabelling:                                                     *)
(*   mates_relabel, boundary_relabel, adjacent_relabel == which facets open   *)
(*   relabel_pseudo_manifold == a pseudo-manifold remains one                 *)
(*   connect_relabel == after a relabelling that respects C, the corners are  *)
(*                      connected as before                                   *)
(*       relabel_iso == relabellings that give the same corners one vertex    *)
(*                      give isomorphic complexes                             *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Notation parent := fst (only parsing).

Section Relabelling.
Variables (n : nat) (V T : finType) (M : complex n V T).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.
Implicit Types (t u : T) (v : V) (w : W) (C : {set {set V}}) (x y : V * T).

(* The relabelled complex                                                     *)

Definition relabelled t := [set lab (v, t) | v in M t].

(* Every cell is, vertex by vertex, a copy of the old one.                    *)
Lemma p_relabelled t : p @: relabelled t = M t.
Proof. by rewrite -imset_comp -[RHS]imset_id; apply: eq_imset => v /=; rewrite pK. Qed.

Lemma lab_inj t : injective (fun v => lab (v, t)).
Proof. by move=> v w /(congr1 p); rewrite !pK. Qed.

Lemma card_relabelled t : #|relabelled t| = n.+1.
Proof. by rewrite card_imset ?card_vertices //; exact: lab_inj. Qed.

Lemma relabelled_inj : injective relabelled.
Proof. by move=> t u e; apply: (vertices_inj (c := M)); rewrite -!p_relabelled e. Qed.

Definition relabel : complex n W T := Complex card_relabelled relabelled_inj.

Lemma mem_relabelled w t : (w \in relabelled t) = (p w \in M t) && (lab (p w, t) == w).
Proof.
apply/imsetP/andP => [[v vt ->]|[pw /eqP e]]; first by rewrite pK.
by exists (p w).
Qed.

Lemma lab_relabelled v t u :
  (lab (v, u) \in relabelled t) = (v \in M t) && (lab (v, t) == lab (v, u)).
Proof. by rewrite mem_relabelled pK. Qed.

Lemma p_inj_in t : {in relabelled t &, injective p}.
Proof.
move=> w1 w2; rewrite !mem_relabelled => /andP[_ /eqP e1] /andP[_ /eqP e2] e.
by rewrite -e1 -e2 e.
Qed.

(* Corners and half-facets: the same ones under new names                     *)

Definition up x : W * T := (lab x, x.2).
Definition down (y : W * T) : V * T := (p y.1, y.2).

Lemma upK : cancel up down. Proof. by case=> v t; rewrite /down /up /= pK. Qed.

Lemma corner_up x : corner relabel (up x) = corner M x.
Proof. by case: x => v t; rewrite /corner lab_relabelled eqxx andbT. Qed.

Lemma up_surj (y : W * T) : corner relabel y -> up (down y) = y.
Proof. by case: y => w t; rewrite /corner /= mem_relabelled => /andP[_ /eqP e]; rewrite /up e. Qed.

Lemma corner_down (y : W * T) : corner relabel y -> corner M (down y).
Proof. by move=> cy; rewrite -corner_up up_surj. Qed.

Lemma facet_up x : facet relabel (up x) = [set lab (v, x.2) | v in facet M x].
Proof.
case: x => v t; apply/setP => w; rewrite !inE mem_relabelled.
apply/and3P/imsetP => [[wv pw /eqP e]|[v' + ->]] /=.
  by exists (p w); rewrite ?inE ?pw ?andbT //; apply: contra wv => /eqP pwv; rewrite -e pwv.
by rewrite !inE pK => /andP[ne ->]; rewrite eqxx (inj_eq (@lab_inj t)).
Qed.

Lemma p_facet_up x : p @: facet relabel (up x) = facet M x.
Proof.
rewrite facet_up -imset_comp -[RHS]imset_id.
by apply: eq_imset => v /=; rewrite pK.
Qed.

(* Mates after are mates before all of whose vertices stay together.          *)
Lemma mates_relabel x y : mates relabel (up x) (up y) =
  mates M x y && [forall v in facet M x, lab (v, x.2) == lab (v, y.2)].
Proof.
rewrite /mates !corner_up /= -!andbA; do 3!congr (_ && _).
apply/eqP/andP => [e|[/eqP e /forall_inP same]].
  have eF : facet M x = facet M y by rewrite -!p_facet_up e.
  split; first exact/eqP; apply/forall_inP => v vx.
  have : lab (v, x.2) \in facet relabel (up y) by rewrite -e facet_up imset_f.
  by rewrite facet_up => /imsetP[w _ e']; have := congr1 p e'; rewrite !pK /= e' => ->.
by rewrite !facet_up -e; apply: eq_in_imset => v /same/eqP.
Qed.

Lemma mates_relabel_sub x y : mates relabel (up x) (up y) -> mates M x y.
Proof. by rewrite mates_relabel => /andP[]. Qed.

(* A half-facet is on the boundary after if from all its mates some vertex
   has come apart.                                                            *)
Lemma boundary_relabel x : corner M x -> (facet relabel (up x) \in boundary relabel) =
  [forall y, mates M x y ==> [exists v in facet M x, lab (v, x.2) != lab (v, y.2)]].
Proof.
move=> cx; rewrite boundaryP ?corner_up //.
apply/existsPn/forallP => [no y|all y].
  by apply/implyP => xy; have := no (up y); rewrite mates_relabel xy negb_forall_in.
apply/negP => xy; have cy : corner relabel y by case/and4P: xy.
move: xy; rewrite -(up_surj cy) mates_relabel => /andP[xy].
by have := all (down y); rewrite xy -negb_forall_in => /negP.
Qed.

Lemma relabel_pseudo_manifold : pseudo_manifold M -> pseudo_manifold relabel.
Proof.
move=> pm f cf; case: (set_0Vmem (cofaces relabel f)) => [->|[t]]; first by rewrite cards0.
rewrite inE => ft; have cpf : #|p @: f| = n.
  rewrite card_in_imset // => w1 w2 /(subsetP ft) i1 /(subsetP ft) i2.
  exact: p_inj_in i1 i2.
apply: leq_trans (pm _ cpf); apply: subset_leq_card; apply/subsetP => u.
by rewrite !inE => /(imsetS p); rewrite p_relabelled.
Qed.

Lemma used_relabel : used relabel = [set lab x | x in [pred x : V * T | corner M x]].
Proof.
apply/setP=> w; apply/usedP/imsetP => [[t /imsetP[v vt ->]]|[[v t] vt ->]].
  by exists (v, t).
by exists t; rewrite imset_f.
Qed.

(* Adjacent cells                                                             *)

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

Lemma adjacent_relabel t u :
  adjacent relabel t u = adjacent M t u && [forall v in common M t u, lab (v, t) == lab (v, u)].
Proof.
have [->|tu] := eqVneq t u; first by rewrite !adjacent_irr.
set S := [set v in common M t u | lab (v, t) == lab (v, u)].
have sS : S \subset common M t u by apply/subsetP=> v; rewrite inE => /andP[].
rewrite /adjacent card_common_relabel -/S.
apply/eqP/andP => [cS|[/eqP cM /forall_inP same]]; last first.
  by rewrite -[RHS]cM; apply: eq_card => v; rewrite inE; case vi: (v \in _) => //=; rewrite same.
have SE : S = common M t u by apply/eqP; rewrite eqEcard sS cS card_common.
split; first by rewrite -SE cS.
by apply/forall_inP => v; rewrite -SE inE => /andP[].
Qed.

Lemma adjacent_relabel_sub t u : adjacent relabel t u -> adjacent M t u.
Proof. by rewrite adjacent_relabel => /andP[]. Qed.

Lemma p_common_adjacent t u : adjacent relabel t u -> p @: common relabel t u = common M t u.
Proof.
rewrite adjacent_relabel p_common => /andP[_ /forall_inP same]; apply/setP=> v.
by rewrite inE; case vi: (v \in common M t u) => //=; rewrite same.
Qed.

(* Relabellings that open only facets of C                                    *)

Definition lifted C : {set {set W}} := [set f : {set W} | p @: f \in C].

Lemma in_lifted C f : (f \in lifted C) = (p @: f \in C). Proof. by rewrite inE. Qed.

Definition respects C := forall x y, glue M C x y -> lab x = lab y.

Lemma respects_connect C : respects C -> forall x y, connect (glue M C) x y -> lab x = lab y.
Proof. exact: connect_inv. Qed.

Lemma respects_adjacent C t u :
  respects C -> adjacent M t u -> common M t u \notin C -> adjacent relabel t u.
Proof.
move=> r a nC; rewrite adjacent_relabel a; apply/forall_inP => v vi.
by apply/eqP/r; rewrite /glue eqxx vi a.
Qed.

(* Respecting C means: what comes apart is in C.                              *)
Lemma respectsP C :
  respects C <-> (forall t u, adjacent M t u -> ~~ adjacent relabel t u -> common M t u \in C).
Proof.
split=> [r t u a|only [v t] [w u] /and4P[/= /eqP <- vi a nC]].
  by apply: contraR => nC; exact: respects_adjacent r a nC.
have := only _ _ a; rewrite (negPf nC) adjacent_relabel a /=.
by case: forall_inP => [/(_ v vi)/eqP //|_ /(_ isT)].
Qed.

Lemma glue_up C x y : respects C -> glue M C x y -> glue relabel (lifted C) (up x) (up y).
Proof.
move=> r g; have := r _ _ g; case: x y g => v t [w u] /and4P[/= /eqP <- vi a nC] e.
have a' := respects_adjacent r a nC.
rewrite /glue /up /= e eqxx a' in_lifted p_common_adjacent // nC /= andbT.
move: vi; rewrite !inE => /andP[vt vu].
by rewrite -{1}e !lab_relabelled vt vu !eqxx.
Qed.

Lemma glue_down C (x y : W * T) : glue relabel (lifted C) x y -> glue M C (down x) (down y).
Proof.
case: x y => w t [w' u] /and4P[/= /eqP<- wi a]; rewrite in_lifted p_common_adjacent // => nC.
rewrite /glue /= eqxx (adjacent_relabel_sub a) nC andbT /=.
by rewrite -(p_common_adjacent a) imset_f.
Qed.

(* The key to everything that happens after a first cut.                      *)
Lemma connect_relabel C x y : respects C ->
  connect (glue relabel (lifted C)) (up x) (up y) = connect (glue M C) x y.
Proof.
move=> r; apply/idP/idP => [c|].
  rewrite -[x]upK -[y]upK; apply: connect_homo c => a b g.
  exact/connect1/glue_down.
by apply: connect_homo => a b g; exact/connect1/glue_up.
Qed.

End Relabelling.

(* The partition of the corners determines the complex. The cell t0 gives the
   renaming some value on names that no corner has.                           *)
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
