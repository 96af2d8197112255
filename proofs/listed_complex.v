(******************************************************************************)
(* The complex that lists of natural numbers denote: cell t of `cs` has the   *)
(* vertices listed in its t-th row, cell and vertex numbers start from 0.     *)
(*                                                                            *)
(*         cell cs t == the t-th row                                          *)
(*      shared a b   == the vertices of a that are in b                       *)
(*      same_set a b == a and b list the same vertices                        *)
(*        wf n nv cs == each row lists n + 1 distinct vertices below nv, and  *)
(*                      no two rows list the same ones                        *)
(*       ecomplex ok == the complex, for ok : wf n nv cs                      *)
(*       ecut nv cut == the cut whose facets the rows of `cut` list           *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition cellsT := seq (seq nat).
Definition cell (cs : cellsT) t := nth [::] cs t.
Definition shared (a b : seq nat) := [seq v <- a | v \in b].
Definition same_set (a b : seq nat) := all (mem a) b && all (mem b) a.
Definition wf n nv (cs : cellsT) :=
  all (fun c => [&& size c == n.+1, uniq c & all (fun v => v < nv) c]) cs &&
  all (fun t => all (fun u => (t == u) || ~~ same_set (cell cs t) (cell cs u))
        (iota 0 (size cs))) (iota 0 (size cs)).

Section Link.
Variables (n nv : nat) (cs cut : cellsT).
Hypothesis ok : wf n nv cs.
Let nt := size cs.

Lemma cell_ok (t : 'I_nt) :
  [/\ size (cell cs t) = n.+1, uniq (cell cs t) & all (fun v => v < nv) (cell cs t)].
Proof. by case/andP: ok => /allP/(_ _ (mem_nth [::] (ltn_ord t)))/and3P[/eqP]. Qed.

Definition evert (t : 'I_nt) : {set 'I_nv} := [set v : 'I_nv | val v \in cell cs t].

Lemma card_seq (s : seq nat) : uniq s -> all (fun v => v < nv) s ->
  #|[set v : 'I_nv | val v \in s]| = size s.
Proof.
move=> us /allP bs; rewrite cardE -(size_map val); apply/perm_size/uniq_perm => //.
  by rewrite map_inj_uniq ?enum_uniq //; exact: val_inj.
move=> v; apply/mapP/idP => [[w]|vs]; first by rewrite mem_enum inE => ws ->.
by exists (Ordinal (bs _ vs)); rewrite // mem_enum inE.
Qed.

Lemma ecard t : #|evert t| = n.+1.
Proof. by have [<- u b] := cell_ok t; exact: card_seq. Qed.

Lemma evert_inj : injective evert.
Proof.
move=> t u /setP e; apply/val_inj/eqP/negPn/negP => tu.
case/andP: ok => _ /allP/(_ (val t)); rewrite mem_iota ltn_ord => /(_ isT).
move=> /allP/(_ (val u)); rewrite mem_iota ltn_ord (negPf tu) => /(_ isT) /=.
have [_ _ /allP bt] := cell_ok t; have [_ _ /allP bu] := cell_ok u.
case/negP; apply/andP; split; apply/allP => v vu /=.
  by have := e (Ordinal (bu _ vu)); rewrite !inE /= vu.
by have := e (Ordinal (bt _ vu)); rewrite !inE /= vu => <-.
Qed.

Definition ecomplex : complex n [finType of 'I_nv] [finType of 'I_nt] := Complex ecard evert_inj.
Definition ecut : {set {set 'I_nv}} :=
  [set f | has (fun g => f == [set v : 'I_nv | val v \in g])
             [seq g <- cut | all (fun v => v < nv) g]].

Lemma ecommon t u :
  common ecomplex t u = [set v : 'I_nv | val v \in shared (cell cs t) (cell cs u)].
Proof. by apply/setP=> v; rewrite !inE mem_filter andbC. Qed.

Lemma shared_ok (t u : 'I_nt) : uniq (shared (cell cs t) (cell cs u)) /\
  all (fun v => v < nv) (shared (cell cs t) (cell cs u)).
Proof.
have [_ ut /allP bt] := cell_ok t; split; first exact: filter_uniq.
by apply/allP=> v; rewrite mem_filter => /andP[_ /bt].
Qed.

End Link.
