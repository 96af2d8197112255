(* chain.v : T10 oriented, boundary of boundary is zero.  Chains are tested     *)
(* against an arbitrary cochain phi, so no free module is needed.              *)
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
(* <phi, boundary of the ordered simplex s with m vertices>                    *)
Definition bdry m phi s : R := \sum_(i < m) (-1) ^+ i * phi (del i s).

Lemma del_del a b s : (a <= b)%N -> del a (del b.+1 s) = del b (del a s).
Proof.
elim: s a b => [|x s IH] [|a] [|b] //= ab; rewrite /del /= ?drop0 //.
by congr (_ :: _); exact: IH.
Qed.

Theorem bdry_bdry m phi s : bdry m.+2 (bdry m.+1 phi) s = 0.
Proof.
pose G (i j : nat) := (-1) ^+ i * ((-1) ^+ j * phi (del j (del i s))).
transitivity (\sum_(i < m.+2) (\sum_(j < m.+1 | (j < i)%N) G i j
                             + \sum_(j < m.+1 | (i <= j)%N) G i j)).
  apply: eq_bigr => i _; rewrite /bdry mulr_sumr (bigID (fun j : 'I_m.+1 => (j < i)%N)) /=.
  by congr (_ + _); apply: eq_bigl => j; rewrite -leqNgt.
rewrite big_split /= (exchange_big_dep xpredT) //= [X in _ + X]big_ord_recr /=.
rewrite [X in _ + (_ + X)]big_pred0 ?addr0; last first.
  by move=> j; rewrite leqNgt ltn_ord.
rewrite -big_split big1 // => a _ /=.
rewrite big_mkcond big_ord_recl /= add0r -big_mkcond /=.
have -> : \sum_(j < m.+1 | (a <= j)%N) G a j = \sum_(j < m.+1 | (a < bump 0 j)%N) G a j.
  by apply: eq_bigl.
rewrite -big_split big1 // => b ab /=.
rewrite /G /bump /= add1n del_del; last by move: ab; rewrite /bump /= add1n ltnS.
rewrite exprS mulN1r mulNr !mulrA -!exprD addnC; apply/eqP.
by rewrite addrC subr_eq0.
Qed.
End Chain.
