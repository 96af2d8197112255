(******************************************************************************)
(* The theorems T1 to T13, and certify, for the reader who believes nothing.  *)
(* They are stated over the definitions of complex.v and of unglue, as far as *)
(* possible, and their proofs are references. The facts that come first say   *)
(* what those definitions are; Coq checks them, so they cannot be out of date.*)
(* What is left to trust is Coq, and that these facts mean what you mean.     *)
(*   M : complex n V T  cells t : T are sets M t of n.+1 vertices in V        *)
(*         C            a cut: a set of facets, which are sets of vertices    *)
(*      (v, t)          the corner of the cell t at v, and the half-facet of t*)
(*                      opposite v, which has the vertices facet M (v, t)     *)
(*   connect r x y      a chain of steps of the relation r leads from x to y  *)
(*   T1 cells stay             T6 which vertices split   T11 Algorithm 3      *)
(*   T2 pseudo-manifolds stay  T7 nothing opens more     T12 cut and stitch   *)
(*   T3 what opens             T8 cuts in stages         T13 Algorithm 5      *)
(*   T4 cut-regular result     T9 pieces                 certify              *)
(*   T5 what changes nothing   T10 closed boundary       two_sides: selection *)
(*                                                   checker: certify_exec    *)
(* What fem.v, elastic_kernel.v, lemma1.v, nearest_vertex.v and others prove  *)
(* of elasticity and of the choice of facets needs definitions of its own, and*)
(* is read there. The counterexamples are in examples.v and torus.v.          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra fingroup perm.
From Cleave Require Import complex isomorphism relabelling unglue algorithm3 incision.
From Cleave Require Import orientation algorithm5 boundary oriented_boundary.
From Cleave Require Import canonical canonical_complex certify dual_edge star_opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* What the definitions are                                                   *)

Section Definitions.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).
Implicit Types (t u : T) (v w : V) (f : {set V}).

Fact cells_have_vertices t : #|M t| = n.+1. Proof. exact: card_vertices. Qed.

Fact cells_differ t u : M t = M u -> t = u. Proof. exact: vertices_inj. Qed.

Fact facet_is v t : facet M (v, t) = M t :\ v. Proof. by []. Qed.

Fact mates_are v t w u :
  mates M (v, t) (w, u) = [&& v \in M t, w \in M u, t != u & M t :\ v == M u :\ w].
Proof. by []. Qed.

Fact boundary_is f : f \in boundary M = (#|f| == n) && (#|[set t | f \subset M t]| == 1).
Proof. exact: in_set. Qed.

Fact pseudo_manifold_is :
  pseudo_manifold M = (forall f, #|f| = n -> #|[set t | f \subset M t]| <= 2).
Proof. by []. Qed.

Fact adjacent_is t u : adjacent M t u = (#|M t :&: M u| == n). Proof. by []. Qed.

Fact glue_is v t w u : glue M C (v, t) (w, u) =
  [&& v == w, v \in M t :&: M u, #|M t :&: M u| == n & M t :&: M u \notin C].
Proof. by []. Qed.

Fact cut_regular_is : cut_regular M =
  (forall v t u, v \in M t -> v \in M u -> connect (glue M set0) (v, t) (v, u)).
Proof. by []. Qed.

Fact unglue_is t : unglue M C t = [set copy M C (v, t) | v in M t].
Proof. by []. Qed.

Fact copies_are v t w u :
  (copy M C (v, t) == copy M C (w, u)) = connect (glue M C) (v, t) (w, u).
Proof. exact: copy_eq. Qed.

Fact parents_are v t : parent (copy M C (v, t)) = v.
Proof. exact: copyK. Qed.

Fact isomorphic_is (W : finType) (N : complex n W T) : isomorphic M N <->
  exists h : V -> W, {in used M &, injective h} /\ forall t, N t = [set h v | v in M t].
Proof. by split=> [[h hi hE]|[h [hi hE]]]; exists h. Qed.

(* Orientation: o gives each cell an order of its vertices, and reverses some.
   A half-facet is a sign and an order; osame says that two of them differ by
   a permutation of that sign; mate changes the sign.                         *)
Variable o : orientation M.
Implicit Types i j : 'I_n.+1.

Fact order_is t : [set v in o t] = M t. Proof. exact: tuple_ofP. Qed.

Fact half_facet_is t i :
  half_facet o t i = (reversed o t (+) odd i, [tuple tnth (o t) (lift i k) | k < n]).
Proof. by []. Qed.

Fact osame_is (a b : bool * n.-tuple V) : osame a b =
  [exists s : 'S_n, (b.2 == [tuple tnth a.2 (s k) | k < n]) && (b.1 == a.1 (+) odd_perm s)].
Proof. by []. Qed.

Fact mate_is (a : bool * n.-tuple V) : mate a = (~~ a.1, a.2). Proof. by []. Qed.

Fact coherent_is : coherent o <-> forall t i u j, t != u ->
  M t :\ tnth (o t) i = M u :\ tnth (o u) j -> osame (mate (half_facet o t i)) (half_facet o u j).
Proof.
by split=> co t i u j tu e; apply: co => //; move: e; rewrite !half_facet_set.
Qed.

(* Algorithm 5: T13 says which cell neighbour finds. flood_step is one step of
   the recursion at v.                                                        *)
Fact neighbour_is t j : neighbour o t j =
  omap fst [pick x : T * 'I_n.+1 | osame (mate (half_facet o t j)) (half_facet o x.1 x.2)].
Proof. by []. Qed.

Fact flood_step_is v t u : flood_step o v t u =
  [exists j, (v \in M t :\ tnth (o t) j) && (neighbour o t j == Some u)].
Proof. by []. Qed.

(* Algorithm 3: a state gives each corner (v, t) a node: (v, None) is v, not yet
   treated; (v, Some u) a copy of v. To treat N is to give each corner at N the
   copy that the root of its component names, in the complex of that state.   *)
Implicit Types (x : V * T) (ns : seq V).

Fact loop_starts x : algorithm3 M C [::] x = (x.1, None). Proof. by []. Qed.

Fact loop_step ns N x : let l := algorithm3 M C ns in
  algorithm3 M C (rcons ns N) x = if x.1 == N then (N, Some (component M C l x)) else l x.
Proof. by rewrite /= {1}/algorithm3 -cats1 foldl_cat. Qed.

Fact component_is l x : component M C l x =
  (fingraph.root (glue (complex_of M l) [set f : {set node V T} | parent @: f \in C]) (l x, x.2)).2.
Proof. by []. Qed.

Fact state_is (l : labelling V T) t : complex_of M l t = [set l (v, t) | v in M t].
Proof. by []. Qed.

End Definitions.

(* Incisions: a state s gives each corner x a vertex, label s x, and has a set
   of scored facets. stays picks one of the vertices that across unites.      *)

Section Incisions.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (s : incision V T) (t u : T) (v : V) (F : {set {set V}}) (x : V * T).

Fact originals_are s x : original s (label s x) = x.1. Proof. exact: labelK. Qed.

Fact now_is s t : now M s t = [set label s (v, t) | v in M t]. Proof. by []. Qed.

Fact start_is x : label (start V T) x = x.1 /\ scored (start V T) = set0. Proof. by []. Qed.

Fact shut_is s f : f \in shut M s <-> f \in scored s /\
  exists h k, mates (now M s) h k /\ original s @: facet (now M s) h = f.
Proof.
rewrite inE; split=> [/andP[-> /existsP[h /existsP[k /andP[hk /eqP e]]]]|[-> [h [k [hk e]]]]].
  by split=> //; exists h, k.
by apply/existsP; exists h; apply/existsP; exists k; rewrite hk e eqxx.
Qed.

Fact cut_is s F : (forall t, now M (cut M s F) t =
    unglue (now M s) [set f : {set names s} | original s @: f \in shut M s :|: F] t) /\
  scored (cut M s F) = scored s :|: F.
Proof. by split=> // t; exact: now_cut. Qed.

Fact stitch_is s F : (forall t, now M (stitch M s F) t = [set stays M F w | w in now M s t]) /\
  scored (stitch M s F) = scored s :\: F.
Proof. by split=> // t; exact: now_stitch. Qed.

Fact stays_are s F w w' : (@stays _ _ _ M s F w == stays M F w') = connect (@across _ _ _ M s F) w w'.
Proof. exact: stays_eq. Qed.

Fact across_is s F w w' : @across _ _ _ M s F w w' <-> exists a t b u v,
  [/\ mates M (a, t) (b, u), ~~ mates (now M s) (label s (a, t), t) (label s (b, u), u),
      M t :\ a \in F, v \in M t :\ a & (w, w') = (label s (v, t), label s (v, u))].
Proof.
split=> [/acrossP[[a t] [[b u] [v [? ? ? ? ?]]]]|[a [t [b [u [v [? ? ? ? ?]]]]]]].
  by exists a, t, b, u, v.
by apply/acrossP; exists (a, t), (b, u), v.
Qed.

(* What is written: the rows of numbers of the cells, in the order of o. A part
   that stands for its old vertex has the number of that; the others follow.  *)
Fact row_is (o : orientation M) s t :
  row o s t = [seq canonical M (corner_number o) (label s) (v, t) | v <- o t].
Proof. by []. Qed.

Fact run_is s F steps : [/\ run M s [::] = s,
  run M s (Cut F :: steps) = run M (cut M s F) steps
  & run M s (Stitch F :: steps) = run M (stitch M s F) steps].
Proof. by []. Qed.

End Incisions.

(* The theorems                                                               *)

Section Theorems.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).
Implicit Types (t u : T) (v w : V).

(* T1: the same cells, still of n.+1 vertices and different, that parent maps
   back one to one.                                                           *)
Theorem T1 t : [/\ #|unglue M C t| = n.+1, forall u, unglue M C t = unglue M C u -> t = u,
  parent @: unglue M C t = M t & {in unglue M C t &, injective parent}].
Proof. split; [exact: T1_card | exact: T1_inj | exact: T1_proj | exact: T1_bij]. Qed.

(* T2: pseudo-manifolds stay so; half-facets correspond one to one, in the same
   cell and with the same parents, and mates were mates.                      *)
Theorem T2 : (pseudo_manifold M -> pseudo_manifold (unglue M C)) /\
  let now v t := (copy M C (v, t), t) in
  [/\ forall v t, v \in M t -> corner (unglue M C) (now v t),
      forall x, corner (unglue M C) x -> exists v t, v \in M t /\ x = now v t,
      forall v t w u, now v t = now w u -> (v, t) = (w, u),
      forall v t, parent @: facet (unglue M C) (now v t) = facet M (v, t)
    & forall v t w u, mates (unglue M C) (now v t) (now w u) -> mates M (v, t) (w, u)].
Proof.
split=> [|now]; first exact: T2_pseudo_manifold.
have [c s i f m] := T2_half_facets M C; split=> [v t|x /s[[v t] vt ->]|v t w u|v t|v t w u].
- exact: (c (v, t)).
- by exists v, t.
- exact: (i (v, t) (w, u)).
- by have [] := f (v, t).
- exact: m.
Qed.

(* T2: a coherent orientation stays coherent.                                 *)
Theorem T2_oriented (o : orientation M) :
  coherent o -> coherent (relabelled_orientation o (copyK M C)).
Proof. exact: T2_coherent. Qed.

(* T3: an interior facet opens iff at one of its vertices the corners of its
   two cells are not connected; if so it is in C. What was apart stays apart. *)
Theorem T3 t u : [/\
  adjacent M t u -> ~~ adjacent (unglue M C) t u <->
    exists2 v, v \in M t :&: M u & ~~ connect (glue M C) (v, t) (v, u),
  adjacent M t u -> ~~ adjacent (unglue M C) t u -> M t :&: M u \in C
  & adjacent (unglue M C) t u -> adjacent M t u].
Proof.
split=> [tu|tu|]; last exact: T3_old; last by apply: contraR; apply: T3_only.
by rewrite T3_adjacent tu negb_forall_in; split=> /exists_inP.
Qed.

(* T4: the result is cut-regular, whatever the input; and even if the facets of
   C that stayed shut are left out, those that remain hold each vertex together.
   *)
Theorem T4 : cut_regular (unglue M C) /\
  forall c t u, c \in unglue M C t -> c \in unglue M C u ->
    connect (glue (unglue M C) [set f : {set V * T} | parent @: f \in C]) (c, t) (c, u).
Proof. by split=> [|c]; [exact: T4_cut_regular | exact: T4_lifted]. Qed.

(* T5: the empty cut changes nothing iff M is cut-regular; and no cut changes
   anything when it is made again.                                            *)
Theorem T5 : (isomorphic (unglue M set0) M <-> cut_regular M) /\
  isomorphic (unglue (unglue M C) [set f : {set V * T} | parent @: f \in C]) (unglue M C).
Proof. split; [exact: T5_iff | exact: T5_idempotent]. Qed.

(* T6: in a cut-regular complex a vertex on no facet of C does not split; and
   there are as many vertices as components of corners.                       *)
Theorem T6 :
  (cut_regular M -> forall v t u, (forall f, f \in C -> v \notin f) ->
     v \in M t -> v \in M u -> copy M C (v, t) = copy M C (v, u)) /\
  #|used (unglue M C)| = #|used M| +
    \sum_(v in used M) (n_comp (glue M C) [pred x | (x.1 == v) && corner M x]).-1.
Proof.
split=> [r v t u off vt vu|]; first by apply: T6_local; rewrite ?inE.
by rewrite T6_new; congr (_ + _); apply: eq_bigr => v _; rewrite T6_components.
Qed.

(* T7: if a splitting of vertices, that gives the corner x the copy lab x of
   its vertex, opens only facets of C, then it is unglue followed by a merging
   of copies; so what unglue leaves shut, it leaves shut. If unglue is also a
   merging of it, both are the same. T3 says that unglue opens only facets of
   C; t0 says that there are cells.                                           *)
Theorem T7 (W : finType) (p : W -> V) (lab : V * T -> W) (lab_copies : forall x, p (lab x) = x.1) :
    let N := relabel M lab_copies in
    (forall t u, adjacent M t u -> ~~ adjacent N t u -> M t :&: M u \in C) ->
  [/\ exists h : V * T -> W, forall x, lab x = h (copy M C x),
      forall t u, adjacent (unglue M C) t u -> adjacent N t u
    & forall t0 : T, (exists g : W -> V * T, forall x, copy M C x = g (lab x)) ->
        isomorphic N (unglue M C)].
Proof.
move=> N only; split=> [|t u|t0]; first exact: T7_universal only.
- exact: T7_shut only.
- exact: T7_unique.
Qed.

(* T8: a larger cut separates at least as much.                               *)
Theorem T8 (C' : {set {set V}}) (x y : V * T) : C \subset C' ->
  copy M C' x = copy M C' y -> copy M C x = copy M C y.
Proof. by move=> sC; exact: T8_mono. Qed.

(* T8: a cut C1 and then a cut C2 are the cut of both, if the second stage
   repeats the facets that the first one left shut.                           *)
Theorem T8_stages (t0 : T) (C1 C2 : {set {set V}}) : pseudo_manifold M ->
  let shut := [set f in C1 | [exists t, exists u,
                 adjacent (unglue M C1) t u && (M t :&: M u == f)]] in
  isomorphic (unglue (unglue M C1) (lifted parent (shut :|: C2))) (unglue M (C1 :|: C2)).
Proof. exact: T8_remembered. Qed.

(* T9: cells are in one piece after the cut iff facets outside C connect them
   before; and in a cut-regular complex cells that share a vertex are in one. *)
Theorem T9 : 0 < n ->
  (forall t u, connect (adjacent (unglue M C)) t u =
     connect [rel a b | adjacent M a b && (M a :&: M b \notin C)] t u) /\
  (forall v t u, cut_regular M -> v \in M t -> v \in M u -> connect (adjacent M) t u).
Proof. by split=> [|v t u]; [exact: T9_pieces | exact: T9_vertex]. Qed.

(* T10: an even number of boundary facets meet in each ridge, before and after. *)
Theorem T10 : pseudo_manifold M ->
  (forall r : {set V}, #|r|.+1 = n -> ~~ odd #|[set f in boundary M | r \subset f]|) /\
  (forall r : {set V * T}, #|r|.+1 = n -> ~~ odd #|[set f in boundary (unglue M C) | r \subset f]|).
Proof. by move=> pm; split=> r; [exact: T10_mod2 | exact: T10_unglue]. Qed.

(* T11: the loop of Algorithm 3 over all vertices, in any order and with any
   repetition, is unglue; for a cut-regular complex so it is over those of C.
   algorithm3.v has the loop, in a few lines.                                 *)
Theorem T11 (t0 : T) (ns : seq V) :
    (forall v, v \in used M -> v \in ns) \/
    (cut_regular M /\ forall v f, v \in used M -> f \in C -> v \in f -> v \in ns) ->
  isomorphic (complex_of M (algorithm3 M C ns)) (unglue M C).
Proof.
case=> [all|[r some]]; first exact: T11_all.
apply: T11_local => // v; rewrite inE => /andP[vM /bigcupP[f fC vf]].
exact: some vf.
Qed.

(* T12: from a cut-regular start, after any cuts and stitches the state is
   unglue of the start by the facets that are scored now; so it depends on these
   alone, and if there are none, it is the start.                             *)
Theorem T12 (t0 : T) steps steps' : cut_regular M ->
  let s := run M (start V T) steps in let s' := run M (start V T) steps' in
  [/\ isomorphic (now M s) (unglue M (scored s)),
      scored s = scored s' -> isomorphic (now M s) (now M s')
    & scored s = set0 -> isomorphic (now M s) M].
Proof. by move=> r; split; [exact: T12_state | exact: T12_alone | exact: T12_back]. Qed.

(* T12: from any start, to stitch F after the cut C is to cut the others of C;
   and to stitch all of C gives the start back iff that was cut-regular.      *)
Theorem T12_stitched (t0 : T) (F : {set {set V}}) :
  isomorphic (now M (stitch M (cut M (start V T) C) F)) (unglue M (C :\: F)) /\
  (isomorphic (now M (stitch M (cut M (start V T) C) C)) M <-> cut_regular M).
Proof. by split; [exact: T12_stitch | exact: T12_regular]. Qed.

(* T12: equal scored sets give equal files: number for number the same rows,
   each in the order that o gives its cell.                                   *)
Theorem T12_written (o : orientation M) steps steps' : cut_regular M ->
  let s := run M (start V T) steps in let s' := run M (start V T) steps' in
  scored s = scored s' -> forall t, row o s t = row o s' t.
Proof. exact: T12_rows. Qed.

(* T13: Algorithm 5 finds the other cell at a facet, and following it at a
   vertex finds the whole star iff the vertex is cut-regular.                 *)
Theorem T13 (o : orientation M) : coherent o ->
  (forall t j u, neighbour o t j = Some u <-> u != t /\ M t :\ tnth (o t) j \subset M u) /\
  (forall v t, v \in M t ->
     [set u | connect (flood_step o v) t u] = [set u | v \in M u] <->
     (forall s u, v \in M s -> v \in M u -> connect (glue M set0) (v, s) (v, u))).
Proof.
move=> co; split=> [t j u|v t vt]; first exact: T13_algorithm5.
by rewrite -T13_flood_step //; exact: T13_flood.
Qed.

(* certify: names for the corners after a cut pass its three clauses iff they
   are those of unglue up to renaming. W: the vertices of the other mesh.     *)
Theorem certify (W : eqType) (name : V * T -> W) :
  [/\ forall v t w u, v \in M t -> w \in M u -> name (v, t) = name (w, u) -> v = w,
      forall t u v, adjacent M t u -> M t :&: M u \notin C -> v \in M t :&: M u ->
        name (v, t) = name (v, u)
    & forall v t w u, v \in M t -> w \in M u -> name (v, t) = name (w, u) ->
        connect (glue M C) (v, t) (w, u)] <->
  exists2 f : V * T -> W, {in used (unglue M C) &, injective f} &
    forall v t, v \in M t -> name (v, t) = f (copy M C (v, t)).
Proof.
have [sound complete] := certify_sound_complete M C name; split=> [[a b c]|[f fi fE]].
  case: sound => [|f fi fE]; last by exists f => // v t vt; apply: fE.
  by split=> [[v t] [w u] cx cy|//|[v t] [w u] cx cy]; [exact: a | exact: c].
have [a b c] : certified M C name by apply: complete; exists f => // -[v t]; exact: fE.
by split=> [v t w u vt wu|//|v t w u vt wu]; [exact: (a (v, t) (w, u)) | exact: (c (v, t) (w, u))].
Qed.

(* Selection: a cut of all facets between cells on different sides, for any two
   sides, separates them, and opens entirely.                                 *)
Theorem two_sides (side : T -> bool) : 0 < n ->
    (forall t u, adjacent M t u -> (M t :&: M u \in C) = (side t != side u)) ->
  (forall t u, connect (adjacent (unglue M C)) t u -> side t = side u) /\
  (forall t u, adjacent M t u -> M t :&: M u \in C -> ~~ adjacent (unglue M C) t u).
Proof.
move=> n0 sides; split=> t u; first exact: (theoremB_separates n0 sides).
exact: (theoremC_full n0 sides).
Qed.

End Theorems.

(* T10: the oriented boundary of a coherent complex is a cycle: its boundary
   vanishes on every alternating function of n vertices, and after any cut.   *)
Theorem T10_signed n (V T : finType) (M : complex n.+1 V T) (o : orientation M)
    (C : {set {set V}}) (o' := relabelled_orientation o (copyK M C)) (R : numDomainType) :
  coherent o ->
  (forall phi : n.-tuple V -> R, alternating phi ->
     (\sum_(x : T * 'I_n.+2 | oset (half_facet o x.1 x.2) \in boundary M)
        value (bdryT phi) (half_facet o x.1 x.2) = 0)%R) /\
  (forall phi : n.-tuple (prod_finType V T) -> R, alternating phi ->
     (\sum_(x : T * 'I_n.+2 | oset (half_facet o' x.1 x.2) \in boundary (unglue M C))
        value (bdryT phi) (half_facet o' x.1 x.2) = 0)%R).
Proof. by move=> co; split=> phi; [exact: T10_oriented | exact: T10_oriented_unglue]. Qed.

(* The extracted checker                                                      *)

(* It reads rows of numbers, as positives: p stands for the number p - 1. nv is
   any bound on the numbers of the vertices.                                  *)
From Coq Require Import PArith.
From Cleave Require Import listed_complex tries prepare denote valid certify_exec.

Section Checker.
Variables n nv : nat.
Implicit Types (before cut after rows : seq (seq positive)) (row : seq positive).
Implicit Types (cs : seq (seq nat)) (v : 'I_nv).

Fact nats_are rows : nats rows = [seq [seq (Pos.to_nat p).-1 | p <- row] | row <- rows].
Proof. by []. Qed.

Fact fits_is rows : fits nv rows = all (all (fun p => (Pos.to_nat p).-1 < nv)) rows.
Proof. by []. Qed.

Fact long_is row : long n row = (size row == n.+1). Proof. by []. Qed.

Fact wf_is cs : wf n nv cs <->
  (forall c, c \in cs -> [/\ size c = n.+1, uniq c & forall k, k \in c -> k < nv]) /\
  (forall i j, i < size cs -> j < size cs -> nth [::] cs i =i nth [::] cs j -> i = j).
Proof.
split=> [/andP[/allP good /allP differ]|[good differ]].
  split=> [c /good/and3P[/eqP sc uc /allP bc] //|i j il jl e].
  apply/eqP/negPn/negP => ij; move: (differ i); rewrite mem_iota il => /(_ isT)/allP/(_ j).
  rewrite mem_iota jl (negPf ij) => /(_ isT)/negP; apply.
  by apply/andP; split; apply/allP => k; rewrite /= /cell e.
apply/andP; split.
  by apply/allP => c /good[-> -> bc]; rewrite eqxx; apply/allP.
apply/allP => i; rewrite mem_iota => /andP[_ il]; apply/allP => j; rewrite mem_iota => /andP[_ jl].
case: eqP => //= ij; apply/negP => /andP[/allP ji /allP ij']; case: ij.
by apply: differ => // k; apply/idP/idP; [exact: ij' | exact: ji].
Qed.

Fact ecomplex_is cs (ok : wf n nv cs) t v : (v \in ecomplex ok t) = (val v \in nth [::] cs t).
Proof. by rewrite inE. Qed.

Fact ecut_is cs (f : {set 'I_nv}) : f \in ecut nv cs <->
  exists2 g, g \in cs & (forall k, k \in g -> k < nv) /\ f = [set v : 'I_nv | val v \in g].
Proof.
rewrite inE; split=> [/hasP[g]|[g gcs [b fE]]].
  by rewrite mem_filter => /andP[/allP b gcs] /eqP fE; exists g.
apply/hasP; exists g; last exact/eqP.
by rewrite mem_filter gcs andbT; apply/allP.
Qed.

Fact is_facet_is rows row : is_facet n rows row <->
  [/\ size row = n, uniq row & exists2 c, c \in rows & {subset row <= c}].
Proof.
split=> [/and3P[/eqP sr ur /hasP[c cc /allP rc]]|[sr ur [c cc rc]]].
  by split=> //; exists c.
by apply/and3P; split; [exact/eqP | | apply/hasP; exists c => //; apply/allP].
Qed.

Fact vertex_after_is before after (x : 'I_nv * 'I_(size (nats before))) :
  vertex_after before after x =
  nth 1%positive (nth [::] after x.2) (index (Pos.of_succ_nat x.1) (nth [::] before x.2)).
Proof. by []. Qed.

(* checker: the extracted program accepts iff `before` is a pseudo-manifold, the
   cut consists of its facets, and `after` lists the cells of unglue in order,
   with the vertices in the places of their parents, under names of its own.  *)
Theorem checker before cut after : fits nv before ->
  certify_exec n before cut after = Accepted <->
  exists ok : wf n nv (nats before), let K := ecomplex ok in let C := ecut nv (nats cut) in
    [/\ pseudo_manifold K, forall row, row \in cut -> is_facet n before row,
        size before = size after, forall row, row \in after -> size row = n.+1
      & exists2 f : _ -> positive, {in used (unglue K C) &, injective f} &
          forall v t, v \in K t -> vertex_after before after (v, t) = f (copy K C (v, t))].
Proof.
move=> fit; apply: iff_trans (certify_exec_correct n cut after fit) _.
split=> -[ok [pm cf sz la [f fi fE]]]; exists ok; split=> //.
- exact/allP.
- by move=> row /(allP la)/eqP.
- by exists f => // v t; exact: (fE (v, t)).
- exact/allP.
- by apply/allP => row /la/eqP.
- by exists f => // -[v t]; exact: fE.
Qed.

End Checker.
