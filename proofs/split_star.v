(******************************************************************************)
(* The hypothesis of Theorem C in space is met: a tetrahedron split into four *)
(* at a vertex inside has a simply connected star there.  So every cut with   *)
(* an even number of facets at each of its four inner edges opens at the      *)
(* vertex.                                                                    *)
(*              split == the four cells; 0..3 are the old vertices, 4 the new *)
(*     loopb n cs r s == the cells s are a loop around r, of lists of numbers *)
(* Main theorems: simply_connected_split, theoremC_split                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary listed_complex parity dual_edge star_opening.
From Cleave Require Import torus.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition loopb n (cs : cellsT) (r s : seq nat) :=
  [&& uniq s, 2 < size s,
      cycle (fun a b => let f := shared (cell cs a) (cell cs b) in
               (size f == n) && all (mem f) r) s
    & all (fun t => (t \in s) == all (mem (cell cs t)) r) (iota 0 (size cs))].

Lemma loopP n nv cs (ok : wf n nv cs) r (s : seq 'I_(size cs)) : all (fun v => v < nv) r ->
  loopb n cs r [seq val t | t <- s] -> dual_loop (ecomplex ok) (eset nv r) s.
Proof.
move=> /allP r_nv /and4P[us s2 cyc all_s].
have sub (c : seq nat) : (eset nv r \subset [set v : 'I_nv | val v \in c]) = all (mem c) r.
  apply/subsetP/allP => [rc v vr|rc v]; last by rewrite !inE => /rc.
  by have := rc (Ordinal (r_nv v vr)); rewrite !inE; apply.
split=> [|t]; last first.
  rewrite sub -(mem_map val_inj); apply/eqP/(allP all_s).
  by rewrite mem_iota ltn_ord.
rewrite (map_inj_uniq val_inj) size_map in us s2; split=> //.
case: s cyc {us s2 all_s} => //= t p; rewrite -map_rcons path_map; apply: sub_path => a b /=.
case/andP=> ab rf; have [uf bf] := shared_ok ok a b.
by rewrite /around /adjacent ecommon card_seq // ab sub.
Qed.

Definition split : cellsT :=
  [:: [:: 1; 2; 3; 4]; [:: 0; 2; 3; 4]; [:: 0; 1; 3; 4]; [:: 0; 1; 2; 4]].

Lemma split_ok : wf 3 5 split. Proof. by vm_compute. Qed.
Local Notation M := (ecomplex split_ok).
Local Notation centre := (inord 4 : 'I_5).

Lemma split_pseudo_manifold : pseudo_manifold M.
Proof. by apply: at_most_twoP; vm_compute. Qed.

(* Any three of the cells are a loop around an edge at the centre.            *)
Lemma three_loop (a b : 'I_(size split)) : val a != 0 -> val b != 0 -> a != b ->
  exists2 k, k < 4 & loopb 3 split [:: k; 4] [:: 0; val a; val b].
Proof.
move=> a0 b0 ab; have: all (fun a => all (fun b => [|| a == 0, b == 0, a == b |
    has (fun k => loopb 3 split [:: k; 4] [:: 0; a; b]) (iota 0 4)]) (iota 0 4)) (iota 0 4).
  by vm_compute.
have bound (c : 'I_(size split)) : val c \in iota 0 4 by rewrite mem_iota; case: c.
move/allP/(_ _ (bound a))/allP/(_ _ (bound b)); rewrite (negPf a0) (negPf b0) val_eqE (negPf ab).
by case/hasP=> k; rewrite mem_iota; exists k.
Qed.

(* Theorem C: its hypothesis, of a vertex inside a mesh of tetrahedra.        *)
Theorem simply_connected_split : simply_connected_star M centre.
Proof.
move=> x x_sym even; have o_lt : 0 < size split by vm_compute.
pose o := Ordinal o_lt; pose lab t := (t != o) && x o t.
have labE : labelling (star_adjacent M centre) x lab.
  move=> t u /andP[/adjacent_neq tu _]; rewrite /lab.
  have [to|to] := eqVneq t o; first by rewrite to eq_sym; move: tu; rewrite to eq_sym => ->.
  have [uo|uo] := eqVneq u o; first by rewrite uo x_sym addbF.
  have [k k4 loop] := three_loop to uo tu.
  have k5 : all (fun v => v < 5) [:: k; 4] by rewrite /= (ltn_trans k4).
  have r3 : #|eset 5 [:: k; 4]|.+1 = 3 by rewrite card_seq //= inE (ltn_eqF k4).
  have vr : centre \in eset 5 [:: k; 4] by rewrite inE -[val _]/(nat_of_ord _) inordK // !inE orbT.
  have := even _ [:: o; t; u] r3 vr (@loopP 3 5 split split_ok [:: k; 4] [:: o; t; u] k5 loop).
  by rewrite /loop_parity /parity /= (x_sym u o); case: (x o t) (x t u) (x o u) => [] [] [].
by move=> t p tp back; rewrite (labelling_walk labE tp) back addbb.
Qed.

(* Theorem C at a vertex inside: what is even at its edges opens there.       *)
Corollary theoremC_split (C : {set {set 'I_5}}) t u :
  (forall (r : {set 'I_5}) s, #|r|.+1 = 3 -> centre \in r -> dual_loop M r s -> ~~ odd (degree M C r)) ->
  star_adjacent M centre t u -> marks M C t u -> opens M C centre t u.
Proof. exact: (theoremC_even split_pseudo_manifold simply_connected_split). Qed.
