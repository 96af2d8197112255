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

Definition coherent (s : classes) :=
  forall x y, (y \in (bearers s (name s x)).2) = (name s y == name s x).

Lemma name_relabel s small to both x :
  name (relabel s small to both) x = if x \in small then to else name s x.
Proof.
rewrite /name /relabel /=; elim: small (labels s) => //= y small IHs m.
rewrite IHs in_cons find_add; case: (x \in small); first by rewrite orbT.
by rewrite orbF; case: (x == y).
Qed.

Lemma bearers_relabel s small to both l :
  bearers (relabel s small to both) l = if l == to then both else bearers s l.
Proof. by rewrite /bearers /relabel /= find_add; case: (l == to). Qed.

(* One class, that of a, goes over to the class of b.                          *)
Lemma relabelP s a b k : coherent s -> name s a != name s b ->
  let both := (k, catrev (bearers s (name s a)).2 (bearers s (name s b)).2) in
  let s' := relabel s (bearers s (name s a)).2 (name s b) both in
  coherent s' /\ (forall x, name s' x = if name s x == name s a then name s b else name s x).
Proof.
move=> ok ab both s'.
have nameE x : name s' x = if name s x == name s a then name s b else name s x.
  by rewrite name_relabel ok.
split=> // x y; rewrite bearers_relabel !nameE.
case: (eqVneq (name s x) (name s a)) => [xa|xa].
  rewrite eqxx /= catrevE mem_cat mem_rev !ok.
  by case: (eqVneq (name s y) (name s a)) => //= ya; rewrite eqxx.
case: (eqVneq (name s x) (name s b)) => [xb|xb].
  rewrite /= catrevE mem_cat mem_rev !ok xb.
  by case: (eqVneq (name s y) (name s a)) => //= ya; rewrite eqxx.
rewrite ok; case: (eqVneq (name s y) (name s a)) => [ya|//].
by rewrite ya eq_sym (negPf xa) eq_sym (negPf xb).
Qed.

Lemma joinP s e : coherent s -> coherent (join s e) /\
  forall x y, (name (join s e) x == name (join s e) y) =
    [|| name s x == name s y, (name s x == name s e.1) && (name s y == name s e.2)
      | (name s x == name s e.2) && (name s y == name s e.1)].
Proof.
case: e => a b ok; rewrite /join /=; change Pos.eqb with (@eq_op positive_eqType).
have [ab|ab] := eqVneq (name s a) (name s b).
  split=> // x y; rewrite ab orbb; case: eqP => //= xy.
  by apply/esym/andP => -[/eqP xb /eqP yb]; apply: xy; rewrite xb yb.
have sym c d s' : name s c != name s d ->
    (forall x, name s' x = if name s x == name s c then name s d else name s x) ->
    forall x y, (name s' x == name s' y) =
    [|| name s x == name s y, (name s x == name s c) && (name s y == name s d)
      | (name s x == name s d) && (name s y == name s c)].
  move=> cd E x y; rewrite !E; move: (name s x) (name s y) (name s c) (name s d) cd.
  move=> i j k l kl; have [->|ik] := eqVneq i k; have [->|jk] := eqVneq j k => //=.
  - by rewrite !eqxx.
  - by rewrite andbF orbF eq_sym.
  - by rewrite (negPf ik) andbT.
  - by rewrite andbF orbF.
case A: (bearers s (name s a)) => [na xs]; case B: (bearers s (name s b)) => [nb ys].
case: Pos.leb.
  have := relabelP (Pos.add na nb) ok ab; rewrite A B /= => -[ok' nameE].
  by split=> // x y; rewrite (sym a b).
rewrite eq_sym in ab; have := relabelP (Pos.add na nb) ok ab; rewrite A B /= => -[ok' nameE].
by split=> // x y; rewrite (sym b a) // [in RHS]orbCA orbA orbC orbA orbC.
Qed.

Lemma eqv_sub es es' x y : {subset es <= es'} -> eqv es x y -> eqv es' x y.
Proof.
move=> sub; elim=> {x y} [x|x y /sub|x y _|x y z _ h1 _ h2].
- exact: eqv_refl.
- exact: eqv_edge.
- exact: eqv_sym.
- exact: eqv_trans h1 h2.
Qed.

(* Two numbers have one name exactly if a chain of edges joins them.           *)
Theorem classesP es x y : name (classes_of es) x = name (classes_of es) y <-> eqv es x y.
Proof.
rewrite /classes_of; suff [_] : coherent (foldl join singletons es) /\ forall x y,
    name (foldl join singletons es) x = name (foldl join singletons es) y <-> eqv es x y by [].
elim/last_ind: es {x y} => [|es [a b] [ok IH]].
  have nameE x : name singletons x = x by rewrite /name find_empty.
  split=> [x y|x y]; rewrite !nameE /bearers ?find_empty ?inE //.
  split=> [->|]; first exact: eqv_refl.
  by elim=> // {x y} [x y z _ -> _ ->].
rewrite -cats1 foldl_cat /=; move: (foldl join _ _) ok IH => s ok IH.
have [ok' joinE] := joinP (a, b) ok; split=> // x y.
have weak u v : eqv es u v -> eqv (es ++ [:: (a, b)]) u v.
  by apply: eqv_sub => e; rewrite mem_cat => ->.
have ab : eqv (es ++ [:: (a, b)]) a b by apply: eqv_edge; rewrite mem_cat inE eqxx orbT.
split=> [/eqP|].
  rewrite joinE /= => /or3P[/eqP/IH/weak //|/andP[/eqP/IH/weak xa /eqP/IH/weak yb]|].
    exact: eqv_trans xa (eqv_trans ab (eqv_sym yb)).
  move=> /andP[/eqP/IH/weak xb /eqP/IH/weak ya].
  exact: eqv_trans xb (eqv_trans (eqv_sym ab) (eqv_sym ya)).
elim=> {x y} [//|x y|x y _ -> //|x y z _ -> _ -> //].
rewrite mem_cat inE => /orP[xy|/eqP[-> ->]]; apply/eqP; rewrite joinE /=.
  by apply/orP; left; apply/eqP/IH/eqv_edge.
by rewrite !eqxx orbT.
Qed.
