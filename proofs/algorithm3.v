(******************************************************************************)
(* Algorithm 3 as printed: a loop that treats one node after the other, and   *)
(* finds the components on the complex as the loop has left it so far (T11).  *)
(* Its state is a relabelling whose new vertices are                          *)
(*        (v, None) == the node v, not yet treated                            *)
(*      (v, Some t) == the copy N_c of v, where the cell t names c            *)
(*   labelling, complex_of M l == a state, and its complex                    *)
(*     component l x == a cell that names the component of the corner x in    *)
(*                      the state l; the facets of C are those whose parents  *)
(*                      are in C, as the paper's facet objects are            *)
(*         treat l N == the body of the loop, for the node N                  *)
(*   algorithm3 M C ns == the loop over the list ns of nodes                  *)
(*   T11_order == the order of the nodes and repetitions do not matter        *)
(*   T11_all   == over all nodes the loop is unglue M C                       *)
(*   T11_local == for a cut-regular complex so it is over the vertices of C;  *)
(*                in any other, unglue splits more vertices than those        *)
(*   T11_regularize == any complex: assemble_regularized, which is unglue     *)
(*                with the empty cut, followed by the loop over the vertices  *)
(*                of C                                                        *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Algorithm3.
Variables (n : nat) (V T : finType) (M : complex n V T) (C : {set {set V}}).
Implicit Types (N v : V) (x y : V * T) (ns : seq V).

Definition node := prod_finType V (option_finType T).

Record labelling := Labelling {
  label :> V * T -> node;
  labelK : forall x, parent (label x) = x.1
}.
Implicit Type l : labelling.

Definition complex_of l : complex n node T := relabel M (labelK l).

Definition component l x : T := (root (glue (complex_of l) (lifted parent C)) (up l x)).2.

Definition treated l N x : node := if x.1 == N then (N, Some (component l x)) else l x.

Lemma treatedK l N x : parent (treated l N x) = x.1.
Proof. by rewrite /treated; case: eqP => [->|_] //; apply: labelK. Qed.

Definition treat l N : labelling := Labelling (treatedK l N).

Definition untouched x : node := (x.1, None).
Lemma untouchedK x : parent (untouched x) = x.1. Proof. by []. Qed.

Definition algorithm3 ns : labelling := foldl treat (Labelling untouchedK) ns.

(* The loop finds the same components as if nothing had been treated before.  *)
Lemma componentP l x y : respects M l C -> x.1 = y.1 ->
  (component l x == component l y) = connect (glue M C) x y.
Proof.
move=> r xy; apply/eqP/idP => [e|c]; last first.
  rewrite /component; congr (_.2); apply/eqP.
  by rewrite (root_connect (glue_csym _ _)) connect_relabel.
have reach z : connect (glue M C) z (z.1, component l z).
  have c := connect_root (glue (complex_of l) (lifted parent C)) (up l z).
  set w := root _ _ in c; have -> : (z.1, component l z) = down parent w.
    by rewrite /down -(connect_fst c) /= labelK.
  rewrite -{1}[z](upK (labelK l)); apply: connect_homo c => a b g.
  exact/connect1/(glue_down g).
by apply: connect_trans (reach x) _; rewrite (glue_csym M C) e xy; exact: reach.
Qed.

(* The state when just the nodes of S have been treated.                      *)
Definition state_of l (S : pred V) := {in corner M &, forall x y,
  (l x == l y) = (x.1 == y.1) && ((x.1 \notin S) || connect (glue M C) x y)}.

Lemma state_respects l S : state_of l S -> respects M l C.
Proof.
move=> st x y g; have c := connect1 g; have xy := connect_fst c.
have cx : corner M x by case/and4P: g => _ + _ _; rewrite inE => /andP[].
by apply/eqP; rewrite (st _ _ cx (connect_corner c cx)) xy eqxx c orbT.
Qed.

Lemma state_treat l S N : state_of l S -> state_of (treat l N) [predU1 N & S].
Proof.
move=> st x y cx cy; have [xy|xy] := eqVneq x.1 y.1; last first.
  by apply: contraNF xy => /eqP/(congr1 parent); rewrite !labelK => ->.
rewrite [_ x]/(treated l N x) [_ y]/(treated l N y) /treated -xy !inE negb_or.
have [xN|_] /= := eqVneq x.1 N; last by rewrite st // xy eqxx.
by rewrite -(componentP (state_respects st) xy) xpair_eqE eqxx.
Qed.

Lemma state_algorithm3 ns : state_of (algorithm3 ns) (mem ns).
Proof.
have start : state_of (Labelling untouchedK) pred0.
  by move=> x y _ _; rewrite xpair_eqE eqxx andbT.
suff loop l S : state_of l S -> state_of (foldl treat l ns) [predU S & mem ns].
  by move=> x y cx cy; rewrite (loop _ _ start).
elim: ns l S => [|N ns IHns] l S st x y cx cy.
  by rewrite st // !inE orbF.
by rewrite (IHns _ _ (state_treat N st)) // !inE orbCA orbA.
Qed.

Variable t0 : T.

(* T11: the state depends on the set of nodes treated alone.                  *)
Theorem T11_order ns ns' : ns =i ns' ->
  isomorphic (complex_of (algorithm3 ns)) (complex_of (algorithm3 ns')).
Proof.
move=> e; apply: (relabel_iso _ _ t0) => x y cx cy.
by rewrite !state_algorithm3 // -![_ \in mem _]/(_ \in _) e.
Qed.

(* The loop is unglue if it leaves out no node that unglue splits.            *)
Lemma algorithm3_unglue ns : (forall v, v \notin ns -> regular_at M C v) ->
  isomorphic (complex_of (algorithm3 ns)) (unglue M C).
Proof.
move=> skip; apply: (relabel_iso _ _ t0) => x y cx cy.
rewrite state_algorithm3 // copy_eq; have [xy|xy] := eqVneq x.1 y.1; last first.
  by apply/esym/negP => /connect_fst/eqP; rewrite (negPf xy).
have [//|/skip r /=] := boolP (x.1 \in ns).
by case: x y xy cx cy r => v t [w u] /= <- vt wu r; rewrite r.
Qed.

(* T11: over all nodes, in any order and with repetitions, it is unglue.      *)
Theorem T11_all ns : {subset used M <= ns} ->
  isomorphic (complex_of (algorithm3 ns)) (unglue M C).
Proof.
move=> sub; apply: algorithm3_unglue => v v_ns t u vt.
by rewrite sub ?(mem_used vt) in v_ns.
Qed.

(* T11: in a cut-regular complex the vertices of the cut suffice.             *)
Theorem T11_local ns : cut_regular M -> {subset used M :&: cover C <= ns} ->
  isomorphic (complex_of (algorithm3 ns)) (unglue M C).
Proof.
move=> r sub; apply: algorithm3_unglue => v v_ns t u vt vu.
rewrite connect_local; first exact: r.
move=> f fC; apply: contra v_ns => vf; apply: sub; rewrite inE (mem_used vt).
by apply/bigcupP; exists f.
Qed.

End Algorithm3.

(* T11: Algorithm 3 over all nodes of any complex is its regularisation,
   followed by the loop over the vertices of the cut.                         *)
Theorem T11_regularize n (V T : finType) (M : complex n V T) (C : {set {set V}}) (t0 : T)
    (ns : seq (prod_finType V T)) (R := unglue M set0) :
    {subset [set w in used R | parent w \in cover C] <= ns} ->
  isomorphic (complex_of R (algorithm3 R (lifted parent C) ns)) (unglue M C).
Proof.
move=> sub; apply: isomorphic_trans (T8_staged M t0 (sub0set C)).
apply: T11_local => //; first exact: T4_cut_regular.
move=> w; rewrite inE => /andP[wR /bigcupP[f]]; rewrite in_lifted => fC wf.
apply: sub; rewrite inE wR; apply/bigcupP; exists (parent @: f) => //.
exact: imset_f.
Qed.
