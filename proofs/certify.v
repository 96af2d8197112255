(******************************************************************************)
(* The certificate check: what `certify` decides, and why that is enough.     *)
(*                                                                            *)
(* `before` is a complex, C a cut. The result of a cut is a list of cells     *)
(* that corresponds to `before` position by position, so it gives each corner *)
(* x = (v, t) of `before` the vertex after x that stands in the place of v in *)
(* cell t. What `after` says of pairs that are no corners is never looked at. *)
(*                                                                            *)
(*           has_parents == corners that share a vertex after the cut shared  *)
(*                          one before: clause (a), no_parent in C++          *)
(*  uncut_mates_together == two cells give the vertices of an uncut facet the *)
(*                          same names: clause (b), uncut_mates_apart         *)
(*     classes_connected == corners that share a vertex after the cut are     *)
(*                          joined by a chain of uncut facets at that vertex: *)
(*                          clause (c), class_not_connected                   *)
(*             certified == all three                                         *)
(*        renames_unglue == `after` is unglue before C with its vertices      *)
(*                          renamed, one name for each                        *)
(*                                                                            *)
(* The first clause of C++, not_comparable, compares the numbers of cells; it *)
(* is in the type here and in certify_exec.v where `after` is a list.         *)
(* Theorems: certify_sound_complete, certified_isomorphic.                    *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Certify.
Variables (n : nat) (V T : finType) (W : eqType).
Variables (before : complex n V T) (C : {set {set V}}) (after : V * T -> W).
Implicit Types (x y : V * T) (t u : T) (v : V).

Definition has_parents := forall x y, corner before x -> corner before y ->
  after x = after y -> x.1 = y.1.

Definition uncut_mates_together := forall t u v,
  adjacent before t u -> common before t u \notin C -> v \in common before t u ->
  after (v, t) = after (v, u).

Definition classes_connected := forall x y, corner before x -> corner before y ->
  after x = after y -> connect (glue before C) x y.

Definition certified := [/\ has_parents, uncut_mates_together & classes_connected].

Definition renames_unglue := exists2 f : V * T -> W,
  {in used (unglue before C) &, injective f} &
  forall x, corner before x -> after x = f (copy before C x).

Lemma uncut_mates_glue : uncut_mates_together <->
  forall x y, glue before C x y -> after x = after y.
Proof.
split=> [b [v t] [w u] /and4P[/= /eqP<- vi a nC]|g t u v a nC vi]; first exact: b a nC vi.
by apply: g; rewrite /glue eqxx vi a nC.
Qed.

(* The clauses together say: one vertex after the cut is one class of unglue. *)
Lemma certifiedP : certified <-> forall x y, corner before x -> corner before y ->
  (after x == after y) = (copy before C x == copy before C y).
Proof.
split=> [[_ /uncut_mates_glue b c] x y cx cy|same].
  rewrite copy_eq; apply/eqP/idP => [|/connectP[s + ->]]; first exact: c.
  by elim: s x {cx cy} => //= z s IHs x /andP[/b-> /IHs].
have connected : classes_connected.
  by move=> x y cx cy e; rewrite -copy_eq -same // e.
split=> [x y cx cy /(connected x y cx cy)/connect_fst //||//].
apply/uncut_mates_glue => x y g; apply/eqP.
have cx : corner before x by case/and4P: g => _; rewrite inE => /andP[].
by rewrite same ?copy_eq ?connect1 // (connect_corner (connect1 g)).
Qed.

(* `certify` accepts exactly if `after` is unglue(before, cut) up to renaming *)
(* of vertices.                                                               *)
Theorem certify_sound_complete : certified <-> renames_unglue.
Proof.
split=> [/certifiedP same|[f inj fE]]; last first.
  apply/certifiedP => x y cx cy; rewrite !fE //; apply/eqP/eqP => [|->//].
  by apply: inj; rewrite used_relabel; apply/imsetP; [exists x | exists y].
exists after; last first.
  move=> x cx; apply/eqP; have [c r] : corner before (copy before C x) /\
    copy before C (copy before C x) = copy before C x.
    split; last by apply/eqP; rewrite copy_eq glue_csym connect_root.
    exact: connect_corner (connect_root _ _) cx.
  by rewrite same // r.
move=> w1 w2; rewrite used_relabel => /imsetP[x cx ->] /imsetP[y cy ->] /eqP.
have cc z : corner before z -> corner before (copy before C z).
  exact: connect_corner (connect_root _ _).
have rr z : copy before C (copy before C z) = copy before C z.
  by apply/eqP; rewrite copy_eq glue_csym connect_root.
by rewrite same ?cc // !rr => /eqP.
Qed.

End Certify.

(* With finitely many names, a certified `after` is a complex isomorphic to    *)
(* unglue(before, cut), cell by cell.                                         *)
Theorem certified_isomorphic n (V T W : finType) (before : complex n V T)
    (C : {set {set V}}) (after : V * T -> W) : certified before C after ->
  exists2 N : complex n W T, forall t, N t = [set after (v, t) | v in before t] &
  isomorphic (unglue before C) N.
Proof.
move=> /certify_sound_complete[f inj fE].
have cellE t : [set after (v, t) | v in before t] = f @: unglue before C t.
  rewrite -imset_comp; apply: eq_in_imset => v vt /=; exact: fE.
have mem_used t w : w \in unglue before C t -> w \in used (unglue before C).
  by move=> wt; apply/usedP; exists t.
have card t : #|[set after (v, t) | v in before t]| = n.+1.
  rewrite cellE card_in_imset ?card_vertices // => w1 w2 /mem_used u1 /mem_used u2.
  exact: inj.
have injective_cells : injective (fun t => [set after (v, t) | v in before t]).
  move=> t u; rewrite !cellE => e; apply: (vertices_inj (c := unglue before C)).
  apply/setP => w; apply/idP/idP => wt.
    have /imsetP[w' w'u ff] : f w \in f @: unglue before C u by rewrite -e imset_f.
    by rewrite (inj _ _ (mem_used _ _ wt) (mem_used _ _ w'u) ff).
  have /imsetP[w' w't ff] : f w \in f @: unglue before C t by rewrite e imset_f.
  by rewrite (inj _ _ (mem_used _ _ wt) (mem_used _ _ w't) ff).
by exists (Complex card injective_cells) => //; exists f.
Qed.
