(* examples.v : concrete counterexamples, decided by vm_compute through exec.v *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue exec.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition regb n cs cut :=
  let l := labels n cs cut in
  all (fun x => all (fun y => (x.1 != y.1) || (get l x == get l y)) (corners cs)) (corners cs).

Section Regb.
Variables (n nv : nat) (cs cut : cellsT) (ok : wf n nv cs).

Lemma regbP : reflect (regular (ecomplex ok) (ecut nv cut)) (regb n cs cut).
Proof.
apply: (iffP idP) => [/allP r v t u vt vu|r].
  have := @exec_correct n nv cs cut ok (v, t) (v, u) vt vu.
  rewrite copy_eq => <-; have /allP r' := r _ (@enc_corner n nv cs ok (v, t) vt).
  by have := r' _ (@enc_corner n nv cs ok (v, u) vu); rewrite /= eqxx.
apply/allP => a ac; apply/allP => b bc; have [ab /=|//] := eqVneq a.1 b.1.
have [x ax] := dec ok ac; have [y bY] := dec ok bc.
have cc z : enc z \in corners cs -> corner (ecomplex ok) z.
  by case: z => v t; rewrite cornersP /corner /= inE => /andP[].
rewrite ax bY; rewrite exec_correct; [|by apply: cc; rewrite -ax|by apply: cc; rewrite -bY].
rewrite copy_eq; case: x y ax bY => v t [w u] ax bY.
have vw : v = w by apply: val_inj; move: ab; rewrite ax bY.
subst w; apply: r.
  by have := cc (v, t); rewrite -ax => /(_ ac).
by have := cc (v, u); rewrite -bY => /(_ bc).
Qed.
End Regb.

Lemma ecut_cat nv c1 c2 : ecut nv (c1 ++ c2) = ecut nv c1 :|: ecut nv c2.
Proof. by apply/setP=> f; rewrite !inE filter_cat has_cat. Qed.

(* Figure 8: two triangles sharing one node; unglue with the empty cut changes *)
Definition fig8 : cellsT := [:: [:: 0; 1; 2]; [:: 0; 3; 4]].
Lemma fig8_ok : wf 2 5 fig8. Proof. by vm_compute. Qed.
Lemma fig8_split : ~ regular (ecomplex fig8_ok) (ecut 5 [::]).
Proof. by move/regbP. Qed.

(* Figure 7: one interior edge, both end nodes interior: the mesh is unchanged *)
Definition fig7 : cellsT :=
  [:: [:: 0; 1; 2]; [:: 0; 2; 4]; [:: 0; 4; 3]; [:: 0; 3; 1]; [:: 1; 3; 5]; [:: 1; 5; 2]].
Lemma fig7_ok : wf 2 6 fig7. Proof. by vm_compute. Qed.
Lemma fig7_unchanged :
  isomorphic (unglue (ecomplex fig7_ok) (ecut 6 [:: [:: 0; 1]])) (ecomplex fig7_ok).
Proof. by apply: T5_regular; apply/regbP; vm_compute. Qed.
Lemma fig7_is_interior : adjacent (ecomplex fig7_ok) ord0 (inord 3).
Proof.
rewrite /adjacent ecommon; have [us bs] := shared_ok fig7_ok ord0 (inord 3).
by rewrite card_seq // inordK.
Qed.

(* T8: two cuts that do nothing one after the other, but open as one cut       *)
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
have r1 : regular M C1 by apply/regbP; vm_compute.
split=> //; first exact: regularS (sub0set _) r1.
- by apply/regbP; vm_compute.
- by rewrite -ecut_cat => /regbP; vm_compute.
Qed.

(* so the sequential composition is M itself while the union splits node 1     *)
Corollary T8_seq_noop : isomorphic (unglue (unglue M C1) (lifted fst C2)) M.
Proof.
have [_ r1 r2 _] := T8_counterexample; have t0 : 'I_(size strip) by exists 0.
apply: isomorphic_trans (T5_regular r2); exact: (T8_forgets t0).
Qed.
Corollary T8_union_splits : ~ {in used (unglue M (C1 :|: C2)) &, injective fst}.
Proof. by move/T5_converse; have [_ _ _] := T8_counterexample. Qed.

(* The same two phenomena with tetrahedra: one tetrahedron split 1 -> 4 at an   *)
(* inner node 4.  One inner face alone never opens; two of them do.            *)
Definition split4 : cellsT :=
  [:: [:: 0; 1; 2; 4]; [:: 0; 1; 3; 4]; [:: 0; 2; 3; 4]; [:: 1; 2; 3; 4]].
Lemma split4_ok : wf 3 5 split4. Proof. by vm_compute. Qed.
Local Definition N := ecomplex split4_ok.
Local Definition D1 := ecut 5 [:: [:: 0; 1; 4]].
Local Definition D2 := ecut 5 [:: [:: 0; 2; 4]].
Theorem T8_counterexample_3d :
  [/\ cut_regular N, regular N D1, regular N D2 & ~ regular N (D1 :|: D2)].
Proof.
have r1 : regular N D1 by apply/regbP; vm_compute.
split=> //; first exact: regularS (sub0set _) r1.
- by apply/regbP; vm_compute.
- by rewrite -ecut_cat => /regbP; vm_compute.
Qed.
Corollary fig7_3d : isomorphic (unglue N D1) N.
Proof. by apply: T5_regular; have [] := T8_counterexample_3d. Qed.
