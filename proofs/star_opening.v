(******************************************************************************)
(* Theorem C: which selected facets open.  unglue (and cleave::topology::     *)
(* unglue) opens a facet iff the cells on its two sides come apart at one of  *)
(* its vertices v; that is decided in the star of v, by its cells, joined     *)
(* where they share a facet with v.  If the facets of C at v are those        *)
(* between two sets of cells of the star, then each of them opens.  It is not *)
(* enough that every ridge at v has an even number of them: torus.v.          *)
(*     star_adjacent M v == cells that share a facet with v                   *)
(*   two_sided M C v lab == in the star of v the facets of C are those        *)
(*                          between cells of different labels                 *)
(*         marks M C t u == the facet of t and u is in C                      *)
(*       opens M C v t u == the corners of t and u at v are not glued any     *)
(*                          more, so their common facet is open               *)
(*          degree M C r == the number of facets of M in C that contain r     *)
(* simply_connected_star M v == any parity of the steps from cell to cell in  *)
(*                          the star of v that is even on the loop around     *)
(*                          each ridge at v is even on every closed walk:     *)
(*                          the link has no first cohomology modulo two. That *)
(*                          spheres and disks have none is not proved here    *)
(* Main theorems:                                                             *)
(*        theoremC == a facet of C at v opens if C is two-sided at v          *)
(*  theoremC_walks == C is two-sided at v iff every closed walk in the star   *)
(*                    crosses C an even number of times                       *)
(*  theoremC_even  == if the star is simply connected, it is enough that each *)
(*                    ridge at v has an even number of facets of C            *)
(*  theoremC_front == so a facet that stays shut has odd ridges at its        *)
(*                    vertices: it is on the front of the cut                 *)
(* theoremC_ridge, theoremC_triangles, theoremC_path == nothing is assumed    *)
(*                    for a ridge, nor for vertices of a mesh of triangles    *)
(*   theoremC_full == if C are the facets between two sets of cells of the    *)
(*                    whole complex, all of them open                         *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary parity dual_edge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Opening.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).
Implicit Types (t u w : T) (v : V) (f r : {set V}) (s p : seq T).

Definition star_adjacent v : rel T := fun t u => adjacent M t u && (v \in common M t u).
Definition marks t u := common M t u \in C.
Definition two_sided v (lab : T -> bool) :=
  forall t u, star_adjacent v t u -> marks t u = (lab t != lab u).
Definition opens v t u := ~~ connect (glue M C) (v, t) (v, u).

Lemma star_adjacent_sym v : symmetric (star_adjacent v).
Proof. by move=> t u; rewrite /star_adjacent adjacentC commonC. Qed.

Lemma marks_sym t u : marks t u = marks u t. Proof. by rewrite /marks commonC. Qed.

Lemma opens_facet v t u : v \in common M t u -> opens v t u -> ~~ adjacent (unglue M C) t u.
Proof.
move=> vtu; apply: contra; rewrite T3_adjacent => /andP[_ /forall_inP glued].
exact: glued.
Qed.

Lemma glued_label v lab t u : two_sided v lab -> connect (glue M C) (v, t) (v, u) ->
  lab t = lab u.
Proof.
move=> labC /connectP[p]; have: (v, t).1 = v by []; rewrite -[t in lab t]/((v, t).2).
move: (v, t) => x xv xp ux; have -> : u = (last x p).2 by rewrite -ux.
elim: p x xv xp {ux} => //= y p IHp x xv /andP[/and4P[/eqP xy vxy a nC] yp].
rewrite -(IHp y) //; last by rewrite -xy.
by apply/eqP; rewrite -[_ == _]negbK -labC // /star_adjacent a -xv.
Qed.

(* Theorem C: if in the star of v the facets of C are those between two sets  *)
(* of cells, the two corners at v of each of them come apart.                 *)
Theorem theoremC v lab t u : two_sided v lab -> star_adjacent v t u -> marks t u ->
  opens v t u.
Proof.
move=> labC tu C_tu; apply/negP => /(glued_label labC) e.
by move: C_tu; rewrite (labC _ _ tu) e eqxx.
Qed.

(* Theorem C, so the facet is boundary after the cut.                         *)
Corollary theoremC_boundary v lab t u : two_sided v lab -> star_adjacent v t u -> marks t u ->
  ~~ adjacent (unglue M C) t u.
Proof.
move=> labC tu C_tu; have /andP[_ vtu] := tu.
exact: opens_facet vtu (theoremC labC tu C_tu).
Qed.

(* Theorem C, its hypothesis by walks: C is two-sided at v iff every closed   *)
(* walk from cell to cell around v crosses C an even number of times.         *)
Theorem theoremC_walks v : even_walks (star_adjacent v) marks <-> exists lab, two_sided v lab.
Proof.
rewrite labellingP => [|| t u _]; [|exact: star_adjacent_sym|exact: marks_sym].
by split=> [] [lab labE]; exists lab => t u /labE ->; case: (lab t) (lab u) => [] [].
Qed.

(* Theorem C: a cut that is two-sided in the whole complex opens entirely.    *)
Theorem theoremC_full lab t u : 0 < n -> coboundary M C lab -> adjacent M t u ->
  common M t u \in C -> ~~ adjacent (unglue M C) t u.
Proof.
move=> n0 labC tu C_tu; have /card_gt0P[v vtu] : 0 < #|common M t u| by rewrite (eqP tu).
apply: (@theoremC_boundary v lab) C_tu; last by rewrite /star_adjacent tu.
by move=> a b /andP[ab _]; exact: labC.
Qed.

Hypothesis pm : pseudo_manifold M.

Definition facets : {set {set V}} := [set f : {set V} | (#|f| == n) && (0 < #|cofaces M f|)].
Definition degree r := #|[set f in C :&: facets | r \subset f]|.

Lemma degree_loop r s : #|r|.+1 = n -> dual_loop M r s -> odd (degree r) = loop_parity marks s.
Proof.
move=> cr [loop sE]; have sym : symmetric_parity M marks by move=> t u _; exact: marks_sym.
rewrite -(theoremB_loop pm loop sym); congr odd; apply: eq_card => f; rewrite !inE.
apply/andP/andP => [[/andP[fC /andP[/eqP cf /card_gt0P[t ft]]] rf]|[/existsP[t]]].
  rewrite inE in ft; have ts : t \in s by rewrite sE (subset_trans rf ft).
  have along := in_facets_along pm cr loop ts cf rf ft; split=> //.
  have /imsetP[u us fE] := along; have /andP[un _] := next_around loop us.
  apply/existsP; exists u; apply/existsP; exists (next s u).
  by rewrite un -fE eqxx /marks -fE fC.
move=> /existsP[u /and3P[tu /eqP<- C_tu]] /imsetP[w ws fE].
have /andP[_ rf] := next_around loop ws; rewrite fE; split=> //; rewrite -fE.
by apply/and3P; split=> //; apply/card_gt0P; exists t; rewrite inE subsetIl.
Qed.

(* Theorem C, when the link of v is a sphere or a disk: it is enough that     *)
(* each ridge at v that is inside the body has an even number of facets of C. *)
Definition simply_connected_star v :=
  forall x : T -> T -> bool, (forall t u, x t u = x u t) ->
  (forall r s, #|r|.+1 = n -> v \in r -> dual_loop M r s -> loop_parity x s = false) ->
  even_walks (star_adjacent v) x.

Theorem theoremC_even v t u : simply_connected_star v ->
  (forall r s, #|r|.+1 = n -> v \in r -> dual_loop M r s -> ~~ odd (degree r)) ->
  star_adjacent v t u -> marks t u -> opens v t u.
Proof.
move=> sc even tu C_tu; have /theoremC_walks[lab labC] : even_walks (star_adjacent v) marks.
  apply: sc => [|r s cr vr loop]; first exact: marks_sym.
  by rewrite -(degree_loop cr loop); apply: negbTE; exact: even loop.
exact: theoremC labC tu C_tu.
Qed.

(* Theorem C, so a facet stays shut only on the front of the cut: not all     *)
(* ridges are even at any of its vertices with a simply connected star.       *)
Corollary theoremC_front v t u : simply_connected_star v -> star_adjacent v t u -> marks t u ->
  adjacent (unglue M C) t u ->
  ~ (forall r s, #|r|.+1 = n -> v \in r -> dual_loop M r s -> ~~ odd (degree r)).
Proof.
move=> sc tu C_tu shut even; have /andP[_ vtu] := tu.
by have /negP[] := opens_facet vtu (theoremC_even sc even tu C_tu).
Qed.

(* For a ridge nothing is left to assume: a parity that is even on the loop   *)
(* of its cells comes from labels of these cells.                             *)
Lemma ridge_labelling (x : T -> T -> bool) r s : (forall t u, x t u = x u t) ->
  #|r|.+1 = n -> dual_loop M r s -> loop_parity x s = false ->
  exists lab, labelling (around M r) x lab.
Proof.
move=> x_sym cr [loop sE] even; have [us _ _] := loop.
have [lab labE] := loop_labelling us even; exists lab => t u tu.
have ts : t \in s by case/andP: tu => _ rf; rewrite sE (subset_trans rf) ?subsetIl.
have us' : u \in s by case/andP: tu => _ rf; rewrite sE (subset_trans rf) ?subsetIr.
case: (loop_neighbours pm cr loop ts tu) => [->|->]; first exact: labE.
by rewrite x_sym addbC; exact: labE.
Qed.

(* Theorem C around a ridge: if an even number of its facets is in C, C is    *)
(* two-sided there.                                                           *)
Theorem theoremC_ridge r s : #|r|.+1 = n -> dual_loop M r s -> ~~ odd (degree r) ->
  exists lab : T -> bool, forall t u, around M r t u -> marks t u = (lab t != lab u).
Proof.
move=> cr loop; rewrite (degree_loop cr loop) => /negbTE even.
have [lab labE] := ridge_labelling marks_sym cr loop even.
by exists lab => t u /labE->; case: (lab t) (lab u) => [] [].
Qed.

(* In a mesh of triangles the star of a vertex inside is simply connected.    *)
Lemma simply_connected_triangles v s : n = 2 -> dual_loop M [set v] s -> simply_connected_star v.
Proof.
move=> n2 loop x x_sym even; have cv : #|[set v]|.+1 = n by rewrite cards1 n2.
have [lab labE] := ridge_labelling x_sym cv loop (even _ _ cv (set11 v) loop).
move=> t p tp back; rewrite (@labelling_walk _ (star_adjacent v) x lab) ?back ?addbb //.
by move=> a b /andP[ab vab]; apply: labE; rewrite /around ab sub1set.
Qed.

(* Theorem C for triangles, a vertex inside: if the triangles around v form a *)
(* loop and an even number of the edges at v is in C, all of those open at v. *)
Theorem theoremC_triangles v s t u : n = 2 -> dual_loop M [set v] s -> ~~ odd (degree [set v]) ->
  star_adjacent v t u -> marks t u -> opens v t u.
Proof.
move=> n2 loop even; apply: theoremC_even; first exact: simply_connected_triangles loop.
move=> r s' cr vr _; suff -> : r = [set v] by [].
apply/esym/eqP; rewrite eqEcard sub1set vr cards1.
by rewrite -ltnS cr n2.
Qed.

(* Theorem C for triangles, a vertex on the boundary: if the triangles around *)
(* v can be listed so that only neighbours in the list share an edge with v,  *)
(* all edges of C at v open at v; their number does not matter.               *)
Theorem theoremC_path v s t u :
  (forall a b, star_adjacent v a b -> a \in s /\
     (index b s = (index a s).+1 \/ index a s = (index b s).+1)) ->
  star_adjacent v t u -> marks t u -> opens v t u.
Proof.
move=> line tu C_tu; case: s line => [|t0 p] line; first by have [] := line t u tu.
pose lab a := parity marks t0 (take (index a (t0 :: p)) p).
apply: (@theoremC v lab) tu C_tu => a b ab.
have step c d : c \in t0 :: p -> d \in t0 :: p -> index d (t0 :: p) = (index c (t0 :: p)).+1 ->
    marks c d = (lab c != lab d).
  move=> cs ds dc; have ip : index c (t0 :: p) < size p by rewrite -ltnS -dc index_mem.
  rewrite /lab dc (take_nth t0) // parity_rcons.
  have -> : nth t0 p (index c (t0 :: p)) = d.
    by rewrite -[LHS]/(nth t0 (t0 :: p) _.+1) -dc nth_index.
  have -> : last t0 (take (index c (t0 :: p)) p) = c.
    by rewrite (last_nth t0) size_take ip -[t0 :: _]/(take _.+1 (t0 :: p)) nth_take // nth_index.
  by case: parity; case: marks.
have [as_ ab_] := line a b ab; have [bs _] := line b a (etrans (star_adjacent_sym v b a) ab).
by case: ab_ => [|e]; [exact: step | rewrite marks_sym (step b a) // eq_sym].
Qed.
End Opening.
