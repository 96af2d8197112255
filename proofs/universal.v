(******************************************************************************)
(* unglue is universal (T7): of all ways to split vertices that open only     *)
(* facets of C it is the finest, so it opens the most. This makes Definition  *)
(* 2 exact: what unglue leaves shut cannot be opened by splitting vertices.   *)
(*   opens_only M C pK == the relabelled complex lacks only facets of C       *)
(*   T7_universal == a relabelling that opens only facets of C splits no      *)
(*                   corners that unglue keeps together: it is unglue,        *)
(*                   followed by a merging h of its new vertices              *)
(*   T7_shut      == a facet that unglue leaves shut, it leaves shut as well  *)
(*   T7_admissible == unglue itself opens only facets of C                    *)
(*   T7_unique    == these two properties determine unglue up to isomorphism  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling copies opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Universal.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.

Definition opens_only :=
  forall t u, adjacent M t u -> ~~ adjacent (relabel M pK) t u -> common M t u \in C.

(* T7: unglue is the finest vertex splitting that opens only facets of C.     *)
Theorem T7_universal : opens_only -> exists h : V * T -> W, forall x, lab x = h (copy M C x).
Proof.
move=> /(respectsP M pK) r; exists lab => x.
by apply: (respects_connect r); exact: connect_root.
Qed.

(* T7: a facet it leaves shut stays shut under every such splitting.          *)
Theorem T7_shut t u : opens_only -> adjacent (unglue M C) t u -> adjacent (relabel M pK) t u.
Proof.
move=> /T7_universal[h hE]; rewrite !adjacent_relabel => /andP[-> /forall_inP same].
by apply/forall_inP => v vi; rewrite !hE (eqP (same _ vi)).
Qed.

End Universal.

Section Unique.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).

(* T7: unglue is itself such a splitting.                                     *)
Theorem T7_admissible : opens_only M C (copyK M C).
Proof. exact/(respectsP M (copyK M C))/copy_respects. Qed.

(* T7: any other splitting that opens only facets of C, and of which unglue is
   a merging, is isomorphic to unglue. The cell t0 says that there are cells. *)
Theorem T7_unique (W : finType) (p : W -> V) (lab : V * T -> W)
    (pK : forall x, p (lab x) = x.1) (t0 : T) :
    opens_only M C pK -> (exists g : W -> V * T, forall x, copy M C x = g (lab x)) ->
  isomorphic (relabel M pK) (unglue M C).
Proof.
move=> /T7_universal[h hE] [g gE]; apply: (relabel_iso _ _ t0) => x y _ _.
by apply/eqP/eqP => e; rewrite ?gE ?e // hE e -hE.
Qed.

End Unique.
