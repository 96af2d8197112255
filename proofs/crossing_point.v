(******************************************************************************)
(* From points to heights: why lemma1.v may speak of heights alone.  Points   *)
(* are rows of d numbers (d = 3: space).  The paper compares the distances    *)
(* of the two ends of an edge to the point where the edge meets the sweep;    *)
(* for a plane this is the comparison of the two heights over it.  A sweep    *)
(* triangle instead of its plane can only put fewer vertices in.              *)
(*         dot p q == scalar product                                          *)
(*       dist2 p q == squared distance, which needs no square root            *)
(*     along p q s == the point of the line pq at parameter s: p at 0, q at   *)
(*                    1, so the edge pq is 0 <= s <= 1                        *)
(*    height N c p == N.p - c, up to a factor the signed distance of p to the *)
(*                    plane {p | N.p = c}                                     *)
(*     plane N c p == p is on that plane                                      *)
(*        hull q p == p is in the convex hull of the points q i: of a sweep   *)
(*                    triangle if there are three                             *)
(*     picks S p q == the edge pq meets the set S in a point to which p is at *)
(*                    least as close as q                                     *)
(* closest S x A v == v, one of the vertices A of a cell with places x, is in *)
(*                    the cell's closest set of S, by the paper's words       *)
(* Main theorems:                                                             *)
(*     closest_end == at the point where an edge meets the plane: the first   *)
(*                    end is as close as the last iff its |height| is no more *)
(*   closest_plane == for a plane the closest set is lemma1.v's               *)
(* lemma1_triangle == for a triangle it is a subset of its plane's            *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import lemma1.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section CrossingPoint.
Variables (R : realFieldType) (d : nat).
Local Notation point := 'rV[R]_d.
Implicit Types (p q : point) (c s : R).

Definition dot p q : R := \sum_i p 0 i * q 0 i.
Definition dist2 p q := dot (p - q) (p - q).
Definition along p q s := p + s *: (q - p).
Definition height (N : point) c p := dot N p - c.

Definition plane N c p := height N c p = 0.

Lemma dotDr p q q' : dot p (q + q') = dot p q + dot p q'.
Proof. by rewrite -big_split; apply: eq_bigr => i _; rewrite mxE mulrDr. Qed.

Lemma dotZr p s q : dot p (s *: q) = s * dot p q.
Proof. by rewrite mulr_sumr; apply: eq_bigr => i _; rewrite mxE mulrCA. Qed.

Lemma dotBr p q q' : dot p (q - q') = dot p q - dot p q'.
Proof. by rewrite dotDr -scaleN1r dotZr mulN1r. Qed.

Lemma dotZZ s p : dot (s *: p) (s *: p) = s ^+ 2 * dot p p.
Proof. by rewrite mulr_sumr; apply: eq_bigr => i _; rewrite !mxE mulrACA expr2. Qed.

Lemma dot_gt0 p : (0 < dot p p) = (p != 0).
Proof.
have sq_ge0 (i : 'I_d) : true -> 0 <= p 0 i * p 0 i by rewrite -expr2 sqr_ge0.
rewrite lt_neqAle sumr_ge0 // andbT eq_sym; congr (~~ _); apply/eqP/eqP => [/eqP|->].
  rewrite psumr_eq0 // => /allP p0; apply/rowP => i; rewrite mxE; apply/eqP.
  by have := p0 i (mem_index_enum i); rewrite mulf_eq0 orbb.
by rewrite /dot big1 // => i _; rewrite mxE mul0r.
Qed.

Lemma dist2_first p q s : dist2 (along p q s) p = s ^+ 2 * dist2 q p.
Proof. by rewrite /dist2 /along addrAC subrr add0r dotZZ. Qed.

Lemma dist2_last p q s : dist2 (along p q s) q = (1 - s) ^+ 2 * dist2 q p.
Proof.
rewrite /dist2 (_ : along p q s - q = (s - 1) *: (q - p)).
  by rewrite dotZZ -sqrrN opprB.
by rewrite /along scalerBl scale1r opprB addrAC addrC.
Qed.

Lemma height_along N c p q s :
  height N c (along p q s) = (1 - s) * height N c p + s * height N c q.
Proof.
rewrite /height /along dotDr dotZr dotBr; set a := dot N p; set b := dot N q.
rewrite [(1 - s) * _]mulrBl mul1r addrAC -[in RHS]addrA; congr (_ + _).
by rewrite [RHS]addrC -mulrBr opprB addrA subrK.
Qed.

(* The edge of two points, not both on the plane, meets the plane in one      *)
(* point at most, and the first end is at least as close to it as the last    *)
(* iff its height is at most that of the last.                                *)
Theorem closest_end N c p q s : 0 <= s <= 1 -> plane N c (along p q s) ->
  (height N c p != 0) || (height N c q != 0) ->
  (dist2 (along p q s) p <= dist2 (along p q s) q) = (`|height N c p| <= `|height N c q|).
Proof.
move=> /andP[s0 s1]; rewrite /plane height_along.
set a := height N c p; set b := height N c q => e0 not_both.
have /eqP := e0; rewrite addr_eq0 => /eqP e1; have e : (1 - s) * `|a| = s * `|b|.
  by rewrite -[1 - s]ger0_norm ?subr_ge0 // -{2}[s]ger0_norm // -!normrM e1 normrN.
have pq : q != p.
  apply: contraTneq not_both => qp; move: e0; rewrite -/a -/b negb_or !negbK.
  have -> : b = a by rewrite /b qp.
  by rewrite -mulrDl subrK mul1r => ->; rewrite eqxx.
rewrite dist2_first dist2_last ler_pmul2r; last by rewrite dot_gt0 subr_eq0.
rewrite ler_sqr ?qualifE //= ?subr_ge0 //; apply/idP/idP => [le|ab].
  have s1' : 0 < 1 - s.
    rewrite lt_neqAle subr_ge0 s1 andbT; apply/eqP => z; move: le; rewrite -z => s_le0.
    have z0 : s = 0 by apply: le_anti; rewrite s0 s_le0.
    by move/eqP: z; rewrite z0 subr0 eq_sym oner_eq0.
  by rewrite -(ler_pmul2l s1') e ler_wpmul2r ?normr_ge0.
have b0 : 0 < `|b|.
  rewrite normr_gt0; apply: contraTneq not_both => b0; rewrite -/a -/b negb_or !negbK b0 eqxx.
  by rewrite b0 normr0 normr_le0 in ab; rewrite ab.
by rewrite -(ler_pmul2r b0) -e ler_wpmul2l // subr_ge0.
Qed.

(* Such a point exists iff the ends are not both strictly on one side.        *)
Lemma sign_change (a b : R) : a * b <= 0 <-> exists2 s, 0 <= s <= 1 & (1 - s) * a + s * b = 0.
Proof.
have rootE s : (1 - s) * a + s * b = 0 <-> a = s * (a - b).
  rewrite mulrBl mul1r -addrA [- _ + _]addrC -mulrBr -opprB mulrN.
  by split=> /eqP; [rewrite subr_eq0 | rewrite -subr_eq0] => /eqP.
split=> [ab|[s /andP[s0 s1] /rootE e]].
  have [a_b|a_b] := eqVneq a b.
    exists 0; rewrite ?lexx ?ler01 //; apply/rootE; rewrite mul0r.
    by apply/eqP; rewrite -sqrf_eq0 eq_le sqr_ge0 andbT expr2 {2}a_b.
  have ab0 : a - b != 0 by rewrite subr_eq0.
  have sq0 : 0 <= ((a - b) ^+ 2)^-1 by rewrite invr_ge0 sqr_ge0.
  have fracE x : x / (a - b) = x * (a - b) * ((a - b) ^+ 2)^-1.
    by rewrite expr2 invfM !mulrA mulfK.
  exists (a / (a - b)); last by apply/rootE; rewrite mulfVK.
  apply/andP; split; first rewrite fracE mulr_ge0 //.
    by rewrite mulrBr subr_ge0 (le_trans ab) // -expr2 sqr_ge0.
  rewrite -subr_ge0 -{1}(divff ab0) -mulrBl addrAC subrr add0r fracE mulr_ge0 //.
  by rewrite mulNr -mulrN opprB mulrBr subr_ge0 mulrC (le_trans ab) // -expr2 sqr_ge0.
have E : (1 - s) * (a * b) = - (s * b ^+ 2).
  by rewrite mulrBl mul1r {1}e mulrBr mulrBl -!mulrA addrAC subrr add0r expr2.
have [//|ab0] := leP (a * b) 0.
have [e1|s1'] := eqVneq s 1.
  have /eqP := E; rewrite e1 subrr mul0r mul1r eq_sym oppr_eq0 sqrf_eq0 => /eqP b0.
  by rewrite b0 mulr0 ltxx in ab0.
have : 0 < (1 - s) * (a * b) by rewrite mulr_gt0 // subr_gt0 lt_neqAle s1' s1.
by rewrite E oppr_gt0 ltNge mulr_ge0 // sqr_ge0.
Qed.

Lemma edge_meets N c p q : height N c p * height N c q <= 0 <->
  exists2 s, 0 <= s <= 1 & plane N c (along p q s).
Proof.
by rewrite sign_change; split=> [] [s s01 e]; exists s; rewrite // /plane height_along in e *.
Qed.

Definition picks (S : point -> Prop) p q := exists2 s, 0 <= s <= 1 &
  S (along p q s) /\ dist2 (along p q s) p <= dist2 (along p q s) q.

(* The paper's "closest to the intersection point" is a test of heights, also *)
(* for edges that lie in the plane.                                           *)
Theorem picks_plane N c p q : picks (plane N c) p q <->
  height N c p * height N c q <= 0 /\ `|height N c p| <= `|height N c q|.
Proof.
have [flat|not_both] := boolP ((height N c p == 0) && (height N c q == 0)).
  have /andP[/eqP p0 /eqP q0] := flat; rewrite p0 q0 mul0r normr0 lexx; split=> // _.
  exists 0; rewrite ?lexx ?ler01 //; rewrite dist2_first dist2_last expr0n mul0r subr0 expr1n mul1r.
  by rewrite /plane height_along p0 q0 !mulr0 addr0 sumr_ge0 // => i _; rewrite -expr2 sqr_ge0.
rewrite negb_and in not_both; split=> [[s s01 [on le]]|[pq le]].
  by split; [apply/edge_meets; exists s | rewrite -(closest_end s01 on not_both)].
by have /edge_meets[s s01 on] := pq; exists s => //; split=> //; rewrite (closest_end s01 on).
Qed.

Section Cell.
Variables (V : finType) (x : V -> point).
Implicit Types (A B : {set V}) (v : V).

Definition closest (S : point -> Prop) A v :=
  v \in A /\ exists2 w, w \in A & w != v /\ picks S (x v) (x w).

(* The closest set of a plane, by points and by heights.                      *)
Theorem closest_plane N c A v :
  closest (plane N c) A v <-> v \in closest_set (height N c \o x) A.
Proof.
rewrite inE; split=> [[vA [w wA [wv /picks_plane[vw le]]]]|].
  by rewrite vA; apply/exists_inP; exists w; rewrite // /crosses wv vw.
case/andP=> vA /exists_inP[w wA /andP[/andP[wv vw] le]]; split=> //.
by exists w => //; split=> //; apply/picks_plane.
Qed.

Definition hull k (q : 'I_k -> point) p := exists2 a : 'I_k -> R,
  (forall i, 0 <= a i) /\ \sum_i a i = 1 & p = \sum_i a i *: q i.

Lemma hull_plane k (q : 'I_k -> point) N c p :
  (forall i, plane N c (q i)) -> hull q p -> plane N c p.
Proof.
move=> qN [a [_ a1] ->]; have dot_sum : dot N (\sum_i a i *: q i) = \sum_i a i * dot N (q i).
  elim/big_rec2: _ => [|i y1 y2 _ <-]; first by rewrite /dot big1 // => i _; rewrite mxE mulr0.
  by rewrite dotDr dotZr.
rewrite /plane /height dot_sum (eq_bigr (fun i => a i * c)) => [|i _].
  by rewrite -mulr_suml a1 mul1r subrr.
by congr (_ * _); apply/eqP; rewrite -subr_eq0; apply/eqP/qN.
Qed.

(* Lemma 1, bounded: what a sweep triangle puts into a cell's set, its plane  *)
(* puts in too.                                                               *)
Theorem lemma1_triangle k (q : 'I_k -> point) N c A v : (forall i, plane N c (q i)) ->
  closest (hull q) A v -> v \in closest_set (height N c \o x) A.
Proof.
move=> qN [vA [w wA [wv [s s01 [on le]]]]]; apply/closest_plane; split=> //.
by exists w => //; split=> //; exists s => //; split=> //; exact: hull_plane on.
Qed.

(* So of one triangle, too, not all vertices are in the set unless the        *)
(* farthest ones on the two sides are equally far.                            *)
Corollary lemma1_triangle_bound k (q : 'I_k -> point) N c A B a b :
  (forall i, plane N c (q i)) -> (1 < #|A|)%N -> extremes (height N c \o x) A a b ->
  height N c (x a) + height N c (x b) != 0 ->
  (forall v, v \in B -> closest (hull q) A v) -> (#|B| < #|A|)%N.
Proof.
move=> qN A2 ex ab inB; apply: leq_ltn_trans (lemma1_bound A2 ex ab).
by apply/subset_leq_card/subsetP => v /inB; exact: lemma1_triangle.
Qed.
End Cell.
End CrossingPoint.
