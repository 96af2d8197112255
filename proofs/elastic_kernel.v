(*********************************************************************************)
(* The displacements that cost no energy (T9). The stiffness operator K takes a  *)
(* displacement of the vertices to the elastic forces at the vertices. In a      *)
(* cut-regular complex it takes to zero one rigid motion for each piece, freely  *)
(* chosen, and nothing else.                                                     *)
(*           body R M == a complex M in R^n, ready for elasticity: an order of   *)
(*                       the vertices of each cell, positions of the vertices,   *)
(*                       volumes and materials of the cells, with what is asked  *)
(*                       of them: no cell is flat, volumes are positive,         *)
(*                       materials are elastic (mu > 0 and n lambda + 2 mu > 0). *)
(*                       R is any ordered field. The C++ computes the volumes    *)
(*                       from the positions, here any positive numbers will do;  *)
(*                       simplex_volume is the usual one, of unit_body.v say.    *)
(*      stiffness B u v == (K u)(v), the elastic force at the vertex v           *)
(*         energy B u == the elastic energy of the displacement u                *)
(*         work B u w == the work of the forces K u along the displacement w     *)
(*          piece M t == the vertices of the piece of the cell t: those of all   *)
(*                       cells that a walk from t through facets can reach       *)
(*          moved B A b == the displacement by a rigid motion for each cell      *)
(*           held D u == the coordinates in D of the displacement u are zero     *)
(*                       (Dirichlet conditions)                                  *)
(*    unglue_body B C == the body after the cut C: copies lie where their        *)
(*                       parents lie, cells keep order, volume and material      *)
(* Theorems: T9_stiffness_symmetric, T9_stiffness_energy (u.Ku is twice the      *)
(* energy), T9_kernel_energy (K u = 0 = no energy), T9_kernel (= a rigid motion  *)
(* of each piece), T9_kernel_unique, T9_piece_disjoint and T9_kernel_free (in a  *)
(* cut-regular complex the motions of the pieces are independent),               *)
(* T9_kernel_unglue (after any cut), T9_supported (K with conditions on D is     *)
(* positive definite if and only if no rigid motion of a piece meets them).      *)
(* In C++: cleave::fem::ElasticOperator, unsupported_pieces.                     *)
(*********************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue elasticity rigid_motion.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Record body (R : realFieldType) n (V T : finType) (M : complex n V T) := Body {
  order : T -> 'I_n.+1 -> V;
  position : V -> 'cV[R]_n;
  volume : T -> R;
  lame_mu : T -> R;
  lame_lambda : T -> R;
  order_vertices : forall t, M t = [set order t i | i : 'I_n.+1];
  not_flat : nondegenerate order position;
  volume_gt0 : forall t, 0 < volume t;
  material : forall t, elastic n (lame_mu t) (lame_lambda t) }.

(* The volume of the simplex with edge matrix P, as the C++ computes it. *)
Definition simplex_volume (R : realFieldType) n (P : 'M[R]_n) : R := `|\det P| / n`!%:R.

Theorem T9_simplex_volume_gt0 (R : realFieldType) n (P : 'M[R]_n) :
  P \in unitmx -> 0 < simplex_volume P.
Proof. by rewrite unitmxE unitfE => nz; rewrite divr_gt0 ?normr_gt0 ?ltr0n ?fact_gt0. Qed.

Definition piece n (V T : finType) (M : complex n V T) t : {set V} :=
  [set v | [exists s, connect (adjacent M) t s && (v \in M s)]].

Section Piece.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t s : T) (v : V).

Lemma pieceP v t :
  reflect (exists2 s, connect (adjacent M) t s & v \in M s) (v \in piece M t).
Proof.
by rewrite inE; apply: (iffP existsP) => [[s /andP[]]|[s ts vs]]; exists s; rewrite ?ts.
Qed.

Lemma cell_piece t : M t \subset piece M t.
Proof. by apply/subsetP => v vt; apply/pieceP; exists t. Qed.

Lemma adjacent_csym : connect_sym (adjacent M).
Proof. exact/sym_connect_sym/adjacentC. Qed.

(* T9: in a cut-regular complex a vertex belongs to one piece only. *)
Theorem T9_piece_disjoint v t s : cut_regular M ->
  v \in piece M t -> v \in piece M s -> connect (adjacent M) t s.
Proof.
move=> reg /pieceP[t' tt' vt'] /pieceP[s' ss' vs'].
apply: connect_trans tt' _; apply: connect_trans (T9_vertex reg vt' vs') _.
by rewrite adjacent_csym.
Qed.

End Piece.

Section Kernel.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T) (B : body R M).
Implicit Types (t s : T) (v : V) (u w : V -> 'cV[R]_n) (A : 'M[R]_n) (b : 'cV[R]_n).

Let X := position B.
Let P t := edges (order B) X t.
Let U u t := edges (order B) u t.

Definition cell_forces u t : 'M[R]_n :=
  forces (volume B t) (lame_mu B t) (lame_lambda B t) (P t) (U u t).
Definition stiffness u v : 'cV[R]_n :=
  \sum_t \sum_(i | order B t i == v) col i (closed (cell_forces u t)).
Definition strain_of u t := strain (gradient (P t) (U u t)).
Definition cell_energy u t : R :=
  volume B t * energy_density (lame_mu B t) (lame_lambda B t) (strain_of u t).
Definition energy u : R := \sum_t cell_energy u t.
Definition work u w : R := \sum_v dot (stiffness u v) (w v).

Lemma dot_sumr m (I : finType) (p : pred I) (F : I -> 'cV[R]_m) (x : 'cV[R]_m) :
  dot (\sum_(i | p i) F i) x = \sum_(i | p i) dot (F i) x.
Proof. by rewrite /dot raddf_sum /= mulmx_suml raddf_sum. Qed.

Lemma workE u w : work u w = \sum_t dot (cell_forces u t) (U w t).
Proof.
rewrite /work; under eq_bigr do rewrite dot_sumr; rewrite exchange_big; apply: eq_bigr => t _.
under eq_bigr do rewrite dot_sumr big_mkcond; rewrite exchange_big.
apply: etrans (work_closed _ (fun i => w (order B t i))); apply: eq_bigr => i _.
by rewrite -big_mkcond (big_pred1 (order B t i)) // => v; apply: eq_sym.
Qed.

(* T9: the stiffness operator is symmetric. *)
Theorem T9_stiffness_symmetric u w : work u w = work w u.
Proof. by rewrite !workE; apply: eq_bigr => t _; rewrite T9_work_symmetric. Qed.

(* T9: the work of the elastic forces along the displacement is twice the energy. *)
Theorem T9_stiffness_energy u : work u u = 2%:R * energy u.
Proof. by rewrite workE mulr_sumr; apply: eq_bigr => t _; rewrite T9_work_self. Qed.

Lemma cell_energy_ge0 u t : 0 <= cell_energy u t.
Proof. by rewrite mulr_ge0 ?T9_energy_ge0 ?material // ltW // volume_gt0. Qed.

(* T9: the energy is never negative. *)
Theorem T9_total_energy_ge0 u : 0 <= energy u.
Proof. by apply: sumr_ge0 => t _; apply: cell_energy_ge0. Qed.

Lemma energy_strain u : energy u = 0 <-> forall t, strain_of u t = 0.
Proof.
split=> [/psumr_eq0P e t|e].
  have /eqP := e (fun s _ => cell_energy_ge0 u s) t isT.
  rewrite mulf_eq0 (gt_eqF (volume_gt0 B t)) /= => /eqP.
  exact/T9_energy_eq0/material.
by rewrite /energy big1 // => t _; rewrite /cell_energy e /energy_density dot0l mxtrace0
           expr0n !mulr0 addr0 mulr0.
Qed.

(* T9: a displacement causes no force anywhere if and only if it costs no energy. *)
Theorem T9_kernel_energy u : (forall v, stiffness u v = 0) <-> energy u = 0.
Proof.
split=> [K0|/energy_strain e v]; last first.
  rewrite /stiffness big1 // => t _; rewrite big1 // => i _.
  rewrite /cell_forces T9_forces_eq0; last exact: e.
  apply/matrixP => a j; rewrite !mxE; case: unlift => [k|]; rewrite ?mxE //.
  by rewrite big1 ?oppr0 // => k _; rewrite mxE.
have : work u u = 0 by rewrite /work big1 // => v _; rewrite K0 dot0l.
by rewrite T9_stiffness_energy => /eqP; rewrite mulf_eq0 pnatr_eq0 => /eqP.
Qed.

Lemma rigid_sub A b (S S' : {set V}) u : S \subset S' -> rigid X A b S' u -> rigid X A b S u.
Proof. by move=> /subsetP sub [skew r]; split=> // v /sub; apply: r. Qed.

(* A rigid motion of a cell, in a displacement where every cell moves rigidly, is *)
(* that of the whole piece.                                                       *)
Lemma rigid_spreads u t A b : (forall s, strain_of u s = 0) ->
  rigid X A b (M t) u -> rigid X A b (piece M t) u.
Proof.
move=> e rt; have step s s' : adjacent M s s' -> rigid X A b (M s) u -> rigid X A b (M s') u.
  move=> ss' rs.
  have [A' [b' rs']] := (T9_rigid_on_cell (order_vertices B) (not_flat B) u s').1 (e s').
  by have [-> ->] := T9_shared_facet (order_vertices B) (not_flat B) ss' rs rs'.
have all s : connect (adjacent M) t s -> rigid X A b (M s) u.
  move=> /connectP[p + ->]; elim: p t rt => [|s' p IHp] t' rt //= /andP[ts' path_p].
  exact: IHp (step _ _ ts' rt) path_p.
by split=> [|v /pieceP[s /all[_ r] vs]]; [case: rt | apply: r].
Qed.

(* T9: a displacement causes no force if and only if it moves each piece rigidly. *)
Theorem T9_kernel u :
  (forall v, stiffness u v = 0) <-> (forall t, exists A b, rigid X A b (piece M t) u).
Proof.
rewrite T9_kernel_energy energy_strain; split=> [e t|r t].
  have [A [b rt]] := (T9_rigid_on_cell (order_vertices B) (not_flat B) u t).1 (e t).
  by exists A, b; apply: rigid_spreads.
apply/(T9_rigid_on_cell (order_vertices B) (not_flat B)).
by have [A [b rt]] := r t; exists A, b; apply: rigid_sub rt; exact: cell_piece.
Qed.

(* T9: the rigid motion of a piece is unique. *)
Theorem T9_kernel_unique u t A b A' b' :
  rigid X A b (piece M t) u -> rigid X A' b' (piece M t) u -> A = A' /\ b = b'.
Proof.
move=> /(rigid_sub (cell_piece M t)) r /(rigid_sub (cell_piece M t)).
exact: (T9_rigid_unique (order_vertices B) (not_flat B)) r.
Qed.

(* The displacement that moves the cells around each vertex by the motion A, b of one *)
(* of them, and unused vertices not at all.                                           *)
Definition moved (A : T -> 'M[R]_n) (b : T -> 'cV[R]_n) v : 'cV[R]_n :=
  if [pick t | v \in M t] is Some t then A t *m X v + b t else 0.

Lemma moved_unused (A : T -> 'M[R]_n) (b : T -> 'cV[R]_n) v : v \notin used M -> moved A b v = 0.
Proof.
by rewrite /moved; case: pickP => // t vt /negP[]; apply/usedP; exists t.
Qed.

Lemma moved_rigid (A : T -> 'M[R]_n) (b : T -> 'cV[R]_n) t :
  cut_regular M -> (forall t, (A t)^T = - A t) ->
  (forall t s, connect (adjacent M) t s -> A t = A s /\ b t = b s) ->
  rigid X (A t) (b t) (piece M t) (moved A b).
Proof.
move=> reg skew same; split=> // v /pieceP[s ts vs].
rewrite /moved; case: pickP => [s' vs'|/(_ s)]; last by rewrite vs.
by have [-> ->] := same t s' (connect_trans ts (T9_vertex reg vs vs')).
Qed.

(* T9: in a cut-regular complex any choice of rigid motions, one for each piece, is in *)
(* the kernel.  At a vertex shared by two pieces two motions could disagree; that is   *)
(* what cut-regularity excludes.                                                       *)
Theorem T9_kernel_free (A : T -> 'M[R]_n) (b : T -> 'cV[R]_n) : cut_regular M ->
  (forall t, (A t)^T = - A t) ->
  (forall t s, connect (adjacent M) t s -> A t = A s /\ b t = b s) ->
  exists u, [/\ forall v, stiffness u v = 0, forall v, v \notin used M -> u v = 0 &
                forall t, rigid X (A t) (b t) (piece M t) u].
Proof.
move=> reg skew same; have r t := moved_rigid t reg skew same.
exists (moved A b); split=> //; last exact: moved_unused.
by apply/T9_kernel => t; exists (A t), (b t).
Qed.

(* Dirichlet conditions: the coordinates in D are held at zero, of all vertices or of some. *)
Definition held (D : {set V * 'I_n}) u := forall v i, (v, i) \in D -> u v i 0 = 0.
Definition held_on (D : {set V * 'I_n}) (S : {set V}) u :=
  {in S, forall v i, (v, i) \in D -> u v i 0 = 0}.

(* T9: with some coordinates held at zero (Dirichlet conditions), K is positive      *)
(* definite if and only if no rigid motion of a piece, but rest, keeps them at zero. *)
Theorem T9_supported (D : {set V * 'I_n}) : cut_regular M ->
  (forall u, held D u -> (exists2 v, v \in used M & u v != 0) -> 0 < work u u) <->
  (forall t A b, A^T = - A -> held_on D (piece M t) (fun v => A *m X v + b) -> A = 0 /\ b = 0).
Proof.
move=> reg; split=> [pos t A b skew hold|firm u hold [v vM nz]]; last first.
  rewrite T9_stiffness_energy mulr_gt0 ?ltr0n // lt_neqAle T9_total_energy_ge0 andbT eq_sym.
  apply: contra nz => /eqP/T9_kernel_energy/T9_kernel r; have /usedP[t vt] := vM.
  have [A [b [skew rt]]] := r t; have vp : v \in piece M t by apply: (subsetP (cell_piece M t)).
  have [] := firm t A b skew; last by rewrite rt // => -> ->; rewrite mul0mx addr0.
  by move=> y yp i yi; rewrite -rt // hold.
pose A' s := if connect (adjacent M) t s then A else 0.
pose b' s := if connect (adjacent M) t s then b else 0.
have skew' s : (A' s)^T = - A' s by rewrite /A'; case: ifP => _; rewrite ?skew // trmx0 oppr0.
have same' s s' : connect (adjacent M) s s' -> A' s = A' s' /\ b' s = b' s'.
  by move=> ss'; rewrite /A' /b' (same_connect_r (@adjacent_csym _ _ _ M) ss').
have [u [/T9_kernel_energy e0 out r]] := T9_kernel_free reg skew' same'.
have hold' : held D u.
  move=> v i vi; have [/usedP[s vs]|/out->] := boolP (v \in used M); last by rewrite mxE.
  rewrite (r s).2 ?(subsetP (cell_piece M s)) // /A' /b'; case: ifP => ts.
    by apply: hold vi; apply/pieceP; exists s.
  by rewrite mul0mx addr0 mxE.
have u0 v : v \in used M -> u v = 0.
  move=> vM; apply/eqP/negPn/negP => nz.
  have := pos u hold'; rewrite T9_stiffness_energy e0 mulr0 ltxx => /(_ (ex_intro2 _ _ v vM nz)).
  by [].
apply: (T9_kernel_unique (u := u) (t := t)).
  by have := r t; rewrite /A' /b' connect0.
split=> [|v /pieceP[s _ vs]]; first by rewrite trmx0 oppr0.
by rewrite mul0mx addr0 u0 //; apply/usedP; exists s.
Qed.

End Kernel.

Section AfterCut.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T) (B : body R M).
Variable C : {set {set V}}.

Definition cut_order t i : prod_finType V T := copy M C (order B t i, t).
Definition cut_position (v : prod_finType V T) : 'cV[R]_n := position B v.1.

Lemma cut_order_vertices t : unglue M C t = [set cut_order t i | i : 'I_n.+1].
Proof. by rewrite unglueE (order_vertices B) -imset_comp. Qed.

Lemma cut_not_flat : nondegenerate cut_order cut_position.
Proof.
move=> t; suff -> : edges cut_order cut_position t = edges (order B) (position B) t.
  exact: not_flat.
by apply/matrixP => a j; rewrite !mxE /cut_position /cut_order !copyK.
Qed.

Definition unglue_body : body R (unglue M C) :=
  Body cut_order_vertices cut_not_flat (volume_gt0 B) (material B).

(* T9: after any cut, of any complex, the displacements without force are one rigid   *)
(* motion for each component of the dual graph without the cut facets.  Corner (v, s) *)
(* carries the vertex copy M C (v, s), which lies where v lay.                        *)
Theorem T9_kernel_unglue u : (0 < n)%N ->
  (forall v, stiffness unglue_body u v = 0) <->
  (forall t, exists A b, A^T = - A /\
     forall s v, connect (dual M C) t s -> v \in M s ->
       u (copy M C (v, s)) = A *m position B v + b).
Proof.
move=> n_gt0; rewrite T9_kernel; split=> r t; have [A [b [skew rt]]] := r t; exists A, b.
  split=> // s v ts vs; rewrite rt; first by rewrite /= /cut_position copyK.
  by apply/pieceP; exists s; rewrite ?T9_pieces // mem_copy.
split=> // _ /pieceP[s + /imsetP[v vs ->]]; rewrite T9_pieces // => ts.
by rewrite /= /cut_position copyK; apply: rt.
Qed.

End AfterCut.
