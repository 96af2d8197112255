(******************************************************************************)
(* The certificate check on lists, made to be extracted.                      *)
(*                                                                            *)
(*             vertex_map == the vertex of each corner number                 *)
(*       find_clash kv rows == two corners to which kv gives the same key and *)
(*                         different values: clauses (a) and (c)              *)
(*        find_apart w es == the first edge whose ends differ under w: (b)    *)
(*                verdict == Accepted, or the first clause that fails in the  *)
(*                         order of Rejection::Clause in C++, with two corner *)
(*                         numbers that show it, or what is malformed         *)
(*           certify_exec == the check: n log n steps in the number of cells  *)
(*  vertex_after before after x == the vertex that stands in `after` in the   *)
(*                         place of corner x of `before`                      *)
(*  means n nv before cut after v == what verdict v says of these lists       *)
(*                                                                            *)
(* Theorems: certify_exec_means (every verdict is justified, with the clause  *)
(* and the corners it names; for the rows that Malformed names see            *)
(* culprits.v), certify_exec_correct (Accepted exactly if `after` is          *)
(* unglue(before, cut) up to renaming of vertices; said again with isomorphic *)
(* in certify_exec_isomorphic).                                               *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue certify listed_complex tries quick_find half_facets.
From Cleave Require Import listed prepare denote valid.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* The corners are named by their numbers.                                     *)
Inductive verdict :=
| Accepted
| Not_comparable
| No_parent of positive & positive
| Uncut_mates_apart of positive & positive
| Class_not_connected of positive & positive
| Malformed of problem.

Fixpoint same_length (A B : Type) (s : seq A) (t : seq B) : bool :=
  match s, t with
  | [::], [::] => true
  | _ :: s', _ :: t' => same_length s' t'
  | _, _ => false
  end.

(* The vertex that each corner has in numbered rows.                           *)
Definition vertex_map (rows : seq (seq numbered)) : PositiveMap.t positive :=
  fold_corners (fun m (x : numbered) => add x.2 x.1 m) (PositiveMap.empty positive) rows.

Definition vertex_at (m : PositiveMap.t positive) (c : positive) : positive :=
  if find c m is Some v then v else 1%positive.

(* Two corners with one key and different values: `seen` holds the value of    *)
(* each key, and the corner that brought it.                                   *)
Record search := Search {
  seen : PositiveMap.t (positive * positive);
  clash : option (positive * positive) }.

Definition look (kv : numbered -> positive * positive) (s : search) (x : numbered) : search :=
  if clash s is Some _ then s else
  let kvx := kv x in
  match find kvx.1 (seen s) with
  | None => Search (add kvx.1 (kvx.2, x.2) (seen s)) None
  | Some (v, d) => if Pos.eqb v kvx.2 then s else Search (seen s) (Some (d, x.2))
  end.

Definition find_clash kv (rows : seq (seq numbered)) : option (positive * positive) :=
  clash (fold_corners (look kv) (Search (PositiveMap.empty (positive * positive)) None) rows).

Definition find_apart (w : positive -> positive) : seq (positive * positive) ->
    option (positive * positive) :=
  first_some (fun e => if Pos.eqb (w e.1) (w e.2) then None else Some e).

Definition certify_exec n (before cut after : seq (seq positive)) : verdict :=
  match prepare n before cut with
  | inl p => Malformed p
  | inr p =>
      if ~~ all (long n) after then Malformed Wrong_length else
      if ~~ same_length before after then Not_comparable else
      let w := vertex_at (vertex_map (number after)) in
      if find_clash (fun x => (w x.2, x.1)) (corner_rows p) is Some (c, d) then No_parent c d else
      if find_apart w (edges p) is Some (c, d) then Uncut_mates_apart c d else
      let s := classes_of (edges p) in
      if find_clash (fun x => (w x.2, name s x.2)) (corner_rows p) is Some (c, d)
      then Class_not_connected c d else Accepted
  end.

Lemma same_lengthE (A B : Type) (s : seq A) (t : seq B) : same_length s t = (size s == size t).
Proof. by elim: s t => [|x s IH] [|y t] //=; rewrite IH. Qed.

Lemma vertex_mapP (rows : seq (seq numbered)) x : uniq [seq z.2 | z <- flatten rows] ->
  x \in flatten rows -> vertex_at (vertex_map rows) x.2 = x.1.
Proof.
rewrite /vertex_at /vertex_map fold_cornersE; elim/last_ind: (flatten rows) => // s z IH.
rewrite map_rcons rcons_uniq => /andP[zs us]; rewrite -cats1 foldl_cat /= cats1 mem_rcons inE.
rewrite find_add; have [->|ne] /= := eqVneq x z; first by rewrite eqxx.
move=> xs; case: eqP => [e|_]; last exact: IH.
by case/mapP: zs; exists x.
Qed.

Lemma find_clashP kv rows : match find_clash kv rows with
  | None => {in flatten rows &, forall x y, (kv x).1 = (kv y).1 -> (kv x).2 = (kv y).2}
  | Some (c, d) => exists x y, [/\ x \in flatten rows, y \in flatten rows, (x.2, y.2) = (c, d),
      (kv x).1 = (kv y).1 & (kv x).2 != (kv y).2]
  end.
Proof.
rewrite /find_clash fold_cornersE; pose s0 := Search (PositiveMap.empty (positive * positive)) None.
suff H l : (match clash (foldl (look kv) s0 l) with
  | None => {in l, forall x, omap fst (find (kv x).1 (seen (foldl (look kv) s0 l))) = Some (kv x).2}
      /\ forall k v d, find k (seen (foldl (look kv) s0 l)) = Some (v, d) ->
         exists2 x, x \in l & kv x = (k, v) /\ x.2 = d
  | Some (c, d) => exists x y, [/\ x \in l, y \in l, (x.2, y.2) = (c, d),
      (kv x).1 = (kv y).1 & (kv x).2 != (kv y).2] end : Prop).
  have := H (flatten rows); rewrite -/s0; case: clash => [[c d]|[vals _]] //.
  move=> x y /vals ex /vals ey kk.
  by move: ex; rewrite kk ey => -[].
elim/last_ind: l => [|l x]; first by split=> // k v d; rewrite find_empty.
rewrite -cats1 foldl_cat cats1 /=; move: (foldl _ s0 l) => s; rewrite /look.
case S: (clash s) => [[c d]|].
  rewrite S => -[y [z [yl zl e k v]]]; exists y, z.
  by split=> //; rewrite mem_rcons inE ?yl ?zl orbT.
move=> [vals keys]; have sub k v d : find k (seen s) = Some (v, d) ->
    exists2 z, z \in rcons l x & kv z = (k, v) /\ z.2 = d.
  by move=> /keys[z zl e]; exists z => //; rewrite mem_rcons inE zl orbT.
case F: (find (kv x).1 (seen s)) => [[v d]|] /=; last first.
  split=> [z|k v d]; last first.
    rewrite find_add; have [-> [<- <-]|_] := eqVneq k (kv x).1; last exact: sub.
    by exists x; rewrite ?mem_rcons ?inE ?eqxx // -surjective_pairing.
  rewrite mem_rcons inE find_add; have [-> _|zx /= zl] := eqVneq z x; first by rewrite eqxx.
  case: eqP => [e|_]; last exact: vals.
  by have := vals _ zl; rewrite e F.
change Pos.eqb with (@eq_op positive_eqType).
have [vx|vx] := eqVneq v (kv x).2.
  rewrite S; split=> // z; rewrite mem_rcons inE => /orP[/eqP->|]; last exact: vals.
  by rewrite F /= vx.
have [z zl [kz zd]] := keys _ _ _ F; exists z, x.
by rewrite !mem_rcons !inE eqxx zl orbT kz zd.
Qed.

Lemma find_apartP w es : match find_apart w es with
  | None => {in es, forall e, w e.1 = w e.2}
  | Some e => e \in es /\ w e.1 != w e.2 end.
Proof.
rewrite /find_apart; elim: es => //= e es IH; change Pos.eqb with (@eq_op positive_eqType).
case: eqP => [we|/eqP we]; last by rewrite inE eqxx.
move: IH; case: first_some => [e' [e'es]|IH]; first by rewrite inE e'es orbT.
by move=> e'; rewrite inE => /orP[/eqP->|/IH].
Qed.

(* The vertex that `after` has in the place that v has in cell t of `before`.  *)
Definition vertex_after nv (before after : seq (seq positive))
    (x : 'I_nv * 'I_(size (nats before))) : positive :=
  nth 1%positive (nth [::] after x.2) (index (pos x.1) (nth [::] before x.2)).
Arguments vertex_after {nv} before after x.

(* What each verdict means.                                                    *)
Definition means n nv (before cut after : seq (seq positive)) (v : verdict) : Prop :=
  let valid := exists2 ok : wf n nv (nats before),
    pseudo_manifold (ecomplex ok) & all (is_facet n before) cut in
  if v is Malformed _ then ~ (valid /\ all (long n) after) else
  valid /\ all (long n) after /\
  if v is Not_comparable then size before <> size after else
  size before = size after /\ forall ok : wf n nv (nats before),
  let M := ecomplex ok in let C := ecut nv (nats cut) in
  let lab := @vertex_after nv before after in
  let shown c d (P : _ -> _ -> Prop) := exists x y,
    [/\ corner M x, corner M y, corner_of x = c, corner_of y = d & P x y] in
  match v with
  | Accepted => certified M C lab
  | No_parent c d => shown c d (fun x y => lab x = lab y /\ x.1 <> y.1)
  | Uncut_mates_apart c d =>
      has_parents M lab /\ shown c d (fun x y => glue M C x y /\ lab x <> lab y)
  | Class_not_connected c d =>
      [/\ has_parents M lab, uncut_mates_together M C lab &
          shown c d (fun x y => lab x = lab y /\ ~~ connect (glue M C) x y)]
  | _ => True
  end.

Section Corners.
Variables (n nv : nat) (cells : seq (seq positive)) (ok : wf n nv (nats cells)).
Local Notation M := (ecomplex ok).

Lemma corner_listed x : corner M x -> (pos x.1, corner_of x) \in flatten (number cells).
Proof.
rewrite /corner in_cell => vt; have tl := cell_lt vt.
apply/flattenP; exists (row_of cells x.2); first by rewrite mem_nth ?size_number.
exact: mem_corner_number.
Qed.

Lemma listed_corner z : z \in flatten (number cells) ->
  exists2 x, corner M x & z = (pos x.1, corner_of x).
Proof.
case/flattenP => r /(nthP [::])[t ts <-] zt; rewrite size_number in ts.
have /andP[z1 /eqP z2] := row_corner_number (wf_uniq ok) zt.
have tl : t < size (nats cells) by rewrite size_map.
have [v vz] := vertex_of ok z1; exists (v, Ordinal tl); first by rewrite /corner in_cell /= vz.
by rewrite /corner_of /= vz -z2 -surjective_pairing.
Qed.

Lemma vertex_map_corner after x : all (long n) after -> size cells = size after ->
  corner M x -> vertex_at (vertex_map (number after)) (corner_of x) = vertex_after cells after x.
Proof.
move=> la sz; rewrite /corner in_cell => vt; have tl := cell_lt vt.
have ta : x.2 < size after by rewrite -sz.
have szc : size (nth [::] after x.2) = size (cell_of cells x.2).
  by have /eqP-> := allP la _ (mem_nth [::] ta); rewrite (size_cell ok).
have shapes : shape cells = shape after.
  apply: (@eq_from_nth _ 0); rewrite ?size_map // => i il.
  rewrite !(nth_map [::]) // -?sz //; have /eqP-> : long n (nth [::] after i).
    by apply: (allP la); rewrite mem_nth // -sz.
  by have := size_cell ok (Ordinal (_ : i < size (nats cells))); rewrite size_map => ->.
have rows : [seq z.2 | z <- row_of after x.2] = [seq z.2 | z <- row_of cells x.2].
  rewrite /row_of -!(nth_map [::] [::] (map snd)) ?size_number //.
  by rewrite (number_shape shapes).
set i := index (pos x.1) (cell_of cells x.2).
have il : i < size (row_of after x.2).
  by rewrite -(size_map fst) row_vertices /cell_of szc index_mem.
pose z := nth (1, 1)%positive (row_of after x.2) i.
have zin : z \in flatten (number after).
  by apply/flattenP; exists (row_of after x.2); rewrite mem_nth ?size_number.
have -> : corner_of x = z.2.
  by rewrite /corner_of /corner_number -rows (nth_map (1, 1)%positive).
rewrite vertex_mapP ?number_uniq // /vertex_after -/(cell_of cells _) -/i.
by rewrite -/(cell_of after x.2) -row_vertices (nth_map (1, 1)%positive).
Qed.
End Corners.

(* Every verdict is justified; what Malformed names is in culprits.v.          *)
Theorem certify_exec_means n nv before cut after : fits nv before ->
  means n nv before cut after (certify_exec n before cut after).
Proof.
move=> fit; rewrite /certify_exec; have := prepare_complete n cut fit.
case P: prepare => [p|p] valid /=; first by case=> /valid.
have {}valid := valid.1 I; case L: (all (long n) after) => /=; last by move=> [_]; rewrite L.
rewrite same_lengthE; case: eqP => /= sz; last by split.
set w := vertex_at _; have [ok pm cf] := valid.
have lab (ok' : wf n nv (nats before)) x : corner (ecomplex ok') x ->
    w (corner_of x) = vertex_after before after x := vertex_map_corner L sz.
have lists (ok' : wf n nv (nats before)) := prepare_edges ok' P.
have [rowsE _ _ _] := lists ok; rewrite rowsE.
have := find_clashP (fun x => (w x.2, x.1)) (number before).
case: find_clash => [[c d] [x [y [xl yl [<- <-] /= e ne]]]|par].
  do 3![split=> //] => ok'; have [x' cx xE] := listed_corner ok' xl.
  have [y' cy yE] := listed_corner ok' yl; exists x', y'; rewrite xE yE in e ne *.
  by split=> //; split=> [|xy]; [rewrite -!lab | case/eqP: ne; rewrite /= xy].
have parents (ok' : wf n nv (nats before)) : has_parents (ecomplex ok') (vertex_after before after).
  move=> x y cx cy; rewrite -!lab // => e; apply: pos_inj.
  exact: (par _ _ (corner_listed cx) (corner_listed cy)).
have := find_apartP w (edges p); case: find_apart => [[c d] [/= ed ne]|together].
  do 3![split=> //] => ok'; split; first exact: parents.
  have [_ _ /(_ _ _ ed)[x [y [cx g cE dE]]] _] := lists ok'.
  have cy := connect_corner (connect1 g) cx; exists x, y; split=> //; split=> // e.
  by case/eqP: ne; rewrite cE dE !lab.
have uncut (ok' : wf n nv (nats before)) :
    uncut_mates_together (ecomplex ok') (ecut nv (nats cut)) (vertex_after before after).
  apply/uncut_mates_glue => x y g; have cx : corner (ecomplex ok') x.
    by case/and4P: g => _; rewrite inE => /andP[].
  have cy := connect_corner (connect1 g) cx; rewrite -!lab //.
  have [_ /(_ _ _ g) E _ _] := lists ok'.
  by case: E => ed; [exact: (together _ ed) | exact/esym/(together _ ed)].
have := find_clashP (fun x => (w x.2, name (classes_of (edges p)) x.2)) (number before).
case: find_clash => [[c d] [x [y [xl yl [<- <-] /= e ne]]]|con].
  do 3![split=> //] => ok'; have [x' cx xE] := listed_corner ok' xl.
  have [y' cy yE] := listed_corner ok' yl; split; [exact: parents | exact: uncut | exists x', y'].
  rewrite xE yE in e ne *; split=> //; split; first by rewrite -!lab.
  have [_ _ _ names] := lists ok'.
  by apply: contra ne; rewrite -copy_eq -names.
do 3![split=> //] => ok'; split; [exact: parents | exact: uncut | move=> x y cx cy].
have [_ _ _ names] := lists ok'; rewrite -!(lab ok') // -copy_eq -names // => e; apply/eqP.
exact: (con _ _ (corner_listed cx) (corner_listed cy)).
Qed.

(* The extracted checker accepts exactly if `before` is a pseudo-manifold, the *)
(* cut consists of its facets, and `after` is unglue(before, cut) up to        *)
(* renaming of vertices. nv is any bound on the numbers of the vertices.       *)
Theorem certify_exec_correct n nv before cut after : fits nv before ->
  certify_exec n before cut after = Accepted <->
  exists ok : wf n nv (nats before),
    [/\ pseudo_manifold (ecomplex ok), all (is_facet n before) cut, size before = size after,
        all (long n) after &
        renames_unglue (ecomplex ok) (ecut nv (nats cut)) (@vertex_after nv before after)].
Proof.
move=> fit; have := certify_exec_means n cut after fit.
case: certify_exec => [[[ok pm cf] [la [sz /(_ ok) C]]]|||||] /=.
- by split=> // _; exists ok; split=> //; apply/certify_sound_complete.
- by move=> [_ [_ ne]]; split=> // -[ok [_ _ /ne]].
- move=> c d [_ [_ [_ R]]]; split=> // -[ok [_ _ _ _ /certify_sound_complete[par _ _]]].
  by have [x [y [cx cy _ _ [e]]]] := R ok; case; exact: par.
- move=> c d [_ [_ [_ R]]]; split=> // -[ok [_ _ _ _ /certify_sound_complete[_ + _]]].
  move=> /uncut_mates_glue b.
  by have [_ [x [y [_ _ _ _ [/b]]]]] := R ok.
- move=> c d [_ [_ [_ R]]]; split=> // -[ok [_ _ _ _ /certify_sound_complete[_ _ con]]].
  by have [_ _ [x [y [cx cy _ _ [e]]]]] := R ok; rewrite con.
- by move=> p bad; split=> // -[ok [pm cf _ la _]]; case: bad; split=> //; exists ok.
Qed.

(* Then the cells of `after` are a complex isomorphic to unglue(before, cut),  *)
(* cell by cell; nw bounds the numbers of its vertices.                        *)
Theorem certify_exec_isomorphic n nv nw before cut after :
  fits nv before -> fits nw.+1 after -> certify_exec n before cut after = Accepted ->
  exists (ok : wf n nv (nats before)) 
      (N : complex n [finType of 'I_nw.+1] [finType of 'I_(size (nats before))]),
    (forall t, N t = [set w : 'I_nw.+1 | pos w \in nth [::] after t]) /\
    isomorphic (unglue (ecomplex ok) (ecut nv (nats cut))) N.
Proof.
move=> fit fita /(certify_exec_correct n cut after fit)[ok [_ _ sz la]].
move=> /certify_sound_complete/certifiedP same.
pose lab (x : 'I_nv * 'I_(size (nats before))) : 'I_nw.+1 :=
  inord (num (vertex_after before after x)).
have cell_after (t : 'I_(size (nats before))) : nth [::] after t \in after.
  by rewrite mem_nth // -sz -(size_map (map num)).
have size_after (t : 'I_(size (nats before))) : size (nth [::] after t) = n.+1.
  by move: (allP la _ (cell_after t)) => /eqP.
have listed x : corner (ecomplex ok) x ->
    vertex_after before after x \in nth [::] after x.2.
  rewrite /corner in_cell => vt; rewrite mem_nth // size_after -(size_cell ok x.2).
  by rewrite index_mem.
have labK x : corner (ecomplex ok) x -> pos (lab x) = vertex_after before after x.
  move=> /listed xa; rewrite /lab inordK ?numK //.
  exact: (allP (allP fita _ (cell_after _)) _ xa).
have cert : certified (ecomplex ok) (ecut nv (nats cut)) lab.
  apply/certifiedP => x y cx cy; rewrite -same // -!labK //.
  by apply/eqP/eqP => [->//|/pos_inj].
have [N NE iso] := certified_isomorphic cert; exists ok, N; split=> // t; rewrite NE.
apply/setP => w; rewrite inE; apply/imsetP/idP => [[v vt ->]|/(nthP 1%positive)[i il iw]].
  by rewrite labK //; apply: (listed (v, t)).
rewrite size_after -(size_cell ok t) in il.
have vt := mem_nth 1%positive il; have [v vE] := vertex_of ok vt.
exists v; first by rewrite in_cell vE.
apply: pos_inj; rewrite labK; last by rewrite /corner in_cell /= vE.
by rewrite /vertex_after /= vE index_uniq ?(cell_uniq (wf_uniq ok)).
Qed.
