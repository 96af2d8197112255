(******************************************************************************)
(* Corners, facets and mates of cells that are given as lists of positives.   *)
(*                                                                            *)
(*       numbered == a vertex with the number of its corner                   *)
(*   number cells == the cells with their corners numbered from 1: corner i   *)
(*                   of cell t gets (n + 1) t + i + 1                         *)
(*     num p, pos k == positives as the natural numbers from 0 of a file      *)
(*  fold_corners f z rows == f folded over all corners, row by row            *)
(*          facet == a half-facet: the opposite corner, and its own corners   *)
(*     facets row == the half-facets of a cell; its row must be sorted        *)
(*          key f == the vertices of a facet, in increasing order             *)
(* all_facets rows == all half-facets of numbered cells                       *)
(*     mate_all s == all mates of the numbered cells s, found in one pass     *)
(*                   with a trie from key to half-facets, or the first fault  *)
(*                   that shows that s is no complex                          *)
(*        good fs == no three of the half-facets fs have one key, and those   *)
(*                   of one key have different opposite vertices              *)
(*                                                                            *)
(* Theorems: mate_good (the pass finds a fault exactly if fs is not good) and *)
(* matesP (it finds the pairs of half-facets with the same key, and only      *)
(* those).                                                                    *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Notation numbered := (positive * positive)%type.
Notation facet := (numbered * seq numbered)%type.

Definition fold_corners (A : Type) (f : A -> numbered -> A) : A -> seq (seq numbered) -> A :=
  foldl (foldl f).

Lemma fold_cornersE A f (z : A) rows : fold_corners f z rows = foldl f z (flatten rows).
Proof. by rewrite /fold_corners; elim: rows z => //= r rows IH z; rewrite foldl_cat IH. Qed.

(* ---------- numbering ------------------------------------------------------ *)
Fixpoint number_cell (c : positive) (row : seq positive) : seq numbered :=
  if row is v :: row' then (v, c) :: number_cell (Pos.succ c) row' else [::].

Definition advance (c : positive) (row : seq positive) : positive :=
  foldl (fun c _ => Pos.succ c) c row.

Fixpoint number_onto (acc : seq (seq numbered)) (c : positive) (rows : seq (seq positive)) :=
  if rows is row :: rows' then
    number_onto (number_cell c row :: acc) (advance c row) rows'
  else rev acc.

Definition number (rows : seq (seq positive)) : seq (seq numbered) :=
  number_onto [::] 1%positive rows.

(* Positives as natural numbers from 0: the numbers that a file holds.         *)
Definition num (p : positive) : nat := (Pos.to_nat p).-1.
Definition pos (k : nat) : positive := Pos.of_succ_nat k.

Lemma posK : cancel pos num. Proof. exact: SuccNat2Pos.pred_id. Qed.
Lemma num_inj : injective num.
Proof.
move=> p q; rewrite /num; have := Pos2Nat.is_pos p; have := Pos2Nat.is_pos q.
by move=> /ltP q0 /ltP p0 /(congr1 S); rewrite !prednK // => /Pos2Nat.inj.
Qed.
Lemma numK : cancel num pos. Proof. by move=> p; apply: num_inj; rewrite posK. Qed.
Lemma num_succ p : num (Pos.succ p) = (num p).+1.
Proof. by rewrite /num Pos2Nat.inj_succ /= prednK //; apply/ltP/Pos2Nat.is_pos. Qed.

Fixpoint number_from (c : positive) (rows : seq (seq positive)) : seq (seq numbered) :=
  if rows is row :: rows' then number_cell c row :: number_from (advance c row) rows' else [::].

Lemma numberE rows : number rows = number_from 1 rows.
Proof.
rewrite /number -[RHS]/(rev [::] ++ _); elim: rows 1%positive [::] => [|r rows IH] c acc /=.
  by rewrite cats0.
by rewrite IH rev_cons cat_rcons.
Qed.

Lemma num_advance c row : num (advance c row) = num c + size row.
Proof.
rewrite /advance; elim: row c => [|v r IH] c /=; first by rewrite addn0.
by rewrite IH num_succ addSnnS.
Qed.

Lemma number_vertices rows : [seq [seq x.1 | x <- r] | r <- number rows] = rows.
Proof.
rewrite numberE; elim: rows 1%positive => //= r rows IH c; rewrite IH; congr (_ :: _).
by elim: r c {IH} => //= v r IH c; rewrite IH.
Qed.

Lemma number_corners rows : [seq num x.2 | x <- flatten (number rows)] =
  iota 0 (size (flatten rows)).
Proof.
rewrite numberE (_ : 0 = num 1) //; elim: rows 1%positive => //= r rows IH c.
rewrite map_cat IH num_advance size_cat iotaD; congr (_ ++ _).
by elim: r c {IH} => //= v r IH c; rewrite IH num_succ.
Qed.

Lemma number_uniq rows : uniq [seq x.2 | x <- flatten (number rows)].
Proof.
rewrite -(map_inj_uniq num_inj) -map_comp; have := iota_uniq 0 (size (flatten rows)).
by rewrite -number_corners.
Qed.

Lemma size_number rows : size (number rows) = size rows.
Proof. by rewrite -[in RHS](number_vertices rows) size_map. Qed.

(* The numbers depend on the shape of the list only.                           *)
Lemma number_shape rows rows' : shape rows = shape rows' ->
  [seq [seq x.2 | x <- r] | r <- number rows] = [seq [seq x.2 | x <- r] | r <- number rows'].
Proof.
rewrite !numberE; elim: rows rows' 1%positive => [|r rows IH] [|r' rows'] //= c [rr /IH E].
have -> : advance c r' = advance c r by apply: num_inj; rewrite !num_advance rr.
rewrite E; congr (_ :: _); elim: r r' c rr {E IH} => [|v r IH] [|v' r'] //= c [/IH->] //.
Qed.

(* ---------- facets --------------------------------------------------------- *)
Definition by_vertex (x y : numbered) : bool := Pos.leb x.1 y.1.

Fixpoint facets (row : seq numbered) : seq facet :=
  if row is x :: row' then (x, row') :: [seq (f.1, x :: f.2) | f <- facets row'] else [::].

Definition key (f : facet) : seq positive := [seq x.1 | x <- f.2].

Definition all_facets (rows : seq (seq numbered)) : seq facet :=
  flatten [seq facets (sort by_vertex r) | r <- rows].

Lemma facetsP (row : seq numbered) (f : facet) : uniq [seq x.1 | x <- row] ->
  (f \in facets row) = (f.1 \in row) && (f.2 == [seq x <- row | x.1 != f.1.1]).
Proof.
case: f => y s; elim: row y s => [|x row IH] y s //= /andP[xr ur].
have memE : ((y, s) \in [seq (f.1, x :: f.2) | f <- facets row]) =
    (y \in row) && (s == x :: [seq z <- row | z.1 != y.1]).
  apply/mapP/andP => [[[z s'] + /= [-> ->]]|[yr /eqP->]].
    by rewrite IH //= eqseq_cons eqxx => /andP[-> ->].
  by exists (y, [seq z <- row | z.1 != y.1]); rewrite ?IH //= yr eqxx.
rewrite !in_cons memE xpair_eqE; have [->|yx] := eqVneq y x; last first.
  have [yr|//] := boolP (y \in row); rewrite orFb /=; case: ifP => // /negbFE /eqP xy.
  by case/negP: xr; rewrite xy map_f.
have -> : x \in row = false by apply: contraNF xr => xr; apply: map_f xr.
rewrite /= eqxx /= orbF (_ : [seq z <- row | _] = row) //.
by apply/all_filterP/allP => z zr; apply: contra xr => /eqP <-; exact: map_f.
Qed.

(* ---------- mates ---------------------------------------------------------- *)
(* Why lists of cells and facets are no complex and no cut of it; the numbers  *)
(* are those of corners, and of a row of the cut for Not_a_facet.              *)
Inductive problem :=
| Wrong_length
| Repeated_vertex of positive & positive
| Same_vertices of positive & positive
| Facet_in_three_cells of positive & positive
| Not_a_facet of positive.

Record mating := Mating {
  table : trie (seq facet);
  mates : seq (facet * facet);
  fault : option problem }.

Definition unmated : mating := Mating (empty_trie (seq facet)) [::] None.

Definition bucket (k : seq positive) (t : trie (seq facet)) : seq facet :=
  if find_trie k t is Some fs then fs else [::].

Definition mate (s : mating) (f : facet) : mating :=
  if fault s is Some _ then s else
  let fail p := Mating (table s) (mates s) (Some p) in
  match bucket (key f) (table s) with
  | [::] => Mating (add_trie (key f) [:: f] (table s)) (mates s) None
  | [:: g] =>
      if Pos.eqb g.1.1 f.1.1 then fail (Same_vertices g.1.2 f.1.2)
      else Mating (add_trie (key f) [:: f; g] (table s)) ((g, f) :: mates s) None
  | g :: _ => fail (Facet_in_three_cells g.1.2 f.1.2)
  end.

Definition mate_all (rows : seq (seq numbered)) : mating :=
  foldl (fun s row => foldl mate s (facets (sort by_vertex row))) unmated rows.

Lemma mate_allE rows : mate_all rows = foldl mate unmated (all_facets rows).
Proof.
rewrite /mate_all /all_facets; elim: rows unmated => //= r rows IH s.
by rewrite foldl_cat IH.
Qed.

Definition of_key (fs : seq facet) k : seq facet := [seq f <- fs | key f == k].

Definition good (fs : seq facet) := forall k,
  size (of_key fs k) <= 2 /\ uniq [seq f.1.1 | f <- of_key fs k].

Lemma of_key_rcons fs f k : of_key (rcons fs f) k =
  if key f == k then rcons (of_key fs k) f else of_key fs k.
Proof. by rewrite /of_key filter_rcons. Qed.

Lemma mem_of_key fs f k : (f \in of_key fs k) = (key f == k) && (f \in fs).
Proof. exact: mem_filter. Qed.

Lemma good_rcons fs f : good (rcons fs f) <->
  [/\ good fs, size (of_key fs (key f)) <= 1 & f.1.1 \notin [seq g.1.1 | g <- of_key fs (key f)]].
Proof.
split=> [g|[g s1 nf] k].
  split=> [k||]; last 2 first.
  - by have [] := g (key f); rewrite of_key_rcons eqxx size_rcons.
  - by have [_] := g (key f); rewrite of_key_rcons eqxx map_rcons rcons_uniq => /andP[].
  have := g k; rewrite of_key_rcons; case: eqP => // _.
  by rewrite size_rcons map_rcons rcons_uniq => -[/ltnW-> /andP[]].
rewrite of_key_rcons; have [<-|_] := eqVneq; last exact: g.
by rewrite size_rcons map_rcons rcons_uniq nf; have [_] := g (key f).
Qed.

Lemma bucket_add k l fs t : bucket k (add_trie l fs t) = if k == l then fs else bucket k t.
Proof. by rewrite /bucket find_add_trie; case: (k == l). Qed.

Lemma mate_fold fs (s := foldl mate unmated fs) : (fault s = None <-> good fs) /\
  (fault s = None ->
   [/\ forall k, bucket k (table s) = rev (of_key fs k),
       forall f g, (g, f) \in mates s -> [/\ g \in fs, f \in fs, key g = key f & g.1.1 != f.1.1]
     & forall f g, f \in fs -> g \in fs -> key f = key g ->
         [\/ f = g, (f, g) \in mates s | (g, f) \in mates s]]).
Proof.
rewrite {}/s; elim/last_ind: fs => [|fs f [IHg IH]].
  split; first by split.
  by split=> // k; rewrite /bucket find_trie_empty.
rewrite -cats1 foldl_cat /= cats1; move: (foldl _ _ _) IHg IH => s IHg IH.
rewrite /mate; case F: (fault s) => [p|].
  by rewrite F; split=> //; split=> // g; have [/IHg] := (good_rcons fs f).1 g; rewrite F.
have [tab only all] := IH F; have gfs : good fs by apply/IHg.
have keep g h : (g, h) \in mates s ->
    [/\ g \in rcons fs f, h \in rcons fs f, key g = key h & g.1.1 != h.1.1].
  by move=> /only[gf hf k d]; rewrite !mem_rcons !inE gf hf !orbT.
have [size2 _] := gfs (key f).
rewrite tab; case O: (of_key fs (key f)) => [|g [|h [|i r]]] /=; last first.
- by rewrite O in size2.
- rewrite /rev /=; split=> //; split=> // g3.
  by have [_] := (good_rcons fs f).1 g3; rewrite O.
- have [/eqP gk gin] : key g == key f /\ g \in fs.
    by apply/andP; rewrite -mem_of_key O inE.
  rewrite /rev /=; change Pos.eqb with (@eq_op positive_eqType).
  have [gf|gf] := eqVneq; first by
    split=> //; split=> // g2; have [_ _] := (good_rcons fs f).1 g2; rewrite O /= inE gf eqxx.
  split; first by split=> // _; apply/(good_rcons fs f).2; rewrite O /= inE eq_sym gf.
  move=> _; split=> /= [k|f' g'|f' g'].
  + rewrite bucket_add of_key_rcons eq_sym; have [<-|_] := eqVneq (key f) k; last exact: tab.
    by rewrite O.
  + rewrite inE => /orP[/eqP[-> ->]|/keep//].
    by rewrite !mem_rcons !inE eqxx gin orbT.
  + rewrite !mem_rcons !inE => /orP[/eqP->|ff] /orP[/eqP->|gg] k; first exact: Or31.
    * have : g' \in of_key fs (key f) by rewrite mem_of_key -k eqxx.
      by rewrite O inE => /eqP->; rewrite eqxx; apply: Or33.
    * have : f' \in of_key fs (key f) by rewrite mem_of_key k eqxx.
      by rewrite O inE => /eqP->; rewrite eqxx; apply: Or32.
    * by case: (all f' g' ff gg k) => [->|->|->]; rewrite ?orbT;
        [exact: Or31|exact: Or32|exact: Or33].
- rewrite /rev /=; split; first by split=> // _; apply/(good_rcons fs f).2; rewrite O.
  move=> _; split=> /= [k|f' g' /keep //|f' g'].
    rewrite bucket_add of_key_rcons eq_sym; have [<-|_] := eqVneq (key f) k; last exact: tab.
    by rewrite O.
  rewrite !mem_rcons !inE => /orP[/eqP->|ff] /orP[/eqP->|gg] k; first exact: Or31.
  + have : g' \in of_key fs (key f) by rewrite mem_of_key -k eqxx.
    by rewrite O.
  + have : f' \in of_key fs (key f) by rewrite mem_of_key k eqxx.
    by rewrite O.
  + exact: all.
Qed.

Theorem mate_good rows : fault (mate_all rows) = None <-> good (all_facets rows).
Proof. by rewrite mate_allE; have [] := mate_fold (all_facets rows). Qed.

Theorem matesP rows (m := mate_all rows) : fault m = None ->
  [/\ forall k, (bucket k (table m) != [::]) = (k \in [seq key f | f <- all_facets rows]),
      forall f g, (g, f) \in mates m ->
        [/\ g \in all_facets rows, f \in all_facets rows, key g = key f & g.1.1 != f.1.1]
    & forall f g, f \in all_facets rows -> g \in all_facets rows -> key f = key g ->
        [\/ f = g, (f, g) \in mates m | (g, f) \in mates m]].
Proof.
rewrite /m mate_allE => F; have [_ /(_ F)[tab only all]] := mate_fold (all_facets rows).
split=> // k; rewrite tab -size_eq0 size_rev size_eq0 -has_filter.
by apply/hasP/mapP => [[f fin /eqP<-]|[f fin ->]]; exists f.
Qed.
