(*******************************************************************************)
(* How large the kernel of the stiffness operator is (T9).                     *)
(*        skews R n == the space of skew matrices of size n                    *)
(*         kernel B == the space of the displacements that cause no force and  *)
(*                     are zero at the vertices that no cell uses              *)
(*   displacement g == the displacement that moves each piece by its motion in *)
(*                     g, a rotation and a translation for each piece          *)
(* n_comp (adjacent M) T is the number of pieces, each counted by its root.    *)
(* Theorems: T9_dim_skews, T9_kernel_dim (n(n + 1)/2 for each piece),          *)
(* T9_kernel_dim_unglue (after any cut).                                       *)
(* In C++: rigid_modes.hpp, six modes for each piece.                          *)
(*******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue fem elasticity rigid_motion elastic_kernel.
From Cleave Require Import stiffness_matrix.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* The dimension of a space that a linear map parametrizes without loss. *)
Lemma dim_param (R : fieldType) (aT rT : vectType R) (f : {linear aT -> rT}) (U : {vspace rT}) :
  (forall a, f a = 0 -> a = 0) -> (forall w, w \in U <-> exists a, w = f a) ->
  \dim U = Vector.dim aT.
Proof.
move=> inj onto; have -> : U = limg (linfun f).
  apply/vspaceP => w; apply/idP/memv_imgP => [/onto[a ->]|[a _ ->]].
    by exists a; rewrite ?memvf // lfunE.
  by apply/onto; exists a; rewrite lfunE.
rewrite limg_dim_eq ?dimvf //; apply/eqP; rewrite -subv0; apply/subvP => a.
by rewrite memv_cap memv_ker lfunE => /andP[_ /eqP/inj->]; rewrite mem0v.
Qed.

(* A linear map between functions on a finite set is one between finite functions. *)
Lemma ffun_linear (R : fieldType) (vT : vectType R) (V : finType)
    (f : (V -> vT) -> V -> vT) :
  (forall u w v, u =1 w -> f u v = f w v) ->
  (forall a u w v, f (fun y => a *: u y + w y) v = a *: f u v + f w v) ->
  linear (fun u : {ffun V -> vT} => [ffun v => f u v] : {ffun V -> vT}).
Proof.
move=> ext lin a u w; apply/ffunP => v; rewrite !ffunE -lin.
by apply: ext => y; rewrite !ffunE.
Qed.

Section Skew.
Variables (R : realFieldType) (n : nat).

Definition add_trmx (A : 'M[R]_n) := A + A^T.
Lemma add_trmx_linear : linear add_trmx.
Proof. by move=> a A B; rewrite /add_trmx linearP /= scalerDr addrACA. Qed.
Definition skews : {vspace 'M[R]_n} := lker (linfun (Linear add_trmx_linear)).

Lemma memskew A : (A \in skews) = (A^T == - A).
Proof. by rewrite memv_ker lfunE /= /add_trmx addrC addr_eq0. Qed.

Let pairs := {p : 'I_n * 'I_n | (p.1 < p.2)%N}.

Lemma card_pairs : #|{: pairs}| = 'C(n, 2).
Proof.
rewrite card_sig -sum1_card big_mkcond -triangular_sum big_mkord.
rewrite -(pair_bigA _ (fun i j : 'I_n => if (i < j)%N then 1%N else 0%N)) exchange_big /=.
apply: eq_bigr => j _; rewrite -big_mkcond -(big_ord_widen _ (fun=> 1%N)) ?sum1_card ?card_ord //.
exact: ltnW.
Qed.

(* The entries above the diagonal, which may be chosen freely. *)
Definition entry (c : {ffun pairs -> R^o}) i j : R := if insub (i, j) is Some p then c p else 0.
Definition skew_of c := \matrix_(i, j) (entry c i j - entry c j i).

Lemma entryP a c d i j : entry (a *: c + d) i j = a * entry c i j + entry d i j.
Proof. by rewrite /entry; case: insub => [p|]; rewrite ?ffunE // mulr0 addr0. Qed.

Lemma skew_of_linear : linear skew_of.
Proof.
by move=> a c d; apply/matrixP => i j; rewrite !mxE !entryP mulrBr opprD addrACA.
Qed.

Lemma entry_upper c (p : pairs) : entry c (val p).1 (val p).2 = c p.
Proof. by rewrite /entry -surjective_pairing valK. Qed.

Lemma entry_lower c (i j : 'I_n) : (j <= i)%N -> entry c i j = 0.
Proof. by move=> ji; rewrite /entry insubF //= ltnNge ji. Qed.

(* Skew matrices of size n have n(n - 1)/2 free entries. *)
Theorem T9_dim_skews : \dim skews = 'C(n, 2).
Proof.
rewrite (@dim_param _ _ _ (Linear skew_of_linear)) /=; last first.
- move=> A; rewrite memskew; split=> [/eqP skew|[c ->]]; last first.
    by apply/eqP/matrixP => i j; rewrite !mxE opprB.
  pose c : {ffun pairs -> R^o} := [ffun p : pairs => A (val p).1 (val p).2].
  have AE (k l : 'I_n) : A l k = - A k l by have /matrixP/(_ k l) := skew; rewrite !mxE.
  have up (k l : 'I_n) (kl : (k < l)%N) : entry c k l = A k l.
    by rewrite (entry_upper c (exist _ (k, l) kl)) ffunE.
  exists c; apply/matrixP => i j; rewrite mxE; have [ij|ji|/val_inj->] := ltngtP i j.
  - by rewrite up // entry_lower ?subr0 // ltnW.
  - by rewrite (up j i) // entry_lower ?sub0r -?AE // ltnW.
  by rewrite subrr; apply/eqP; rewrite -[_ == _](mulrn_eq0 _ 2) mulr2n {2}AE subrr.
- move=> c /matrixP c0; apply/ffunP => p; rewrite ffunE -entry_upper.
  have := c0 (val p).1 (val p).2; rewrite !mxE [X in _ - X]entry_lower ?subr0 //.
  exact/ltnW/(valP p).
by rewrite /Vector.dim /= card_pairs muln1.
Qed.

End Skew.

Section KernelDimension.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T) (B : body R M).

Let field := [vectType R of {ffun V -> 'cV[R]_n}].
Let X := position B.

Definition stiffness_map (u : field) : field := [ffun v => stiffness B u v].
Lemma stiffness_map_linear : linear stiffness_map.
Proof.
apply: ffun_linear; [exact: eq_stiffness | exact: stiffness_linear].
Qed.

Definition unused_part (u : field) : field := [ffun v => if v \in used M then 0 else u v].
Lemma unused_part_linear : linear unused_part.
Proof.
by move=> a u w; apply/ffunP => v; rewrite !ffunE; case: ifP; rewrite ?scaler0 ?addr0.
Qed.

Definition kernel : {vspace field} :=
  (lker (linfun (Linear stiffness_map_linear)) :&: lker (linfun (Linear unused_part_linear)))%VS.

Lemma mem_kernel (u : field) : reflect
  ((forall v, stiffness B u v = 0) /\ (forall v, v \notin used M -> u v = 0)) (u \in kernel).
Proof.
rewrite memv_cap !memv_ker !lfunE /=.
apply: (iffP andP) => [[/eqP K0 /eqP out]|[K0 out]].
  split=> [v|v nM]; first by have /ffunP/(_ v) := K0; rewrite !ffunE.
  by have /ffunP/(_ v) := out; rewrite !ffunE (negbTE nM).
split; apply/eqP/ffunP => v; rewrite !ffunE // ?K0 //.
by case: ifPn => // /out.
Qed.

(* A rigid motion for each piece, named by the root of the piece. *)
Let piece_root := {t | roots (adjacent M) t}.
Let motions := [vectType R of {ffun piece_root -> subvs_of (skews R n) * 'cV[R]_n}].
Let root_of t : piece_root :=
  exist _ (fingraph.root (adjacent M) t) (roots_root (@adjacent_csym _ _ _ M) t).
Let rotation (g : motions) t : 'M[R]_n := vsval (g (root_of t)).1.
Let translation (g : motions) t : 'cV[R]_n := (g (root_of t)).2.

Definition displacement (g : motions) : field :=
  [ffun v => moved B (rotation g) (translation g) v].

Lemma displacement_linear : linear displacement.
Proof.
move=> a g h; apply/ffunP => v; rewrite !ffunE /moved; case: pickP => [t _|_]; last first.
  by rewrite scaler0 addr0.
rewrite /rotation /translation !ffunE /= mulmxDl -scalemxAl scalerDr.
by rewrite addrACA.
Qed.

(* T9: in a cut-regular complex the kernel of the stiffness operator has dimension *)
(* n(n + 1)/2 for each piece: 6 for tetrahedra, 3 for triangles.                   *)
Theorem T9_kernel_dim : cut_regular M -> \dim kernel = (n_comp (adjacent M) T * 'C(n.+1, 2))%N.
Proof.
move=> reg.
have root_same t s : connect (adjacent M) t s -> root_of t = root_of s.
  by move=> ts; apply/val_inj/eqP; rewrite /= (root_connect (@adjacent_csym _ _ _ M)).
have skew g t : (rotation g t)^T = - rotation g t.
  by apply/eqP; rewrite -memskew subvsP.
have r g t : rigid X (rotation g t) (translation g t) (piece M t) (displacement g).
  have [] := @moved_rigid _ _ _ _ _ B (rotation g) (translation g) t reg (skew g).
    by move=> s s' ss'; rewrite /rotation /translation (root_same s s').
  by move=> sk mv; split=> // v vp; rewrite ffunE mv.
rewrite (@dim_param _ _ _ (Linear displacement_linear)) /=; last first.
- move=> u; split=> [/mem_kernel[/T9_kernel K0 out]|[g ->]]; last first.
    apply/mem_kernel; split; last by move=> v nM; rewrite ffunE moved_unused.
    by apply/T9_kernel => t; exists (rotation g t), (translation g t).
  pose A t := grad (order B) X u t.
  pose b t := u (order B t ord0) - A t *m X (order B t ord0).
  have rA t : rigid X (A t) (b t) (piece M t) u.
    have [A' [b' rA']] := K0 t.
    have e v : v \in M t -> u v = A' *m X v + b'.
      by move=> vt; rewrite rA'.2 // (subsetP (cell_piece M t)).
    have AA' : A t = A'.
      apply: (grad_uniq (order_vertices B) (not_flat B)) => v w vt wt.
      by rewrite !e // opprD addrACA subrr addr0 mulmxBr.
    by rewrite /b e ?(mem_order (order_vertices B)) // AA' addrC addKr.
  exists [ffun p => (vsproj (skews R n) (A (val p)), b (val p))]; set g := [ffun p => _].
  apply/ffunP => v; have [/usedP[t vt]|nM] := boolP (v \in used M); last first.
    by rewrite ffunE moved_unused // out.
  have vp : v \in piece M t by rewrite (subsetP (cell_piece M t)).
  rewrite (r g t).2 // /rotation /translation ffunE /=; set t' := fingraph.root _ _.
  have tt' : connect (adjacent M) t' t by rewrite adjacent_csym connect_root.
  rewrite vsprojK ?memskew ?(rA t').1 //; apply: (rA t').2.
  by apply/pieceP; exists t.
- move=> g g0; have r0 t : rigid X 0 0 (piece M t) (displacement g).
    by split=> [|v _]; rewrite ?trmx0 ?oppr0 // g0 ffunE mul0mx addr0.
  apply/ffunP => p; rewrite ffunE; have -> : p = root_of (val p).
    by apply: val_inj; have /eqP := valP p.
  have [rot tr] := T9_kernel_unique (r g (val p)) (r0 (val p)).
  by apply: injective_projections; first exact: val_inj.
have -> : Vector.dim motions = (#|{: piece_root}| * (\dim (skews R n) + n * 1))%N by [].
rewrite T9_dim_skews muln1 card_sig binS bin1 /n_comp_mem; congr (_ * _)%N.
by apply: eq_card => t; rewrite !inE andbT.
Qed.

End KernelDimension.

(* T9: after any cut, of any complex, one rigid motion is left to each component of *)
(* the dual graph without the cut facets.                                           *)
Theorem T9_kernel_dim_unglue (R : realFieldType) n (V T : finType) (M : complex n V T)
    (B : body R M) (C : {set {set V}}) : (0 < n)%N ->
  \dim (kernel (unglue_body B C)) = (n_comp (dual M C) T * 'C(n.+1, 2))%N.
Proof.
move=> n_gt0; rewrite T9_kernel_dim; last exact: T4_cut_regular.
by rewrite (eq_n_comp (T9_pieces M C n_gt0)).
Qed.
