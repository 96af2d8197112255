(******************************************************************************)
(* Numbered cells, their corners and facets, before any complex is built.     *)
(*                                                                            *)
(*        cell_of cells t == the vertices of cell t                           *)
(*         row_of cells t == the same with the numbers of its corners         *)
(*  corner_number cells t v == the number of the corner of cell t at v        *)
(*         opposite cells t v == the facet of cell t opposite v               *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries half_facets.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---------- lists ---------------------------------------------------------- *)
Lemma uniq_map_inj (A B : eqType) (h : A -> B) (s : seq A) x y :
  uniq [seq h z | z <- s] -> x \in s -> y \in s -> h x = h y -> x = y.
Proof.
elim: s => //= z s IH /andP[zs us]; rewrite !inE => /orP[/eqP->|xs] /orP[/eqP->|ys] e //.
- by case/mapP: zs; exists y.
- by case/mapP: zs; exists x.
- exact: IH.
Qed.

Lemma flatten_uniq_nth (rows : seq (seq numbered)) t u x y :
  uniq [seq z.2 | z <- flatten rows] ->
  x \in nth [::] rows t -> y \in nth [::] rows u -> x.2 = y.2 -> t = u.
Proof.
have out r (rs : seq (seq numbered)) i a b : uniq [seq z.2 | z <- r ++ flatten rs] ->
    a \in r -> b \in nth [::] rs i -> a.2 != b.2.
  rewrite map_cat cat_uniq => /and3P[_ /hasPn dis _] ar bi; apply/eqP => e.
  have i_lt : i < size rs by rewrite ltnNge; apply: contraL bi => /(nth_default [::])->.
  have bs : b.2 \in [seq z.2 | z <- flatten rs].
    by apply/map_f/flattenP; exists (nth [::] rs i); rewrite ?mem_nth.
  by case/negP: (dis _ bs); apply/mapP; exists a.
elim: rows t u => [|r rows IH] [|t] [|u] //= U xt yu e.
- by have := out _ _ _ _ _ U xt yu; rewrite e eqxx.
- by have := out _ _ _ _ _ U yu xt; rewrite e eqxx.
- by congr _.+1; apply: IH xt yu e; move: U; rewrite map_cat cat_uniq => /and3P[].
Qed.

Lemma mem_zip_numbered (s r : seq numbered) x y : [seq z.1 | z <- s] = [seq z.1 | z <- r] ->
  uniq [seq z.1 | z <- s] -> ((x, y) \in zip s r) = [&& x \in s, y \in r & x.1 == y.1].
Proof.
elim: s r => [|a s IH] [|b r] //= [ab sr] /andP[as_ us]; rewrite !inE IH // xpair_eqE.
have [->|xa] := eqVneq x a; have [->|yb] := eqVneq y b => //=.
- by rewrite ab eqxx.
- have -> : a \in s = false by apply: contraNF as_ => /(map_f fst).
  by apply/esym/negbTE; apply: contra as_ => /andP[yr /eqP->]; rewrite sr map_f.
- have -> : b \in r = false by apply: contraNF as_ => /(map_f fst); rewrite -sr -ab.
  rewrite andFb andbF -ab; apply/esym/negbTE; apply: contra as_ => /andP[xs /eqP<-].
  exact: map_f.
Qed.

Lemma leb_total : total Pos.leb.
Proof.
by move=> p q; apply/orP; case: (Pos.leb_spec p q) => [|/Pos.lt_le_incl/Pos.leb_le]; auto.
Qed.
Lemma leb_trans : transitive Pos.leb.
Proof.
by move=> q p r /Pos.leb_le pq /Pos.leb_le qr; apply/Pos.leb_le; exact: Pos.le_trans pq qr.
Qed.
Lemma leb_anti : antisymmetric Pos.leb.
Proof. by move=> p q /andP[/Pos.leb_le pq /Pos.leb_le qp]; exact: Pos.le_antisym. Qed.

Lemma sorted_eq_mem s r : sorted Pos.leb s -> sorted Pos.leb r -> uniq s -> uniq r ->
  s =i r -> s = r.
Proof.
by move=> ss sr us ur e; apply: (sorted_eq leb_trans leb_anti) => //; apply: uniq_perm.
Qed.

Section Cells.
Variable cells : seq (seq positive).
Hypothesis uniq_cells : all uniq cells.

Definition cell_of t := nth [::] cells t.
Definition row_of t := nth [::] (number cells) t.

Lemma row_vertices t : [seq x.1 | x <- row_of t] = cell_of t.
Proof.
rewrite /cell_of -[in RHS](number_vertices cells) /row_of.
have [ts|ts] := ltnP t (size (number cells)); first by rewrite (nth_map [::]).
by rewrite !nth_default // size_map.
Qed.

Lemma cell_uniq t : uniq (cell_of t).
Proof.
have [ts|ts] := ltnP t (size cells); last by rewrite /cell_of nth_default.
exact: (allP uniq_cells) (mem_nth _ ts).
Qed.

Lemma cell_lt t v : v \in cell_of t -> t < size cells.
Proof. by rewrite ltnNge; apply: contraL => /(nth_default [::]); rewrite /cell_of => ->. Qed.

Definition corner_number t v := nth 1%positive [seq x.2 | x <- row_of t] (index v (cell_of t)).

Lemma mem_corner_number t v : v \in cell_of t -> (v, corner_number t v) \in row_of t.
Proof.
rewrite -row_vertices => /[dup] vt; rewrite -index_mem size_map => it.
rewrite /corner_number -row_vertices (nth_map (1, 1)%positive) //.
rewrite -[X in (X, _)](nth_index 1%positive vt) (nth_map (1, 1)%positive) //.
by rewrite -surjective_pairing mem_nth.
Qed.

Lemma row_corner_number t x : x \in row_of t ->
  (x.1 \in cell_of t) && (x.2 == corner_number t x.1).
Proof.
move=> xt; have x1 : x.1 \in cell_of t by rewrite -row_vertices map_f.
rewrite x1; apply/eqP; have := mem_corner_number x1.
have U : uniq [seq z.1 | z <- row_of t] by rewrite row_vertices cell_uniq.
by move=> /(uniq_map_inj U xt)/(_ erefl) {1}->.
Qed.

Lemma corner_number_inj t u v w : v \in cell_of t -> w \in cell_of u ->
  corner_number t v = corner_number u w -> t = u /\ v = w.
Proof.
move=> /mem_corner_number vt /mem_corner_number wu e.
have tu : t = u by apply: (flatten_uniq_nth (number_uniq cells) vt wu).
split=> //; subst u; have := number_uniq cells.
have tlt : t < size (number cells).
  by rewrite ltnNge; apply: contraL vt => /(nth_default [::]); rewrite /row_of => ->.
have sub x : x \in row_of t -> x \in flatten (number cells).
  by move=> xt; apply/flattenP; exists (row_of t); rewrite ?mem_nth.
by move=> /uniq_map_inj/(_ (sub _ vt) (sub _ wu) e)[].
Qed.

Definition opposite t v : facet :=
  ((v, corner_number t v), [seq x <- sort by_vertex (row_of t) | x.1 != v]).

Lemma mem_all_facets f :
  reflect (exists2 t, f.1.1 \in cell_of t & f = opposite t f.1.1) (f \in all_facets (number cells)).
Proof.
have U t : uniq [seq x.1 | x <- sort by_vertex (row_of t)].
  by rewrite (perm_uniq (perm_map _ (permEl (perm_sort _ _)))) row_vertices cell_uniq.
apply: (iffP flatten_mapP) => [[r /(nthP [::])[t ts <-]]|[t ft fE]].
  rewrite facetsP ?U // mem_sort => /andP[ft /eqP fE]; exists t.
    by have /andP[] := row_corner_number ft.
  have /andP[_ /eqP e] := row_corner_number ft.
  by case: f ft fE e => [[v c] s] /= _ -> ->.
exists (row_of t); first by rewrite mem_nth // size_number (cell_lt ft).
by rewrite facetsP ?U // mem_sort fE /= mem_corner_number // eqxx.
Qed.

Lemma key_opposite t v : key (opposite t v) = [seq w <- sort Pos.leb (cell_of t) | w != v].
Proof. by rewrite /key /= -row_vertices sort_map filter_map. Qed.

Lemma mem_key t v w : (w \in key (opposite t v)) = (w \in cell_of t) && (w != v).
Proof. by rewrite key_opposite mem_filter mem_sort andbC. Qed.

Lemma uniq_key t v : uniq (key (opposite t v)).
Proof. by rewrite key_opposite filter_uniq // sort_uniq cell_uniq. Qed.

Lemma sorted_key t v : sorted Pos.leb (key (opposite t v)).
Proof.
rewrite key_opposite sorted_filter //; first exact: leb_trans.
exact/sort_sorted/leb_total.
Qed.

Lemma key_eq t v u w : key (opposite t v) =i key (opposite u w) ->
  key (opposite t v) = key (opposite u w).
Proof. by apply: sorted_eq_mem; rewrite ?sorted_key ?uniq_key. Qed.

Lemma size_key t v : v \in cell_of t -> size (key (opposite t v)) = (size (cell_of t)).-1.
Proof.
move=> vt; rewrite key_opposite size_filter.
rewrite (permP (permEl (perm_sort _ _))) -(size_rem vt) rem_filter ?cell_uniq //.
by rewrite size_filter.
Qed.

Lemma uniq_all_facets : uniq (all_facets (number cells)).
Proof.
apply: (@map_uniq _ _ (fun f : facet => f.1.2)).
have fst_facets r : [seq f.1 | f <- facets r] = r.
  by elim: r => //= x r IH; rewrite -map_comp; congr (_ :: _); rewrite -[RHS]IH; apply: eq_map.
rewrite map_comp; have := number_uniq cells; rewrite /all_facets.
elim: (number cells) => //= r rows IH.
rewrite !map_cat !cat_uniq fst_facets => /and3P[ur /hasPn dis /IH->].
rewrite (perm_uniq (perm_map _ (permEl (perm_sort _ _)))) ur andbT /=.
apply/hasPn => c cs; rewrite /= (perm_mem (perm_map _ (permEl (perm_sort _ _)))).
apply: dis; move: cs; elim: rows {IH} => //= r' rows IH.
rewrite !map_cat !mem_cat fst_facets (perm_mem (perm_map _ (permEl (perm_sort _ _)))).
by move=> /orP[->//|/IH->]; rewrite orbT.
Qed.

End Cells.
