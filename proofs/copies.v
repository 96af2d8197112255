(******************************************************************************)
(* unglue: the operation, and what it never changes (T1, T2).                 *)
(*      copy M C x == the new vertex of the corner x: the paper's N_c, where  *)
(*                    c is the component of the corner. It is named by a      *)
(*                    corner of that component, its root under glue M C, so   *)
(*                    that the new vertices are pairs (old vertex, cell) and  *)
(*                    parent is fst. Pairs that name no component are not in  *)
(*                    use.                                                    *)
(*      unglue M C == the relabelling of M by copy: Algorithm 3, all nodes at *)
(*                    once (algorithm3.v treats them one after the other);    *)
(*                    unglue(K, C) of the C++                                 *)
(*     after M C x == the corner, or half-facet, x of M as one of unglue M C  *)
(* A theorem on unglue holds for every cut C, and for every complex M unless  *)
(* it says otherwise: T1 to T4 do not suppose that M is cut-regular.          *)
(*   T1_card T1_inj T1_proj T1_bij == cells keep n.+1 vertices, differ, and   *)
(*                    parent maps each back onto itself                       *)
(*   T2_pseudo_manifold == pseudo-manifolds remain so                         *)
(*   T2_half_facets == no half-facet is created or destroyed                  *)
(* Section 4: Algorithm 3 is well defined, and maps pseudo-manifolds to       *)
(* pseudo-manifolds. (T2 for oriented complexes is in orientation.v.)         *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Unglue.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

Definition copy C x : V * T := root (glue M C) x.

Lemma copyK C x : parent (copy C x) = x.1.
Proof. by rewrite -(connect_fst (connect_root (glue M C) x)). Qed.

Definition unglue C : complex n (prod_finType V T) T := relabel M (copyK C).

Definition after C x : (V * T) * T := up (copy C) x.

(* Two corners get the same new vertex iff they are in the same component.    *)
Lemma copy_eq C x y : (copy C x == copy C y) = connect (glue M C) x y.
Proof. exact/root_connect/glue_csym. Qed.

Lemma copy_respects C : respects M (copy C) C.
Proof. by move=> x y g; apply/eqP; rewrite copy_eq; exact: connect1. Qed.

Lemma unglueE C t : unglue C t = [set copy C (v, t) | v in M t]. Proof. by []. Qed.

Lemma mem_copy C v t : v \in M t -> copy C (v, t) \in unglue C t.
Proof. by move=> vt; rewrite unglueE; apply/imsetP; exists v. Qed.

(* T1: every cell still has n.+1 different vertices. That there are as many
   cells as before is in the type of unglue: the same T names them.           *)
Theorem T1_card C t : #|unglue C t| = n.+1.
Proof. exact: card_vertices. Qed.

(* T1: different cells stay different.                                        *)
Theorem T1_inj C : injective (unglue C).
Proof. exact: vertices_inj. Qed.

(* T1: parent maps each cell back onto itself.                                *)
Theorem T1_proj C t : parent @: unglue C t = M t.
Proof. exact: (p_relabelled M (copyK C)). Qed.

(* T1: and no two vertices of a cell have the same parent.                    *)
Theorem T1_bij C t : {in unglue C t &, injective parent}.
Proof. exact: (p_inj_in (copyK C)). Qed.

(* T2: a pseudo-manifold remains one.                                         *)
Theorem T2_pseudo_manifold C : pseudo_manifold M -> pseudo_manifold (unglue C).
Proof. exact: relabel_pseudo_manifold. Qed.

(* T2: no half-facet (nor corner) is created or destroyed, none is moved to
   another cell or to other parents, and none gets a mate that it had not.    *)
Theorem T2_half_facets C :
  [/\ {in corner M, forall x, corner (unglue C) (after C x)},
      forall z, corner (unglue C) z -> exists2 x, corner M x & z = after C x,
      injective (after C),
      forall x, (after C x).2 = x.2 /\ parent @: facet (unglue C) (after C x) = facet M x
    & forall x y, mates (unglue C) (after C x) (after C y) -> mates M x y].
Proof.
split=> [x cx|z cz|||x y].
- by rewrite corner_up.
- by exists (down parent z); [exact: corner_down cz | exact/esym/(up_surj cz)].
- exact: can_inj (upK (copyK C)).
- by split=> //; apply: p_facet_up.
- exact: mates_relabel_sub.
Qed.

End Unglue.
