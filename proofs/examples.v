(******************************************************************************)
(* The paper's Figures 7 and 8 and two cuts that need each other, as small    *)
(* complexes that are decided by running regular_exec.v.                      *)
(*                                                                            *)
(*    fig8 == two triangles that share one vertex                             *)
(*    fig7 == six triangles around an inner edge whose ends are inner, too    *)
(*   strip == eight triangles around the path 0, 1, 2                         *)
(*  split4 == a tetrahedron split into four at an inner vertex                *)
(*                                                                            *)
(* Theorems: fig8_split (Figure 8: the empty cut changes the mesh),           *)
(* fig7_unchanged and fig7_3d (Figure 7: a cut facet stays shut; against      *)
(* "these triangles" of Definition 2), T8_counterexample and its solid form   *)
(* (two cuts that open nothing one after the other, but open as one: shut     *)
(* facets must be remembered).                                                *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue listed_complex regular_exec.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma ecut_cat nv c1 c2 : ecut nv (c1 ++ c2) = ecut nv c1 :|: ecut nv c2.
Proof. by apply/setP=> f; rewrite !inE filter_cat has_cat. Qed.

(* Figure 8: the vertex that two triangles share splits without any cut.       *)
Definition fig8 : cellsT := [:: [:: 0; 1; 2]; [:: 0; 3; 4]].
Lemma fig8_ok : wf 2 5 fig8. Proof. by vm_compute. Qed.

Theorem fig8_split : ~ regular (ecomplex fig8_ok) (ecut 5 [::]).
Proof. by apply: irregular_by; vm_compute. Qed.

(* Figure 7: the facet {0, 1} is interior, and cutting it changes nothing.      *)
Definition fig7 : cellsT :=
  [:: [:: 0; 1; 2]; [:: 0; 2; 4]; [:: 0; 4; 3]; [:: 0; 3; 1]; [:: 1; 3; 5]; [:: 1; 5; 2]].
Lemma fig7_ok : wf 2 6 fig7. Proof. by vm_compute. Qed.

Lemma fig7_is_interior : adjacent (ecomplex fig7_ok) ord0 (inord 3).
Proof.
rewrite /adjacent ecommon; have [us bs] := shared_ok fig7_ok ord0 (inord 3).
by rewrite card_seq // inordK.
Qed.

Theorem fig7_unchanged :
  isomorphic (unglue (ecomplex fig7_ok) (ecut 6 [:: [:: 0; 1]])) (ecomplex fig7_ok).
Proof. by apply/T5_regular/regular_by; vm_compute. Qed.

(* T8: two cuts that open nothing one after the other, but open as one cut.     *)
Definition strip : cellsT :=
  [:: [:: 0; 1; 3]; [:: 1; 2; 3]; [:: 0; 1; 4]; [:: 1; 2; 4];
      [:: 0; 3; 5]; [:: 0; 4; 5]; [:: 2; 3; 6]; [:: 2; 4; 6]].
Lemma strip_ok : wf 2 7 strip. Proof. by vm_compute. Qed.
Local Definition M := ecomplex strip_ok.
Local Definition C1 := ecut 7 [:: [:: 0; 1]].
Local Definition C2 := ecut 7 [:: [:: 1; 2]].

Theorem T8_counterexample :
  [/\ cut_regular M, regular M C1, regular M C2 & ~ regular M (C1 :|: C2)].
Proof.
have r1 : regular M C1 by apply: regular_by; vm_compute.
split=> //; first exact: regularS (sub0set _) r1.
- by apply: regular_by; vm_compute.
- by rewrite -ecut_cat; apply: irregular_by; vm_compute.
Qed.

(* So the second cut, after the first, gives M itself ...                       *)
Corollary T8_seq_noop : isomorphic (unglue (unglue M C1) (lifted fst C2)) M.
Proof.
have [_ r1 r2 _] := T8_counterexample; have t0 : 'I_(size strip) by exists 0.
apply: isomorphic_trans (T5_regular r2); exact: (T8_forgets t0).
Qed.

(* ... while both at once split vertex 1.                                       *)
Corollary T8_union_splits : ~ {in used (unglue M (C1 :|: C2)) &, injective fst}.
Proof. by move/T5_converse; have [_ _ _] := T8_counterexample. Qed.

(* The same with tetrahedra: one inner facet alone never opens, two of them do. *)
Definition split4 : cellsT :=
  [:: [:: 0; 1; 2; 4]; [:: 0; 1; 3; 4]; [:: 0; 2; 3; 4]; [:: 1; 2; 3; 4]].
Lemma split4_ok : wf 3 5 split4. Proof. by vm_compute. Qed.
Local Definition N := ecomplex split4_ok.
Local Definition D1 := ecut 5 [:: [:: 0; 1; 4]].
Local Definition D2 := ecut 5 [:: [:: 0; 2; 4]].

Theorem T8_counterexample_3d :
  [/\ cut_regular N, regular N D1, regular N D2 & ~ regular N (D1 :|: D2)].
Proof.
have r1 : regular N D1 by apply: regular_by; vm_compute.
split=> //; first exact: regularS (sub0set _) r1.
- by apply: regular_by; vm_compute.
- by rewrite -ecut_cat; apply: irregular_by; vm_compute.
Qed.

(* Figure 7 in three dimensions.                                                *)
Corollary fig7_3d : isomorphic (unglue N D1) N.
Proof. by apply: T5_regular; have [] := T8_counterexample_3d. Qed.
