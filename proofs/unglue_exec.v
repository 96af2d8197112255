(******************************************************************************)
(* unglue on lists, made to be extracted.                                     *)
(*                                                                            *)
(*         least s rows == for each name of the classes s, the first corner   *)
(*                         in rows that bears it                              *)
(*   canonical_name s m c == the first corner of the class of c               *)
(* unglue_exec n cells cut == the cells with their corners renamed: each row  *)
(*                         holds, for each corner, the first corner of its    *)
(*                         class; or why the lists are no complex and cut     *)
(*                                                                            *)
(* Theorem unglue_exec_correct: read as the cells after the cut, the result   *)
(* is unglue(before, cut). unglue_exec_least: a name is the least corner of   *)
(* its class, the canonical name of canonical.v.                              *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue certify listed_complex tries quick_find half_facets.
From Cleave Require Import listed prepare denote valid certify_exec.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition add_least (s : classes) (m : PositiveMap.t positive) (x : numbered) :=
  if find (name s x.2) m is Some _ then m else add (name s x.2) x.2 m.

Definition least (s : classes) (rows : seq (seq numbered)) : PositiveMap.t positive :=
  fold_corners (add_least s) (PositiveMap.empty positive) rows.

Definition canonical_name (s : classes) (m : PositiveMap.t positive) (c : positive) : positive :=
  if find (name s c) m is Some d then d else c.

Definition rev_map (A B : Type) (f : A -> B) (s : seq A) : seq B :=
  foldl (fun acc x => f x :: acc) [::] s.

Definition unglue_exec n (cells cut : seq (seq positive)) : problem + seq (seq positive) :=
  match prepare n cells cut with
  | inl p => inl p
  | inr p =>
      let s := classes_of (edges p) in
      let m := least s (corner_rows p) in
      inr (rev (rev_map (map (fun x : numbered => canonical_name s m x.2)) (corner_rows p)))
  end.

Lemma rev_mapE (A B : Type) (f : A -> B) s : rev (rev_map f s) = map f s.
Proof.
rewrite /rev_map -[RHS]/(rev [::] ++ _); elim: s [::] => [|x s IH] acc /=; first by rewrite cats0.
by rewrite IH rev_cons cat_rcons.
Qed.

(* The first corner of each class, when the corners come in increasing order.  *)
Lemma leastP s rows c : sorted ltn [seq num x.2 | x <- flatten rows] ->
  c \in [seq x.2 | x <- flatten rows] -> let d := canonical_name s (least s rows) c in
  [/\ d \in [seq x.2 | x <- flatten rows], name s d = name s c &
      {in [seq x.2 | x <- flatten rows], forall e, name s e = name s c -> num d <= num e}].
Proof.
rewrite /canonical_name /least fold_cornersE; move: (flatten rows) => l inc.
suff H : forall i, match find i (foldl (add_least s) (PositiveMap.empty positive) l) with
    | Some d => [/\ d \in [seq x.2 | x <- l], name s d = i &
        {in [seq x.2 | x <- l], forall e, name s e = i -> num d <= num e}]
    | None => {in [seq x.2 | x <- l], forall e, name s e != i} end.
  move=> cl; have := H (name s c); case: find => [d //|/(_ c cl)]; by rewrite eqxx.
elim/last_ind: l inc => [|l x IH] inc i; first by rewrite find_empty.
have incl : sorted ltn [seq num x.2 | x <- l].
  by move: inc; rewrite map_rcons -cats1 => /cat_sorted2[].
have big e : e \in [seq x.2 | x <- l] -> num e <= num x.2.
  case/mapP => y yl ->; move: inc; rewrite map_rcons (sorted_pairwise ltn_trans).
  by rewrite pairwise_rcons => /andP[/allP/(_ _ (map_f _ yl))/ltnW].
rewrite -cats1 foldl_cat cats1 /= /add_least map_rcons; have {}IH := IH incl.
have grow j : match find j (foldl (add_least s) (PositiveMap.empty positive) l) with
    | Some d => [/\ d \in rcons [seq x.2 | x <- l] x.2, name s d = j &
        {in rcons [seq x.2 | x <- l] x.2, forall e, name s e = j -> num d <= num e}]
    | None => name s x.2 != j ->
        {in rcons [seq x.2 | x <- l] x.2, forall e, name s e != j} end.
  have := IH j; case: find => [d [dl dj min]|none xj e]; last first.
    by rewrite mem_rcons inE => /orP[/eqP->//|]; exact: none.
  split=> [|//|e]; first by rewrite mem_rcons inE dl orbT.
  by rewrite mem_rcons inE => /orP[/eqP-> _|]; [exact: big | exact: min].
case F: (find (name s x.2)) => [d|].
  have := grow i; case G: (find i) => [d'//|]; apply; apply/eqP => e.
  by rewrite -e F in G.
rewrite find_add; have [->|ne] := eqVneq i (name s x.2); last first.
  by have := grow i; case: find => // none; apply: none; rewrite eq_sym.
split=> // [|e]; first by rewrite mem_rcons inE eqxx.
rewrite mem_rcons inE => /orP[/eqP->//|el] ee; have := IH (name s x.2); rewrite F.
by move=> /(_ e el); rewrite ee eqxx.
Qed.

Lemma number_sorted cells : sorted ltn [seq num x.2 | x <- flatten (number cells)].
Proof. by rewrite number_corners; exact: iota_ltn_sorted. Qed.

Section Correct.
Variables (n nv : nat) (cells cut : seq (seq positive)) (ok : wf n nv (nats cells)).
Local Notation M := (ecomplex ok).
Local Notation C := (ecut nv (nats cut)).
Variable result : seq (seq positive).
Hypothesis done : unglue_exec n cells cut = inr result.

Let p := if prepare n cells cut is inr p then p else Prepared [::] [::].
Let s := classes_of (edges p).
Let rename := canonical_name s (least s (number cells)).

Lemma prepareE : prepare n cells cut = inr p.
Proof. by move: done; rewrite /p /unglue_exec; case: prepare. Qed.

Lemma resultE : result = [seq [seq rename x.2 | x <- r] | r <- number cells].
Proof.
have [rowsE _ _ _] := prepare_edges ok prepareE.
by move: done; rewrite /unglue_exec prepareE rev_mapE rowsE => -[].
Qed.

Lemma result_at x : corner M x -> vertex_after cells result x = rename (corner_of x).
Proof.
rewrite /corner in_cell => vt.
have tl : x.2 < size (number cells) by rewrite size_number (cell_lt vt).
rewrite /vertex_after resultE (nth_map [::]) // -/(row_of _ _) -/(cell_of _ _).
have il : index (pos x.1) (cell_of cells x.2) < size (row_of cells x.2).
  by rewrite -(size_map fst) row_vertices index_mem.
by rewrite (nth_map (1, 1)%positive) // /corner_of /corner_number (nth_map (1, 1)%positive).
Qed.

Lemma renameP x : corner M x -> exists y, [/\ corner M y, rename (corner_of x) = corner_of y,
  connect (glue M C) x y &
  forall z, connect (glue M C) x z -> num (corner_of y) <= num (corner_of z)].
Proof.
move=> cx; have [_ _ _ names] := prepare_edges ok prepareE.
have lx : corner_of x \in [seq z.2 | z <- flatten (number cells)].
  by apply/mapP; exists (pos x.1, corner_of x) => //; exact: corner_listed cx.
have [/mapP[z /(listed_corner ok)[y cy zE] dE] nE min] := leastP s (number_sorted cells) lx.
rewrite zE /= in dE; exists y; move: dE nE min; rewrite -/(rename _) => dE nE min.
split=> // [|z' xz]; first by rewrite -copy_eq eq_sym -names // -nE dE.
have cz := connect_corner xz cx; rewrite -dE; apply: min.
  by apply/mapP; exists (pos z'.1, corner_of z') => //; exact: corner_listed cz.
by apply/eqP; rewrite names // copy_eq glue_csym.
Qed.

(* The result is unglue(before, cut) up to renaming of vertices ...            *)
Theorem unglue_exec_correct : size result = size cells /\
  renames_unglue M C (vertex_after cells result).
Proof.
split; first by rewrite resultE size_map size_number.
apply/certify_sound_complete/certifiedP => x y cx cy; rewrite !result_at //.
have [x' [cx' -> xx' minx]] := renameP cx.
have [y' [cy' -> yy' miny]] := renameP cy.
rewrite copy_eq; apply/eqP/idP => [/(corner_of_inj cx' cy') e|xy].
  by apply: connect_trans xx' _; rewrite glue_csym e.
have x'y : connect (glue M C) x y' by apply: connect_trans yy'.
have y'x : connect (glue M C) y x' by apply: connect_trans xx'; rewrite glue_csym.
by apply: num_inj; apply/eqP; rewrite eqn_leq minx // miny.
Qed.

(* ... with each vertex named by the least corner of its class.                *)
Theorem unglue_exec_least x : corner M x -> exists y,
  [/\ vertex_after cells result x = corner_of y, copy M C y = copy M C x &
      forall z, copy M C z = copy M C x -> num (corner_of y) <= num (corner_of z)].
Proof.
move=> cx; have [y [cy yE xy min]] := renameP cx; exists y; rewrite result_at //.
split=> // [|z /eqP]; first by apply/eqP; rewrite copy_eq glue_csym.
by rewrite copy_eq glue_csym; exact: min.
Qed.
End Correct.
