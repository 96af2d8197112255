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
(* What fem.v, elastic_kernel.v, lemma1.v, nearest_vertex.v and others prove  *)
(* of elasticity and of the choice of facets needs definitions of its own, and*)
(* is read there. The counterexamples are in examples.v and torus.v.          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra fingroup perm.
From Cleave Require Import complex isomorphism relabelling unglue incision.
From Cleave Require Import orientation algorithm5 boundary oriented_boundary algorithm3.
From Cleave Require Import certify dual_edge star_opening.
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

End Definitions.

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

(* T4: the result is cut-regular, whatever the input.                         *)
Theorem T4 : cut_regular (unglue M C).
Proof. exact: T4_cut_regular. Qed.

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
   of copies; so what unglue leaves shut, it leaves shut.                     *)
Theorem T7 (W : finType) (p : W -> V) (lab : V * T -> W) (lab_copies : forall x, p (lab x) = x.1) :
    let N := relabel M lab_copies in
    (forall t u, adjacent M t u -> ~~ adjacent N t u -> M t :&: M u \in C) ->
  (exists h : V * T -> W, forall x, lab x = h (copy M C x)) /\
  (forall t u, adjacent (unglue M C) t u -> adjacent N t u).
Proof. by move=> N only; split; [exact: T7_universal only | move=> t u; exact: T7_shut only]. Qed.

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

(* T12: after any cuts and stitches the state is unglue of the start by the
   facets that are scored now; if there is none, it is the start. incision.v
   says what cut and stitch do.                                               *)
Theorem T12 (t0 : T) steps : cut_regular M ->
  let s := run M (start V T) steps in
  isomorphic (now M s) (unglue M (scored s)) /\ (scored s = set0 -> isomorphic (now M s) M).
Proof. by move=> r; split; [exact: T12_state | exact: T12_back]. Qed.

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
