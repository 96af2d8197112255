(******************************************************************************)
(* Oriented complexes (T2).                                                   *)
(*      osimplex n V == a sign and an ordering of n vertices. Section 4: each *)
(*                    set is ordered, and the parity of the ordering          *)
(*                    determines the orientation. The sign is apart because a *)
(*                    facet of one vertex (n = 1) has only one ordering.      *)
(*         oset a == its vertices                                             *)
(*         mate a == the same with opposite orientation                       *)
(*      osame a b == a and b are one oriented simplex: reordering a by the    *)
(*                    permutation s gives b, up to the sign of s              *)
(*  orientation M == for each cell the order of its vertices and whether it   *)
(*                    is reversed (the tuples of the file and Complex::sign)  *)
(*   facet_tuple o t i == the facet opposite the i-th vertex of t, in the     *)
(*                    order of the cell (Complex::facet)                      *)
(*   half_facet o t i == that facet with the orientation that t induces on it *)
(*                    (Complex::facet_sign)                                   *)
(*     coherent o == half-facets with the same vertices, of different cells,  *)
(*                    have opposite orientation: Cleave's invariant           *)
(*  each_in_one_cell o == the paper's form of it: in the oriented             *)
(*                    3-dimensional pseudo-manifold, each triangle is part of *)
(*                    precisely one tetrahedron                               *)
(*  relabelled_orientation o pK == the same after a relabelling               *)
(*  coherent_each_in_one_cell == the two forms of coherence are equivalent    *)
(*  coherent_pseudo_manifold == a coherent complex is a pseudo-manifold. Not  *)
(*                    every pseudo-manifold can be oriented so, which the     *)
(*                    paper does not say.                                     *)
(*  T2_coherent == unglue, and any relabelling, keeps coherence               *)
(*  T2_oriented_facets == and creates and destroys no oriented facet          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect fingroup perm.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section OrientedSimplex.
Variables (n : nat) (V : finType).

Definition osimplex := (bool * n.-tuple V)%type.
Implicit Types a b c : osimplex.

Definition oset a : {set V} := [set x in a.2].
Definition mate a : osimplex := (~~ a.1, a.2).
Definition osame a b :=
  [exists s : 'S_n, (b.2 == [tuple tnth a.2 (s i) | i < n]) && (b.1 == a.1 (+) s)].

Lemma osameP a b :
  reflect (exists2 s : 'S_n, (forall i, tnth b.2 i = tnth a.2 (s i)) & b.1 = a.1 (+) s)
          (osame a b).
Proof.
apply: (iffP existsP) => [[s /andP[/eqP e /eqP sgn]]|[s e sgn]]; exists s => //.
  by move=> i; rewrite e tnth_mktuple.
by rewrite sgn eqxx andbT; apply/eqP/eq_from_tnth => i; rewrite e tnth_mktuple.
Qed.

Lemma osame_refl a : osame a a.
Proof. by apply/osameP; exists 1%g => [i|]; rewrite ?perm1 // odd_perm1 addbF. Qed.

Lemma osame_sym : symmetric osame.
Proof.
suff sub a b : osame a b -> osame b a by move=> a b; apply/idP/idP; apply: sub.
case/osameP=> s e sgn; apply/osameP; exists s^-1%g => [i|]; first by rewrite e permKV.
by rewrite odd_permV sgn -addbA addbb addbF.
Qed.

Lemma osame_trans : transitive osame.
Proof.
move=> b a c /osameP[s e sgn] /osameP[r e' sgn']; apply/osameP.
exists (r * s)%g => [i|]; first by rewrite e' e permM.
by rewrite odd_permM sgn' sgn -addbA [odd_perm s (+) _]addbC.
Qed.

Lemma osame_mate a b : osame (mate a) b = osame a (mate b).
Proof.
apply/osameP/osameP => -[s e sgn]; exists s => //; move: sgn => /=.
  by move->; rewrite addNb negbK.
by rewrite addNb => <-; rewrite negbK.
Qed.

Lemma osame_oset a b : osame a b -> oset a = oset b.
Proof.
have sub c d : osame c d -> oset d \subset oset c.
  case/osameP=> s e _; apply/subsetP=> x; rewrite !inE => /tnthP[i ->].
  by rewrite e mem_tnth.
by move=> ab; apply/eqP; rewrite eqEsubset !sub // osame_sym.
Qed.

(* An oriented simplex is not its own mate.                                   *)
Lemma osame_mateN a : uniq a.2 -> ~~ osame a (mate a).
Proof.
move=> /tuple_uniqP a_inj; apply/osameP => -[s e /=].
suff -> : s = 1%g by rewrite odd_perm1 addbF; case: a.1.
by apply/permP => i; rewrite perm1; apply: a_inj; rewrite -e.
Qed.

(* n vertices carry just two oriented simplices.                              *)
Lemma osame_or_mate a b : uniq a.2 -> uniq b.2 -> oset a = oset b ->
  osame a b || osame (mate a) b.
Proof.
move=> ua ub /setP ab; have /tuple_permP[s es] : perm_eq b.2 a.2.
  by apply: uniq_perm => // x; have := ab x; rewrite !inE => ->.
have e i : tnth b.2 i = tnth a.2 (s i).
  by have -> : b.2 = [tuple tnth a.2 (s j) | j < n]; [apply: val_inj | rewrite tnth_mktuple].
case sgn: (b.1 == a.1 (+) s); apply/orP; [left | right]; apply/osameP; exists s => //.
  exact/eqP.
by move: sgn; rewrite /= addNb; case: b.1; case: (_ (+) _).
Qed.

End OrientedSimplex.

Section Orientation.
Variables (n : nat) (V T : finType) (M : complex n V T).

Record orientation := Orientation {
  tuple_of :> T -> n.+1.-tuple V;
  reversed : T -> bool;
  tuple_ofP : forall t, [set x in tuple_of t] = M t
}.

Variable o : orientation.
Implicit Types (t u w : T) (i j k : 'I_n.+1).

Lemma mem_tuple_of v t : (v \in o t) = (v \in M t).
Proof. by rewrite -(tuple_ofP o t) inE. Qed.

Lemma tuple_of_inj t : injective (tnth (o t)).
Proof.
suff /tuple_uniqP : uniq (o t) by [].
apply/card_uniqP; rewrite size_tuple; apply: etrans (card_vertices M t).
by apply: eq_card => x; rewrite mem_tuple_of.
Qed.

Lemma corner_tnth t i : corner M (tnth (o t) i, t).
Proof. by rewrite /corner -mem_tuple_of mem_tnth. Qed.

Lemma tnth_corner x : corner M x -> exists i, x = (tnth (o x.2) i, x.2).
Proof. by case: x => v t; rewrite /corner -mem_tuple_of /= => /tnthP[i ->]; exists i. Qed.

Definition facet_tuple t i : n.-tuple V := [tuple tnth (o t) (lift i j) | j < n].
Definition half_facet t i : osimplex n V := (reversed o t (+) odd i, facet_tuple t i).

Lemma half_facet_uniq t i : uniq (half_facet t i).2.
Proof. by apply/tuple_uniqP => j k; rewrite !tnth_mktuple => /tuple_of_inj/lift_inj. Qed.

Lemma half_facet_set t i : oset (half_facet t i) = facet M (tnth (o t) i, t).
Proof.
apply/setP=> x; rewrite !inE -mem_tuple_of; apply/tnthP/andP => [[j ->]|[xi /tnthP[k xk]]].
  by rewrite tnth_mktuple mem_tnth (inj_eq (@tuple_of_inj t)) eq_sym neq_lift.
have ki : i != k by apply: contra xi => /eqP->; rewrite xk.
by case: (unlift_some ki) => j kj _; exists j; rewrite tnth_mktuple -kj.
Qed.

Lemma half_facet_index t i j : oset (half_facet t i) = oset (half_facet t j) -> i = j.
Proof.
rewrite !half_facet_set => e; apply: tuple_of_inj.
exact: facet_inj (corner_tnth t i) e.
Qed.

Definition coherent := forall t i u j, t != u ->
  oset (half_facet t i) = oset (half_facet u j) -> osame (mate (half_facet t i)) (half_facet u j).

Definition each_in_one_cell := forall t i u j,
  osame (half_facet t i) (half_facet u j) -> (t, i) = (u, j).

Theorem coherent_each_in_one_cell : coherent <-> each_in_one_cell.
Proof.
split=> [co t i u j s|one t i u j tu e].
  have [tu|tu] := eqVneq t u; first by subst u; rewrite (half_facet_index (osame_oset s)).
  have := co _ _ _ _ tu (osame_oset s); rewrite osame_sym => /(osame_trans s).
  by rewrite (negPf (osame_mateN (half_facet_uniq t i))).
have /orP[s|//] := osame_or_mate (half_facet_uniq t i) (half_facet_uniq u j) e.
by case: (one _ _ _ _ s) tu => -> _; rewrite eqxx.
Qed.

(* Two half-facets with one set of vertices are mates; coherence makes them
   mates in the sense of orientation as well.                                 *)
Lemma half_facet_mates t i u j : coherent ->
  osame (mate (half_facet t i)) (half_facet u j) =
  mates M (tnth (o t) i, t) (tnth (o u) j, u).
Proof.
move=> co; rewrite /mates !corner_tnth -!half_facet_set /=.
apply/idP/andP => [s|[tu /eqP/(co _ _ _ _ tu)//]].
split; last by apply/eqP; exact: (osame_oset s).
apply/eqP=> tu; subst u; have ij := half_facet_index (osame_oset s); subst j.
by move: s; rewrite osame_sym (negPf (osame_mateN (half_facet_uniq t i))).
Qed.

(* The converse holds of orientable complexes only.                           *)
Theorem coherent_pseudo_manifold : coherent -> pseudo_manifold M.
Proof.
move=> co f cf; rewrite leqNgt; apply/card_gt2P => -[t [u [w]]].
rewrite !inE => -[[ft fu fw] [tu uw wt]].
have index x : f \subset M x -> exists i, f = oset (half_facet x i).
  case/facetP=> // v vx ->; have [i [->]] := tnth_corner (vx : corner M (v, x)).
  by exists i; rewrite half_facet_set.
have [[i fi] [j fj] [k fk]] := And3 (index t ft) (index u fu) (index w fw).
have ij : osame (mate (half_facet t i)) (half_facet u j) by apply: co; rewrite -?fi.
have ik : osame (mate (half_facet t i)) (half_facet w k) by apply: co; rewrite -?fi // eq_sym.
have /coherent_each_in_one_cell one := co.
have : osame (half_facet u j) (half_facet w k) by apply: osame_trans ik; rewrite osame_sym.
by move/one => e; move: uw; case: e => ->; rewrite eqxx.
Qed.

End Orientation.

Section Relabelled.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : orientation M).
Variables (W : finType) (p : W -> V) (lab : V * T -> W).
Hypothesis pK : forall x, p (lab x) = x.1.
Let R := relabel M pK.
Implicit Types (t u : T) (i j k : 'I_n.+1).

Definition relabelled_tuple t := [tuple lab (tnth (o t) i, t) | i < n.+1].

Lemma relabelled_tupleP t : [set w in relabelled_tuple t] = R t.
Proof.
apply/setP=> w; rewrite inE; apply/tnthP/imsetP => [[i ->]|[v]].
  by exists (tnth (o t) i); rewrite ?tnth_mktuple // -(mem_tuple_of o) mem_tnth.
by rewrite -(mem_tuple_of o) => /tnthP[i ->] ->; exists i; rewrite tnth_mktuple.
Qed.

Definition relabelled_orientation : orientation R :=
  Orientation (reversed o) relabelled_tupleP.
Local Notation o' := relabelled_orientation.

Lemma half_facet_tnth t i (k : 'I_n) :
  tnth (half_facet o' t i).2 k = lab (tnth (half_facet o t i).2 k, t).
Proof. by rewrite !tnth_mktuple. Qed.

(* T2: unglue keeps a coherent orientation coherent.                          *)
Theorem T2_coherent : coherent o -> coherent o'.
Proof.
move=> co t i u j tu e.
have : mates R (up lab (tnth (o t) i, t)) (up lab (tnth (o u) j, u)).
  have cornerR := corner_tnth o'; move: e; rewrite !half_facet_set => e.
  have := cornerR t i; have := cornerR u j; rewrite !tnth_mktuple => cu ct.
  by rewrite /mates ct cu tu; apply/eqP; move: e; rewrite !tnth_mktuple.
rewrite mates_relabel -half_facet_mates // => /andP[/osameP[s eV sgn] /forall_inP same].
apply/osameP; exists s => // k; rewrite !half_facet_tnth eV; apply/esym/eqP/same.
by rewrite -half_facet_set inE mem_tnth.
Qed.

(* T2: half-facets are the same oriented facet after iff they were before: by
   coherent_each_in_one_cell, iff they are the same half-facet. So unglue
   instantiates and destroys no object.                                       *)
Theorem T2_oriented_facets t i u j : coherent o ->
  osame (half_facet o' t i) (half_facet o' u j) <-> osame (half_facet o t i) (half_facet o u j).
Proof.
move=> co; have /coherent_each_in_one_cell one := co.
have /coherent_each_in_one_cell one' := T2_coherent co.
by split=> [/one'[-> ->]|/one[-> ->]]; apply: osame_refl.
Qed.

End Relabelled.
