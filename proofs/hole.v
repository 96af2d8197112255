(******************************************************************************)
(* Theorem B needs its hypothesis for a whole body: that the rim of the sweep *)
(* is outside does not do.  A ring of sixteen triangles, 0..7 the vertices on *)
(* its outside and 8..15 those at its hole; a blade from the hole to the      *)
(* outside passes one edge inside, {0, 8}, and selects it.  The edge opens,   *)
(* the ring stays in one piece, and the edge is not all edges between two     *)
(* sets of triangles.  All vertices are on the boundary, so there is no ridge *)
(* inside at which anything could be odd.                                     *)
(*            annulus == the triangles; each shares an edge with the next     *)
(*               gate == the edge                                             *)
(* Main theorem: theoremB_counterexample                                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary pieces listed_complex regular_exec parity.
From Cleave Require Import dual_edge star_opening simply_connected torus.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Decide.
Variables (n nv : nat) (cs cut : cellsT) (ok : wf n nv cs).
Local Notation M := (ecomplex ok).

Lemma eset_eqE a b : all (fun v => v < nv) a -> all (fun v => v < nv) b ->
  (eset nv a == eset nv b) = same_set a b.
Proof.
move=> /allP a_nv /allP b_nv; apply/eqP/andP => [/setP e|[/allP ba /allP ab]].
  split; apply/allP => v vg /=.
    by have := e (Ordinal (b_nv v vg)); rewrite !inE /= vg.
  by have := e (Ordinal (a_nv v vg)); rewrite !inE /= vg => <-.
by apply/setP => v; rewrite !inE; apply/idP/idP => [/ab|/ba].
Qed.

Lemma cofaces_count g : all (fun v => v < nv) g ->
  #|cofaces M (eset nv g)| = count (fun c => all (mem c) g) cs.
Proof.
move=> /allP g_nv; rewrite -sum1_count (big_nth [::]) big_mkord sum1dep_card; apply: eq_card => t.
rewrite !inE; apply/subsetP/allP => [gt v vg|gt v].
  by have := gt (Ordinal (g_nv v vg)); rewrite !inE; apply.
by rewrite !inE => /gt.
Qed.

(* Two cells that share a facet, which is not cut.                            *)
Definition uncut_step a b := let g := shared (cell cs a) (cell cs b) in
  (size g == n) && all (fun f => ~~ same_set g f) cut.

Lemma uncut_stepP (t u : 'I_(size cs)) : uncut_step t u -> dual M (ecut nv cut) t u.
Proof.
have [us bs] := shared_ok ok t u; case/andP=> /eqP sg /allP out.
rewrite /dual /adjacent ecommon card_seq // sg eqxx inE; apply/hasPn => f.
by rewrite mem_filter => /andP[f_nv fc]; rewrite -/(eset nv _) eset_eqE ?out.
Qed.
End Decide.

(* A loop around a ridge passes no facet of the boundary.                     *)
Lemma dual_loop_inside n (V T : finType) (M : complex n V T) (r f : {set V}) s :
  pseudo_manifold M -> #|r|.+1 = n -> dual_loop M r s -> r \subset f -> #|f| = n -> #|cofaces M f| != 1.
Proof.
move=> pm cr [loop sE] rf cf; apply/negP => /cards1P[t /setP tE].
have ft : f \subset M t by have := tE t; rewrite !inE eqxx.
have ts : t \in s by rewrite sE (subset_trans rf).
have /imsetP[u us fE] := in_facets_along pm cr loop ts cf rf ft.
have /andP[/adjacent_neq/eqP[]] := next_around loop us.
have := tE u; have := tE (next s u); rewrite !inE fE subsetIl subsetIr.
by move=> /esym/eqP-> /esym/eqP->.
Qed.

Definition annulus : cellsT := flatten
  [seq let j := (i + 1) %% 8 in [:: [:: i; 8 + i; j]; [:: 8 + i; j; 8 + j]] | i <- iota 0 8].
Definition gate : cellsT := [:: [:: 0; 8]].

Lemma annulus_ok : wf 2 16 annulus. Proof. by vm_compute. Qed.
Local Notation M := (ecomplex annulus_ok).
Local Notation C := (ecut 16 gate).

Lemma annulus_pseudo_manifold : pseudo_manifold M.
Proof. by apply: at_most_twoP; vm_compute. Qed.

Lemma gate_facets : all (facet_of_cells 2 16 annulus) gate. Proof. by vm_compute. Qed.

Lemma gateE f : (f \in C) = (f == eset 16 [:: 0; 8]).
Proof. by rewrite (in_ecut _ gate_facets) inE. Qed.

(* The edge is between the first triangle and the last.                       *)
Lemma gate_sides : exists t u : 'I_(size annulus), adjacent M t u /\ common M t u \in C.
Proof.
have [t0 u0] : 0 < size annulus /\ 15 < size annulus by vm_compute.
exists (Ordinal t0), (Ordinal u0); have e : common M (Ordinal t0) (Ordinal u0) = eset 16 [:: 0; 8].
  by rewrite ecommon; apply/setP => v; rewrite !inE.
by rewrite /adjacent gateE e eqxx card_seq.
Qed.

(* At vertex 0 it parts the first triangle from the others.                   *)
Lemma gate_two_sided : two_sided M C (inord 0) (fun t => val t == 0).
Proof.
move=> t u /andP[]; have [us bs] := shared_ok annulus_ok t u.
rewrite /marks gateE /adjacent ecommon card_seq // -/(eset 16 _) eset_eqE // => s2.
rewrite inE -[val _]/(nat_of_ord _) inordK // => v0.
have: all (fun a => all (fun b => let g := shared (cell annulus a) (cell annulus b) in
    (size g == 2) && (0 \in g) ==> (same_set g [:: 0; 8] == ((a == 0) != (b == 0))))
  (iota 0 16)) (iota 0 16) by vm_compute.
have bound (a : 'I_(size annulus)) : val a \in iota 0 16 by rewrite mem_iota; case: a.
by move/allP/(_ _ (bound t))/allP/(_ _ (bound u)); rewrite /= s2 v0 => /eqP.
Qed.

(* Every vertex is in an edge of the boundary.                                *)
Lemma annulus_no_loop (r : {set 'I_16}) s : #|r|.+1 = 2 -> ~ dual_loop M r s.
Proof.
case=> /eqP/cards1P[v ->] loop.
have: all (fun v => has (fun w => count (fun c => all (mem c) [:: v; w]) annulus == 1)
                      (filter (predC1 v) (iota 0 16))) (iota 0 16) by vm_compute.
move/allP/(_ (val v)); rewrite mem_iota ltn_ord => /(_ isT)/hasP[w].
rewrite mem_filter mem_iota => /andP[/= wv w16] one.
have bound : all (fun v => v < 16) [:: val v; w] by rewrite /= ltn_ord w16.
have cf : #|eset 16 [:: val v; w]| = 2 by rewrite card_seq //= inE eq_sym wv.
have vf : [set v] \subset eset 16 [:: val v; w] by rewrite sub1set !inE eqxx.
have := dual_loop_inside annulus_pseudo_manifold _ loop vf cf.
by rewrite cofaces_count // one cards1 => /(_ erefl).
Qed.

Lemma annulus_connected t u : connect (dual M C) t u.
Proof.
have sym : connect_sym (dual M C).
  by apply: sym_connect_sym => a b; rewrite /dual adjacentC commonC.
have t0 : 0 < size annulus by vm_compute.
have from_first k (k_lt : k < size annulus) : connect (dual M C) (Ordinal t0) (Ordinal k_lt).
  elim: k k_lt => [|k IHk] k_lt.
    by rewrite (_ : Ordinal t0 = Ordinal k_lt) //; apply: val_inj.
  apply: connect_trans (IHk (ltnW k_lt)) (connect1 _); apply: uncut_stepP.
  have: all (fun k => uncut_step 2 annulus gate k k.+1) (iota 0 15) by vm_compute.
  by move/allP; apply; rewrite mem_iota; move: k_lt; rewrite (_ : size annulus = 16).
by case: t u => [t t_lt] [u u_lt]; rewrite (connect_trans _ (from_first u u_lt)) // sym.
Qed.

(* Theorem B, why a body with a hole needs more: one edge inside is cut, it   *)
(* opens, no ridge is inside, all triangles are still connected, and the cut  *)
(* is not all facets between two sets of cells.                               *)
Theorem theoremB_counterexample :
  [/\ exists t u, [/\ adjacent M t u, common M t u \in C & ~~ adjacent (unglue M C) t u],
      forall (r : {set 'I_16}) s, #|r|.+1 = 2 -> ~ dual_loop M r s,
      forall t u, connect (adjacent (unglue M C)) t u &
      ~ exists lab, coboundary M C lab].
Proof.
have one_piece t u : connect (adjacent (unglue M C)) t u.
  by rewrite T9_pieces // annulus_connected.
have [a [b [ab C_ab]]] := gate_sides; split=> //; last first.
- move=> [lab labC]; have := labC a b ab; rewrite C_ab => /esym/negP[]; apply/eqP.
  exact: theoremB_separates labC (one_piece a b).
- exact: annulus_no_loop.
exists a, b; split=> //; apply: (theoremC_boundary gate_two_sided) => //; rewrite /star_adjacent ab.
by move: C_ab; rewrite gateE => /eqP->; rewrite inE -[val _]/(nat_of_ord _) inordK.
Qed.

(* Theorem B: so the ring is not simply connected, and that hypothesis of     *)
(* theoremB_even_simply_connected cannot be left out.                         *)
Corollary annulus_not_simply_connected : ~ simply_connected M.
Proof.
have [_ no_ridge _ no_labels] := theoremB_counterexample => sc; apply: no_labels.
apply: (theoremB_even_simply_connected annulus_pseudo_manifold sc) => r s cr loop.
by case: (no_ridge r s cr).
Qed.
