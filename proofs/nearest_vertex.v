(******************************************************************************)
(* Theorem A: why the paper's rule of selection (section 3; in the library    *)
(* cleave::cutting::Rule::nearest_vertex) separates along a plane.  Label     *)
(* each set of vertices by the side of its vertex farthest from the plane.    *)
(* Then a cell selects one of its facets iff the labels of cell and facet     *)
(* differ.  So exactly one of the two cells of a facet selects it iff the     *)
(* labels of the two cells differ; if they agree, both do or none.  The       *)
(* selected facets therefore contain every facet between cells of different   *)
(* labels, and after the cut no piece has cells of both labels.               *)
(*   The theorem needs a total order of the vertices by distance, no general  *)
(* position; with ties broken by id it holds for every plane.  For the        *)
(* paper's text (both ends if equally close) general position must be asked   *)
(* for; ties_counterexample shows why.                                        *)
(*      far_side side le A == the vertex of A that is last in the order le is *)
(*                            on the side where side is true                  *)
(*    selects M side le t f == the closest vertices of cell t are exactly n   *)
(*                            and are f                                       *)
(*   nearest_cut M side le == the facets that some cell selects               *)
(*    parity_cut M side le == those that an odd number of cells selects       *)
(*    general_position h A == no vertex of A is on the plane and no two have  *)
(*                            their middle on it                              *)
(*      plane_selects M h t f == selects, by the paper's text                 *)
(*         plane_cut M h == nearest_cut, by the paper's text                  *)
(* Main theorems: theoremA_cell, theoremA, theoremA_separates,                *)
(* theoremA_parity, theoremA_by_id, theoremA_plane, theoremA_plane_separates  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Cleave Require Import complex unglue lemma1.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section AnyOrder.
Variables (n : nat) (V T : finType) (M : complex n V T) (side : V -> bool) (le : rel V).
Implicit Types (A f : {set V}) (v w y z : V) (t u : T).

Definition far_side A := [exists z in A, side z && [forall w in A, le w z]].
Definition selects t f := (nearest_set side le (M t) == f) && (#|f| == n).
Definition nearest_cut : {set {set V}} := [set f | [exists t, selects t f]].
Definition parity_cut : {set {set V}} := [set f : {set V} | odd #|[set t | selects t f]| ].

Hypothesis le_total : total le.
Hypothesis le_trans : transitive le.
Hypothesis le_anti : antisymmetric le.

Lemma far_sideE A z : z \in A -> {in A, forall w, le w z} -> far_side A = side z.
Proof.
move=> zA zmax; apply/exists_inP/idP => [[y yA /andP[ys /forall_inP ymax]]|zs].
  by rewrite (_ : z = y) //; apply: le_anti; rewrite ymax ?zmax.
by exists z; rewrite ?zs //; apply/forall_inP.
Qed.

Lemma add_apex t f z : f \subset M t -> #|f| = n -> z \in M t -> z \notin f -> M t = z |: f.
Proof.
move=> ft cf zt zf; apply/esym/eqP; rewrite eqEcard cardsU1 zf cf card_vertices leqnn andbT.
by rewrite subUset sub1set zt.
Qed.

(* A cell selects one of its facets iff the vertex of the cell farthest from  *)
(* the plane and that of the facet are on different sides.  A facet must have *)
(* a vertex: a cell with one vertex selects the empty facet, or not, whatever *)
(* the side.                                                                  *)
Theorem theoremA_cell t f : 0 < n -> f \subset M t -> #|f| = n ->
  selects t f = (far_side (M t) != far_side f).
Proof.
move=> n0 ft cf; have f0 : f != set0 by rewrite -card_gt0 cf.
have t0 : M t != set0 by rewrite -card_gt0 card_vertices.
have [z zt zmax] := farthest le_total le_trans t0.
have [y yf ymax] := farthest le_total le_trans f0.
have yt := subsetP ft y yf.
rewrite (far_sideE zt zmax) (far_sideE yf ymax) /selects cf eqxx andbT.
have zn := farthest_not_nearest side le_anti zmax.
apply/eqP/idP => [nf | zy].
  have zf : z \notin f by rewrite -nf.
  have: y \in nearest_set side le (M t) by rewrite nf.
  rewrite inE => /andP[_ /exists_inP[w]]; rewrite (add_apex ft cf zt zf).
  rewrite !inE => /orP[/eqP-> /andP[]//|wf /andP[wy yw]].
  by move: wy; rewrite (_ : w = y) ?eqxx //; apply: le_anti; rewrite yw ymax.
have zf : z \notin f.
  by apply: contra zy => zf; rewrite (_ : z = y) //; apply: le_anti; rewrite ymax ?zmax.
apply/setP => v; rewrite inE [in v \in M t](add_apex ft cf zt zf) !inE.
have [-> | vz] /= := eqVneq v z.
  by rewrite (negPf zf); move: zn; rewrite inE zt => /negbTE.
apply: andb_idr => vf; apply/exists_inP.
have [e|ne] := eqVneq (side z) (side v); last by exists z; rewrite // ne zmax // (subsetP ft).
by exists y; rewrite // -e eq_sym zy ymax.
Qed.

(* Theorem A: exactly one of the two cells of a facet selects it iff the      *)
(* labels of the cells differ; if they agree, both or none.                   *)
Theorem theoremA t u : 0 < n -> adjacent M t u ->
  selects t (common M t u) (+) selects u (common M t u) = (far_side (M t) != far_side (M u)).
Proof.
move=> n0 /eqP c; rewrite !theoremA_cell ?subsetIl ?subsetIr //.
by do 3![case: far_side].
Qed.

Lemma nearest_cutP t u : 0 < n -> adjacent M t u -> far_side (M t) != far_side (M u) ->
  common M t u \in nearest_cut.
Proof.
move=> n0 a; rewrite -theoremA // inE => tu; apply/existsP.
by case ts: (selects t _) tu => /= us; [exists t | exists u].
Qed.

(* Theorem A, what it is for: after a cut along the selected facets no piece  *)
(* has cells of both labels.                                                  *)
Theorem theoremA_separates t u : 0 < n -> connect (adjacent (unglue M nearest_cut)) t u ->
  far_side (M t) = far_side (M u).
Proof.
move=> n0; rewrite T9_pieces // => /connectP[p + ->{u}].
elim: p t => //= s p IHp t /andP[/andP[a ns] /IHp<-].
have [//|ne] := eqVneq (far_side (M t)) (far_side (M s)).
by rewrite nearest_cutP in ns.
Qed.

(* Theorem A, the selection without folds: the facets that one cell selects   *)
(* and the other does not are exactly those between different labels.         *)
Theorem theoremA_parity t u : 0 < n -> pseudo_manifold M -> adjacent M t u ->
  (common M t u \in parity_cut) = (far_side (M t) != far_side (M u)).
Proof.
move=> n0 pm a; rewrite -theoremA // inE; set f := common M t u.
have tu := adjacent_neq a; have cf : #|f| = n by exact/eqP.
have tuf : [set t; u] = cofaces M f.
  apply/eqP; rewrite eqEcard cards2 tu pm // andbT.
  by apply/subsetP => s; rewrite !inE => /orP[]/eqP->; rewrite ?subsetIl ?subsetIr.
have E : [set s | selects s f] =
         (if selects t f then [set t] else set0) :|: (if selects u f then [set u] else set0).
  apply/setP => s; rewrite 2!inE.
  have -> : selects s f = (s \in [set t; u]) && selects s f.
    rewrite tuf inE andb_idl // => /andP[/eqP<- _].
    by apply/subsetP => v; rewrite inE => /andP[].
  rewrite !inE; have [->|st] /= := eqVneq s t.
    by case: ifP => _; case: ifP => _; rewrite !inE ?eqxx ?(negPf tu).
  have [->|su] /= := eqVneq s u.
    by case: (selects t f); case: (selects u f); rewrite !inE ?eqxx ?orbT // eq_sym (negPf tu).
  by do 2!case: ifP => _; rewrite !inE ?(negPf st) ?(negPf su).
by rewrite E; do 2!case: ifP => _; rewrite ?set0U ?setU0 ?cards1 ?cards0 ?cards2 ?tu.
Qed.
End AnyOrder.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Plane.
Variables (n : nat) (V T : finType) (M : complex n V T) (R : realFieldType) (h : V -> R).
Implicit Types (A f : {set V}) (a b c d v w : V) (t u : T).

(* Theorem A for the rule as the library runs it on a whole plane: ties in    *)
(* |height| go to the lesser id, sides may be chosen in any way for vertices  *)
(* on the plane.  No position of the plane is excepted.                       *)
Theorem theoremA_by_id (id : V -> nat) (side : V -> bool) t u :
  injective id -> (0 < n)%N ->
  connect (adjacent (unglue M (nearest_cut M side (nearer h id)))) t u ->
  far_side side (nearer h id) (M t) = far_side side (nearer h id) (M u).
Proof.
move=> id_inj; apply: theoremA_separates; first exact: nearer_total.
- exact: nearer_trans.
- exact: nearer_anti.
Qed.

Definition general_position A := {in A &, forall v w, h v + h w != 0}.
Definition plane_selects t f := (closest_set h (M t) == f) && (#|f| == n).
Definition plane_cut : {set {set V}} := [set f | [exists t, plane_selects t f]].

Let upper v := 0 < h v.
Let rank (v : V) : nat := enum_rank v.
Let rank_inj : injective rank. Proof. by move=> v w /val_inj/enum_rank_inj. Qed.

Lemma closest_nearest A : general_position A ->
  closest_set h A = nearest_set upper (nearer h rank) A.
Proof.
move=> gp; apply/setP => v; rewrite !inE; case vA: (v \in A) => //=.
apply: eq_existsb => w; case wA: (w \in A) => //=.
have off x : x \in A -> h x != 0.
  by move=> xA; have := gp x x xA xA; rewrite -mulr2n mulrn_eq0.
have [v0 w0] := (off v vA, off w wA); have vw := gp v w vA wA.
rewrite /crosses /upper /nearer; have [->|wv] := eqVneq w v.
  by rewrite eqxx.
have [v_neg|v_pos|/eqP] := ltgtP (h v) 0; last by rewrite (negPf v0).
  have [w_neg|w_pos|/eqP] := ltgtP (h w) 0; last by rewrite (negPf w0).
    by rewrite nmulr_rle0 // leNgt w_neg.
  rewrite nmulr_rle0 // (ltW w_pos) (ltr0_norm v_neg) (gtr0_norm w_pos) /= le_eqVlt orbC.
  by rewrite -subr_eq0 -opprD oppr_eq0 (negPf vw) /= orbF.
have [w_neg|w_pos|/eqP] := ltgtP (h w) 0; last by rewrite (negPf w0).
  rewrite pmulr_rle0 // (ltW w_neg) (gtr0_norm v_pos) (ltr0_norm w_neg) /= le_eqVlt orbC.
  by rewrite -addr_eq0 (negPf vw) /= orbF.
by rewrite pmulr_rle0 // leNgt w_pos.
Qed.

Lemma far_sideP A a b : general_position A -> extremes h A a b ->
  far_side upper (nearer h rank) A = (0 < h a + h b).
Proof.
move=> gp /and3P[aA bA /forall_inP bnd]; have A0 : A != set0 by apply/set0Pn; exists a.
have [z zA zmax] := farthest (nearer_total h rank) (@nearer_trans _ _ h rank) A0.
have z_far w : w \in A -> `|h w| <= `|h z|.
  by move/zmax; rewrite /nearer => /orP[/ltW|/andP[/eqP->]].
rewrite (far_sideE upper (nearer_anti rank_inj) zA zmax) /upper.
have /andP[bz za] := bnd z zA; have gz x : x \in A -> h z + h x != 0 by move=> ?; exact: gp.
apply/idP/idP => [z0 | ab].
  rewrite (lt_le_trans _ (ler_add za (lexx (h b)))) // lt_neqAle eq_sym gz //=.
  by rewrite -ler_subl_addr sub0r -(gtr0_norm z0) (le_trans _ (z_far b bA)) // -normrN ler_norm.
rewrite ltNge; apply/negP => z0; have := z_far a aA; rewrite (ler0_norm z0) => az.
have: h a + h b <= 0.
  rewrite -(addNr (h z)) ler_add // (le_trans (ler_norm _)) //.
by rewrite leNgt ab.
Qed.

(* Theorem A for the paper's text: a plane in general position.  The label of *)
(* a cell is the sign of (largest height) + (smallest height).                *)
Theorem theoremA_plane t u a b c d : (0 < n)%N -> adjacent M t u ->
  general_position (M t) -> general_position (M u) ->
  extremes h (M t) a b -> extremes h (M u) c d ->
  plane_selects t (common M t u) (+) plane_selects u (common M t u) =
  ((0 < h a + h b) != (0 < h c + h d)).
Proof.
move=> n0 tu gt gu et eu; rewrite /plane_selects !closest_nearest //.
rewrite -(far_sideP gt et) -(far_sideP gu eu).
rewrite -!/(selects M upper (nearer h rank) _ _) theoremA //; first exact: nearer_total.
- exact: nearer_trans.
- exact: nearer_anti.
Qed.

(* Theorem A for the paper's text: the cut along the selected facets          *)
(* separates the cells of one label from those of the other.                  *)
Theorem theoremA_plane_separates t u a b c d : (0 < n)%N ->
  (forall s, general_position (M s)) -> extremes h (M t) a b -> extremes h (M u) c d ->
  connect (adjacent (unglue M plane_cut)) t u -> (0 < h a + h b) = (0 < h c + h d).
Proof.
move=> n0 gp et eu; rewrite -(far_sideP (gp t) et) -(far_sideP (gp u) eu).
have -> : plane_cut = nearest_cut M upper (nearer h rank).
  apply/setP => f; rewrite !inE; apply: eq_existsb => s.
  by rewrite /plane_selects closest_nearest.
exact: theoremA_by_id.
Qed.
End Plane.

(* Two triangles 012 and 013 with heights 1, -1, 2, -2: the middle of their   *)
(* common edge is on the plane, their labels differ, and both select it.  So  *)
(* Theorem A needs general position if both ends of a tie are put in.         *)
Section TiesCounterexample.
Definition two_triangles (t : bool) : {set 'I_4} := [set~ if t then inord 2 else inord 3].

Lemma card_two_triangles t : #|two_triangles t| = 3%N.
Proof. by rewrite cardsC1 card_ord. Qed.

Lemma two_triangles_inj : injective two_triangles.
Proof. by case=> [] [] // /setP/(_ (inord 2)); rewrite !inE -!val_eqE /= !inordK. Qed.

Definition tied_triangles : complex 2 [finType of 'I_4] [finType of bool] :=
  Complex card_two_triangles two_triangles_inj.
Definition tied_heights (v : 'I_4) : rat := nth 0 [:: 1; -1; 2%:R; -2%:R] v.
Local Notation M := tied_triangles.
Local Notation h := tied_heights.

Lemma in_tied v t : (v \in M t) = (v != (if t then 2 else 3)%N :> nat).
Proof. by rewrite !inE -val_eqE; case: t; rewrite /= inordK. Qed.

Theorem ties_counterexample :
  let f := common M false true in
  [/\ adjacent M false true, plane_selects M h false f, plane_selects M h true f,
      extremes h (M false) (inord 2) (inord 1) /\ 0 < h (inord 2) + h (inord 1) &
      extremes h (M true) (inord 0) (inord 3) /\ h (inord 0) + h (inord 3) < 0].
Proof.
have fE : common M false true = [set v : 'I_4 | (v < 2)%N].
  by apply/setP; case=> [[|[|[|[|]]]] lt] //; rewrite inE !in_tied inE.
have cf : #|common M false true| = 2%N.
  rewrite fE (_ : [set v : 'I_4 | _] = [set inord 0; inord 1]) ?cards2 -?val_eqE /= ?inordK //.
  by apply/setP; case=> [[|[|[|[|]]]] lt] //; rewrite !inE -!val_eqE /= !inordK.
have e0 : extremes h (M false) (inord 2) (inord 1).
  apply/and3P; split; rewrite ?in_tied ?inordK //; apply/forall_inP => v.
  by rewrite in_tied; case: v => [[|[|[|[|]]]] lt] //; rewrite /h !inordK.
have e1 : extremes h (M true) (inord 0) (inord 3).
  apply/and3P; split; rewrite ?in_tied ?inordK //; apply/forall_inP => v.
  by rewrite in_tied; case: v => [[|[|[|[|]]]] lt] //; rewrite /h !inordK.
rewrite /adjacent /plane_selects cf; split=> //.
- rewrite andbT (lemma1_mended _ e0) ?card_vertices // fE; apply/eqP/setP.
  move=> v; rewrite [LHS]in_set [RHS]in_set in_tied.
  by case: v => [[|[|[|[|]]]] lt] //; rewrite /h !inordK.
- rewrite andbT (lemma1_mended _ e1) ?card_vertices // fE; apply/eqP/setP.
  move=> v; rewrite [LHS]in_set [RHS]in_set in_tied.
  by case: v => [[|[|[|[|]]]] lt] //; rewrite /h !inordK.
- by split=> //; rewrite /h !inordK.
- by split=> //; rewrite /h !inordK.
Qed.
End TiesCounterexample.
