(******************************************************************************)
(* What is written of an incision (T12): the complex with the canonical       *)
(* numbers for vertices. Incisions with the same scored set give, number for  *)
(* number, the same file.                                                     *)
(*         file_id s x == the canonical number of the vertex of the corner x, *)
(*                        in a type with room for those of every incision     *)
(* canonical_complex s == the complex of s with these numbers for vertices    *)
(*     corner_number o == (n + 1) * cell + local index, the C++ CornerId; o   *)
(*                        lists the vertices of each cell as the file does    *)
(*             row o s == the rows of numbers that are written, cell by cell  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex isomorphism relabelling orientation incision canonical.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section CanonicalComplex.
Variables (n : nat) (V T : finType) (M : complex n V T) (rank : V * T -> nat).
Hypothesis rank_inj : {in corner M &, injective rank}.
Implicit Types (v : V) (t u : T) (x y z : V * T).
Local Notation canonical := (canonical M rank).
Local Notation copies := (copies M rank).

Section State.
Variable s : incision V T.
Let number := canonical (label s).
Let bound := #|V| + #|{: V * T}|.

Lemma label_home : {in corner M &, forall x y, label s x = label s y -> x.1 = y.1}.
Proof. by move=> x y _ _ /(congr1 (original s)); rewrite !labelK. Qed.

Lemma number_inj x y : corner M x -> corner M y ->
  (number x == number y) = (label s x == label s y).
Proof. exact: (T12_canonical_injective rank_inj label_home). Qed.

Lemma size_copies : size (copies (label s)) <= #|{: V * T}|.
Proof. by rewrite -(card_uniqP (copies_uniq _ _ _)) max_card. Qed.

Definition file_id x : 'I_bound.+1 := inord (number x).
Lemma val_file_id x : corner M x -> file_id x = number x :> nat.
Proof.
move=> cx; rewrite inordK // ltnS (leq_trans (ltnW (canonical_lt rank_inj label_home cx))) //.
by rewrite leq_add2l size_copies.
Qed.

Lemma file_id_eq x y : corner M x -> corner M y ->
  (file_id x == file_id y) = (label s x == label s y).
Proof. by move=> cx cy; rewrite -val_eqE /= !val_file_id // number_inj. Qed.

Definition canonical_cell t := [set file_id (v, t) | v in M t].

Lemma card_canonical_cell t : #|canonical_cell t| = n.+1.
Proof.
rewrite card_in_imset ?card_vertices // => v w vt wt /eqP.
by rewrite file_id_eq // => /eqP/label_home; exact.
Qed.

Lemma canonical_cell_inj : injective canonical_cell.
Proof.
suff sub t u : canonical_cell t = canonical_cell u -> now M s t \subset now M s u.
  by move=> t u e; apply: (vertices_inj (c := now M s)); apply/eqP; rewrite eqEsubset !sub.
move=> e; apply/subsetP=> _ /imsetP[v vt ->].
have : file_id (v, t) \in canonical_cell u by rewrite -e; apply/imsetP; exists v.
by case/imsetP=> w wu /eqP; rewrite file_id_eq // => /eqP->; apply/imsetP; exists w.
Qed.

Definition canonical_complex := Complex card_canonical_cell canonical_cell_inj.

(* T12: the canonical numbers rename vertices, and change nothing else.       *)
Theorem T12_canonical_isomorphic : isomorphic (now M s) canonical_complex.
Proof.
pose f w := if [pick x | corner M x && (label s x == w)] is Some x then file_id x else ord0.
have fE x : corner M x -> f (label s x) = file_id x.
  move=> cx; rewrite /f; case: pickP => [y /andP[cy]|/(_ x)]; last by rewrite cx eqxx.
  by rewrite -file_id_eq // => /eqP.
exists f => [w w'|t].
  rewrite !used_relabel => /imsetP[x cx ->] /imsetP[y cy ->]; rewrite !fE // => /eqP.
  by rewrite file_id_eq // => /eqP.
by rewrite /= /relabelled -imset_comp; apply: eq_in_imset => v vt /=; rewrite fE.
Qed.

(* T12: if every original vertex is one of a cell, the numbers of the k
   vertices are 0 to k - 1.                                                   *)
Theorem T12_canonical_count i : used M = setT ->
  i < #|used (now M s)| <-> exists2 x, corner M x & number x = i.
Proof.
move=> all; rewrite -(T12_canonical_range rank_inj label_home) //.
rewrite -(isomorphic_card T12_canonical_isomorphic).
suff -> : #|used canonical_complex| = #|V| + size (copies (label s)) by [].
have le : #|V| + size (copies (label s)) <= bound.+1.
  by rewrite leqW // leq_add2l size_copies.
have inj : injective (widen_ord le) by move=> j k /(congr1 val) /= /ord_inj.
rewrite -[RHS]card_ord -(card_imset _ inj).
apply: eq_card => j; apply/usedP/imsetP => [[t /imsetP[v vt ->]]|[k _ ->]].
  have lt := canonical_lt rank_inj label_home (vt : (v, t) \in corner M).
  by exists (Ordinal lt) => //; apply: ord_inj; rewrite val_file_id.
have [[v t] vt e] := (T12_canonical_range rank_inj label_home k all).1 (ltn_ord k).
exists t; apply/imsetP; exists v => //.
by apply: ord_inj; rewrite val_file_id.
Qed.

End State.

(* T12: equal scored sets give equal complexes, number for number, whatever
   was cut and stitched before, in whatever order.                            *)
Theorem T12_canonical s s' : sound M s -> sound M s' -> scored s = scored s' ->
  {in corner M, canonical (label s) =1 canonical (label s')} /\
  canonical_complex s =1 canonical_complex s'.
Proof.
move=> ok ok' e.
have same : {in corner M, canonical (label s) =1 canonical (label s')}.
  by apply: (T12_canonical_partition rank_inj) => x y cx cy; rewrite ok // ok' // e.
split=> // t; apply: eq_in_imset => v vt.
by rewrite /file_id same.
Qed.

End CanonicalComplex.

(* Corners are numbered cell by cell, in each cell as the file lists it.      *)
Section CornerNumber.
Variables (n : nat) (V T : finType) (M : complex n V T) (o : orientation M).

Definition corner_number (x : V * T) : nat := n.+1 * enum_rank x.2 + index x.1 (o x.2).

Lemma corner_number_inj : {in corner M &, injective corner_number}.
Proof.
have mem x : x \in corner M -> x.1 \in o x.2 by rewrite mem_tuple_of.
move=> [v t] [w u] /mem vt /mem wu; rewrite /corner_number /= => e.
have lt x : x.1 \in o x.2 -> index x.1 (o x.2) < n.+1 by rewrite -index_mem size_tuple.
have et : t = u.
  apply/enum_rank_inj/ord_inj; have := congr1 (fun k => k %/ n.+1) e.
  by rewrite !(mulnC n.+1) !divnMDl // !divn_small ?addn0 //; [exact: lt wu|exact: lt vt].
move: e vt wu; rewrite et => /addnI e vt wu.
by rewrite -[v](nth_index v vt) e nth_index.
Qed.

Definition row s t := [seq canonical M corner_number (label s) (v, t) | v <- o t].

(* T12: equal scored sets give equal files, row by row.                       *)
Theorem T12_rows steps steps' : cut_regular M ->
  let s := run M (start V T) steps in let s' := run M (start V T) steps' in
  scored s = scored s' -> row s =1 row s'.
Proof.
move=> r s s' e t; apply/eq_in_map => v vt.
have ok st : sound M (run M (start V T) st) by exact/sound_run/sound_start.
have [same _] := T12_canonical corner_number_inj (ok steps) (ok steps') e.
by apply: same; rewrite unfold_in /corner -(mem_tuple_of o).
Qed.

End CornerNumber.
