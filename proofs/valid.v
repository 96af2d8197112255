(******************************************************************************)
(* When lists of positives are a pseudo-manifold with a cut of its facets:    *)
(* prepare.v finds out, and then hands on the right edges.                    *)
(*                                                                            *)
(*           fits nv rows == all vertices are below nv                        *)
(*   is_facet n cells row == row lists the n vertices of a facet of a cell    *)
(*                                                                            *)
(* Theorems: pseudo_manifold_good (what the mating pass checks is that the    *)
(* complex is a pseudo-manifold), prepare_complete (prepare succeeds exactly  *)
(* on pseudo-manifolds with a cut of facets), prepare_edges (its edges are    *)
(* the pairs of glued corners).                                               *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue listed_complex tries quick_find half_facets.
From Cleave Require Import listed prepare denote.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Good.
Variables (n nv : nat) (cells : seq (seq positive)).
Hypothesis ok : wf n nv (nats cells).
Local Notation M := (ecomplex ok).
Local Notation V := [finType of 'I_nv].
Local Notation T := [finType of 'I_(size (nats cells))].
Implicit Types (t u : T) (p q : positive).
Local Notation all_f := (all_facets (number cells)).

(* ---------- good facets are a pseudo-manifold ------------------------------ *)
Lemma facet_of (f : facet) : f \in all_f ->
  exists2 t : T, f.1.1 \in cell_of cells t & f = opposite cells t f.1.1.
Proof.
case/(mem_all_facets (wf_uniq ok)) => t ft fE; have tl : t < size (nats cells).
  by rewrite size_map (cell_lt ft).
by exists (Ordinal tl).
Qed.

Lemma pseudo_manifold_good : pseudo_manifold M <-> good all_f.
Proof.
split=> [pm k|g f cf]; last first.
  have [->|[t0]] := set_0Vmem (cofaces M f); first by rewrite cards0.
  rewrite inE => ft0; have [p0 pt0 fE] := facet_opposite cf ft0.
  pose k := key (opposite cells t0 p0).
  have phi t : t \in cofaces M f -> exists2 p, p \in cell_of cells t & key (opposite cells t p) = k.
    rewrite inE => /(facet_opposite cf)[p pt e]; exists p => //.
    by apply/(set_of_key_eq ok); rewrite e.
  have [le2 _] := g k; apply: leq_trans le2; rewrite cardE.
  pose fac (t : T) := odflt (opposite cells t0 p0)
    (ohead [seq opposite cells t p | p <- cell_of cells t & key (opposite cells t p) == k]).
  have facP t : t \in cofaces M f -> exists2 p, p \in cell_of cells t &
      fac t = opposite cells t p /\ key (opposite cells t p) = k.
    move=> /phi[p pt e]; rewrite /fac.
    case E: [seq q <- _ | _] => [|q s] /=.
      have : p \in [seq q <- cell_of cells t | key (opposite cells t q) == k].
        by rewrite mem_filter e eqxx.
      by rewrite E.
    have : q \in [seq q <- cell_of cells t | key (opposite cells t q) == k] by rewrite E inE eqxx.
    by rewrite mem_filter => /andP[/eqP kq qt]; exists q.
  rewrite -(size_map fac); apply: uniq_leq_size.
    rewrite map_inj_in_uniq ?enum_uniq // => t u; rewrite !mem_enum => /facP[p pt [-> _]].
    move=> /facP[q qu [-> _]] [_ e _]; have [/val_inj] := corner_number_inj pt qu e.
    by [].
  move=> h /mapP[t]; rewrite mem_enum => /facP[p pt [-> pk]] ->.
  by rewrite mem_of_key pk eqxx; apply/(mem_all_facets (wf_uniq ok)); exists t.
have uk : uniq (of_key all_f k).
  by apply: filter_uniq; exact: uniq_all_facets.
have same f g : f \in of_key all_f k ->
    g \in of_key all_f k -> 
    forall t u : T, f = opposite cells t f.1.1 -> g = opposite cells u g.1.1 ->
    f.1.1 \in cell_of cells t -> g.1.1 \in cell_of cells u ->
    f.1.1 = g.1.1 \/ t = u -> f = g.
  rewrite !mem_of_key => /andP[/eqP fk _] /andP[/eqP gk _] t u fE gE ft gu.
  case=> [e|tu].
    suff tu : t = u by rewrite fE gE -e tu.
    apply: (vertices_inj (c := M)); apply/setP => v; rewrite !in_cell.
    have := mem_key cells t f.1.1 (pos v); have := mem_key cells u g.1.1 (pos v).
    rewrite -fE -gE fk gk e => ->; have [->|_] := eqVneq (pos v) g.1.1.
      by rewrite gu -e ft.
    by rewrite !andbT.
  subst u; rewrite fE gE; congr (opposite _ _ _); apply/eqP; apply: contraTT isT => d.
  have := mem_key cells t f.1.1 f.1.1; rewrite eqxx andbF -fE fk -gk gE mem_key /=.
  by rewrite ft d.
have cellP f : f \in of_key all_f k -> 
    exists2 t : T, f.1.1 \in cell_of cells t & f = opposite cells t f.1.1.
  by rewrite mem_of_key => /andP[_ /facet_of].
split; last first.
  rewrite map_inj_in_uniq // => f g fk gk e; have [t ft fE] := cellP f fk.
  have [u gu gE] := cellP g gk; exact: (same f g fk gk t u fE gE ft gu (or_introl e)).
case O: (of_key all_f k) => [//|f0 s]; rewrite -O.
have f0k : f0 \in of_key all_f k by rewrite O inE eqxx.
have [t0 ft0 f0E] := cellP f0 f0k.
pose at_ (f : facet) := odflt t0
  [pick t : T | (f.1.1 \in cell_of cells t) && (f == opposite cells t f.1.1)].
have atP f : f \in of_key all_f k ->
    f.1.1 \in cell_of cells (at_ f) /\ f = opposite cells (at_ f) f.1.1.
  move=> /cellP[t ft fE]; rewrite /at_; case: pickP => [u /andP[fu /eqP ->] //|/(_ t)].
  by rewrite ft {1}fE eqxx.
have kE : k = key f0 by move: f0k; rewrite mem_of_key => /andP[/eqP].
apply: leq_trans (pm (set_of nv k) _); last by rewrite kE f0E (card_set_of_key ok).
rewrite cardE -(size_map at_); apply: uniq_leq_size.
  rewrite map_inj_in_uniq // => f g fk gk e; have [ft fE] := atP f fk; have [gu gE] := atP g gk.
  exact: (same f g fk gk _ _ fE gE ft gu (or_intror e)).
move=> t /mapP[f fk ->]; rewrite mem_enum inE; have [ft fE] := atP f fk.
have -> : k = key f by move: fk; rewrite mem_of_key => /andP[/eqP].
by rewrite {1}fE; apply: set_of_key_sub.
Qed.
End Good.

(* ---------- when lists are a complex and a cut of it ----------------------- *)
Definition fits nv (rows : seq (seq positive)) := all (all (fun p => num p < nv)) rows.

Lemma longE n row : long n row = (size row == n.+1). Proof. by []. Qed.

Lemma good_wf n nv cells : all (long n) cells -> all uniq cells -> fits nv cells ->
  good (all_facets (number cells)) -> wf n nv (nats cells).
Proof.
move=> /allP sz /allP un /allP fit g; apply/andP; split.
  apply/allP => _ /mapP[c cc ->]; rewrite size_map -longE sz //= (map_inj_uniq num_inj) un //=.
  by rewrite all_map; exact: fit.
apply/allP => t; rewrite mem_iota size_map /= => ts; apply/allP => u; rewrite mem_iota /= => us.
have [//|tu] := eqVneq t u; rewrite /cell !(nth_map [::]) //=.
apply/negP => /andP[/allP tu1 /allP tu2].
have e : cell_of cells t =i cell_of cells u.
  move=> p; rewrite -!(mem_map num_inj); apply/idP/idP; [exact: tu2 | exact: tu1].
have [p pt] : exists p, p \in cell_of cells t.
  have := sz _ (mem_nth [::] ts); rewrite -/(cell_of _ _); case: (cell_of cells t) => //= p s _.
  by exists p; rewrite inE eqxx.
have pu : p \in cell_of cells u by rewrite -e.
have uc : all uniq cells by apply/allP.
have kk : key (opposite cells t p) = key (opposite cells u p).
  by apply: key_eq => // q; rewrite !mem_key e.
have [_ U] := g (key (opposite cells t p)).
have fac i : p \in cell_of cells i -> key (opposite cells i p) = key (opposite cells t p) ->
    opposite cells i p \in of_key (all_facets (number cells)) (key (opposite cells t p)).
  by move=> pi ki; rewrite mem_of_key ki eqxx; apply/(mem_all_facets uc); exists i.
have [] := uniq_map_inj U (fac t pt erefl) (fac u pu (esym kk)) erefl.
by move=> /(corner_number_inj pt pu)[/eqP]; rewrite (negPf tu).
Qed.

Lemma wf_parts n nv cells : wf n nv (nats cells) -> all (long n) cells && all uniq cells.
Proof.
move=> ok; rewrite (wf_uniq ok) andbT; apply/allP => c /(nthP [::])[t ts <-].
have tl : t < size (nats cells) by rewrite size_map.
by have := size_cell ok (Ordinal tl); rewrite /long /cell_of => ->; rewrite [eqn _ _]eqxx.
Qed.

Definition is_facet n (cells : seq (seq positive)) (row : seq positive) :=
  [&& size row == n, uniq row & has (fun c => all (mem c) row) cells].

Lemma is_facetE n (cells : seq (seq positive)) row : all (long n) cells -> all uniq cells ->
  (sort Pos.leb row \in [seq key f | f <- all_facets (number cells)]) = is_facet n cells row.
Proof.
move=> /allP sz un; have szc t p : p \in cell_of cells t -> size (cell_of cells t) = n.+1.
  by move=> pt; apply/eqP/(sz _)/mem_nth/(cell_lt pt).
apply/mapP/and3P => [[f /(mem_all_facets un)[t ft fE] e]|[/eqP sr ur /hasP[c cc /allP rc]]].
  split.
  - by rewrite -(size_sort Pos.leb) e fE size_key // (szc _ _ ft).
  - by rewrite -(sort_uniq Pos.leb) e fE uniq_key.
  - apply/hasP; exists (cell_of cells t); first exact/mem_nth/(cell_lt ft).
    by apply/allP => p; rewrite -(mem_sort Pos.leb) e fE mem_key => /andP[].
have [t ts cE] := nthP [::] cc; have {}cE : c = cell_of cells t by [].
have [p pt pr] : exists2 p, p \in c & p \notin row.
  apply/hasP; rewrite has_predC; apply/negP => /allP sub.
  have := uniq_leq_size (allP un _ cc) sub; rewrite sr.
  by have /eqP-> := sz _ cc; rewrite ltnn.
exists (opposite cells t p); first by apply/(mem_all_facets un); exists t; rewrite -?cE.
apply: sorted_eq_mem; rewrite ?sort_uniq ?uniq_key ?sorted_key //.
  exact/sort_sorted/leb_total.
move=> q; rewrite mem_sort; have sub : {subset row <= key (opposite cells t p)}.
  move=> r rr; rewrite mem_key -cE; apply/andP; split; first exact: rc.
  by apply: contraNneq pr => <-.
have le : size (key (opposite cells t p)) <= size row.
  by rewrite size_key -?cE // sr; have /eqP-> := sz _ cc.
by have [_ ->] := uniq_min_size ur sub le.
Qed.

Theorem prepare_complete n nv cells cut : fits nv cells ->
  (if prepare n cells cut is inr _ then True else False) <->
  exists2 ok : wf n nv (nats cells), pseudo_manifold (ecomplex ok) & all (is_facet n cells) cut.
Proof.
move=> fit; split=> [|[ok pm cf]].
  rewrite /prepare; case sz: (all (long n) cells) => //.
  case U: first_some => [//|]; have un : all uniq cells.
    by have := cell_problemE cells; rewrite U => /esym/negbFE.
  case F: fault => [//|]; have g := (mate_good (number cells)).1 F.
  case S: stray => [//|] _; have ok := good_wf sz un fit g.
  exists ok; first exact/pseudo_manifold_good.
  apply/allP => row rc; rewrite -is_facetE //.
  have [[/(_ S) H _] _] := read_cutP (table (mate_all (number cells))) cut.
  by have [tab _ _] := matesP F; rewrite -tab; exact: H.
have /andP[sz un] := wf_parts ok; rewrite /prepare sz.
case U: first_some => [p|]; first by have := cell_problemE cells; rewrite U un.
have F : fault (mate_all (number cells)) = None by apply/mate_good/(pseudo_manifold_good ok).
rewrite F; case S: stray => [p|//].
suff S' : stray (read_cut (table (mate_all (number cells))) cut) = None by rewrite S' in S.
have [[_ H] _] := read_cutP (table (mate_all (number cells))) cut; apply: H => row rc.
have [tab _ _] := matesP F; rewrite tab (is_facetE row sz un); exact: (allP cf).
Qed.

(* What prepare hands on.                                                      *)
Theorem prepare_edges n nv cells cut p (ok : wf n nv (nats cells)) :
  prepare n cells cut = inr p -> let M := ecomplex ok in let C := ecut nv (nats cut) in
  [/\ corner_rows p = number cells,
      forall x y, glue M C x y ->
        (corner_of x, corner_of y) \in edges p \/ (corner_of y, corner_of x) \in edges p,
      forall a b, (a, b) \in edges p -> exists x y,
        [/\ corner M x, glue M C x y, a = corner_of x & b = corner_of y]
    & forall x y, corner M x -> corner M y ->
        (name (classes_of (edges p)) (corner_of x) == name (classes_of (edges p)) (corner_of y)) =
        (copy M C x == copy M C y)].
Proof.
rewrite /prepare; case sz: (all (long n) cells) => //.
case U: first_some => [//|]; have un := wf_uniq ok.
case F: fault => [//|]; case S: stray => [//|] [<-] /=.
have [[/(_ S) H _] inc] := read_cutP (table (mate_all (number cells))) cut.
have ck row : row \in cut -> sort Pos.leb row \in [seq key f | f <- all_facets (number cells)].
  by have [tab _ _] := matesP F; rewrite -tab; exact: H.
split=> //.
- exact: glue_edge.
- exact: edge_glue.
- exact: name_copy.
Qed.

