(******************************************************************************)
(* Theorem C needs its hypothesis: an even number of cut facets at every      *)
(* ridge of a vertex does not make them open.  Span the torus with seven      *)
(* vertices 0..6, every two of them joined, by two apexes 7 and 8: a closed   *)
(* complex of 28 tetrahedra in which the link of an apex is a torus.  Cut the *)
(* three facets that join apex 7 to the closed walk 0 1 2, which goes around  *)
(* the torus and does not bound on it: each ridge at 7 is in none or in two   *)
(* of them, and nothing opens.                                                *)
(*       torus, suspension == the triangles and the tetrahedra                *)
(*                 collar == the three facets                                 *)
(*           eset nv g == the vertices listed in g, as a set                  *)
(* Main theorem: theoremC_counterexample                                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary listed_complex regular_exec.
From Cleave Require Import parity dual_edge star_opening.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* What a computation must check of lists of numbers.                         *)
Section Decide.
Variables (n nv : nat) (cs cut : cellsT) (ok : wf n nv cs).
Local Notation M := (ecomplex ok).
Implicit Types (g : seq nat) (f : {set 'I_nv}).

Definition eset g : {set 'I_nv} := [set v : 'I_nv | val v \in g].

Definition facet_of_cells g :=
  [&& size g == n, uniq g, all (fun v => v < nv) g & has (fun c => all (mem c) g) cs].

(* No facet is in three cells.                                                *)
Definition at_most_two := all (fun c => all (fun v =>
  count (fun d => all (mem d) (filter (predC1 v) c)) cs <= 2) c) cs.

Lemma at_most_twoP : at_most_two -> pseudo_manifold M.
Proof.
move=> /allP two f cf; have [->|[t]] := set_0Vmem (cofaces M f); first by rewrite cards0.
rewrite inE => ft; have [v vt fE] := facetP ft cf; move: vt; rewrite inE => vt.
have /allP/(_ _ vt) := two _ (mem_nth [::] (ltn_ord t)); apply: leq_trans.
rewrite -sum1_count (big_nth [::]) big_mkord sum1dep_card; apply/subset_leq_card/subsetP => u.
rewrite !inE fE => /subsetP fu; apply/allP => w; rewrite mem_filter => /andP[/= wv wt].
have [_ _ /allP/(_ w wt) w_nv] := cell_ok ok t.
by have := fu (Ordinal w_nv); rewrite !inE -val_eqE /= wv wt => /(_ isT).
Qed.

Lemma facet_of_cellsP g : facet_of_cells g -> eset g \in facets M.
Proof.
case/and4P=> [/eqP sg ug bg /(hasP)[c /(nthP [::])[t t_cs <-] /allP gt]].
rewrite inE /eset card_seq // sg eqxx; apply/card_gt0P; exists (Ordinal t_cs).
by rewrite inE; apply/subsetP => v; rewrite !inE => /gt.
Qed.

Lemma in_ecut f : all facet_of_cells cut -> (f \in ecut nv cut) = (f \in [seq eset g | g <- cut]).
Proof.
move=> /allP fc; rewrite inE; apply/hasP/mapP => [[g]|[g gc ->]].
  by rewrite mem_filter => /andP[_ gc] /eqP->; exists g.
by exists g; rewrite ?mem_filter ?gc //; case/and4P: (fc g gc) => _ _ ->.
Qed.

(* The degree of a ridge that contains v, in dimension 3.                     *)
Lemma degree_ecut (v w : 'I_nv) : all facet_of_cells cut -> uniq [seq eset g | g <- cut] ->
  degree M (ecut nv cut) [set v; w] = count (fun g => (val v \in g) && (val w \in g)) cut.
Proof.
move=> fc us; rewrite /degree.
have -> : #|[set f in ecut nv cut :&: facets M | [set v; w] \subset f]| =
          count (fun f : {set 'I_nv} => [set v; w] \subset f) [seq eset g | g <- cut].
  rewrite -size_filter -(card_uniqP (filter_uniq _ us)); apply: eq_card => f.
  rewrite mem_filter inE andbC; congr (_ && _); rewrite in_setI in_ecut //.
  by apply: andb_idr => /mapP[g gc ->]; rewrite facet_of_cellsP ?(allP fc).
rewrite count_map; apply: eq_count => g /=.
by rewrite subUset !sub1set !inE.
Qed.
End Decide.

Definition torus : cellsT :=
  [seq [:: i; (i + 1) %% 7; (i + 3) %% 7] | i <- iota 0 7] ++
  [seq [:: i; (i + 2) %% 7; (i + 3) %% 7] | i <- iota 0 7].
Definition suspension : cellsT :=
  [seq rcons t 7 | t <- torus] ++ [seq rcons t 8 | t <- torus].
Definition collar : cellsT := [:: [:: 0; 1; 7]; [:: 1; 2; 7]; [:: 0; 2; 7]].

Lemma suspension_ok : wf 3 9 suspension. Proof. by vm_compute. Qed.
Local Notation M := (ecomplex suspension_ok).
Local Notation C := (ecut 9 collar).
Local Notation apex := (inord 7 : 'I_9).

Lemma suspension_pseudo_manifold : pseudo_manifold M.
Proof. by apply: at_most_twoP; vm_compute. Qed.

Lemma collar_facets : all (facet_of_cells 3 9 suspension) collar.
Proof. by vm_compute. Qed.

Lemma collar_uniq : uniq [seq eset 9 g | g <- collar].
Proof.
have ne a b k : k < 9 -> k \in a -> k \notin b -> eset 9 a != eset 9 b.
  move=> k9 ka kb; apply/eqP => /setP/(_ (inord k)).
  by rewrite !inE /= inordK // ka (negPf kb).
rewrite /= !inE negb_or !andbT; apply/andP; split.
  by rewrite (ne _ _ 0) // (ne _ _ 1).
exact: (ne _ _ 1).
Qed.

(* The three facets are interior.                                             *)
Lemma collar_interior f : f \in C -> exists t u, adjacent M t u /\ common M t u = f.
Proof.
have shares a b (a_lt : a < size suspension) (b_lt : b < size suspension) g :
    same_set (shared (cell suspension a) (cell suspension b)) g ->
    size (shared (cell suspension a) (cell suspension b)) = 3 ->
    exists t u, adjacent M t u /\ common M t u = eset 9 g.
  move=> /andP[/allP sg /allP gs] s3; exists (Ordinal a_lt), (Ordinal b_lt).
  have [us bs] := shared_ok suspension_ok (Ordinal a_lt) (Ordinal b_lt).
  rewrite /adjacent ecommon card_seq // s3; split=> //.
  by apply/setP => v; rewrite !inE; apply/idP/idP => [/gs|/sg].
rewrite (in_ecut _ collar_facets) /= !inE => /or3P[] /eqP->.
- exact: (shares 0 12).
- exact: (shares 1 13).
- exact: (shares 6 7).
Qed.

Lemma collar_regular : regular M C. Proof. by apply: regular_by; vm_compute. Qed.

(* Theorem C, why even is not enough: the facets of C are interior, every     *)
(* ridge at the apex is in an even number of them, and every two cells that   *)
(* shared a facet share it after the cut.                                     *)
Theorem theoremC_counterexample :
  [/\ #|C| = 3, forall f, f \in C -> exists t u, adjacent M t u /\ common M t u = f,
      forall r : {set 'I_9}, #|r|.+1 = 3 -> apex \in r -> ~~ odd (degree M C r) &
      forall t u, adjacent M t u -> adjacent (unglue M C) t u].
Proof.
split=> [|||t u tu]; last first.
- rewrite T3_adjacent tu; apply/forall_inP => v; rewrite inE => /andP[vt vu].
  exact: collar_regular.
- move=> r [r2] ar; have [w /andP[wa wr]] : exists w, (w != apex) && (w \in r).
    have /card_gt0P[w] : 0 < #|r :\ apex| by have := cardsD1 apex r; rewrite r2 ar => -[<-].
    by rewrite !inE; exists w.
  have -> : r = [set apex; w].
    apply/esym/eqP; rewrite eqEcard r2 cards2 eq_sym wa andbT.
    by apply/subsetP => v; rewrite !inE => /orP[]/eqP->.
  rewrite (degree_ecut _ _ _ collar_facets collar_uniq) /= inordK //.
  have: val w != 7 by move: wa; rewrite -val_eqE /= inordK.
  by case: w {wr wa} => [] [|[|[|[|[|[|[|[|[|k]]]]]]]]].
- exact: collar_interior.
rewrite (eq_card (fun f => in_ecut f collar_facets)) (card_uniqP collar_uniq) size_map //.
Qed.

(* Theorem C: so the star of the apex is not simply connected, and that       *)
(* hypothesis of theoremC_even cannot be left out.                            *)
Corollary torus_not_simply_connected : ~ simply_connected_star M apex.
Proof.
have [_ _ even shut] := theoremC_counterexample => sc.
have C_f : eset 9 [:: 0; 1; 7] \in C by rewrite (in_ecut _ collar_facets) mem_head.
have [t [u [tu fE]]] := collar_interior C_f.
have apex_f : apex \in common M t u by rewrite fE !inE /= inordK.
have := @theoremC_even _ _ _ M C suspension_pseudo_manifold apex t u sc.
rewrite /star_adjacent tu apex_f /marks fE C_f => opened.
have /(opens_facet apex_f)/negP[] : opens M C apex t u; last exact: shut.
by apply: opened => // r s cr ar _; apply: even.
Qed.
