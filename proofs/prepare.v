(******************************************************************************)
(* From lists of cells and cut facets to what certify and unglue start from:  *)
(* numbered corners, and the pairs of corners that uncut mates share; or the  *)
(* reason why the lists are no complex with a cut.                            *)
(*                                                                            *)
(*          long n row == row has n + 1 vertices                              *)
(*        repeated row == two corners of a sorted row with the same vertex    *)
(*      first_some f s == the first value of f on s                           *)
(*      read_cut t cut == the set of the keys of the rows of the cut, and the *)
(*                        first row that is no key of the table t             *)
(*    uncut_edges c ms == the pairs of corners at the same vertex of the      *)
(*                        mates ms whose key is not in c                      *)
(* prepare n cells cut == all that together                                   *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries half_facets listed.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition long (n : nat) (row : seq positive) : bool := eqn (size row) n.+1.

Fixpoint repeated (row : seq numbered) : option (positive * positive) :=
  if row is x :: row' then
    if row' is y :: _ then if Pos.eqb x.1 y.1 then Some (x.2, y.2) else repeated row' else None
  else None.

Definition first_some (A B : Type) (f : A -> option B) : seq A -> option B :=
  fix go s := if s is x :: s' then if f x is Some y then Some y else go s' else None.

Definition cell_problem (row : seq numbered) : option problem :=
  if repeated (sort by_vertex row) is Some (c, d) then Some (Repeated_vertex c d) else None.

Record cutting := Cutting { in_cut : trie bool; next : positive; stray : option problem }.

Definition add_cut (t : trie (seq facet)) (s : cutting) (row : seq positive) : cutting :=
  let k := sort Pos.leb row in
  Cutting (add_trie k true (in_cut s)) (Pos.succ (next s))
    (if stray s is Some p then Some p
     else if bucket k t is [::] then Some (Not_a_facet (next s)) else None).

Definition read_cut t (cut : seq (seq positive)) : cutting :=
  foldl (add_cut t) (Cutting (empty_trie bool) 1%positive None) cut.

Definition uncut_edges (c : trie bool) (ms : seq (facet * facet)) : seq (positive * positive) :=
  foldl (fun es m =>
    if find_trie (key m.1) c is Some _ then es
    else foldl (fun es xy => (xy.1.2, xy.2.2) :: es) es (zip m.1.2 m.2.2)) [::] ms.

Record prepared := Prepared {
  corner_rows : seq (seq numbered);
  edges : seq (positive * positive) }.

Definition prepare n (cells cut : seq (seq positive)) : problem + prepared :=
  if all (long n) cells then
    let rows := number cells in
    if first_some cell_problem rows is Some p then inl p else
    let m := mate_all rows in
    if fault m is Some p then inl p else
    let c := read_cut (table m) cut in
    if stray c is Some p then inl p else
    inr (Prepared rows (uncut_edges (in_cut c) (mates m)))
  else inl Wrong_length.

Lemma first_someE (A B : Type) (f : A -> option B) s :
  isSome (first_some f s) = has (fun x => isSome (f x)) s.
Proof. by elim: s => //= x s IH; case: (f x). Qed.

Lemma repeatedE r : sorted by_vertex r -> isSome (repeated r) = ~~ uniq [seq x.1 | x <- r].
Proof.
elim: r => [|x [|y r] IH] //= /andP[xy sr]; change Pos.eqb with (@eq_op positive_eqType).
have [->|ne] := eqVneq x.1 y.1; first by rewrite inE eqxx.
suff -> : x.1 \notin y.1 :: [seq z.1 | z <- r] by rewrite [LHS]IH.
rewrite inE (negPf ne); apply/mapP => -[z zr xz].
have /allP/(_ z zr) yx : all (by_vertex y) r.
  by apply: order_path_min sr => a b c; apply: leb_trans.
by case/eqP: ne; apply: leb_anti; rewrite [Pos.leb _ _]xy xz.
Qed.

Lemma cell_problemE cells :
  isSome (first_some cell_problem (number cells)) = ~~ all uniq cells.
Proof.
rewrite first_someE -has_predC -[in RHS](number_vertices cells) has_map.
apply: eq_has => r /=; rewrite /cell_problem.
rewrite -(perm_uniq (perm_map _ (permEl (perm_sort by_vertex r)))).
rewrite -repeatedE; last by apply: sort_sorted => x y; exact: leb_total.
by case: repeated => [[]|].
Qed.

Lemma read_cutP t cut (c := read_cut t cut) :
  (stray c = None <-> forall row, row \in cut -> bucket (sort Pos.leb row) t != [::]) /\
  forall k, isSome (find_trie k (in_cut c)) = (k \in [seq sort Pos.leb row | row <- cut]).
Proof.
rewrite {}/c /read_cut; set none := Cutting _ _ _; elim/last_ind: cut => [|cut row [IH inc]].
  by split=> // k; rewrite find_trie_empty.
rewrite -cats1 foldl_cat cats1; split=> /= [|k]; last first.
  by rewrite find_add_trie map_rcons mem_rcons inE; case: (k == _) => //=; exact: inc.
case S: stray => [p|].
  split=> // H; suff : stray (foldl (add_cut t) none cut) = None by rewrite S.
  by apply/IH => r rc; apply: H; rewrite mem_rcons inE rc orbT.
have {}IH := IH.1 S; case B: (bucket _ _) => [|f fs].
  by split=> // /(_ row); rewrite mem_rcons inE eqxx B => /(_ isT).
split=> // _ r; rewrite mem_rcons inE => /orP[/eqP->|]; [by rewrite B | exact: IH].
Qed.

Lemma uncut_edgesP c ms a b :
  (a, b) \in uncut_edges c ms <-> exists m xy, [/\ m \in ms, ~~ isSome (find_trie (key m.1) c),
    xy \in zip m.1.2 m.2.2 & (a, b) = (xy.1.2, xy.2.2)].
Proof.
rewrite /uncut_edges; pose step es (m : facet * facet) :=
  if find_trie (key m.1) c is Some _ then es
  else foldl (fun es xy => (xy.1.2, xy.2.2) :: es) es (zip m.1.2 m.2.2).
have inner (zs : seq (numbered * numbered)) es :
    (a, b) \in foldl (fun es xy => (xy.1.2, xy.2.2) :: es) es zs <->
    (a, b) \in es \/ exists2 xy, xy \in zs & (a, b) = (xy.1.2, xy.2.2).
  elim: zs es => [|z zs IH] es /=; first by split=> [|[|[]]//]; left.
  rewrite IH inE; split=> [[/orP[/eqP e|]|[xy xyz e]]|[es_|[xy]]].
  - by right; exists z; rewrite ?inE ?eqxx.
  - by left.
  - by right; exists xy; rewrite ?inE ?xyz ?orbT.
  - by left; rewrite es_ orbT.
  - by rewrite inE => /orP[/eqP-> ->|xyz e]; [left; rewrite eqxx | right; exists xy].
suff -> : forall es, (a, b) \in foldl step es ms <-> (a, b) \in es \/
    exists m xy, [/\ m \in ms, ~~ isSome (find_trie (key m.1) c),
    xy \in zip m.1.2 m.2.2 & (a, b) = (xy.1.2, xy.2.2)].
  by split=> [[]//|]; right.
elim: ms => [|m ms IH] es /=; first by split=> [|[|[m [xy []]]]//]; left.
rewrite IH /step; split.
  case F: find_trie => [d|].
    move=> [|[m' [xy [m'm F' z e]]]]; first by left.
    by right; exists m', xy; rewrite inE m'm orbT.
  move=> [/inner[|[xy z e]]|[m' [xy [m'm F' z e]]]]; first by left.
    by right; exists m, xy; rewrite inE eqxx F.
  by right; exists m', xy; rewrite inE m'm orbT.
case=> [ees|[m' [xy []]]].
  by left; case: find_trie => // ; apply/inner; left.
rewrite inE => /orP[/eqP->|m'm] F z e; last by right; exists m', xy.
by left; move: F; case: find_trie => // _; apply/inner; right; exists xy.
Qed.
