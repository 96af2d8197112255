(******************************************************************************)
(* How many Dirichlet conditions are enough (T9). Section 2 of the paper says *)
(* that K with the boundary conditions put in is strictly positive definite.  *)
(* T9_supported (elastic_kernel.v) is the exact condition; here are two cases *)
(* that a user meets.                                                         *)
(*     definite B D == K is positive definite on the displacements that are   *)
(*                     zero in the coordinates D: the work of every such      *)
(*                     displacement that moves some vertex is positive        *)
(* Theorems: T9_facet_supports (it is enough to hold one facet of each piece) *)
(* and T9_axis_free (it is not enough to hold vertices on one axis, that is,  *)
(* where two independent linear forms are constant: one vertex in the plane,  *)
(* collinear vertices in space), T9_vertex_free (one vertex is not enough).   *)
(* In C++: unsupported_pieces.                                                *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue elasticity rigid_motion elastic_kernel.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Supports.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T) (B : body R M).
Implicit Types (t s : T) (v w : V) (D : {set V * 'I_n}) (h : 'rV[R]_n) (p : 'cV[R]_n).

Let X := position B.

Definition definite D := forall u : V -> 'cV[R]_n,
  held D u -> (exists2 v, v \in used M & u v != 0) -> 0 < work B u u.

(* T9: holding all vertices of one facet in each piece makes K positive definite. *)
Theorem T9_facet_supports D : cut_regular M -> (0 < n)%N ->
  (forall t, exists s (f : {set V}), [/\ connect (adjacent M) t s, f \subset M s, #|f| = n &
     forall v i, v \in f -> (v, i) \in D]) -> definite D.
Proof.
move=> reg n_gt0 enough; apply/T9_supported => // t A b skew hold.
have [s [f [ts fs cf fD]]] := enough t.
apply: (T9_facet_held (order_vertices B) (not_flat B) n_gt0 cf fs skew) => v vf.
apply/matrixP => i k; rewrite ord1 [RHS]mxE; apply: hold; last exact: fD.
by apply/pieceP; exists s => //; apply: (subsetP fs).
Qed.

(* Two independent forms span a rotation. *)
Lemma rotation_neq0 h1 h2 : h1 != 0 -> (forall c, h2 != c *: h1) ->
  h1^T *m h2 - h2^T *m h1 != 0.
Proof.
move=> nz1 indep; apply/eqP => /matrixP e.
have [i nzi] : exists i, h1 0 i != 0.
  apply/existsP; apply: contraR nz1; rewrite negb_exists => /forallP z.
  by apply/eqP/matrixP => a i; rewrite ord1 mxE; apply/eqP; rewrite -[_ == _]negbK.
have /eqP[] := indep (h2 0 i / h1 0 i); apply/matrixP => a j; rewrite ord1 mxE.
have := e i j; rewrite !mxE !big_ord1 !mxE => /eqP; rewrite subr_eq0 => /eqP ij.
by apply: (mulfI nzi); rewrite ij mulrA mulrCA divff // mulr1.
Qed.

(* T9: if the held vertices of a piece lie on one axis, the piece turns about it. *)
Theorem T9_axis_free D t p h1 h2 : cut_regular M -> h1 != 0 -> (forall c, h2 != c *: h1) ->
  (forall v i, v \in piece M t -> (v, i) \in D ->
     h1 *m (X v - p) = 0 /\ h2 *m (X v - p) = 0) ->
  ~ definite D.
Proof.
move=> reg nz1 indep axis /T9_supported-/(_ reg) firm.
pose A := h1^T *m h2 - h2^T *m h1.
have skew : A^T = - A by rewrite linearB /= !trmx_mul !trmxK opprB.
have [|A0 _] := firm t A (- (A *m p)) skew; last first.
  by have := rotation_neq0 nz1 indep; rewrite -/A A0 eqxx.
move=> v vt i vi; have [e1 e2] := axis v i vt vi.
by rewrite -mulmxBr mulmxBl -!mulmxA e1 e2 !mulmx0 subr0 mxE.
Qed.

(* T9: in two or more dimensions, a piece that is held in at most one vertex turns. *)
Theorem T9_vertex_free D t w : cut_regular M -> (1 < n)%N ->
  (forall v i, v \in piece M t -> (v, i) \in D -> v = w) -> ~ definite D.
Proof.
move=> reg n_gt1 one; pose i := Ordinal (ltnW n_gt1); pose j := Ordinal n_gt1.
apply: (@T9_axis_free D t (X w) (delta_mx 0 i) (delta_mx 0 j)) => // [|c|v k vt vk].
- by apply/eqP => /matrixP/(_ 0 i); rewrite !mxE !eqxx => /eqP; rewrite oner_eq0.
- by apply/eqP => /matrixP/(_ 0 j); rewrite !mxE !eqxx mulr0 => /eqP; rewrite oner_eq0.
by rewrite (one v k) // subrr !mulmx0.
Qed.

End Supports.
