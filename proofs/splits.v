(******************************************************************************)
(* Which vertices split, and into how many copies (T5, T6).                   *)
(*    ncopies M C v == the number of copies of v: of different new vertices   *)
(*                     at the corners of v                                    *)
(*   T5_regular T5_empty_cut == if C parts no star, nothing changes; so it is *)
(*                     for the empty cut of a cut-regular complex             *)
(*   T5_converse T5_iff == only then does nothing change                      *)
(*   T5_idempotent  == the same cut a second time changes nothing             *)
(*   T6_local       == in a cut-regular complex no vertex splits but those of *)
(*                     C                                                      *)
(*   T6_components  == a vertex gets as many copies as C leaves components    *)
(*                     around it (Figure 6)                                   *)
(*   T6_count T6_new == the number of vertices after unglue                   *)
(* T5_empty_cut is the remark of section 4 after Definition 4; Figure 8 is    *)
(* the counterexample without cut_regular (examples.v).                       *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling copies opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Splits.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

Definition ncopies C v := #|[set copy M C (v, t) | t in star M v]|.

Lemma ncopies_gt0 C v : v \in used M -> 0 < ncopies C v.
Proof.
case/usedP=> t vt; apply/card_gt0P; exists (copy M C (v, t)).
by apply/imsetP; exists t; rewrite ?inE.
Qed.

(* T6: in a cut-regular complex a vertex on no facet of C is not split.       *)
Theorem T6_local C v : cut_regular M -> (forall f, f \in C -> v \notin f) ->
  {in star M v &, forall t u, copy M C (v, t) = copy M C (v, u)}.
Proof.
move=> r off t u; rewrite !inE => vt vu; apply/eqP.
by rewrite copy_eq connect_local //; apply: r.
Qed.

(* T6: v gets as many copies as there are components around it.               *)
Theorem T6_components C v :
  ncopies C v = n_comp (glue M C) [pred x | (x.1 == v) && corner M x].
Proof.
apply: eq_card => x; rewrite !inE; apply/imsetP/and3P => [[t]|[/eqP rx /eqP xv cx]].
  rewrite inE => vt ->; split; first exact/roots_root/glue_csym.
    by rewrite copyK.
  exact: (connect_corner (connect_root (glue M C) (v, t))) vt.
case: x rx xv cx => w t /= rx wv vt; subst w.
by exists t; rewrite ?inE // /copy rx.
Qed.

(* T6: the vertices after unglue, counted by parent.                          *)
Theorem T6_count C : #|used (unglue M C)| = \sum_(v in used M) ncopies C v.
Proof.
rewrite -sum1_card (partition_big fst (mem (used M))) /=; last first.
  by move=> w; rewrite used_relabel => /imsetP[[v t] vt ->]; rewrite copyK; apply: mem_used vt.
apply: eq_bigr => v vM; rewrite sum1_card; apply: eq_card => w.
rewrite unfold_in; apply/andP/imsetP => [[]|[t]].
  move=> /usedP[t /imsetP[v' vt ->]] /eqP; rewrite copyK /= => e; subst v'.
  by exists t; rewrite ?inE.
by rewrite inE => vt ->; rewrite copyK (mem_used (mem_copy C vt)).
Qed.

(* T6: the number of new vertices is the sum of (copies - 1).                 *)
Theorem T6_new C : #|used (unglue M C)| = #|used M| + \sum_(v in used M) (ncopies C v).-1.
Proof.
rewrite T6_count -sum1_card -big_split; apply: eq_bigr => v vM /=.
by rewrite add1n prednK // ncopies_gt0.
Qed.

(* T5: if the corners of each vertex hold together without C, parent turns
   the result back into M.                                                    *)
Theorem T5_regular C : regular M C -> isomorphic (unglue M C) M.
Proof.
move=> r; exists fst; last by move=> t; rewrite T1_proj.
move=> w1 w2; rewrite !used_relabel => /imsetP[[v t] vt ->] /imsetP[[v' u] v'u ->].
by rewrite !copyK /= => e; subst v'; apply/eqP; rewrite copy_eq; exact: r.
Qed.

(* T5: the empty cut leaves a cut-regular complex as it is.                   *)
Theorem T5_empty_cut : cut_regular M -> isomorphic (unglue M set0) M.
Proof. exact: T5_regular. Qed.

(* T5: if no vertex is copied, the corners of each held together without C.   *)
Theorem T5_converse C : {in used (unglue M C) &, injective parent} -> regular M C.
Proof.
move=> inj v t u vt vu; rewrite -copy_eq; apply/eqP/inj; rewrite ?copyK //.
  exact: mem_used (mem_copy C vt).
exact: mem_used (mem_copy C vu).
Qed.

(* T5: nothing changes iff the corners of each vertex hold together without C:
   for the empty cut, iff M is cut-regular.                                   *)
Theorem T5_iff C : isomorphic (unglue M C) M <-> regular M C.
Proof.
split=> [iso|]; last exact: T5_regular.
apply/T5_converse/imset_injP; have fstM t : M t = fst @: unglue M C t by rewrite T1_proj.
by rewrite -(used_image fstM) (isomorphic_card iso).
Qed.

End Splits.

(* T5: the second time the same cut changes nothing.                          *)
Theorem T5_idempotent n (V T : finType) (M : complex n V T) (C : {set {set V}}) :
  isomorphic (unglue (unglue M C) (lifted parent C)) (unglue M C).
Proof. exact/T5_regular/T4_lifted. Qed.
