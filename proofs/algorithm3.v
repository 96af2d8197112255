(* algorithm3.v : the node-by-node LOOP of Algorithm 3, components recomputed on the *)
(* partially modified mesh, equals the simultaneous unglue, in every order.    *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Alg3.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).

(* (v, None) : original node, (v, Some t) : the copy N_c named after a cell t  *)
Definition node := prod_finType V (option_finType T).
Record labelling := Lab { lab :> V * T -> node; labK : forall x, (lab x).1 = x.1 }.
Definition complex_of (l : labelling) : complex n node T := relabel M (labK l).

Definition compname (l : labelling) x : T :=
  (root (glue (complex_of l) (lifted fst C)) (up l x)).2.
Definition step_fun (l : labelling) (N : V) x : node :=
  if x.1 == N then (N, Some (compname l x)) else l x.
Lemma step_funK l N x : (step_fun l N x).1 = x.1.
Proof. by rewrite /step_fun; case: eqP => [->|_]; rewrite ?labK. Qed.
Definition step l N : labelling := Lab (step_funK l N).

Lemma lab0K (x : V * T) : ((x.1, None) : node).1 = x.1. Proof. by []. Qed.
Definition alg3 (ns : seq V) : labelling := foldl step (Lab lab0K) ns.

Lemma compnameP (l : labelling) x y : respects M l C -> x.1 = y.1 ->
  (compname l x == compname l y) = connect (glue M C) x y.
Proof.
move=> r xy; apply/eqP/idP => [|c]; last first.
  rewrite /compname; congr (_.2); apply/eqP.
  by rewrite (root_connect (glue_csym _ _)) connect_relabel.
have H z : connect (glue M C) z (z.1, compname l z).
  have c := connect_root (glue (complex_of l) (lifted fst C)) (up l z).
  have := connect_fst c => /= e.
  have -> : (z.1, compname l z) = down fst (root (glue (complex_of l) (lifted fst C)) (up l z)).
    by rewrite /down -e labK.
  rewrite -{1}[z](upK (labK l)); apply: connect_homo c => a b g.
  exact/connect1/(glue_down g).
move=> e; apply: connect_trans (H x) _.
by rewrite (glue_csym M C) e xy; exact: H.
Qed.

Definition inv (l : labelling) (S : pred V) := forall x y, x.1 = y.1 ->
  corner M x -> corner M y ->
  (l x == l y) = (x.1 \notin S) || connect (glue M C) x y.

Lemma inv_respects l S : inv l S -> respects M l C.
Proof.
move=> i x y g; have c := connect1 g; have xy := connect_fst c.
have cx : corner M x by case/and4P: g => _ + _ _; rewrite inE => /andP[].
by apply/eqP; rewrite (i _ _ xy cx (connect_corner c cx)) c orbT.
Qed.

Lemma inv_step l S N : inv l S -> inv (step l N) [pred v | (v == N) || S v].
Proof.
move=> i x y xy cx cy; rewrite [_ x]/(step_fun l N x) [_ y]/(step_fun l N y).
rewrite /step_fun -xy !inE negb_or; have [xN|xN] /= := eqVneq x.1 N; last exact: i.
by rewrite -(compnameP (inv_respects i) xy) xpair_eqE eqxx.
Qed.

Lemma inv_alg3 ns : exists S, inv (alg3 ns) S /\ S =i ns.
Proof.
rewrite /alg3; suff H l S : inv l S -> exists S', inv (foldl step l ns) S' /\
    S' =i [pred v | (v \in S) || (v \in ns)].
  have [|S' [i e]] := H (Lab lab0K) pred0; first by move=> x y xy _ _; rewrite /= xy eqxx.
  by exists S'; split=> // v; rewrite e.
elim: ns l S => [|N ns IHs] l S i /=.
  by exists S; split=> // v; rewrite !inE orbF.
have [S' [i' e]] := IHs _ _ (@inv_step l S N i).
exists S'; split=> // v; rewrite e !inE.
by rewrite unfold_in /= orbCA orbA.
Qed.

Theorem alg3_correct (t0 : T) (ns : seq V) :
  (forall v t u, v \in M t -> v \in M u -> v \notin ns ->
     connect (glue M C) (v, t) (v, u)) ->
  isomorphic (complex_of (alg3 ns)) (unglue M C).
Proof.
move=> cov; have [S [i e]] := inv_alg3 ns.
apply: (relabel_iso _ _ t0) => x y cx cy.
have [xy|xy] := eqVneq x.1 y.1; last first.
  rewrite copy_eq; transitivity false; last first.
    by apply/esym/negP => /connect_fst/eqP; rewrite (negPf xy).
  by apply/negP => /eqP/(congr1 fst); rewrite !labK => /eqP; rewrite (negPf xy).
rewrite i // copy_eq e; case: (boolP (x.1 \in ns)) => //= nx.
case: x y xy nx cx cy => v t [w u] /= <- nv vt wu; apply/esym; exact: cov.
Qed.

(* every order, with repetitions                                              *)
Corollary T11_all (t0 : T) (ns : seq V) : {subset used M <= ns} ->
  isomorphic (complex_of (alg3 ns)) (unglue M C).
Proof.
move=> sub; apply: alg3_correct => // v t u vt _.
by rewrite sub //; apply/usedP; exists t.
Qed.

(* in a cut-regular mesh only the nodes of the cut surface need processing     *)
Corollary T11_local (t0 : T) (ns : seq V) : cut_regular M ->
  (forall f v, f \in C -> v \in f -> v \in ns) ->
  isomorphic (complex_of (alg3 ns)) (unglue M C).
Proof.
move=> r sub; apply: alg3_correct => // v t u vt vu nv.
rewrite connect_local; first exact: r.
by move=> f fC; apply: contra nv; exact: sub.
Qed.
End Alg3.
