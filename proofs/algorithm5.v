(******************************************************************************)
(* Algorithm 5 and the flood that finds the star of a vertex (T13).           *)
(*  neighbour o t j == Algorithm 5: the cell of the mate of the facet         *)
(*                   opposite the j-th vertex of t; none on the boundary      *)
(*      flood M v t == the cells reached from t through facets that contain v *)
(*   flood_step o v == the same step taken by Algorithm 5, as in section 4:   *)
(*                   find recursively all neighbours of t that contain v      *)
(*                   (star(const Complex&, VertexId) of the C++)              *)
(*   T13_algorithm5 == Algorithm 5 finds the other cell at the facet          *)
(*   T13_neighbour  == and there is one such cell at most                     *)
(*   T13_flood_step == so the flood by Algorithm 5 is the flood               *)
(*   T13_flood      == from any cell around v it reaches the whole star iff   *)
(*                   the vertex v is cut-regular                              *)
(*   T13_cut_regular == so it does at every vertex iff M is cut-regular       *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue orientation.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Flood.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V).

Definition flood v t : {set T} := [set u | connect (glue M set0) (v, t) (v, u)].

(* T13: the flood reaches the whole star iff the vertex is cut-regular.       *)
Theorem T13_flood v t : v \in M t -> flood v t = star M v <-> regular_at M set0 v.
Proof.
move=> vt; split=> [/setP full|r].
  have reach u : v \in M u -> connect (glue M set0) (v, t) (v, u).
    by have := full u; rewrite !inE => ->.
  move=> u w vu vw; apply: connect_trans (reach w vw).
  by rewrite glue_csym; exact: reach.
apply/setP=> u; rewrite !inE; apply/idP/idP => [/connect_corner/(_ vt)//|].
exact: r.
Qed.

(* T13: hence in a cut-regular complex, and in no other, each flood succeeds. *)
Theorem T13_cut_regular :
  cut_regular M <-> (forall v t, v \in M t -> flood v t = star M v).
Proof.
split=> [r v t vt|full v t u vt vu]; first exact/(T13_flood vt)/r.
by have /(T13_flood vt) r := full v t vt; apply: r.
Qed.

End Flood.

Section Algorithm5.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : orientation M).
Hypothesis co : coherent o.
Implicit Types (t u w : T) (v : V) (j : 'I_n.+1).

Definition neighbour t j : option T :=
  omap fst [pick x : T * 'I_n.+1 | osame (mate (half_facet o t j)) (half_facet o x.1 x.2)].

(* T13: Algorithm 5 returns u iff u is another cell with that facet.          *)
Theorem T13_algorithm5 t j u :
  neighbour t j = Some u <-> u != t /\ facet M (tnth (o t) j, t) \subset M u.
Proof.
set f := facet _ _; have cf : #|f| = n by rewrite card_facet ?corner_tnth.
have matesE w k := half_facet_mates t j w k co; rewrite /neighbour; split.
  case: pickP => // -[w k] /=; rewrite matesE => /and4P[_ _ tw /eqP e] [<-].
  by rewrite eq_sym tw /f e facet_sub.
move=> [ut fu]; have [v vu fE] := facetP fu cf.
have [k vE] := tnth_corner o (vu : corner M (v, u)).
have uk : osame (mate (half_facet o t j)) (half_facet o u k).
  by rewrite matesE /mates !corner_tnth eq_sym ut -/f fE {1}vE eqxx.
case: pickP => [[w i] /= wi|/(_ (u, k))]; last by rewrite /= uk.
have /coherent_each_in_one_cell one := co.
have /one[->//] : osame (half_facet o w i) (half_facet o u k).
by apply: osame_trans uk; rewrite osame_sym.
Qed.

(* T13: no other cell has that facet, so "the" neighbour is meaningful.       *)
Theorem T13_neighbour t j u w : let f := facet M (tnth (o t) j, t) in
  u != t -> w != t -> f \subset M u -> f \subset M w -> u = w.
Proof.
move=> f ut wt fu fw; apply: Some_inj.
by rewrite -((T13_algorithm5 t j u).2 (conj ut fu)) ((T13_algorithm5 t j w).2 (conj wt fw)).
Qed.

Definition flood_step v : rel T :=
  fun t u => [exists j, (v \in facet M (tnth (o t) j, t)) && (neighbour t j == Some u)].

Lemma flood_step_glue v t u : flood_step v t u = glue M set0 (v, t) (v, u).
Proof.
apply/existsP/idP => [[j /andP[vf /eqP/T13_algorithm5[ut fu]]]|/glueP[_]].
  have cf : #|facet M (tnth (o t) j, t)| = n by rewrite card_facet ?corner_tnth.
  have e : common M t u = facet M (tnth (o t) j, t).
    by apply: (common_facet cf); rewrite ?facet_sub // eq_sym.
  by rewrite /glue /adjacent /= e eqxx vf cf eqxx inE.
move=> [[h t'] [[k u'] [/= -> -> /and4P[ch _ tu /eqP e] vh _]]].
have [j hE] := tnth_corner o ch; exists j; rewrite -hE vh.
by apply/eqP/T13_algorithm5; rewrite eq_sym -hE e facet_sub.
Qed.

(* T13: following Algorithm 5 at v from t is the flood.                       *)
Theorem T13_flood_step v t : flood M v t = [set u | connect (flood_step v) t u].
Proof.
apply/setP=> u; rewrite !inE; apply/idP/idP.
  pose at_v x := x.1 = v /\ connect (flood_step v) t x.2.
  suff stay x y : glue M set0 x y -> at_v x -> at_v y.
    by move/(connect_stay stay) => /(_ (conj erefl (connect0 _ _)))[].
  case: x y => w z [w' z'] xy [/= wv tz]; have /= ww' := connect_fst (connect1 xy).
  subst w w'; split=> //=; apply: connect_trans tz (connect1 _).
  by rewrite flood_step_glue.
apply: (connect_homo (f := fun z => (v, z))) => x y.
by rewrite flood_step_glue => /connect1.
Qed.

End Algorithm5.
