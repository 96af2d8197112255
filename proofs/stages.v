(******************************************************************************)
(* Several cuts (T8): larger cuts, and cuts one after the other.              *)
(*     shut M C == the facets of C that unglue M C leaves interior            *)
(*   opened M C == the others. When C consists of interior facets, these are  *)
(*                 the ones that unglue M C opens.                            *)
(*   T8_mono T8_adjacent == a larger cut parts and opens at least as much     *)
(*   T8_staged     == a cut C1, then a cut C that contains C1, is the cut C   *)
(*   T8_remembered == C1, then C2 and what C1 left shut, is the cut C1 :|: C2 *)
(*   T8_sequential == C1, then C2 alone, is the cut opened C1 :|: C2          *)
(*   T8_forgets    == C1 that opens nothing, then C2 alone, is the cut C2     *)
(* The last is less than C1 :|: C2 in general: T8_counterexample in           *)
(* examples.v has two cuts that open nothing, but open when made together.    *)
(* Hence the scored set of Incision, which remembers shut facets. The cut of  *)
(* the second stage is written lifted parent C: the same facets, on the       *)
(* complex as it is.                                                          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling copies opening splits.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Larger.
Variables (n : nat) (V T : finType) (M : complex n V T) (C C' : {set {set V}}).
Hypothesis sC : C \subset C'.

(* T8: a larger cut never joins what a smaller one separates.                 *)
Theorem T8_mono x y : copy M C' x = copy M C' y -> copy M C x = copy M C y.
Proof. by move=> /eqP e; apply/eqP; move: e; rewrite !copy_eq; exact: connect_subset. Qed.

(* T8: a larger cut opens every facet that a smaller one opens.               *)
Theorem T8_adjacent t u : adjacent (unglue M C') t u -> adjacent (unglue M C) t u.
Proof.
rewrite !adjacent_relabel => /andP[-> /forall_inP same]; apply/forall_inP => v vi.
exact/eqP/T8_mono/eqP/same.
Qed.

End Larger.

(* After any relabelling that respects C, unglue by C does what it would have
   done at the start.                                                         *)
Lemma unglue_relabel n (V W T : finType) (M : complex n V T) (t0 : T)
    (p : W -> V) (lab : V * T -> W) (pK : forall x, p (lab x) = x.1) (C : {set {set V}}) :
  respects M lab C -> isomorphic (unglue (relabel M pK) (lifted p C)) (unglue M C).
Proof.
move=> r; pose lab2 x := copy (relabel M pK) (lifted p C) (up lab x).
pose p2 (w : prod_finType W T) := p w.1.
have lab2K x : p2 (lab2 x) = x.1 by rewrite /p2 copyK pK.
suff : isomorphic (relabel M lab2K) (unglue M C).
  apply: isomorphic_trans; exists id => // t.
  by rewrite imset_id /= /relabelled -imset_comp.
apply: (relabel_iso _ _ t0) => x y _ _.
by rewrite !copy_eq connect_relabel.
Qed.

Section Stages.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (f : {set V}) (C : {set {set V}}).

Definition shut C : {set {set V}} :=
  [set f in C | [exists t, exists u, adjacent (unglue M C) t u && (common M t u == f)]].
Definition opened C : {set {set V}} := C :\: shut C.

(* A shut facet of a pseudo-manifold has no effect of its own: a path around
   each of its vertices joins its two sides without it.                       *)
Lemma connect_opened C x y : pseudo_manifold M ->
  connect (glue M (opened C)) x y = connect (glue M C) x y.
Proof.
move=> pm; apply/idP/idP; last exact/connect_subset/subsetDl.
apply: connect_sub => {x y} [[v t] [w u]] /and4P[/= /eqP<- vi tu].
rewrite in_setD negb_and negbK => iC.
case: (boolP (common M t u \in C)) iC => [C_tu|nC _]; rewrite ?orbF; last first.
  by apply: connect1; rewrite /glue /= eqxx vi tu.
rewrite inE => /andP[_ /existsP[t' /existsP[u' /andP[tu' /eqP e]]]].
have [M_tu' /forall_inP same] := andP (etrans (esym (T3_adjacent M C t' u')) tu').
have c : connect (glue M C) (v, t') (v, u') by apply: same; rewrite e.
have cofE : [set t; u] = cofaces M (common M t u).
  apply/eqP; rewrite eqEcard cards2 (adjacent_neq tu) pm ?(eqP tu) // andbT.
  by apply/subsetP => z; rewrite !inE => /orP[]/eqP->; rewrite ?subsetIl ?subsetIr.
have : t' \in [set t; u] by rewrite cofE inE -e subsetIl.
have : u' \in [set t; u] by rewrite cofE inE -e subsetIr.
move: (adjacent_neq M_tu') c; rewrite !inE => ne c /orP[]/eqP eu /orP[]/eqP et.
- by rewrite et eu eqxx in ne.
- by rewrite glue_csym -et -eu.
- by rewrite -et -eu.
- by rewrite et eu eqxx in ne.
Qed.

Variable t0 : T.

(* T8: in stages is at once, if each stage cuts all that was cut before.      *)
Theorem T8_staged C1 C : C1 \subset C ->
  isomorphic (unglue (unglue M C1) (lifted parent C)) (unglue M C).
Proof.
by move=> sC; apply: unglue_relabel => // x y /(glue_subrel sC); apply: copy_respects.
Qed.

(* T8: a second cut that forgets the first keeps just what the first opened.  *)
Theorem T8_sequential C1 C2 : pseudo_manifold M ->
  isomorphic (unglue (unglue M C1) (lifted parent C2)) (unglue M (opened C1 :|: C2)).
Proof.
move=> pm; set D := opened C1 :|: C2.
have r : respects M (copy M C1) D.
  move=> x y /(glue_subrel (subsetUl _ C2)) g; apply/eqP.
  by rewrite copy_eq -(connect_opened C1 x y pm); exact: connect1.
have glueE : glue (unglue M C1) (lifted parent C2) =2 glue (unglue M C1) (lifted parent D).
  move=> x y; rewrite /glue; case a: (adjacent _ _ _); last by rewrite !andbF.
  congr [&& _, _, _ & ~~ _].
  rewrite !in_lifted p_common_adjacent // in_setU orbC; case: (_ \in C2) => //=.
  apply/esym/negbTE; rewrite in_setD negb_and negbK inE; case: (_ \in C1) => //=.
  by rewrite orbF; apply/existsP; exists x.2; apply/existsP; exists y.2; rewrite a eqxx.
apply: isomorphic_trans (unglue_relabel t0 (copyK M C1) r).
exists id => // t; rewrite imset_id !unglueE; apply: eq_imset => w.
exact/esym/(eq_root glueE).
Qed.

(* T8: in stages is at once, if the second stage remembers the shut facets.   *)
Theorem T8_remembered C1 C2 : pseudo_manifold M ->
  isomorphic (unglue (unglue M C1) (lifted parent (shut C1 :|: C2))) (unglue M (C1 :|: C2)).
Proof.
move=> pm; suff -> : C1 :|: C2 = opened C1 :|: (shut C1 :|: C2) by apply: T8_sequential.
rewrite setUA; congr (_ :|: _); apply/setP=> f; rewrite !inE.
by case: (f \in C1) => //=; rewrite andbT orNb.
Qed.

(* T8: a cut that opens nothing leaves no trace for the next one.             *)
Theorem T8_forgets C1 C2 :
  regular M C1 -> isomorphic (unglue (unglue M C1) (lifted parent C2)) (unglue M C2).
Proof.
move=> r; apply: unglue_relabel => // x y g; apply/eqP; rewrite copy_eq.
case: x y g => v t [w u] /and4P[/= /eqP <-]; rewrite inE => /andP[vt vu] _ _.
exact: r.
Qed.

End Stages.
