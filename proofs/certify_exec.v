From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries quick_find half_facets.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive verdict :=
| Accepted
| Not_comparable
| No_parent of positive & positive
| Uncut_mates_apart of positive & positive
| Class_not_connected of positive & positive
| Malformed of problem.

Fixpoint same_length (A B : Type) (s : seq A) (t : seq B) : bool :=
  match s, t with
  | [::], [::] => true
  | _ :: s', _ :: t' => same_length s' t'
  | _, _ => false
  end.

(* the vertex that each corner has in `rows`                                   *)
Definition vertex_map (rows : seq (seq numbered)) : PositiveMap.t positive :=
  fold_corners (fun m (x : numbered) => add x.2 x.1 m) (PositiveMap.empty positive) rows.

Definition at_corner (m : PositiveMap.t positive) (c : positive) : positive :=
  if find c m is Some v then v else 1%positive.

(* two corners with the same key and different values                          *)
Record search_state := Search {
  seen : PositiveMap.t (positive * positive);
  clash : option (positive * positive) }.

Definition look (kv : numbered -> positive * positive) (s : search_state) (x : numbered) :=
  if clash s is Some _ then s else
  let: (k, v) := kv x in
  match find k (seen s) with
  | None => Search (add k (v, x.2) (seen s)) None
  | Some (v', d) => if Pos.eqb v' v then s else Search (seen s) (Some (d, x.2))
  end.

Definition find_clash kv (rows : seq (seq numbered)) : option (positive * positive) :=
  clash (fold_corners (look kv) (Search (PositiveMap.empty (positive * positive)) None) rows).

Definition find_apart (w : positive -> positive) : seq (positive * positive) ->
    option (positive * positive) :=
  first_some (fun e => if Pos.eqb (w e.1) (w e.2) then None else Some e).

Definition certify_exec n (before cut after : seq (seq positive)) : verdict :=
  match prepare n before cut with
  | inl p => Malformed p
  | inr p =>
      if ~~ all (long n) after then Malformed Wrong_length else
      if ~~ same_length before after then Not_comparable else
      let w := at_corner (vertex_map (number after)) in
      if find_clash (fun x => (w x.2, x.1)) (corner_rows p) is Some (c, d) then No_parent c d else
      if find_apart w (edges p) is Some (c, d) then Uncut_mates_apart c d else
      let s := classes_of (edges p) in
      if find_clash (fun x => (w x.2, name s x.2)) (corner_rows p) is Some (c, d)
      then Class_not_connected c d else Accepted
  end.
