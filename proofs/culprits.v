(******************************************************************************)
(* A malformed certificate: the rows that are named are at fault.             *)
(*                                                                            *)
(*  among fs k gs == gs are different half-facets of fs with key k            *)
(*  blames n before cut after p == what problem p says of these lists: which  *)
(*                    cells and which row of the cut are at fault, and how.   *)
(*                    A corner c of cell t is a pair (vertex, c) in row_of    *)
(*                    before t; the row of the cut with number k is the one   *)
(*                    at num k, counted from 0.                               *)
(*                                                                            *)
(* Theorems: prepare_blames (of the lists a program starts from) and          *)
(* certify_exec_blames (of the checker's verdict Malformed).                  *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import tries half_facets listed prepare valid certify_exec.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition blames n (before cut after : seq (seq positive)) (p : problem) : Prop :=
  match p with
  | Wrong_length => ~~ all (long n) before || ~~ all (long n) after
  | Repeated_vertex c d =>
      exists t v, [/\ (v, c) \in row_of before t, (v, d) \in row_of before t & c != d]
  | Same_vertices c d => exists t u v w, [/\ t != u, cell_of before t =i cell_of before u,
      (v, c) \in row_of before t & (w, d) \in row_of before u]
  | Facet_in_three_cells c d => exists t u r v w z,
      [/\ uniq [:: t; u; r], (v, c) \in row_of before t, (w, d) \in row_of before u,
          z \in cell_of before r &
          key (opposite before u w) = key (opposite before t v) /\
          key (opposite before r z) = key (opposite before t v)]
  | Not_a_facet k => num k < size cut /\ ~~ is_facet n before (nth [::] cut (num k))
  end.

Lemma first_some_mem (A : eqType) B (f : A -> option B) s y :
  first_some f s = Some y -> exists2 x, x \in s & f x = Some y.
Proof.
elim: s => //= x s IH; case E: (f x) => [z|].
  by case=> <-; exists x; rewrite ?inE ?eqxx.
by case/IH => x' xs fx; exists x'; rewrite // inE xs orbT.
Qed.

Lemma flatten_uniq_mem (A : eqType) (ss : seq (seq A)) s :
  uniq (flatten ss) -> s \in ss -> uniq s.
Proof.
elim: ss => //= r ss IH; rewrite cat_uniq inE => /and3P[ur _ us] /orP[/eqP->//|].
exact: IH.
Qed.

Lemma repeated_mem r c d : uniq r -> repeated r = Some (c, d) ->
  exists v, [/\ (v, c) \in r, (v, d) \in r & c != d].
Proof.
elim: r => [|x [|y r] IH] //= /andP[xr ur].
change Pos.eqb with (@eq_op positive_eqType); case: eqP => [xy [<- <-]|_ rep].
  exists x.1; rewrite {2}xy -!surjective_pairing !inE !eqxx orbT; split=> //.
  apply: contraNneq xr => xy2; rewrite inE.
  by rewrite [x]surjective_pairing xy xy2 -surjective_pairing eqxx.
by have [v [vc vd cd]] := IH ur rep; exists v; rewrite inE vc inE vd !orbT.
Qed.

Lemma repeated_blames n before cut after row p : row \in number before ->
  cell_problem row = Some p -> blames n before cut after p.
Proof.
move=> /[dup] rin /(nthP [::])[t _ rowE]; rewrite /cell_problem.
case R: repeated => [[c d]|//] [<-].
have ur : uniq (sort by_vertex row).
  rewrite sort_uniq; apply: flatten_uniq_mem rin.
  exact: (map_uniq (number_uniq before)).
have [v [vc vd cd]] := repeated_mem ur R; exists t, v.
by rewrite /row_of rowE -!(mem_sort by_vertex row).
Qed.

(* ---------- mates ---------------------------------------------------------- *)
Definition among fs k (gs : seq facet) := uniq gs && all (mem (of_key fs k)) gs.

Lemma among_rcons fs k gs f : among fs k gs -> among (rcons fs f) k gs.
Proof.
move=> /andP[u /allP sub]; rewrite /among u; apply/allP => g /sub /=.
by rewrite !mem_of_key mem_rcons inE => /andP[-> ->]; rewrite orbT.
Qed.

Lemma mate_culprits fs p : uniq fs -> fault (foldl mate unmated fs) = Some p ->
  match p with
  | Same_vertices c d => exists k g f,
      [/\ among fs k [:: g; f], g.1.1 = f.1.1, g.1.2 = c & f.1.2 = d]
  | Facet_in_three_cells c d => exists k g h f,
      [/\ among fs k [:: g; f; h], g.1.2 = c & f.1.2 = d]
  | _ => False
  end.
Proof.
elim/last_ind: fs => // fs f IH; rewrite rcons_uniq => /andP[ffs us].
rewrite -cats1 foldl_cat cats1 /=; have [good_fs tab] := mate_fold fs.
move: (foldl _ _ _) IH good_fs tab => s IH good_fs tab; rewrite /mate; case F: (fault s) => [q|].
  rewrite F => -[qp]; rewrite -qp in IH *; have := IH us F; case: (q) => // c d.
    by case=> k [g [f' [a e1 e2 e3]]]; exists k, g, f'; split=> //; apply: among_rcons.
  by case=> k [g [h [f' [a e1 e2]]]]; exists k, g, h, f'; split=> //; apply: among_rcons.
have [{}tab _ _] := tab F; have [size2 _] := good_fs.1 F (key f).
have fin : f \in of_key (rcons fs f) (key f) by rewrite mem_of_key mem_rcons inE !eqxx.
have old g : g \in of_key fs (key f) -> (g \in of_key (rcons fs f) (key f)) && (g != f).
  rewrite !mem_of_key mem_rcons inE => /andP[-> gin]; rewrite gin orbT /=.
  by apply: contraNneq ffs => <-.
have mem_b g : g \in rev (of_key fs (key f)) -> g \in of_key fs (key f) by rewrite mem_rev.
have ub : uniq (rev (of_key fs (key f))) by rewrite rev_uniq filter_uniq.
rewrite tab; case: (rev _) mem_b ub => [//|g [|h r]] mem_b ub.
  change Pos.eqb with (@eq_op positive_eqType); case: eqP => //= gf [<-].
  have /andP[gin ne] := old g (mem_b g (mem_head _ _)).
  by exists (key f), g, f; rewrite /among /= inE ne gin fin.
move=> [<-] /=; exists (key f), g, h, f; split=> //.
have /andP[gin gf] := old g (mem_b g (mem_head _ _)).
have /andP[hin hf] : (h \in of_key (rcons fs f) (key f)) && (h != f).
  by apply/old/mem_b; rewrite !inE eqxx orbT.
move: ub => /= /and3P[]; rewrite inE negb_or => /andP[gh _] _ _.
by rewrite /among /= !inE negb_or gf gh eq_sym hf gin fin hin.
Qed.

Section Cells.
Variables (n : nat) (before cut after : seq (seq positive)).
Hypothesis un : all uniq before.
Local Notation all_f := (all_facets (number before)).

(* Different half-facets with one key are facets of different cells.           *)
Lemma of_key_cells k (f g : facet) t u : f != g ->
  f \in of_key all_f k -> g \in of_key all_f k ->
  f = opposite before t f.1.1 -> g = opposite before u g.1.1 ->
  f.1.1 \in cell_of before t -> t != u.
Proof.
rewrite !mem_of_key => ne /andP[/eqP fk _] /andP[/eqP gk _] fE gE ft; apply: contra ne.
move=> /eqP tu; subst u; have := mem_key before t f.1.1 f.1.1.
rewrite eqxx andbF -fE fk -gk gE mem_key ft => /negbT/negPn/eqP e.
by rewrite fE gE -e.
Qed.

Lemma of_keyP k f : f \in of_key all_f k -> exists t,
  [/\ f.1 \in row_of before t, f.1.1 \in cell_of before t, f = opposite before t f.1.1 & key f = k].
Proof.
rewrite mem_of_key => /andP[/eqP fk /(mem_all_facets un)[t ft fE]]; exists t; split=> //.
by rewrite fE; apply: mem_corner_number.
Qed.

Lemma mates_blame p : fault (mate_all (number before)) = Some p -> blames n before cut after p.
Proof.
rewrite mate_allE => /(mate_culprits (uniq_all_facets _)); case: p => // c d.
  case=> k [g [f [/andP[/= gf /and3P[gk fk _]] gf1 <- <-]]].
  have [t [gt gt1 gE gkE]] := of_keyP gk; have [u [fu fu1 fE fkE]] := of_keyP fk.
  exists t, u, g.1.1, f.1.1; rewrite -!surjective_pairing; split=> //.
    by move: gf; rewrite inE andbT => gf; apply: (of_key_cells gf gk fk gE fE).
  move=> q; have [->|qg] := eqVneq q g.1.1; first by rewrite gt1 gf1 fu1.
  have := mem_key before t g.1.1 q; have := mem_key before u f.1.1 q.
  by rewrite -gE -fE gkE fkE -gf1 qg !andbT => ->.
case=> k [g [h [f [/andP[/= ne /and4P[gk fk hk _]] <- <-]]]].
have [t [gt gt1 gE gkE]] := of_keyP gk; have [u [fu fu1 fE fkE]] := of_keyP fk.
have [r [hr hr1 hE hkE]] := of_keyP hk.
exists t, u, r, g.1.1, f.1.1, h.1.1; rewrite -!surjective_pairing -gE -fE -hE gkE fkE hkE.
split=> //; move: ne; rewrite !inE !negb_or !andbT => /andP[/andP[gf gh] fh].
by rewrite (of_key_cells gf gk fk gE) // (of_key_cells gh gk hk gE) // (of_key_cells fh fk hk fE).
Qed.
End Cells.

(* ---------- the cut -------------------------------------------------------- *)
Lemma read_cut_stray t cut p : stray (read_cut t cut) = Some p -> exists2 k, p = Not_a_facet k &
  num k < size cut /\ bucket (sort Pos.leb (nth [::] cut (num k))) t = [::].
Proof.
rewrite /read_cut; set s0 := Cutting _ _ _.
suff [] : num (next (foldl (add_cut t) s0 cut)) = size cut /\
  (stray (foldl (add_cut t) s0 cut) = Some p -> exists2 k, p = Not_a_facet k &
   num k < size cut /\ bucket (sort Pos.leb (nth [::] cut (num k))) t = [::]) by [].
elim/last_ind: cut => // cut row [count IH].
rewrite -cats1 foldl_cat cats1 size_rcons /= num_succ count; split=> //.
case: stray IH => [q IH e|_]; last first.
  case B: bucket => //= -[<-]; exists (next (foldl (add_cut t) s0 cut)) => //.
  by rewrite count ltnSn nth_rcons ltnn eqxx.
have [k pk [lt b]] := IH e; exists k => //.
by rewrite ltnS ltnW // nth_rcons lt.
Qed.

(* The rows that prepare names are at fault.                                   *)
Theorem prepare_blames n before cut after p :
  prepare n before cut = inl p -> blames n before cut after p.
Proof.
rewrite /prepare; case sz: (all (long n) before); last by case=> <-; rewrite /= sz.
case U: first_some => [q|].
  by case=> <-; have [row /repeated_blames b /b] := first_some_mem U.
have un : all uniq before by have := cell_problemE before; rewrite U => /esym/negbFE.
case F: fault => [q|]; first by case=> <-; apply: mates_blame F.
case S: stray => [q|//] [<-]; have [k -> [lt b]] := read_cut_stray S; split=> //.
by rewrite -is_facetE //; have [<- _ _] := matesP F; rewrite b.
Qed.

(* So are those of the checker's verdict Malformed.                            *)
Theorem certify_exec_blames n before cut after p :
  certify_exec n before cut after = Malformed p -> blames n before cut after p.
Proof.
rewrite /certify_exec; case P: prepare => [q|q]; first by case=> <-; apply: prepare_blames P.
case L: (all (long n) after) => /=; last by case=> <-; rewrite /= L orbT.
by case: ifP => // _; do 3![case: (find_clash _ _) => [[]//|] || case: find_apart => [[]//|]].
Qed.
