(*********************************************************************************)
(* A cell without strain moves rigidly, and its neighbours with it. A complex    *)
(* lies in R^n by the positions X of its vertices; a displacement u moves vertex *)
(* v to X v + u v. As in the C++, a cell is an ordered tuple of its n + 1        *)
(* vertices; nondegenerateP, gradP and grad_uniq say that the order is free.     *)
(*          order t i == the i-th vertex of the cell t, i = 0 .. n               *)
(*    edges order f t == (f v_1 - f v_0 | .. | f v_n - f v_0): the paper's       *)
(*                       matrix X for the positions, U for a displacement        *)
(*    nondegenerate order X == every edge matrix is invertible: no cell is flat  *)
(*      rigid X A b S u == A is skew and u v = A X_v + b for every vertex v in   *)
(*                       S: an infinitesimal rotation A, a translation b         *)
(*   grad order X u t == the gradient of the displacement u on the cell t        *)
(* Theorems: T9_rigid_on_cell (zero strain on a cell is a rigid motion of it),   *)
(* T9_rigid_unique (one such motion for each cell), T9_facet_held (a cell that   *)
(* is at rest on a facet is at rest), T9_shared_facet (two cells that share a    *)
(* facet and move rigidly have the same motion).                                 *)
(* In C++: rigid_modes.hpp.                                                      *)
(*********************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex elasticity.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.Theory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Rigid.
Variables (R : realFieldType) (n : nat) (V T : finType) (M : complex n V T).
Variable order : T -> 'I_n.+1 -> V.
Hypothesis orderE : forall t, M t = [set order t i | i : 'I_n.+1].
Implicit Types (t s : T) (v w : V) (S : {set V}).

Definition edges m (f : V -> 'cV[R]_m) t : 'M[R]_(m, n) :=
  \matrix_(a, j) (f (order t (lift ord0 j)) - f (order t ord0)) a 0.

Lemma mem_order t i : order t i \in M t.
Proof. by rewrite orderE; apply/imsetP; exists i. Qed.

Lemma memP v t : reflect (exists i, v = order t i) (v \in M t).
Proof. by rewrite orderE; apply: (iffP imsetP) => [[i _ ->]|[i ->]]; exists i. Qed.

Lemma col_edges m (f : V -> 'cV[R]_m) t j :
  col j (edges f t) = f (order t (lift ord0 j)) - f (order t ord0).
Proof. by apply/matrixP => a k; rewrite !mxE !ord1. Qed.

Lemma col_mulmx m k p (B : 'M[R]_(m, k)) (C : 'M[R]_(k, p)) j : col j (B *m C) = B *m col j C.
Proof. by rewrite !colE mulmxA. Qed.

Variable X : V -> 'cV[R]_n.
Implicit Types (A E : 'M[R]_n) (b : 'cV[R]_n) (u : V -> 'cV[R]_n).

Definition nondegenerate := forall t, edges X t \in unitmx.
Definition rigid A b S u := A^T = - A /\ {in S, forall v, u v = A *m X v + b}.
Definition grad u t := gradient (edges X t) (edges u t).

(* A matrix takes the edge matrix of a cell to that of f if and only if it takes *)
(* the difference of any two vertices to the difference of their values.         *)
Lemma edgesP m (B : 'M[R]_(m, n)) (f : V -> 'cV[R]_m) t :
  B *m edges X t = edges f t <->
  {in M t &, forall v w, B *m (X v - X w) = f v - f w}.
Proof.
split=> [e|e]; last first.
  apply/matrixP => a j.
  have /matrixP/(_ a 0) := e _ _ (mem_order t (lift ord0 j)) (mem_order t ord0).
  by rewrite -!col_edges -col_mulmx !mxE.
have from0 i : B *m (X (order t i) - X (order t ord0)) = f (order t i) - f (order t ord0).
  case: (unliftP ord0 i) => [j|] ->; last by rewrite !subrr mulmx0.
  by rewrite -!col_edges -col_mulmx e.
move=> _ _ /memP[i ->] /memP[j ->].
rewrite -(subrKA (X (order t ord0))) mulmxDr -[X (order t ord0) - _]opprB mulmxN !from0.
by rewrite opprB subrKA.
Qed.

Lemma edges0 m t : edges (fun=> 0 : 'cV[R]_m) t = 0.
Proof. by apply/matrixP => a j; rewrite !mxE subrr. Qed.

(* The edge matrix of a cell is invertible if and only if no hyperplane contains *)
(* its vertices: a property of the set of vertices, whatever their order.        *)
Theorem nondegenerateP t :
  edges X t \in unitmx <->
  (forall h : 'rV[R]_n, {in M t &, forall v w, h *m (X v - X w) = 0} -> h = 0).
Proof.
split=> [unit h h0|flat].
  have e0 : h *m edges X t = 0.
    by rewrite -(edges0 1 t); apply/edgesP => v w vt wt; rewrite subrr h0.
  by rewrite -[h](mulmxK unit) e0 mul0mx.
rewrite -row_free_unit; apply: inj_row_free => h e; apply: flat => v w vt wt.
by move: e; rewrite -(edges0 1 t) => /edgesP->; rewrite ?subrr.
Qed.

Hypothesis solid : nondegenerate.

(* The edges of a cell that leave one of its vertices span the space. *)
Lemma spanning m (B : 'M[R]_(m, n)) t w :
  {in M t, forall v, B *m (X v - X w) = 0} -> B = 0.
Proof.
move=> B0; have e0 : B *m edges X t = 0.
  rewrite -(edges0 m t); apply/edgesP => v v' vt v't; rewrite subrr -(subrKA (X w)) mulmxDr.
  by rewrite -[X w - _]opprB mulmxN !B0 // subrr.
by rewrite -[B](mulmxK (solid t)) e0 mul0mx.
Qed.

(* The gradient takes the edges of the cell to their displacements ... *)
Lemma gradP u t : {in M t &, forall v w, grad u t *m (X v - X w) = u v - u w}.
Proof. by apply/edgesP; rewrite mulmxKV. Qed.

(* ... and is the only matrix that does. *)
Lemma grad_uniq u t E :
  {in M t &, forall v w, E *m (X v - X w) = u v - u w} -> grad u t = E.
Proof. by move/edgesP => e; rewrite /grad /gradient -e mulmxK. Qed.

(* T9: a displacement has no strain on a cell if and only if it is, on the vertices *)
(* of the cell, an infinitesimal rigid motion x |-> A x + b with A skew.            *)
Theorem T9_rigid_on_cell u t :
  strain (grad u t) = 0 <-> exists A b, rigid A b (M t) u.
Proof.
rewrite T9_strain_eq0; split=> [skew|[A [b [skew rig]]]]; last first.
  suff -> : grad u t = A by [].
  by apply: grad_uniq => v w vt wt; rewrite !rig // opprD addrACA subrr addr0 mulmxBr.
pose v0 := order t ord0; exists (grad u t), (u v0 - grad u t *m X v0).
split=> // v vt; by rewrite addrCA -mulmxBr gradP ?mem_order // addrC subrK.
Qed.

Lemma motions_differ A b A' b' x :
  A *m x + b = A' *m x + b' -> (A - A') *m x = b' - b :> 'cV[R]_n.
Proof. by move=> e; rewrite mulmxBl -[A *m x](addrK b) e addrAC [_ *m x + b']addrC addrK. Qed.

(* T9: the rigid motion of a cell is unique. *)
Theorem T9_rigid_unique t u A b A' b' :
  rigid A b (M t) u -> rigid A' b' (M t) u -> A = A' /\ b = b'.
Proof.
case=> _ r [_ r']; have e v : v \in M t -> (A - A') *m X v = b' - b.
  by move=> vt; apply: motions_differ; rewrite -r // r'.
have AA' : A = A'.
  apply/eqP; rewrite -subr_eq0; apply/eqP/(@spanning _ _ t (order t ord0)) => v vt.
  by rewrite mulmxBr !e ?mem_order // subrr.
split=> //; have := e _ (mem_order t ord0); rewrite AA' subrr mul0mx => /esym/eqP.
by rewrite subr_eq0 => /eqP.
Qed.

Lemma skew_mx1 (q : 'M[R]_1) : q = - q^T -> q = 0.
Proof.
move=> e; apply/matrixP => i j; rewrite !ord1 [RHS]mxE; apply/eqP.
have /eqP := congr1 (fun a : 'M[R]_1 => a 0 0) e.
by rewrite !mxE -addr_eq0 -mulr2n mulrn_eq0.
Qed.

(* T9: a skew motion x |-> A x + b that rests on a facet of a cell is at rest. Take a *)
(* vertex w of the facet as origin: for any two vertices a, c of the cell             *)
(* (a - w)^T A (c - w) = 0, as one of them is on the facet, or a = c is the opposite  *)
(* vertex and A is skew.                                                              *)
Theorem T9_facet_held t (f : {set V}) A b : (0 < n)%N -> #|f| = n -> f \subset M t ->
  A^T = - A -> {in f, forall v, A *m X v + b = 0} -> A = 0 /\ b = 0.
Proof.
move=> n_gt0 cf ft skew rest; have /card_gt0P[w wf] : (0 < #|f|)%N by rewrite cf.
have facet v : v \in f -> A *m (X v - X w) = 0.
  have e y : y \in f -> A *m X y = - b.
    by move=> /rest r0; apply/eqP; rewrite -addr_eq0 r0.
  by move=> vf; rewrite mulmxBr !e // subrr.
have form_skew x y : x^T *m A *m y = - (y^T *m A *m x)^T :> 'M_1.
  by rewrite !trmx_mul trmxK skew !mulNmx mulmxN opprK mulmxA.
have form0 v y : v \in M t -> y \in M t -> (X v - X w)^T *m A *m (X y - X w) = 0.
  move=> vt yt; have [yf|nyf] := boolP (y \in f); first by rewrite -mulmxA facet // mulmx0.
  have [vf|nvf] := boolP (v \in f).
    by rewrite form_skew -mulmxA facet // mulmx0 trmx0 oppr0.
  have -> : v = y.
    have /eqP/cards1P[z /setP ez] : #|M t :\: f| = 1%N.
      by rewrite cardsD (setIidPr ft) card_vertices cf subSnn.
    have [] := (ez v, ez y); rewrite !inE vt yt nvf nyf /=.
    by move=> /esym/eqP-> /esym/eqP->.
  exact/skew_mx1/form_skew.
have A0 : A = 0.
  have wt := subsetP ft _ wf.
  apply: (@spanning _ _ t w) => y yt; rewrite -[LHS]trmxK -[RHS]trmxK trmx0; congr _^T.
  apply: (@spanning _ _ t w) => v vt; rewrite -[LHS]trmxK trmx_mul trmxK mulmxA.
  by rewrite form0 // trmx0.
by split=> //; have := rest _ wf; rewrite A0 mul0mx add0r.
Qed.

(* T9: two cells with a common facet that move rigidly have one and the same motion. *)
Theorem T9_shared_facet t s u A b A' b' : adjacent M t s ->
  rigid A b (M t) u -> rigid A' b' (M s) u -> A = A' /\ b = b'.
Proof.
move=> ts [skew r] [skew' r'].
have [n0|n_gt0] := posnP n.
  split; first by rewrite [A]mx_dim0 // [A']mx_dim0.
  by apply/matrixP => i; have := ltn_ord i; rewrite {2}n0.
have both v : v \in common M t s -> v \in M t /\ v \in M s by rewrite inE => /andP[].
have [||||AA' bb'] := @T9_facet_held t (common M t s) (A - A') (b - b') n_gt0.
- exact/eqP.
- exact: subsetIl.
- by rewrite linearB /= skew skew' opprB opprK addrC.
- move=> v /both[vt vs]; rewrite (_ : _ *m _ = b' - b) ?addrA ?subrK ?subrr //.
  by apply: motions_differ; rewrite -r // r'.
by split; apply/eqP; rewrite -subr_eq0; apply/eqP.
Qed.

End Rigid.
