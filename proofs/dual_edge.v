(******************************************************************************)
(* Theorem B: what the library's own rule of selection, Rule::dual_edge, is   *)
(* good for.  The rule selects a facet iff the segment between the dual       *)
(* points of its two cells crosses the sweep an odd number of times.  Nothing *)
(* here depends on what the sweep is: x is any parity of crossing for pairs   *)
(* of adjacent cells.                                                         *)
(*        dual_cut M x == the selected facets                                 *)
(*      around M r t u == t and u share a facet that contains the ridge r     *)
(*   loop_around M r s == s lists at least three cells, each once, of which   *)
(*                        each shares a facet that contains r with the next,  *)
(*                        and the last with the first                         *)
(*     dual_loop M r s == so, and these are all cells around r: r is inside   *)
(*                        the body, and not pinched                           *)
(*    facets_along M s == the facets that the loop s passes                   *)
(*   coboundary M C lab == the facets of C are those between different labels *)
(*  closes cross o p q == the segments of the triangle o p q cross the sweep  *)
(*                        an even number of times; so it is if the rim of the *)
(*                        sweep does not pass through the triangle (tested    *)
(*                        for the library's predicate, tests/cutting)         *)
(*       towards cross c == the parity between the dual points c t of cells   *)
(* Main theorems:                                                             *)
(* theoremB_loop, theoremB_degree == the number of selected facets along a    *)
(*                          loop, or of those at r, has the parity of the     *)
(*                          crossings of the loop                             *)
(*         theoremB_even == it is even if the rim avoids the triangles that a *)
(*                          point spans with the steps of that loop           *)
(*    theoremB_labelling == the selected facets are those between two sets of *)
(*                          cells iff every closed walk from cell to cell     *)
(*                          crosses an even number of times                   *)
(*       theoremB_no_rim == so it is if the rim avoids all triangles that a   *)
(*                          point spans with the dual edges                   *)
(*    theoremB_separates == then no piece has cells of both sets              *)
(*          theoremB_sum == two sweeps together select what exactly one of    *)
(*                          them selects                                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary parity.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section DualEdge.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u w : T) (f r : {set V}) (s p : seq T) (x y : T -> T -> bool).

Definition dual_cut x : {set {set V}} :=
  [set f | [exists t, exists u, [&& adjacent M t u, common M t u == f & x t u]]].
Definition around r : rel T := fun t u => adjacent M t u && (r \subset common M t u).
Definition loop_around r s := [/\ uniq s, 2 < size s & cycle (around r) s].
Definition dual_loop r s := loop_around r s /\ forall t, (t \in s) = (r \subset M t).
Definition facets_along s : {set {set V}} := [set common M t (next s t) | t in s].
Definition coboundary (C : {set {set V}}) (lab : T -> bool) :=
  forall t u, adjacent M t u -> (common M t u \in C) = (lab t != lab u).

(* Theorem B: between any two cells of one piece, after a cut along all       *)
(* facets between two sets of cells, the label is the same: it separates.     *)
Theorem theoremB_separates C lab t u : 0 < n -> coboundary C lab ->
  connect (adjacent (unglue M C)) t u -> lab t = lab u.
Proof.
move=> n0 labC; rewrite T9_pieces // => /connectP[p + ->{u}].
elim: p t => //= u p IHp t /andP[/andP[tu nC] /IHp<-]; apply/eqP.
by move: nC; rewrite (labC _ _ tu) negbK.
Qed.

Hypothesis pm : pseudo_manifold M.

Lemma two_cells f t u w : #|f| = n -> f \subset M t -> f \subset M u -> f \subset M w ->
  t != u -> t != w -> u = w.
Proof.
move=> cf ft fu fw tu tw; apply: contraTeq (pm cf) => uw; rewrite -ltnNge.
apply: (@leq_trans #|[set t; u; w]|).
  by rewrite setUC cardsU1 cards2 !inE !(eq_sym w) negb_or tw uw tu.
by apply/subset_leq_card/subsetP => z; rewrite !inE => /orP[/orP[]|] /eqP->.
Qed.

Lemma common_inj t u w : adjacent M t u -> adjacent M t w -> common M t u = common M t w -> u = w.
Proof.
move=> tu tw e; have cf : #|common M t u| = n by exact/eqP.
apply: (two_cells cf _ _ _ (adjacent_neq tu) (adjacent_neq tw)); rewrite ?subsetIl ?subsetIr //.
by rewrite e subsetIr.
Qed.

Definition symmetric_parity x := forall t u, adjacent M t u -> x t u = x u t.

Lemma dual_cutP x t u : symmetric_parity x -> adjacent M t u ->
  (common M t u \in dual_cut x) = x t u.
Proof.
move=> x_sym tu; rewrite inE; apply/existsP/idP => [[a /existsP[b /and3P[ab /eqP e xab]]]|xtu].
  have cf : #|common M t u| = n by exact/eqP.
  have at_ : common M t u \subset M a by rewrite -e subsetIl.
  have [ta|ta] := eqVneq t a.
    by rewrite -ta in ab xab e; rewrite (common_inj tu ab).
  have ua : u = a.
    by apply: (two_cells cf _ _ _ (adjacent_neq tu) ta); rewrite ?subsetIl ?subsetIr.
  rewrite x_sym // ua; rewrite -ua in ab xab e *; rewrite (@common_inj u t b) // 1?adjacentC //.
  by rewrite e commonC.
by exists t; apply/existsP; exists u; rewrite tu eqxx.
Qed.

(* Theorem B: sweeps add up.                                                  *)
Theorem theoremB_sum x y t u : symmetric_parity x -> symmetric_parity y -> adjacent M t u ->
  (common M t u \in dual_cut (fun a b => x a b (+) y a b)) =
  (common M t u \in dual_cut x) (+) (common M t u \in dual_cut y).
Proof. by move=> xs ys tu; rewrite !dual_cutP // => a b ab; rewrite xs // ys. Qed.

Section Loop.
Variables (r : {set V}) (s : seq T).
Hypotheses (card_r : #|r|.+1 = n) (loop : loop_around r s).

Lemma next_around t : t \in s -> around r t (next s t).
Proof. by case: loop => _ _ cyc; exact: next_cycle. Qed.

Lemma prev_around t : t \in s -> around r t (prev s t).
Proof.
by case: loop => _ _ cyc /(prev_cycle cyc); rewrite /around adjacentC commonC.
Qed.

Lemma next_next t : t \in s -> next s (next s t) != t.
Proof.
case: loop => us s2 _ ts; have [i s' sE] := rot_to ts.
rewrite -!(next_rot i us) sE; move: us s2; rewrite -(rot_uniq i) -(size_rot i) sE.
case: s' {sE} => [|u [|w s']] //= /and3P[]; rewrite !inE !negb_or.
move=> /and3P[tu tw _] /andP[uw _] _ _.
by rewrite eqxx [u == t]eq_sym (negPf tu) eqxx eq_sym.
Qed.

Lemma next_common_inj : {in s &, injective (fun t => common M t (next s t))}.
Proof.
move=> t u ts us /= e; have /andP[tn _] := next_around ts; have /andP[un _] := next_around us.
apply/eqP/negPn/negP => tu; have cf : #|common M t (next s t)| = n by exact/eqP.
have fu : common M t (next s t) \subset M u by rewrite e subsetIl.
have nt : next s t = u.
  by apply: (two_cells cf _ _ fu (adjacent_neq tn) tu); rewrite ?subsetIl ?subsetIr.
have /eqP[] := next_next ts; rewrite nt.
apply: (two_cells cf fu _ _ (adjacent_neq un)); rewrite ?subsetIl 1?eq_sym //.
by rewrite e subsetIr.
Qed.

(* Theorem B: the number of selected facets that a loop around a ridge passes *)
(* has the parity of the crossings of the loop. A pinched ridge has several   *)
(* loops; this holds for each.                                                *)
Theorem theoremB_loop x : symmetric_parity x ->
  odd #|dual_cut x :&: facets_along s| = loop_parity x s.
Proof.
move=> x_sym; have [us _ _] := loop; rewrite loop_parityE //.
have -> : dual_cut x :&: facets_along s =
          [set common M t (next s t) | t in [set t in s | x t (next s t)]].
  apply/setP => f; apply/setIP/imsetP => [[xf /imsetP[t ts fE]]|[t]]; last first.
    rewrite inE => /andP[ts xt] ->; have /andP[tn _] := next_around ts.
    by rewrite dual_cutP //; split=> //; apply/imsetP; exists t.
  have /andP[tn _] := next_around ts.
  by exists t; rewrite // inE ts -(dual_cutP x_sym tn) -fE.
rewrite card_in_imset => [|t u]; last first.
  by rewrite !inE => /andP[ts _] /andP[us' _]; exact: next_common_inj.
rewrite -size_filter -(card_uniqP (filter_uniq _ us)); congr odd.
by apply: eq_card => t; rewrite inE mem_filter andbC.
Qed.

(* A cell has two facets at r, those that it shares with its neighbours on    *)
(* the loop.                                                                  *)
Lemma loop_facets t f : t \in s -> #|f| = n -> r \subset f -> f \subset M t ->
  f = common M t (next s t) \/ f = common M t (prev s t).
Proof.
move=> ts cf rf ft; have [us _ _] := loop.
have [/andP[tn rn] /andP[tp rp]] := (next_around ts, prev_around ts).
have np : common M t (next s t) != common M t (prev s t).
  apply/eqP => /(common_inj tn tp) e; have := next_next ts.
  by rewrite e next_prev // eqxx.
have F2 : [set common M t (next s t); common M t (prev s t)] =
          [set g : {set V} | [&& #|g| == n, r \subset g & g \subset M t]].
  apply/eqP; rewrite eqEcard (two_facets card_r (subset_trans rf ft)) cards2 np andbT.
  apply/subsetP => g; rewrite !inE => gE.
  by apply/and3P; case/orP: gE => /eqP->; split; rewrite ?subsetIl.
have: f \in [set common M t (next s t); common M t (prev s t)].
  by rewrite F2 inE cf eqxx rf ft.
by rewrite !inE => /orP[]/eqP; [left | right].
Qed.

Lemma in_facets_along t f : t \in s -> #|f| = n -> r \subset f -> f \subset M t ->
  f \in facets_along s.
Proof.
move=> ts cf rf ft; have [us _ _] := loop; apply/imsetP.
have [fE|fE] := loop_facets ts cf rf ft; first by exists t.
by exists (prev s t); rewrite ?mem_prev // next_prev // commonC.
Qed.

Lemma loop_neighbours t u : t \in s -> around r t u -> u = next s t \/ t = next s u.
Proof.
move=> ts /andP[tu rf]; have [us _ _] := loop.
have [/andP[tn _] /andP[tp _]] := (next_around ts, prev_around ts).
have cf : #|common M t u| = n by exact/eqP.
have [|/(common_inj tu tp)->] := loop_facets ts cf rf (subsetIl _ _).
  by move/(common_inj tu tn); left.
by right; rewrite next_prev.
Qed.

(* Theorem B: for a ridge with a single loop, so whose star is not pinched:   *)
(* the number of selected facets that contain it.                             *)
Theorem theoremB_degree x : (forall t, (t \in s) = (r \subset M t)) -> symmetric_parity x ->
  odd #|[set f in dual_cut x | r \subset f]| = loop_parity x s.
Proof.
move=> sE x_sym; rewrite -(theoremB_loop x_sym); congr odd; apply: eq_card => f.
rewrite inE [RHS]inE; apply: andb_id2l; rewrite inE.
move=> /existsP[t /existsP[u /and3P[tu /eqP<- _]]]; apply/idP/imsetP => [rf | [w ws ->]].
  have cf : #|common M t u| = n by exact/eqP.
  have ts : t \in s by rewrite sE (subset_trans rf) ?subsetIl.
  by have /imsetP := in_facets_along ts cf rf (subsetIl _ _).
by have /andP[] := next_around ws.
Qed.
End Loop.

(* Theorem B: the selected facets are exactly those between two sets of cells *)
(* iff every closed walk from cell to cell has an even number of crossings.   *)
Theorem theoremB_labelling x : symmetric_parity x ->
  even_walks (adjacent M) x <-> exists lab, coboundary (dual_cut x) lab.
Proof.
move=> x_sym; rewrite labellingP //; last exact: adjacentC.
split=> [] [lab labE]; exists lab => t u tu.
  by rewrite dual_cutP // labE //; case: (lab t) (lab u) => [] [].
by rewrite -(dual_cutP x_sym tu) labE //; case: (lab t) (lab u) => [] [].
Qed.
End DualEdge.

(* The crossings of segments: P may be any type of points.                    *)
Section Points.
Variables (n : nat) (V T : finType) (M : complex n V T) (P : Type).
Variables (cross : P -> P -> bool) (c : T -> P).
Implicit Types (o p q : P) (t u : T) (r : {set V}) (s : seq T).

Definition closes o p q := ~~ (cross o p (+) cross p q (+) cross q o).
Definition towards t u := cross (c t) (c u).

Hypothesis pm : pseudo_manifold M.
Hypothesis cross_sym : forall p q, cross p q = cross q p.

Lemma towards_sym : symmetric_parity M towards.
Proof. by move=> t u _; exact: cross_sym. Qed.

Lemma closesE o t u : closes o (c t) (c u) -> towards t u = cross o (c t) (+) cross o (c u).
Proof.
rewrite /closes /towards (cross_sym (c u)).
by case: (cross o (c t)) (cross (c t) (c u)) (cross o (c u)) => [] [] [].
Qed.

(* Theorem B: a loop around a ridge passes an even number of selected facets  *)
(* if, for some point o, the rim of the sweep passes through no triangle that *)
(* o spans with a step of the loop of dual edges.                             *)
Theorem theoremB_even r s o : loop_around M r s ->
  (forall t, t \in s -> closes o (c t) (c (next s t))) ->
  ~~ odd #|dual_cut M towards :&: facets_along M s|.
Proof.
move=> loop rim; rewrite (theoremB_loop pm loop towards_sym).
have [us _ _] := loop; case: s us rim {loop} => // t p us rim.
have steps : cycle (fun a b => closes o (c a) (c b)) (t :: p).
  apply: (@sub_in_cycle _ (mem (t :: p)) [rel a b | next (t :: p) a == b]).
  - by move=> a b /rim ab _ /eqP<-.
  - exact/allP.
  - exact: cycle_next.
have seen : labelling (fun a b => closes o (c a) (c b)) towards (fun a => cross o (c a)).
  by move=> a b; exact: closesE.
by rewrite /loop_parity (labelling_walk seen steps) last_rcons addbb.
Qed.

(* Theorem B: a sweep whose rim passes through no triangle that some point o  *)
(* spans with a dual edge selects exactly the facets between two sets of      *)
(* cells: those whose dual points o sees through the sweep an odd number of   *)
(* times, and the others.                                                     *)
Theorem theoremB_no_rim o : (forall t u, adjacent M t u -> closes o (c t) (c u)) ->
  coboundary M (dual_cut M towards) (fun t => cross o (c t)).
Proof.
move=> rim t u tu; rewrite (dual_cutP pm towards_sym) // (closesE (rim t u tu)).
by case: (cross o (c t)) (cross o (c u)) => [] [].
Qed.

Corollary theoremB_full_crossing o t u : 0 < n ->
  (forall a b, adjacent M a b -> closes o (c a) (c b)) ->
  connect (adjacent (unglue M (dual_cut M towards))) t u -> cross o (c t) = cross o (c u).
Proof. by move=> n0 /theoremB_no_rim; exact: theoremB_separates. Qed.
End Points.
