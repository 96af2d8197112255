(******************************************************************************)
(* Corners, facets and mates of a complex that is given as lists.             *)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries quick_find.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Notation numbered := (positive * positive)%type.
Notation facet := (numbered * seq numbered)%type.

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

Definition fold_corners (A : Type) (f : A -> numbered -> A) : A -> seq (seq numbered) -> A :=
  foldl (foldl f).

Definition by_vertex (x y : numbered) : bool := Pos.leb x.1 y.1.

Fixpoint facets (row : seq numbered) : seq facet :=
  if row is x :: row' then (x, row') :: [seq (f.1, x :: f.2) | f <- facets row'] else [::].

Definition key (f : facet) : seq positive := [seq x.1 | x <- f.2].

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

Definition mate (s : mating) (f : facet) : mating :=
  if fault s is Some _ then s else
  match find_trie (key f) (table s) with
  | None => Mating (add_trie (key f) [:: f] (table s)) (mates s) None
  | Some [:: g] =>
      if Pos.eqb g.1.1 f.1.1 then Mating (table s) (mates s) (Some (Same_vertices g.1.2 f.1.2))
      else Mating (add_trie (key f) [:: f; g] (table s)) ((g, f) :: mates s) None
  | Some gs =>
      let other := if gs is g :: _ then g.1.2 else f.1.2 in
      Mating (table s) (mates s) (Some (Facet_in_three_cells other f.1.2))
  end.

Definition mate_all (rows : seq (seq numbered)) : mating :=
  foldl (fun s row => foldl mate s (facets (sort by_vertex row))) unmated rows.

Fixpoint repeated (row : seq numbered) : option (positive * positive) :=
  if row is x :: row' then
    if row' is y :: _ then if Pos.eqb x.1 y.1 then Some (x.2, y.2) else repeated row' else None
  else None.

Definition first_some (A B : Type) (f : A -> option B) : seq A -> option B :=
  fix go s := if s is x :: s' then if f x is Some y then Some y else go s' else None.

Definition long (n : nat) (row : seq positive) : bool := eqn (size row) n.+1.

Definition cell_problem (row : seq numbered) : option problem :=
  if repeated (sort by_vertex row) is Some (c, d) then Some (Repeated_vertex c d) else None.

(* The rows of the cut, sorted; `at` numbers the next one.                    *)
Record cutting := Cutting { in_cut : trie bool; next : positive; stray : option problem }.

Definition add_cut (t : trie (seq facet)) (s : cutting) (row : seq positive) : cutting :=
  let k := sort Pos.leb row in
  Cutting (add_trie k true (in_cut s)) (Pos.succ (next s))
    (if stray s is Some p then Some p
     else if find_trie k t is Some _ then None else Some (Not_a_facet (next s))).

Definition read_cut t (cut : seq (seq positive)) : cutting :=
  foldl (add_cut t) (Cutting (empty_trie bool) 1%positive None) cut.

(* Pairs of corners at the same vertex of uncut mates.                        *)
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

(* The names of the classes: the least corner of each                          *)
Definition least (s : classes) (rows : seq (seq numbered)) : PositiveMap.t positive :=
  fold_corners (fun m (x : numbered) => let l := name s x.2 in
    if find l m is Some _ then m else add l x.2 m) (PositiveMap.empty positive) rows.

Definition canonical_name (s : classes) (m : PositiveMap.t positive) (c : positive) : positive :=
  if find (name s c) m is Some d then d else c.

Definition rev_map (A B : Type) (f : A -> B) (s : seq A) : seq B :=
  foldl (fun acc x => f x :: acc) [::] s.

Definition unglue_exec n (cells cut : seq (seq positive)) : problem + seq (seq positive) :=
  match prepare n cells cut with
  | inl p => inl p
  | inr p =>
      let s := classes_of (edges p) in
      let m := least s (corner_rows p) in
      inr (rev (rev_map (map (fun x : numbered => canonical_name s m x.2)) (corner_rows p)))
  end.
