(******************************************************************************)
(* Complexes: the definitions that a reader of the theorems has to trust. The *)
(* dimension n is arbitrary: 3 for tetrahedra, 2 for triangles. V is the set  *)
(* of vertices and T that of cells; both are finite and otherwise arbitrary.  *)
(*       complex n V T == Complex<n> of the C++: each cell t : T has a set M  *)
(*                        t of n.+1 vertices, and no two cells the same set.  *)
(*                        The paper's mesh consists of 3-simplexes and their  *)
(*                        subsets, so the cells determine it. Cells have      *)
(*                        names of their own, like the paper's objects,       *)
(*                        because they outlive a change of their vertices.    *)
(*              used M == the vertices of the cells (others do not matter)    *)
(*            star M v == the cells around the vertex v                       *)
(*          corner M x == x = (v, t) is a corner: v is a vertex of the cell t *)
(*                        (CornerId). The corner (v, t) is at the same time   *)
(*                        the half-facet of t opposite v (HalfFacetId).       *)
(*           facet M x == the n vertices of the half-facet x = (v, t): those  *)
(*                        of t but v                                          *)
(*         mates M x y == the half-facets x and y belong to different cells   *)
(*                        and have the same vertices (Complex::mate)          *)
(*         cofaces M f == the cells that contain the vertices f               *)
(*   pseudo_manifold M == no n vertices lie in three cells (section 4: a      *)
(*                        triangle can be in at most two tetrahedra)          *)
(*          boundary M == the facets in exactly one cell (section 4)          *)
(*        common M t u == the vertices that t and u share                     *)
(*      adjacent M t u == t and u are different cells with a common facet. As *)
(*                        cells have n.+1 vertices and differ, this says that *)
(*                        they share n: adjacent_mates.                       *)
(*        glue M C x y == the corners x = (v, t) and y = (v, u) are held      *)
(*                        together: t and u share a facet that contains v and *)
(*                        is not in the cut C; glueP says it with mates       *)
(*    regular_at M C v == facets at v and not in C connect all corners at v   *)
(*         regular M C == so it is at every vertex                            *)
(*       cut_regular M == Definition 4: for every vertex the cells around it  *)
(*                        form one facet-connected component                  *)
(* A cut is any set C of vertex sets; those that are no interior facet of M   *)
(* do nothing (the C++ refuses them: FacetSet).                               *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Record complex (n : nat) (V T : finType) := Complex {
  vertices :> T -> {set V};
  card_vertices : forall t, #|vertices t| = n.+1;
  vertices_inj : injective vertices
}.

Section Definitions.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (f : {set V}) (C : {set {set V}}) (x y : V * T).

Definition used : {set V} := [set v | [exists t, v \in M t]].
Definition star v : {set T} := [set t | v \in M t].

Definition corner : pred (V * T) := fun x => x.1 \in M x.2.
Definition facet x : {set V} := M x.2 :\ x.1.
Definition mates : rel (V * T) :=
  fun x y => [&& corner x, corner y, x.2 != y.2 & facet x == facet y].

Definition cofaces f : {set T} := [set t | f \subset M t].
Definition pseudo_manifold := forall f, #|f| = n -> #|cofaces f| <= 2.
Definition boundary : {set {set V}} :=
  [set f : {set V} | (#|f| == n) && (#|cofaces f| == 1)].

Definition common t u : {set V} := M t :&: M u.
Definition adjacent t u := #|common t u| == n.
Definition glue C : rel (V * T) := fun x y =>
  [&& x.1 == y.1, x.1 \in common x.2 y.2, adjacent x.2 y.2 & common x.2 y.2 \notin C].

Definition regular_at C v := forall t u, v \in M t -> v \in M u ->
  connect (glue C) (v, t) (v, u).
Definition regular C := forall v, regular_at C v.
Definition cut_regular := regular set0.

End Definitions.

Section Theory.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (f : {set V}) (C : {set {set V}}) (x y : V * T).
Local Notation used := (used M).
Local Notation common := (common M).
Local Notation adjacent := (adjacent M).
Local Notation facet := (facet M).
Local Notation corner := (corner M).
Local Notation mates := (mates M).
Local Notation glue := (glue M).

Lemma usedP v : reflect (exists t, v \in M t) (v \in used).
Proof. by rewrite inE; apply: (iffP existsP). Qed.

Lemma mem_used v t : v \in M t -> v \in used.
Proof. by move=> vt; apply/usedP; exists t. Qed.

(* Adjacent cells                                                             *)

Lemma commonC t u : common t u = common u t. Proof. exact: setIC. Qed.

Lemma adjacentC t u : adjacent t u = adjacent u t.
Proof. by rewrite /complex.adjacent commonC. Qed.

Lemma adjacent_irr t : adjacent t t = false.
Proof. by rewrite /complex.adjacent /complex.common setIid card_vertices eqn_leq ltnn. Qed.

Lemma adjacent_neq t u : adjacent t u -> t != u.
Proof. by apply: contraTneq => ->; rewrite adjacent_irr. Qed.

Lemma card_common t u : t != u -> #|common t u| <= n.
Proof.
move=> tu; rewrite -ltnS -(card_vertices M t); apply: proper_card.
rewrite properE subsetIl /=; apply: contra tu => tI.
apply/eqP; apply: (vertices_inj (c := M)); apply/eqP.
by rewrite eqEcard (subset_trans tI (subsetIr _ _)) !card_vertices /=.
Qed.

(* Two different cells through n vertices share just these.                   *)
Lemma common_facet f t u : #|f| = n -> t != u ->
  f \subset M t -> f \subset M u -> common t u = f.
Proof.
move=> cf tu ft fu; apply/esym/eqP; rewrite eqEcard cf card_common // andbT.
by rewrite subsetI ft.
Qed.

(* Half-facets and mates                                                      *)

Lemma facet_sub x : facet x \subset M x.2. Proof. exact: subsetDl. Qed.

Lemma card_facet x : corner x -> #|facet x| = n.
Proof. by move=> cx; have := cardsD1 x.1 (M x.2); rewrite [_ \in _]cx card_vertices => -[]. Qed.

Lemma facet_inj t v w : v \in M t -> facet (v, t) = facet (w, t) -> v = w.
Proof.
move=> vt /setP/(_ v); rewrite !inE eqxx /= vt andbT => /esym/negbFE/eqP; exact.
Qed.

Lemma facetP f t : f \subset M t -> #|f| = n -> exists2 v, v \in M t & f = facet (v, t).
Proof.
move=> ft cf; have /cards1P[v vE] : #|M t :\: f| == 1.
  by rewrite cardsD (setIidPr ft) card_vertices cf subSnn.
have : v \in M t :\: f by rewrite vE inE.
rewrite inE => /andP[_ vt]; exists v => //.
by rewrite /complex.facet /= -vE setDDr setDv set0U (setIidPr ft).
Qed.

Lemma mates_sym : symmetric mates.
Proof. by move=> x y; rewrite /complex.mates andbCA eq_sym [facet x == _]eq_sym. Qed.

Lemma mates_common x y : mates x y -> common x.2 y.2 = facet x.
Proof.
case/and4P=> cx _ xy /eqP e; apply: common_facet; rewrite ?card_facet ?facet_sub //.
by rewrite e facet_sub.
Qed.

Lemma mates_adjacent x y : mates x y -> adjacent x.2 y.2.
Proof.
move=> xy; rewrite /complex.adjacent (mates_common xy).
by case/and4P: xy => /card_facet->.
Qed.

Lemma adjacent_mates t u : adjacent t u -> exists v w, mates (v, t) (w, u).
Proof.
move=> tu; have [v vt vE] := facetP (subsetIl _ _ : common t u \subset M t) (eqP tu).
have [w wu wE] := facetP (subsetIr _ _ : common t u \subset M u) (eqP tu).
by exists v, w; rewrite /complex.mates /complex.corner /= vt wu -vE -wE adjacent_neq /=.
Qed.

(* The boundary consists of the half-facets without mate.                     *)
Lemma boundaryP x : corner x -> (facet x \in boundary M) = ~~ [exists y, mates x y].
Proof.
move=> cx; have cf := card_facet cx; rewrite inE cf eqxx (cardsD1 x.2) inE facet_sub add1n eqSS /=.
rewrite cards_eq0; apply/eqP/existsPn => [no y|no].
  apply/negP => /and4P[_ _ xy /eqP e]; have : y.2 \in cofaces M (facet x) :\ x.2.
    by rewrite !inE eq_sym xy e facet_sub.
  by rewrite no inE.
apply/setP => u; rewrite !inE; apply/andP => -[ux fu].
have [w wu wE] := facetP fu cf.
by have := no (w, u); rewrite /complex.mates cx /complex.corner /= wu eq_sym ux -wE eqxx.
Qed.

(* The glue relation                                                          *)

(* glue, said with mates: two half-facets, one of each cell, are mates, and
   their facet contains the vertex and is not cut.                            *)
Lemma glueP C x y :
  reflect (x.1 = y.1 /\ exists h k, [/\ h.2 = x.2, k.2 = y.2, mates h k,
                                       x.1 \in facet h & facet h \notin C])
          (glue C x y).
Proof.
apply: (iffP and4P) => [[/eqP e xi a nC]|[e [h [k [hx ky hk xh nC]]]]].
  split=> //; have [v [w vw]] := adjacent_mates a.
  by exists (v, x.2), (w, y.2); rewrite -(mates_common vw).
by rewrite -hx -ky (mates_common hk) (mates_adjacent hk) e eqxx -e.
Qed.

Lemma glue_sym C : symmetric (glue C).
Proof.
move=> [v t] [w u]; rewrite /complex.glue /= eq_sym [in RHS]adjacentC [in RHS]commonC.
by case: eqP => // ->.
Qed.

Lemma glue_csym C : connect_sym (glue C).
Proof. exact/sym_connect_sym/glue_sym. Qed.

Lemma connect_fst C x y : connect (glue C) x y -> x.1 = y.1.
Proof. by apply: connect_inv => {}x {}y /andP[/eqP]. Qed.

Lemma connect_corner C x y : connect (glue C) x y -> corner x -> corner y.
Proof.
apply: (connect_stay (P := fun z => corner z)) => {}x {}y /and4P[/eqP e + _ _] _.
by rewrite inE e => /andP[].
Qed.

(* A smaller cut glues more.                                                  *)
Lemma glue_subrel C C' : C \subset C' -> subrel (glue C') (glue C).
Proof.
move=> sC x y /and4P[e xi a nC]; rewrite /complex.glue e xi a /=.
by apply: contra nC; apply: subsetP.
Qed.

Lemma connect_subset C C' x y : C \subset C' -> connect (glue C') x y -> connect (glue C) x y.
Proof. by move=> sC; apply: connect_sub => z w /(glue_subrel sC)/connect1. Qed.

Lemma regularS C C' : C \subset C' -> regular M C' -> regular M C.
Proof. by move=> sC r v t u vt vu; apply: connect_subset sC _; exact: r. Qed.

(* Facets that do not contain v have no say in what happens at v.             *)
Lemma connect_local C v t u : (forall f, f \in C -> v \notin f) ->
  connect (glue C) (v, t) (v, u) = connect (glue set0) (v, t) (v, u).
Proof.
move=> off; apply/idP/idP; first exact/connect_subset/sub0set.
apply: (connect_sub_in (P := fun x => x.1 = v)) => [x y xv|//] /and4P[/eqP e xi a _].
split; last by rewrite -e.
apply: connect1; rewrite /complex.glue e eqxx -e xi a.
by apply: contraL xi => /off; rewrite xv.
Qed.

End Theory.
