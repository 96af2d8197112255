(******************************************************************************)
(* Undo and redo (T12). The library keeps, of each step, the facets by which  *)
(* it changed the scored set, and nothing of the complex before it. This is   *)
(* enough, since the state depends on the scored set alone.                   *)
(*          after C st == the scored set after the step st, if it was C       *)
(*        changes C st == what of the step changes C: a cut keeps its facets  *)
(*                        not in C, a stitch those in C                       *)
(*      effective C st == all facets of st change C                           *)
(*          reverse st == the step that takes st back: a stitch for a cut, a  *)
(*                        cut for a stitch                                    *)
(*             history == an incision, and the steps that are done and those  *)
(*                        that are undone, the latest first; done_ and        *)
(*                        undone_ of Incision                                 *)
(*           beginning == the start, no steps                                 *)
(*      perform M h st == Incision::cut or Incision::stitch; it records what  *)
(*                        changes the scored set, and nothing if it stays     *)
(*            undo M h == Incision::undo; h itself if there is no step (there *)
(*                        the library throws)                                 *)
(*            redo M h == Incision::redo, likewise                            *)
(*         reached M h == h comes from the beginning by these three.          *)
(*                        Incision::forget_steps, which drops steps and leaves*)
(*                        the state, is left out: T12_history_start needs     *)
(*                        every step there was.                               *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex isomorphism unglue incision.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section History.
Variables (n : nat) (V T : finType) (M : complex n V T) (t0 : T).
Implicit Types (C F : {set {set V}}) (s : incision V T) (st : step V) (l : seq (step V)).

Definition after C st := match st with Cut F => C :|: F | Stitch F => C :\: F end.
Definition changes C st :=
  match st with Cut F => Cut (F :\: C) | Stitch F => Stitch (F :&: C) end.
Definition effective C st :=
  match st with Cut F => [disjoint F & C] | Stitch F => F \subset C end.
Definition reverse st := match st with Cut F => Stitch F | Stitch F => Cut F end.

Lemma scored_make s st : scored (make M s st) = after (scored s) st.
Proof. by case: st. Qed.

Lemma effective_changes C st : effective C (changes C st).
Proof.
case: st => F /=; last exact: subsetIr.
by rewrite -setI_eq0; apply/eqP/setP=> f; rewrite !inE; case: (f \in C) (f \in F) => -[].
Qed.

Lemma reverseK : involutive reverse. Proof. by case. Qed.

Lemma effective_reverse C st : effective C st -> effective (after C st) (reverse st).
Proof.
case: st => F /= _; first exact: subsetUr.
by rewrite -setI_eq0; apply/eqP/setP=> f; rewrite !inE; case: (f \in F).
Qed.

Lemma after_reverse C st : effective C st -> after (after C st) (reverse st) = C.
Proof.
case: st => F /= e; last by rewrite setUC -{1}(setIidPr e) setID.
by rewrite setDUl setDv setU0; apply/setDidPl; rewrite disjoint_sym.
Qed.

Record history := History {
  state : incision V T;
  done : seq (step V);
  undone : seq (step V)
}.
Implicit Type h : history.

Definition beginning : history := History (start V T) [::] [::].

Definition perform h st :=
  let C := scored (state h) in
  if after C st == C then h
  else History (make M (state h) (changes C st)) (changes C st :: done h) [::].

Definition undo h := if done h is st :: l
  then History (make M (state h) (reverse st)) l (st :: undone h) else h.

Definition redo h := if undone h is st :: l
  then History (make M (state h) st) (st :: done h) l else h.

Inductive reached : history -> Prop :=
| reached_beginning : reached beginning
| reached_perform h st : reached h -> reached (perform h st)
| reached_undo h : reached h -> reached (undo h)
| reached_redo h : reached h -> reached (redo h).

(* Step by step, l is effective.                                              *)
Fixpoint fits C l := if l is st :: l' then effective C st && fits (after C st) l' else true.

Definition consistent h := [/\ fits (scored (state h)) (map reverse (done h)),
  fits (scored (state h)) (undone h) &
  foldl after (scored (state h)) (map reverse (done h)) = set0].

Lemma reached_consistent h : reached h -> consistent h.
Proof.
elim=> {h} [//|h st _ ok|h _ ok|h _ ok].
- case: (ok) => fd fu e; rewrite /perform; case: eqP => // _.
  have ef := effective_changes (scored (state h)) st.
  by split; rewrite //= scored_make ?effective_reverse ?after_reverse.
- case: (ok) => fd fu e; rewrite /undo.
  case: (done h) fd e => [|st l] //= /andP[ef fl] e.
  have := effective_reverse ef; have := after_reverse ef; rewrite reverseK => back ef'.
  by split; rewrite /= scored_make ?ef' ?back.
- case: (ok) => fd fu e; rewrite /redo.
  case: (undone h) fu => [|st l] //= /andP[ef fl].
  by split; rewrite /= scored_make ?effective_reverse ?after_reverse.
Qed.

Lemma reached_sound h : cut_regular M -> reached h -> sound M (state h).
Proof.
move=> r; elim=> {h} [|h st _ ok|h _ ok|h _ ok]; first exact: sound_start.
- by rewrite /perform; case: eqP => // _; exact: sound_make.
- by rewrite /undo; case: (done h) => [|st l] //=; exact: sound_make.
- by rewrite /redo; case: (undone h) => [|st l] //=; exact: sound_make.
Qed.

(* T12: with undo and redo, too, the state is unglue of the original by the
   scored set.                                                                *)
Theorem T12_history h : cut_regular M -> reached h ->
  isomorphic (now M (state h)) (unglue M (scored (state h))).
Proof. by move=> r hh; apply/(sound_unglue t0)/reached_sound. Qed.

(* T12: undo after a step that changed the scored set gives the state before
   it.                                                                        *)
Theorem T12_history_undo h st : cut_regular M -> reached h ->
  after (scored (state h)) st != scored (state h) ->
  isomorphic (now M (state (undo (perform h st)))) (now M (state h)).
Proof.
move=> r hh /negPf new; apply: sound_isomorphic => //; try exact: reached_sound.
  by apply: reached_sound => //; apply/reached_undo/reached_perform.
by rewrite /undo /perform new /= !scored_make after_reverse ?effective_changes.
Qed.

(* T12: redo after an undo gives the state before the undo.                   *)
Theorem T12_history_redo h : cut_regular M -> reached h -> 0 < size (done h) ->
  isomorphic (now M (state (redo (undo h)))) (now M (state h)).
Proof.
move=> r hh d; apply: sound_isomorphic => //; try exact: reached_sound.
  by apply: reached_sound => //; apply/reached_redo/reached_undo.
have [fd _ _] := reached_consistent hh; move: fd d; rewrite /redo /undo.
case: (done h) => [|st l] //= /andP[ef _] _; rewrite !scored_make.
by have := after_reverse ef; rewrite reverseK.
Qed.

(* T12: when every step is undone, the start is back.                         *)
Theorem T12_history_start h : cut_regular M -> reached h -> done h = [::] ->
  isomorphic (now M (state h)) M.
Proof.
move=> r hh d; apply: isomorphic_trans (T12_history r hh) _.
have [_ _] := reached_consistent hh; rewrite d /= => ->.
exact: T5_empty_cut.
Qed.

End History.
