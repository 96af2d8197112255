(******************************************************************************)
(* Incisions: cutting in many steps, and taking cuts back (T12). An incision  *)
(* is a complex with its scored facets: all that were asked for and not taken *)
(* back. The complex as it is now is a relabelling of the original one. A cut *)
(* and a stitch act on the complex as it is now, as the library's do: a cut   *)
(* floods the present complex, a stitch merges present vertices, and neither  *)
(* starts anew from the original. The theorems say that they might as well:   *)
(* the state is unglue of the original by the scored set.                     *)
(*        incision V T == the ids of the vertices (names), the vertex of each *)
(*                        corner (label), the vertex of the start that each   *)
(*                        is a copy of (original), and the scored facets, by  *)
(*                        their vertices at the start; Incision. Ids are of   *)
(*                        any finite type, for they are mere handles.         *)
(*             now M s == the complex as it is now; Incision::complex. The    *)
(*                        complex M is the one at the start.                  *)
(*               start == the incision that has nothing scored                *)
(*            shut M s == the scored facets that have mates now;              *)
(*                        Incision::shut                                      *)
(*           cut M s F == unglue of the present complex by F and the shut     *)
(*                        facets (now_cut); Incision::cut. Opened facets have *)
(*                        no mates any more and need not be named again.      *)
(*    across M s F w w' == some facet of F is opened, and w and w' are copies *)
(*                        of one of its vertices, on its two sides; such pairs*)
(*                        are united by Merging::across of stitch.cpp         *)
(*        stays M s F w == the vertex that stays of all that are united with w*)
(*        stitch M s F == every present vertex w becomes stays M s F w        *)
(*                        (now_stitch), and F is scored no longer;            *)
(*                        Incision::stitch                                    *)
(*           sound M s == two corners share a vertex now if and only if facets*)
(*                        that are not scored connect them                    *)
(*       run M s steps == cuts and stitches one after the other               *)
(* What a stitch does needs no hypothesis on the complex (T12_stitch), nor    *)
(* that it follows a cut of the whole scored set. Only the start has to be    *)
(* cut-regular: at a vertex that pinches even the empty cut parts the star,   *)
(* and no stitch joins what no facet joins (T12_regular). The library's       *)
(* Complex is cut-regular; assemble_regularized makes it so.                  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Record incision (V T : finType) := Incision {
  names : finType;
  original : names -> V;
  label : V * T -> names;
  labelK : forall x, original (label x) = x.1;
  scored : {set {set V}}
}.
Arguments original {V T} i _.
Arguments label {V T} i _.

Section Incision.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (s : incision V T) (t u : T) (v : V) (C F : {set {set V}}).
Implicit Types (x y h k : V * T).

Definition now s : complex n (names s) T := relabel M (labelK s).

Definition start : incision V T := @Incision V T V id fst (fun=> erefl) set0.

Definition shut s : {set {set V}} :=
  [set f in scored s | [exists h, exists k,
     mates (now s) h k && (original s @: facet (now s) h == f)]].

Section Cut.
Variables (s : incision V T) (F : {set {set V}}).
Let D : {set {set names s}} := lifted (original s) (shut s :|: F).

Definition cut_label x := copy (now s) D (up (label s) x).

Lemma cut_labelK x : original s (cut_label x).1 = x.1.
Proof. by rewrite /cut_label copyK labelK. Qed.

Definition cut : incision V T :=
  @Incision V T (prod_finType (names s) T) (original s \o fst) cut_label cut_labelK
            (scored s :|: F).

Lemma now_cut t : now cut t = unglue (now s) D t.
Proof. by rewrite [RHS]/= /relabelled -imset_comp. Qed.

End Cut.

Section Stitch.
Variables (s : incision V T) (F : {set {set V}}).

Definition across : rel (names s) := fun w w' => [exists h, exists k, exists v,
  [&& mates M h k, ~~ mates (now s) (up (label s) h) (up (label s) k), facet M h \in F,
      v \in facet M h & (w, w') == (label s (v, h.2), label s (v, k.2))]].

Lemma acrossP w w' :
  reflect (exists h k v,
             [/\ mates M h k, ~~ mates (now s) (up (label s) h) (up (label s) k), facet M h \in F,
                 v \in facet M h & (w, w') = (label s (v, h.2), label s (v, k.2))])
          (across w w').
Proof.
apply: (iffP existsP) => -[h].
  by case/existsP=> k /existsP[v /and5P[hk o hF vh /eqP e]]; exists h, k, v.
case=> k [v [hk o hF vh e]]; exists h; apply/existsP; exists k; apply/existsP; exists v.
by rewrite hk o hF vh e eqxx.
Qed.

Lemma across_sym : connect_sym across.
Proof.
suff sym w w' : across w w' -> across w' w.
  by apply/sym_connect_sym => w w'; apply/idP/idP; exact: sym.
move=> /acrossP[h [k [v [hk o hF vh [-> ->]]]]]; apply/acrossP; exists k, h, v.
have /and4P[_ _ _ /eqP <-] := hk.
by rewrite mates_sym hk mates_sym o.
Qed.

Lemma original_across w w' : connect across w w' -> original s w = original s w'.
Proof.
by apply: connect_inv => {}w {}w' /acrossP[h [k [v [_ _ _ _ [-> ->]]]]]; rewrite !labelK.
Qed.

Definition stays (w : names s) : names s := root across w.

Lemma stays_eq w w' : (stays w == stays w') = connect across w w'.
Proof. exact/root_connect/across_sym. Qed.

Lemma stitch_labelK x : original s (stays (label s x)) = x.1.
Proof. by rewrite -(original_across (connect_root _ _)) labelK. Qed.

Definition stitch : incision V T := Incision stitch_labelK (scored s :\: F).

Lemma now_stitch t : now stitch t = stays @: now s t.
Proof. by rewrite [RHS]/= -imset_comp. Qed.

(* T12: a stitch makes the half-facets of each facet that it takes back mates
   again, and leaves all others that are mates what they are.                 *)
Theorem T12_mates h k :
  mates M h k -> (facet M h \in F) || mates (now s) (up (label s) h) (up (label s) k) ->
  mates (now stitch) (up (label stitch) h) (up (label stitch) k).
Proof.
move=> hk closes; rewrite mates_relabel hk; apply/forall_inP => v vh /=; rewrite stays_eq.
have [|o] := boolP (mates (now s) (up (label s) h) (up (label s) k)).
  by rewrite mates_relabel => /andP[_ /forall_inP/(_ v vh)/eqP->].
rewrite (negPf o) orbF in closes.
by apply/connect1/acrossP; exists h, k, v.
Qed.

End Stitch.

Definition sound s := {in corner M &, forall x y,
  (label s x == label s y) = connect (glue M (scored s)) x y}.

Lemma glue_corner C x y : glue M C x y -> corner M x /\ corner M y.
Proof. by case: x y => v t [w u] /and4P[/= /eqP<-]; rewrite inE => /andP[]. Qed.

Lemma sound_respects s : sound s -> respects M (label s) (scored s).
Proof.
move=> ok x y g; have [cx cy] := glue_corner g.
by apply/eqP; rewrite ok //; exact: connect1.
Qed.

Lemma sound_start : cut_regular M -> sound start.
Proof.
move=> r [v t] [w u] vt wu /=; apply/eqP/idP => [e|/connect_fst//].
by subst w; apply: r.
Qed.

(* The opened facets have no say in a cut.                                    *)
Lemma glue_shut s F : glue (now s) (lifted (original s) (shut s :|: F))
                   =2 glue (now s) (lifted (original s) (scored s :|: F)).
Proof.
move=> x y; rewrite /glue; case a: (adjacent _ _ _); last by rewrite !andbF.
do 3![congr (_ && _)]; congr (~~ _).
have e : original s @: common (now s) x.2 y.2 = common M x.2 y.2 by exact: p_common_adjacent.
rewrite !in_lifted e !in_setU; congr (_ || _); rewrite inE.
case: (_ \in scored s) => //=; have [v [w vw]] := adjacent_mates a.
apply/existsP; exists (v, x.2); apply/existsP; exists (w, y.2).
by rewrite vw -(mates_common vw) e eqxx.
Qed.

Lemma cut_sound s F : respects M (label s) (scored s :|: F) -> sound (cut s F).
Proof.
move=> r x y _ _; rewrite /= copy_eq (eq_connect (glue_shut F)).
exact: connect_relabel.
Qed.

Lemma sound_cut_start C : sound (cut start C).
Proof. by apply: cut_sound => x y /and4P[/eqP]. Qed.

Lemma sound_cut s F : sound s -> sound (cut s F).
Proof.
move=> ok; apply: cut_sound => x y /(glue_subrel (subsetUl _ _)).
exact: sound_respects.
Qed.

Lemma sound_stitch s F : sound s -> sound (stitch s F).
Proof.
move=> ok x y cx cy; rewrite [LHS]/= stays_eq; apply/idP/idP => [|g].
  have glued a b : corner M a -> corner M b -> label s a = label s b ->
      connect (glue M (scored s :\: F)) a b.
    by move=> ca cb /eqP; rewrite ok //; apply: connect_subset; exact: subsetDl.
  move=> /(@connect_stay _ _ (fun w => forall a, corner M a -> label s a = w ->
    connect (glue M (scored s :\: F)) x a)) => stay.
  apply: stay cy erefl => [w w' /acrossP[h [k [v [hk _ hF vh [-> ->]]]]] xw a ca ea|a ca ea].
    have vhk : v \in common M h.2 k.2 by rewrite (mates_common hk).
    have [vt vu] : corner M (v, h.2) /\ corner M (v, k.2) by apply/andP; rewrite inE in vhk.
    apply: connect_trans (xw _ vt erefl) _; apply: connect_trans (glued _ _ vu ca (esym ea)).
    by apply: connect1; rewrite /glue /= eqxx vhk (mates_adjacent hk) (mates_common hk) inE hF.
  exact: glued.
apply: connect_homo g => {cx cy} {}x {}y {}g; have [cx cy] := glue_corner g.
have [e [h [k [hx ky hk xh nCF]]]] := glueP _ _ _ _ g.
have [->|other] := eqVneq (label s x) (label s y); first exact: connect0.
have hC : facet M h \in scored s.
  apply: contraR other => nC; rewrite ok //; apply/connect1/glueP.
  by split=> //; exists h, k.
apply/connect1/acrossP; exists h, k, x.1; split=> //.
- apply: contra other; rewrite mates_relabel => /andP[_ /forall_inP/(_ _ xh)].
  by rewrite hx ky -surjective_pairing e -surjective_pairing.
- by move: nCF; rewrite inE hC andbT negbK.
- by rewrite hx ky -surjective_pairing e -surjective_pairing.
Qed.

Inductive step := Cut of {set {set V}} | Stitch of {set {set V}}.

Definition make s st := match st with Cut F => cut s F | Stitch F => stitch s F end.
Definition run := foldl make.

Lemma sound_make s st : sound s -> sound (make s st).
Proof. by case: st => F; [exact: sound_cut | exact: sound_stitch]. Qed.

Lemma sound_run s steps : sound s -> sound (run s steps).
Proof. by elim: steps s => //= st steps IH s /(sound_make st); exact: IH. Qed.

Section Theorems.
Variable t0 : T.

Lemma sound_isomorphic s s' :
  sound s -> sound s' -> scored s = scored s' -> isomorphic (now s) (now s').
Proof.
move=> ok ok' e; apply: relabel_iso (labelK s) (labelK s') t0 _ => x y cx cy.
by rewrite ok // ok' // e.
Qed.

Lemma sound_unglue s : sound s -> isomorphic (now s) (unglue M (scored s)).
Proof.
move=> ok; apply: relabel_iso (labelK s) (copyK M (scored s)) t0 _ => x y cx cy.
by rewrite ok // copy_eq.
Qed.

(* T12: to stitch some facets of a cut is to cut the others from the start.   *)
Theorem T12_stitch C F : isomorphic (now (stitch (cut start C) F)) (unglue M (C :\: F)).
Proof. by have := sound_unglue (sound_stitch F (sound_cut_start C)); rewrite /= set0U. Qed.

(* T12: whatever was cut and stitched, the state is unglue of the original by
   the scored set.                                                            *)
Theorem T12_state steps : cut_regular M ->
  isomorphic (now (run start steps)) (unglue M (scored (run start steps))).
Proof. by move=> r; apply/sound_unglue/sound_run/sound_start. Qed.

(* T12: the state depends on the scored set alone, not on the way to it.      *)
Theorem T12_alone steps steps' : cut_regular M ->
  scored (run start steps) = scored (run start steps') ->
  isomorphic (now (run start steps)) (now (run start steps')).
Proof. by move=> r; apply: sound_isomorphic => //; exact/sound_run/sound_start. Qed.

(* T12: when every scored facet is stitched, the start is back.               *)
Theorem T12_back steps : cut_regular M ->
  scored (run start steps) = set0 -> isomorphic (now (run start steps)) M.
Proof.
move=> r e; apply: isomorphic_trans (T12_state steps r) _.
by rewrite e; exact: T5_empty_cut.
Qed.

(* T12: two cuts in either order, and both at once, give the same.            *)
Theorem T12_order s A B : sound s ->
  isomorphic (now (cut (cut s A) B)) (now (cut (cut s B) A)) /\
  isomorphic (now (cut (cut s A) B)) (now (cut s (A :|: B))).
Proof.
move=> ok; split; apply: sound_isomorphic => /=.
- exact/sound_cut/sound_cut.
- exact/sound_cut/sound_cut.
- exact: setUAC.
- exact/sound_cut/sound_cut.
- exact: sound_cut.
- by rewrite setUA.
Qed.

(* T12: to undo a cut is to stitch the facets that it scored, and to undo a
   stitch is to cut the facets that it took back.                             *)
Theorem T12_undo s F : sound s ->
  isomorphic (now (stitch (cut s F) (F :\: scored s))) (now s) /\
  isomorphic (now (cut (stitch s F) (F :&: scored s))) (now s).
Proof.
move=> ok; split; apply: sound_isomorphic => //=.
- exact/sound_stitch/sound_cut.
- by apply/setP=> f; rewrite !inE; case: (f \in scored s); case: (f \in F).
- exact/sound_cut/sound_stitch.
- by apply/setP=> f; rewrite !inE; case: (f \in scored s); case: (f \in F).
Qed.

(* Splits are counted, so no other isomorphism can hide one.                  *)
Lemma isomorphic_regular C : isomorphic (unglue M C) M -> regular M C.
Proof.
move=> /isomorphic_card e; apply: T5_converse; apply/imset_injP/eqP.
by rewrite -(used_image (M := unglue M C) (N := M)) // => t; rewrite T1_proj.
Qed.

(* T12: whatever is cut, to stitch it all gives the start back if and only if
   the start was cut-regular.                                                 *)
Theorem T12_regular C : isomorphic (now (stitch (cut start C) C)) M <-> cut_regular M.
Proof.
have i := T12_stitch C C; rewrite setDv in i.
split=> [j|r]; last exact: isomorphic_trans i (T5_empty_cut r).
by apply: isomorphic_regular; apply: isomorphic_trans j; exact: isomorphic_sym.
Qed.

End Theorems.
End Incision.
