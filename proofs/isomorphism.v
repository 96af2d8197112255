(******************************************************************************)
(* Isomorphism of complexes with the same cells.                              *)
(*    isomorphic M N == some renaming of vertices, injective on those in use, *)
(*                      turns every cell of M into the cell of N of the same  *)
(*                      name. The cells are not permuted: the paper's cells   *)
(*                      are objects that remain valid, and Cleave's keep      *)
(*                      their numbers. All theorems mean this when they say:  *)
(*                      the same up to renaming of vertices.                  *)
(* It is an equivalence: isomorphic_sym, isomorphic_trans.                    *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition isomorphic n (V W T : finType) (M : complex n V T) (N : complex n W T) :=
  exists2 f : V -> W, {in used M &, injective f} & forall t, N t = f @: M t.

Section Isomorphism.
Variables (n : nat) (T : finType).

Lemma used_image (V W : finType) (M : complex n V T) (N : complex n W T) (f : V -> W) :
  (forall t, N t = f @: M t) -> used N = f @: used M.
Proof.
move=> fM; apply/setP=> w; apply/usedP/imsetP => [[t]|[v /usedP[t vt] ->]].
  by rewrite fM => /imsetP[v vt ->]; exists v => //; apply: mem_used vt.
by exists t; rewrite fM imset_f.
Qed.

Lemma isomorphic_trans (V W X : finType)
    (M : complex n V T) (N : complex n W T) (P : complex n X T) :
  isomorphic M N -> isomorphic N P -> isomorphic M P.
Proof.
case=> f fi fM [g gi gN]; exists (g \o f); last by move=> t; rewrite gN fM imset_comp.
have fu v : v \in used M -> f v \in used N by rewrite (used_image fM); apply: imset_f.
by move=> v w vM wM /= /gi e; apply: fi => //; apply: e; exact: fu.
Qed.

(* The cell t only shows that M has vertices at all.                          *)
Lemma isomorphic_sym (V W : finType) (M : complex n V T) (N : complex n W T) :
  T -> isomorphic M N -> isomorphic N M.
Proof.
move=> t [f fi fM]; have /card_gt0P[v0 _] : 0 < #|M t| by rewrite card_vertices.
pose g w := odflt v0 [pick v in used M | f v == w].
have fK v : v \in used M -> g (f v) = v.
  move=> vM; rewrite /g; case: pickP => [u /andP[uM /eqP/fi->//]|/(_ v)].
  by rewrite vM eqxx.
exists g => [w1 w2|u]; rewrite ?(used_image fM).
  by move=> /imsetP[v1 v1M ->] /imsetP[v2 v2M ->]; rewrite !fK // => ->.
rewrite fM -imset_comp -[LHS]imset_id; apply: eq_in_imset => v vu /=.
by rewrite fK //; apply: mem_used vu.
Qed.

Lemma isomorphic_card (V W : finType) (M : complex n V T) (N : complex n W T) :
  isomorphic M N -> #|used N| = #|used M|.
Proof. by case=> f fi /used_image->; rewrite card_in_imset. Qed.

End Isomorphism.
