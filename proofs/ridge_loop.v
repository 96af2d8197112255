(******************************************************************************)
(* Around a ridge inside a pseudo-manifold there is a loop of cells.  Theorem *)
(* B (dual_edge.v) speaks of such loops; they exist for every ridge of which  *)
(* no facet is on the boundary, and one passes through every cell there, so   *)
(* the theorem speaks of all ridges inside, pinched ones too.                 *)
(*   inside M r == no facet of M that contains r is on the boundary           *)
(* Main theorem: theoremB_loop_exists                                         *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue boundary dual_edge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* A graph in which every vertex has two neighbours consists of loops: take a *)
(* path as long as possible; its last vertex can go on only to the first.     *)
Section TwoRegular.
Variables (T : finType) (e : rel T) (near : pred T).
Implicit Types (t u : T) (p : seq T).
Hypothesis e_sym : symmetric e.
Hypothesis e_irr : irreflexive e.
Hypothesis e_near : forall t u, near t -> e t u -> near u.
Hypothesis two : forall t, near t ->
  exists u1 u2, u1 != u2 /\ forall u, e t u = (u \in [:: u1; u2]).

Lemma not_three t u1 u2 u3 : near t -> e t u1 -> e t u2 -> e t u3 -> ~~ uniq [:: u1; u2; u3].
Proof.
move=> /two[a [b [_ tE]]]; rewrite !tE => e1 e2 e3; apply/negP => u.
have sub : {subset [:: u1; u2; u3] <= [:: a; b]} by apply/allP; rewrite /= e1 e2 e3.
by have := uniq_leq_size u sub.
Qed.

Lemma other_neighbour t u : near t -> exists2 w, w != u & e t w.
Proof.
case/two=> a [b [ab tE]]; have [au|au] := eqVneq a u.
  by exists b; rewrite ?tE ?inE ?eqxx ?orbT // -au eq_sym.
by exists a; rewrite ?tE ?inE ?eqxx.
Qed.

Lemma longest_path t : exists p, [/\ path e t p, uniq (t :: p) &
  forall q, path e t q -> uniq (t :: q) -> size q <= size p].
Proof.
pose P m := [exists p : m.-tuple T, path e t p && uniq (t :: p)].
have P0 : exists m, P m by exists 0; apply/existsP; exists [tuple].
have bound m : P m -> m <= #|T|.
  case/existsP=> p /andP[_ /card_uniqP u]; rewrite -[m](size_tuple p) ltnW //.
  by rewrite -[X in X <= _]u max_card.
have [m /existsP[p /andP[tp up]] m_max] := ex_maxnP P0 bound.
exists p; split=> // q tq uq; rewrite size_tuple; apply: m_max; apply/existsP.
by exists (in_tuple q); rewrite tq.
Qed.

Theorem loop_exists t : near t -> exists p, [/\ uniq (t :: p), 1 < size p & cycle e (t :: p)].
Proof.
move=> t_near; have [p [tp up longest]] := longest_path t.
have path_near : all near (t :: p).
  rewrite /= t_near; elim: p t t_near tp {up longest} => //= u p IHp t t_near /andP[tu up].
  by have u_near := e_near t_near tu; rewrite u_near (IHp u).
case/lastP: p => [|q x] in tp up longest path_near *.
  have [w _ tw] := other_neighbour t t_near.
  have: size [:: w] <= 0.
    by apply: longest; rewrite /= ?tw // inE andbT; apply: contraTneq tw => <-; rewrite e_irr.
  by [].
move: (tp); rewrite rcons_path => /andP[tq qx].
have x_near : near x by move/allP: path_near; apply; rewrite inE mem_rcons mem_head orbT.
have [y yq xy] := other_neighbour (last t q) x_near.
have y_in : y \in t :: rcons q x.
  apply: contraT => y_out; have: size (rcons (rcons q x) y) <= size (rcons q x).
    apply: longest; first by rewrite rcons_path tp last_rcons.
    by rewrite -rcons_cons rcons_uniq y_out.
  by rewrite !size_rcons ltnn.
have yx : y != x by apply: contraTneq xy => ->; rewrite e_irr.
have [j j_q yE] : exists2 j, j < size q & y = nth t (t :: q) j.
  move: y_in; rewrite -rcons_cons mem_rcons inE (negPf yx) /= => /(nthP t)[j].
  rewrite /= ltnS leq_eqVlt => /orP[/eqP-> ey|j_q <-]; last by exists j.
  by case/eqP: yq; rewrite -ey (last_nth t).
exists (rcons q x); rewrite size_rcons; split=> //.
  by rewrite ltnS (leq_ltn_trans _ j_q).
case: j => [|j] in j_q yE *.
  by rewrite /= rcons_path tp last_rcons -[t in e x t]/(nth t (t :: q) 0) -yE.
have /pathP step := tp; have nthE i : i <= size q -> nth t (t :: rcons q x) i = nth t (t :: q) i.
  by move=> iq; rewrite -rcons_cons nth_rcons ltnS iq.
have nx : nth t (t :: rcons q x) (size q).+1 = x by rewrite /= nth_rcons ltnn eqxx.
have y_near : near y by move/allP: path_near; apply.
have yE' : y = nth t (t :: rcons q x) j.+1 by rewrite nthE // ltnW.
have sL : size (t :: rcons q x) = (size q).+2 by rewrite /= size_rcons.
have j2 : j.+2 <= size q by [].
have j_x : j < (size q).+1 by rewrite ltnS; apply/ltnW/ltnW.
have L_uniq a b : a < b -> b <= (size q).+1 ->
    nth t (t :: rcons q x) a != nth t (t :: rcons q x) b.
  by move=> ab b_q; rewrite nth_uniq ?sL ?ltnS ?(ltn_eqF ab) // ltnW // (leq_trans ab).
have ax : nth t (t :: rcons q x) j != x by rewrite -[X in _ != X]nx; apply: L_uniq.
have bx : nth t (t :: rcons q x) j.+2 != x by rewrite -[X in _ != X]nx; apply: L_uniq.
have ab := L_uniq j j.+2 (leqnSn _) (leqW j2).
have: ~~ uniq [:: nth t (t :: rcons q x) j; nth t (t :: rcons q x) j.+2; x].
  apply: (not_three y_near); first by rewrite e_sym yE'; apply: step; rewrite size_rcons.
    by rewrite yE'; apply: step; rewrite size_rcons ltnW.
  by rewrite e_sym.
by case/negP; move: ab ax bx; move: (nth t _ j) (nth t _ j.+2) => a b ab ax bx;
  rewrite /= !inE negb_or ab ax bx.
Qed.
End TwoRegular.

Section RidgeLoop.
Variables (n : nat) (V T : finType) (M : complex n V T) (r : {set V}).
Implicit Types (t u : T) (f : {set V}) (s : seq T).

Definition inside := forall f : {set V}, #|f| = n -> r \subset f -> #|cofaces M f| != 1.

Hypotheses (pm : pseudo_manifold M) (card_r : #|r|.+1 = n) (r_inside : inside).

Lemma cell_across t f : #|f| = n -> r \subset f -> f \subset M t ->
  exists2 u, around M r t u & common M t u = f.
Proof.
move=> cf rf ft; have t_f : t \in cofaces M f by rewrite inE.
have : 0 < #|cofaces M f :\ t|.
  by have := r_inside cf rf; rewrite (cardsD1 t) t_f add1n eqSS lt0n.
case/card_gt0P=> u; rewrite !inE eq_sym => /andP[tu fu].
have e := common_facet cf tu ft fu.
by exists u; rewrite // /around e rf andbT /adjacent e cf.
Qed.

Lemma two_around t : r \subset M t ->
  exists u1 u2, u1 != u2 /\ forall u, around M r t u = (u \in [:: u1; u2]).
Proof.
move=> rt; have /eqP/cards2P[f1 [f2 [f12 F]]] := two_facets card_r rt.
have inF f : (f \in [set f1; f2]) = [&& #|f| == n, r \subset f & f \subset M t].
  by rewrite -F inE.
have /and3P[/eqP c1 r1 t1] : [&& #|f1| == n, r \subset f1 & f1 \subset M t].
  by rewrite -inF set21.
have /and3P[/eqP c2 r2 t2] : [&& #|f2| == n, r \subset f2 & f2 \subset M t].
  by rewrite -inF set22.
have [[u1 a1 e1] [u2 a2 e2]] := (cell_across c1 r1 t1, cell_across c2 r2 t2).
exists u1, u2; split=> [|u]; first by apply: contraNneq f12 => u12; rewrite -e1 -e2 u12.
rewrite !inE; apply/idP/orP => [|[/eqP->|/eqP->]] //.
case/andP=> tu rf; have: common M t u \in [set f1; f2].
  by rewrite inF rf subsetIl; apply/and3P.
have [/andP[a1' _] /andP[a2' _]] := (a1, a2); rewrite !inE => /orP[] /eqP e; [left | right].
  by apply/eqP/(common_inj pm tu a1'); rewrite e e1.
by apply/eqP/(common_inj pm tu a2'); rewrite e e2.
Qed.

(* Theorem B: through every cell at a ridge inside there is a loop of cells   *)
(* around it.                                                                 *)
Theorem theoremB_loop_exists t : r \subset M t -> exists2 s, loop_around M r s & t \in s.
Proof.
have sym : symmetric (around M r) by move=> a b; rewrite /around adjacentC commonC.
have irr : irreflexive (around M r) by move=> a; rewrite /around adjacent_irr.
have stay a b : r \subset M a -> around M r a b -> r \subset M b.
  by move=> _ /andP[_ rab]; rewrite (subset_trans rab) ?subsetIr.
move=> rt; have [p [up p1 cyc]] := loop_exists sym irr stay two_around rt.
by exists (t :: p); rewrite ?mem_head.
Qed.
End RidgeLoop.
