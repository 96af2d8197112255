(******************************************************************************)
(* A body to which the theorems of elastic_kernel.v apply: one simplex, with  *)
(* a corner at the origin and the others at the unit vectors.                 *)
(*                                                                            *)
(*     unit_simplex n == the complex of one cell, with n + 1 vertices         *)
(*    unit_position v == the origin for vertex 0, the i-th unit vector for    *)
(*                       vertex i + 1                                         *)
(*      unit_body R n == this simplex, with its own volume (simplex_volume)   *)
(*                       and a material with mu = lambda = 1                  *)
(*                                                                            *)
(* Theorems: T9_unit_volume (its volume is 1 / n!, as it should be) and       *)
(* T9_unit_kernel (a displacement of it causes no force exactly if it is a    *)
(* rigid motion).                                                             *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex elasticity rigid_motion elastic_kernel.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section UnitBody.
Variables (R : realFieldType) (n : nat).

Lemma unit_card (t : unit) : #|[set: 'I_n.+1]| = n.+1.
Proof. by rewrite cardsT card_ord. Qed.

Lemma unit_inj : injective (fun _ : unit => [set: 'I_n.+1]).
Proof. by move=> [] []. Qed.

Definition unit_simplex : complex n [finType of 'I_n.+1] unit_finType :=
  Complex unit_card unit_inj.

Definition unit_order (t : unit) (i : 'I_n.+1) : 'I_n.+1 := i.
Definition unit_position (v : 'I_n.+1) : 'cV[R]_n :=
  if unlift ord0 v is Some i then delta_mx i 0 else 0.

Lemma unit_order_vertices t : unit_simplex t = [set unit_order t i | i : 'I_n.+1].
Proof. by apply/setP => v; rewrite inE; apply/esym/imsetP; exists v. Qed.

Lemma unit_edges t : edges unit_order unit_position t = 1%:M.
Proof.
apply/matrixP => a j; rewrite !mxE /unit_position /unit_order liftK unlift_none !mxE subr0.
by rewrite eqxx andbT.
Qed.

Lemma unit_not_flat : nondegenerate unit_order unit_position.
Proof. by move=> t; rewrite unit_edges unitmx1. Qed.

Definition unit_volume t := simplex_volume (edges unit_order unit_position t).

Lemma unit_volume_gt0 t : 0 < unit_volume t.
Proof. exact/T9_simplex_volume_gt0/unit_not_flat. Qed.

Lemma unit_material (t : unit) : elastic n (1 : R) 1.
Proof. by rewrite /elastic ltr01 !mulr1 -natrD ltr0n addn2. Qed.

Definition unit_body : body R unit_simplex :=
  Body unit_order_vertices unit_not_flat unit_volume_gt0 unit_material.

(* T9: the volume of the unit simplex is 1 / n!. *)
Theorem T9_unit_volume t : volume unit_body t = n`!%:R^-1.
Proof. by rewrite /= /unit_volume unit_edges /simplex_volume det1 normr1 mul1r. Qed.

(* T9: the unit simplex answers to a displacement with no force exactly if it moves rigidly. *)
Theorem T9_unit_kernel u : (forall v, stiffness unit_body u v = 0) <->
  exists A b, A^T = - A /\ forall v, u v = A *m unit_position v + b.
Proof.
have inside v t : v \in piece unit_simplex t.
  by apply: (subsetP (cell_piece _ _)); rewrite inE.
rewrite T9_kernel; split=> [/(_ tt)[A [b [skew r]]]|[A [b [skew r]]] t]; exists A, b.
  by split=> // v; apply: r.
by split=> // v _; apply: r.
Qed.

End UnitBody.
