(******************************************************************************)
(* The boundary of a boundary is zero. A chain is known by the values that    *)
(* all cochains take on it, so no free modules are needed: cochains are       *)
(* functions to a ring R, and bdry is what the boundary operator is to them.  *)
(*        del i s == the sequence s without its i-th element                  *)
(*   bdry m phi s == the cochain phi on the boundary of the ordered simplex s *)
(*                   with m vertices: the alternating sum of phi (del i s)    *)
(*      bdry_bdry == the boundary of a boundary is zero                       *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Chain.
Variables (A : Type) (R : ringType).
Implicit Types (s : seq A) (phi : seq A -> R).

Definition del i s := take i s ++ drop i.+1 s.

Definition bdry m phi s : R := \sum_(i < m) (-1) ^+ i * phi (del i s).

Lemma del_del a b s : (a <= b)%N -> del a (del b.+1 s) = del b (del a s).
Proof.
elim: s a b => [|x s IH] [|a] [|b] //= ab; rewrite /del /= ?drop0 //.
by congr (_ :: _); exact: IH.
Qed.

(* The terms cancel in pairs: leave out a and then b, or b.+1 and then a.     *)
Lemma bdry_bdry m phi s : bdry m.+2 (bdry m.+1 phi) s = 0.
Proof.
pose G (i j : nat) := (-1) ^+ i * ((-1) ^+ j * phi (del j (del i s))).
transitivity (\sum_(i < m.+2) (\sum_(j < m.+1 | (j < i)%N) G i j
                             + \sum_(j < m.+1 | (i <= j)%N) G i j)).
  apply: eq_bigr => i _; rewrite /bdry mulr_sumr (bigID (fun j : 'I_m.+1 => (j < i)%N)) /=.
  by congr (_ + _); apply: eq_bigl => j; rewrite -leqNgt.
rewrite big_split /= (exchange_big_dep xpredT) //= [X in _ + X]big_ord_recr /=.
rewrite [X in _ + (_ + X)]big_pred0 ?addr0; last by move=> j; rewrite leqNgt ltn_ord.
rewrite -big_split big1 // => a _ /=.
rewrite big_mkcond big_ord_recl /= add0r -big_mkcond /=.
have -> : \sum_(j < m.+1 | (a <= j)%N) G a j = \sum_(j < m.+1 | (a < bump 0 j)%N) G a j.
  by apply: eq_bigl.
rewrite -big_split big1 // => b; rewrite /G /bump /= add1n ltnS => ab.
by rewrite del_del // exprS mulN1r mulNr !mulrA -!exprD addnC addNr.
Qed.

End Chain.
