(******************************************************************************)
(* Finite maps for the programs that are extracted: PositiveMap of the        *)
(* standard library, and a trie of them for keys that are lists.              *)
(*                                                                            *)
(*  positive is given mathcomp's equality (Pos.eqb).                          *)
(*        find k m == the value of k in m, an option; find and add are        *)
(*       add k a m    PositiveMap's                                           *)
(*          trie A == a finite map from lists of positives to A: the value at *)
(*                    the empty list, and one trie for each first element.    *)
(*                    Equal facets have equal sorted lists of vertices, so    *)
(*                    this is the map that finds mates.                       *)
(* find_trie k m, add_trie k a m == as for PositiveMap                        *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma positive_eqP : Equality.axiom Pos.eqb.
Proof. by move=> p q; apply: (iffP idP) => /Pos.eqb_eq. Qed.
Canonical positive_eqType := Eval hnf in EqType positive (EqMixin positive_eqP).

Notation find := PositiveMap.find.
Notation add := PositiveMap.add.

Lemma find_empty A p : find p (PositiveMap.empty A) = None.
Proof. exact: PositiveMap.gempty. Qed.

Lemma find_add A p q (a : A) m : find p (add q a m) = if p == q then Some a else find p m.
Proof. by case: eqP => [->|pq]; [exact: PositiveMap.gss | exact: PositiveMap.gso]. Qed.

Inductive trie (A : Type) := Trie of option A & PositiveMap.t (trie A).

Definition empty_trie A : trie A := Trie None (PositiveMap.empty (trie A)).

Fixpoint find_trie A (k : seq positive) (m : trie A) : option A :=
  let: Trie here below := m in
  if k is p :: k' then
    if find p below is Some m' then find_trie k' m' else None
  else here.

Fixpoint add_trie A (k : seq positive) (a : A) (m : trie A) : trie A :=
  let: Trie here below := m in
  if k is p :: k' then
    let m' := if find p below is Some m' then m' else empty_trie A in
    Trie here (add p (add_trie k' a m') below)
  else Trie (Some a) below.

Lemma find_trie_empty A k : find_trie k (empty_trie A) = None.
Proof. by case: k => //= p k; rewrite find_empty. Qed.

Lemma find_add_trie A k l (a : A) m :
  find_trie k (add_trie l a m) = if k == l then Some a else find_trie k m.
Proof.
elim: l k m => [|q l IHl] [|p k] [here below] //=.
rewrite find_add eqseq_cons; have [->|//] := eqVneq p q.
rewrite IHl; case: ifP => // _; case: (find q below) => // .
exact: find_trie_empty.
Qed.
