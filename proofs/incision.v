(* incision.v : cutting in many steps, and taking cuts back (T12).            *)
(*                                                                            *)
(* An incision is a complex together with its scored facets: all facets that  *)
(* were asked for and not taken back.  The complex as it is now is a          *)
(* relabelling of the original one.  Cutting and stitching act on the complex *)
(* as it is now, as the library does: a cut floods the corners of the present *)
(* complex, a stitch merges present vertices; neither starts anew from the    *)
(* original.  The theorems say that they might as well: the state is unglue   *)
(* of the original by the scored set.                                         *)
(*                                                                            *)
(*   incision M == vertex ids (names), the original vertex of each (parent),  *)
(*             the vertex of each corner (label), and the scored facets, by   *)
(*             their vertices in the original; Incision in incision.hpp.      *)
(*             The ids are any finite type, since they are mere handles.      *)
(*       now s == the complex as it is now; Incision::complex().              *)
(*       start == the original complex, nothing scored.                       *)
(*      shut s == the scored facets that are interior; Incision::shut().      *)
(*     cut s F == unglue of the present complex by F and the shut facets;     *)
(*             Incision::cut.  Opened facets need not be named again.         *)
(*  across s F == the two sides of an opened facet of F have these vertices,  *)
(*             copies of one original; Merging::across in stitch.cpp.         *)
(* stays s F w == the vertex that stays of those that become one with w;      *)
(*             VertexUnions::stays.                                           *)
(*  stitch s F == every present vertex w becomes stays s F w, and F is scored *)
(*             no longer; Incision::stitch.                                   *)
(*  sound s == two corners share a vertex now iff a chain of facets that are  *)
(*             not scored joins them: the partition is that of unglue.        *)
(* operation, run s ops == cuts and stitches in any order.                    *)
(*                                                                            *)
(* T12_stitch needs no hypothesis on the complex, and the others need         *)
(* cut-regular only because a stitch cannot bring back a vertex that pinches: *)
(* the first cut at it, even an empty one, parts its star for good            *)
(* (T12_regular: stitching all gives the start back iff it is cut-regular).   *)
(* The library's Complex is cut-regular by construction.                      *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Incision.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C F : {set {set V}}) (x y : V * T).

Record incision := Incision {
  names : finType;
  parent : names -> V;
  label : V * T -> names;
  labelK : forall x, parent (label x) = x.1;
  scored : {set {set V}} }.
Arguments parent : clear implicits.
Implicit Type s : incision.

Definition now s : complex n (names s) T := relabel M (labelK s).

Definition start : incision := @Incision V id fst (fun=> erefl) set0.

Definition shut s : {set {set V}} :=
  [set f in scored s | [exists t, exists u, adjacent (now s) t u && (common M t u == f)]].

Section Cut.
Variables (s : incision) (F : {set {set V}}).
Let D : {set {set names s}} := lifted (parent s) (shut s :|: F).

Definition cut_label x : names s * T := copy (now s) D (up (label s) x).
Lemma cut_labelK x : parent s (cut_label x).1 = x.1.
Proof. by rewrite /cut_label copyK labelK. Qed.
Definition cut : incision :=
  @Incision (prod_finType (names s) T) (fun w => parent s w.1) cut_label cut_labelK
            (scored s :|: F).

(* A cut is unglue of the complex as it is now.                               *)
Lemma now_cut t : now cut t = unglue (now s) D t.
Proof. by rewrite unglueE [RHS]/= -imset_comp. Qed.

End Cut.

Section Stitch.
Variables (s : incision) (F : {set {set V}}).

Definition across : rel (names s) := fun w w' =>
  [exists t, exists u, [&& adjacent M t u, ~~ adjacent (now s) t u, common M t u \in F &
     [exists v in common M t u, (w == label s (v, t)) && (w' == label s (v, u))]]].

Lemma acrossP w w' :
  reflect (exists v t u, [/\ adjacent M t u, ~~ adjacent (now s) t u, common M t u \in F,
                             v \in common M t u & (w, w') = (label s (v, t), label s (v, u))])
          (across w w').
Proof.
apply: (iffP existsP) => [[t /existsP[u /and4P[a na iF /exists_inP[v vi /andP[/eqP-> /eqP->]]]]]|].
  by exists v, t, u.
move=> [v [t [u [a na iF vi [-> ->]]]]]; exists t; apply/existsP; exists u.
by rewrite a na iF; apply/exists_inP; exists v; rewrite ?eqxx.
Qed.

Lemma across_sym : connect_sym across.
Proof.
apply/sym_connect_sym => w w'; apply/acrossP/acrossP => -[v [t [u [a na iF vi [-> ->]]]]];
  by exists v, u, t; rewrite adjacentC commonC [adjacent (now s) _ _]adjacentC.
Qed.

Lemma parent_across w w' : connect across w w' -> parent s w = parent s w'.
Proof.
move=> /connectP[p + ->{w'}]; elim: p w => [|z p IHp] w //= /andP[/acrossP wz /IHp <-].
by case: wz => v [t [u [_ _ _ _ [-> ->]]]]; rewrite !labelK.
Qed.

Definition stays (w : names s) : names s := root across w.

Lemma stays_eq w w' : (stays w == stays w') = connect across w w'.
Proof. exact/root_connect/across_sym. Qed.

Lemma stitch_labelK x : parent s (stays (label s x)) = x.1.
Proof. by rewrite -(parent_across (connect_root _ _)) labelK. Qed.

Definition stitch : incision := Incision stitch_labelK (scored s :\: F).

(* A stitch merges vertices of the complex as it is now.                      *)
Lemma now_stitch t : now stitch t = stays @: now s t.
Proof. by rewrite [RHS]/= -imset_comp. Qed.

End Stitch.

Definition sound s := {in corner M &, forall x y,
  (label s x == label s y) = connect (glue M (scored s)) x y}.

Lemma glue_corner C x y : glue M C x y -> corner M x /\ corner M y.
Proof.
by case: x y => v t [w u] /and4P[/= /eqP<-]; rewrite inE => /andP[].
Qed.

Lemma sound_respects s : sound s -> respects M (label s) (scored s).
Proof.
move=> ok x y g; have [cx cy] := glue_corner g.
by apply/eqP; rewrite ok //; exact: connect1.
Qed.

(* A cut needs the shut facets and the new ones only: an opened facet has no  *)
(* mate that could be severed again.                                          *)
Lemma glue_shut s F : glue (now s) (lifted (parent s) (shut s :|: F))
                   =2 glue (now s) (lifted (parent s) (scored s :|: F)).
Proof.
move=> x y; rewrite /glue; case a: (adjacent _ _ _); last by rewrite !andbF.
do 3![congr (_ && _)]; congr (~~ _).
have e : parent s @: common (now s) x.2 y.2 = common M x.2 y.2 by exact: p_common_adjacent.
rewrite !in_lifted e !in_setU; congr (_ || _); rewrite inE.
case: (_ \in scored s) => //=; apply/existsP; exists x.2; apply/existsP; exists y.2.
by rewrite a eqxx.
Qed.

Lemma cut_sound s F : respects M (label s) (scored s :|: F) -> sound (cut s F).
Proof.
move=> r x y _ _; rewrite /= /cut_label copy_eq (eq_connect (glue_shut F)).
exact: connect_relabel.
Qed.

Lemma sound_cut s F : sound s -> sound (cut s F).
Proof.
move=> ok; apply: cut_sound => x y /(glue_subrel (subsetUl _ _)).
exact: sound_respects.
Qed.

Lemma sound_stitch s F : sound s -> sound (stitch s F).
Proof.
move=> ok x y cx cy; rewrite /= stays_eq.
have up_ok a b : corner M a -> corner M b -> label s a = label s b ->
    connect (glue M (scored s :\: F)) a b.
  by move=> ca cb /eqP; rewrite ok //; apply: connect_subset; exact: subsetDl.
apply/idP/idP => [/connectP[p]|].
  elim: p x cx => [|w p IHp] x cx /= => [_ e|]; first exact: up_ok.
  case/andP=> /acrossP[v [t [u [a _ iF vi [ex ->]]]]] wp wy.
  have [vt vu] : corner M (v, t) /\ corner M (v, u) by apply/andP; rewrite inE in vi.
  apply: connect_trans (up_ok _ _ cx vt ex) _.
  apply: connect_trans (IHp _ vu wp wy); apply: connect1.
  by rewrite /glue /= eqxx vi a inE iF.
apply: (@connect_homo _ _ _ _ (label s)) => {cx cy} {}x {}y g.
have [cx cy] := glue_corner g; have [/eqP xy vi a nCF] := and4P g.
have [same|other] := eqVneq (label s x) (label s y); first by rewrite same connect0.
case: x y xy vi a nCF {g} cx cy other => v t [w u] /= <- vi a nCF cx cy other.
have iC : common M t u \in scored s.
  apply: contraR other => nC; rewrite ok //; apply: connect1.
  by rewrite /glue /= eqxx vi a nC.
apply/connect1/acrossP; exists v, t, u; split=> //; last first.
  by move: nCF; rewrite inE iC andbT negbK.
by apply: contra other; rewrite adjacent_relabel => /andP[_ /forall_inP->].
Qed.

Lemma sound_start : cut_regular M -> sound start.
Proof.
move=> r [v t] [w u] vt wu /=; apply/eqP/idP => [e|/connect_fst//].
by subst w; apply: r.
Qed.

(* Sound incisions with the same scored set are the same up to the ids.       *)
Lemma sound_isomorphic (t0 : T) s s' :
  sound s -> sound s' -> scored s = scored s' -> isomorphic (now s) (now s').
Proof.
move=> ok ok' e; apply: relabel_iso (labelK s) (labelK s') t0 _ => x y cx cy.
by rewrite ok // ok' // e.
Qed.

Lemma sound_unglue (t0 : T) s : sound s -> isomorphic (now s) (unglue M (scored s)).
Proof.
move=> ok; apply: relabel_iso (labelK s) (copyK M (scored s)) t0 _ => x y cx cy.
by rewrite ok // copy_eq.
Qed.

Lemma sound_cut_start C : sound (cut start C).
Proof. by apply: cut_sound => x y /and4P[/eqP]. Qed.

(* T12: a cut of the original complex is unglue.                              *)
Theorem T12_cut (t0 : T) C : isomorphic (now (cut start C)) (unglue M C).
Proof. by have := sound_unglue t0 (sound_cut_start C); rewrite /= set0U. Qed.

(* T12: to stitch some facets of a cut is to cut the others from the start.   *)
Theorem T12_stitch (t0 : T) C F :
  isomorphic (now (stitch (cut start C) F)) (unglue M (C :\: F)).
Proof.
have := sound_unglue t0 (sound_stitch F (sound_cut_start C)).
by rewrite /= set0U.
Qed.

Inductive operation := Cut of {set {set V}} | Stitch of {set {set V}}.

Definition perform s o := match o with Cut F => cut s F | Stitch F => stitch s F end.
Definition run := foldl perform.

Lemma sound_run s ops : sound s -> sound (run s ops).
Proof.
elim: ops s => [|[] F ops IHops] s ok //=; apply: IHops.
  exact: sound_cut.
exact: sound_stitch.
Qed.

(* T12: whatever was cut and stitched, the state is unglue of the original by *)
(* the scored set.                                                            *)
Theorem T12_state (t0 : T) ops : cut_regular M ->
  isomorphic (now (run start ops)) (unglue M (scored (run start ops))).
Proof. by move=> r; apply/sound_unglue/sound_run/sound_start. Qed.

(* T12: the state depends on the scored set alone, not on the way to it.      *)
Theorem T12_alone (t0 : T) ops ops' : cut_regular M ->
  scored (run start ops) = scored (run start ops') ->
  isomorphic (now (run start ops)) (now (run start ops')).
Proof. by move=> r; apply: sound_isomorphic => //; exact/sound_run/sound_start. Qed.

(* T12: when every scored facet is stitched, the start is back.               *)
Theorem T12_back (t0 : T) ops : cut_regular M ->
  scored (run start ops) = set0 -> isomorphic (now (run start ops)) M.
Proof.
move=> r e; apply: isomorphic_trans (T12_state t0 ops r) _.
by rewrite e; exact: T5_empty_cut.
Qed.

(* T12: two cuts in either order, and both at once, give the same.            *)
Theorem T12_order (t0 : T) s A B : sound s ->
  isomorphic (now (cut (cut s A) B)) (now (cut (cut s B) A)) /\
  isomorphic (now (cut (cut s A) B)) (now (cut s (A :|: B))).
Proof.
move=> ok; split; apply: sound_isomorphic => //; do ?[exact: ok | apply: sound_cut].
  by rewrite /= setUAC.
by rewrite /= setUA.
Qed.

(* T12: undo of a cut is to stitch the facets that it scored.                 *)
Theorem T12_undo_cut (t0 : T) s F : sound s ->
  isomorphic (now (stitch (cut s F) (F :\: scored s))) (now s).
Proof.
move=> ok; apply: sound_isomorphic => //; first exact/sound_stitch/sound_cut.
apply/setP=> f; rewrite !inE; by case: (f \in scored s); case: (f \in F).
Qed.

(* T12: undo of a stitch is to cut the facets that it took back.              *)
Theorem T12_undo_stitch (t0 : T) s F : sound s ->
  isomorphic (now (cut (stitch s F) (F :&: scored s))) (now s).
Proof.
move=> ok; apply: sound_isomorphic => //; first exact/sound_cut/sound_stitch.
apply/setP=> f; rewrite !inE; by case: (f \in scored s); case: (f \in F).
Qed.

(* An isomorphism of any kind shows that no vertex pinches, not only parent.  *)
Lemma isomorphic_used (W W' : finType) (N : complex n W T) (N' : complex n W' T) :
  isomorphic N N' -> #|used N| = #|used N'|.
Proof.
case=> f fi fN; rewrite -(card_in_imset fi); apply: eq_card => w; apply/imsetP/usedP.
  by case=> v /usedP[t vt] ->; exists t; rewrite fN imset_f.
by case=> t; rewrite fN => /imsetP[v vt ->]; exists v => //; apply/usedP; exists t.
Qed.

Lemma isomorphic_regular C : isomorphic (unglue M C) M -> regular M C.
Proof.
move=> /isomorphic_used e; apply: T5_converse; apply/imset_injP.
rewrite e; apply/eqP/eq_card => v; apply/imsetP/usedP => [[w /usedP[t wt] ->]|[t vt]].
  by exists t; rewrite -(T1_proj M C) imset_f.
exists (copy M C (v, t)); last by rewrite copyK.
by apply/usedP; exists t; exact: mem_copy.
Qed.

(* T12: cut anything and stitch it all: the start is back iff it was          *)
(* cut-regular.                                                               *)
Theorem T12_regular (t0 : T) C :
  isomorphic (now (stitch (cut start C) C)) M <-> cut_regular M.
Proof.
have i := T12_stitch t0 C C; rewrite setDv in i.
split=> [j|r]; last exact: isomorphic_trans i (T5_empty_cut r).
by apply: isomorphic_regular; apply: isomorphic_trans j; exact: isomorphic_sym.
Qed.

End Incision.
Arguments parent {V T} i _.
Arguments label {V T} i _.
