(******************************************************************************)
(* The complex that lists of positives denote, and why prepare.v is right     *)
(* about it.                                                                  *)
(*                                                                            *)
(*            nats rows == the rows with vertex p as the natural number p - 1 *)
(*                         (num p); listed_complex.v makes of these           *)
(*         set_of s     == the vertices listed in s, as a set                 *)
(*          corner_of x == the number of corner x                             *)
(*         fits nv rows == all vertices are below nv                          *)
(*  is_facet n cells row == row lists the n vertices of a facet of a cell     *)
(*                                                                            *)
(* Theorems: pseudo_manifold_good (what the mating pass checks is that the    *)
(* complex is a pseudo-manifold), prepare_complete (prepare succeeds exactly  *)
(* on pseudo-manifolds with a cut of facets), prepare_edges (its edges are    *)
(* the pairs of glued corners, so the classes of corners are those of         *)
(* unglue).                                                                   *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue listed_complex tries quick_find half_facets listed prepare.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---------- the complex that lists of positives denote --------------------- *)
Definition nats (rows : seq (seq positive)) : cellsT := [seq [seq num p | p <- r] | r <- rows].

Section Link.
Variables (n nv : nat) (cells cut : seq (seq positive)).
Hypothesis ok : wf n nv (nats cells).
Local Notation M := (ecomplex ok).
Local Notation C := (ecut nv (nats cut)).
Local Notation V := [finType of 'I_nv].
Local Notation T := [finType of 'I_(size (nats cells))].
Implicit Types (v w : V) (t u : T) (p : positive).

Lemma nats_cell t : cell (nats cells) t = [seq num p | p <- cell_of cells t].
Proof. by rewrite /cell (nth_map [::]) // -(size_map (map num)) ltn_ord. Qed.

Lemma pos_mem (v : 'I_nv) (s : seq positive) : (val v \in [seq num p | p <- s]) = (pos v \in s).
Proof. by rewrite -[val v]posK (mem_map num_inj). Qed.

Lemma in_cell v t : (v \in M t) = (pos v \in cell_of cells t).
Proof. by rewrite inE nats_cell pos_mem. Qed.

Lemma wf_uniq : all uniq cells.
Proof.
apply/allP => c /(map_f (map num)) cc; case/andP: ok => /allP/(_ _ cc)/and3P[_ + _] _.
by rewrite (map_inj_uniq num_inj).
Qed.
Hint Resolve wf_uniq : core.

Lemma size_cell t : size (cell_of cells t) = n.+1.
Proof. by have [+ _ _] := cell_ok ok t; rewrite nats_cell size_map. Qed.

Lemma vertex_of p (t : nat) : p \in cell_of cells t -> exists v, pos v = p.
Proof.
move=> pt; have tl := cell_lt pt.
have tl' : t < size (nats cells) by rewrite size_map.
have [_ _ /allP/(_ (num p))] := cell_ok ok (Ordinal tl').
rewrite nats_cell map_f //= => /(_ isT) pb; by exists (Ordinal pb); rewrite /= numK.
Qed.

Definition set_of (s : seq positive) : {set V} := [set v : V | pos v \in s].

Lemma card_set_of s : uniq s -> {subset s <= [pred p | num p < nv]} -> #|set_of s| = size s.
Proof.
move=> us bs; rewrite -(size_map num) -(@card_seq nv) ?(map_inj_uniq num_inj) //.
  by apply: eq_card => v; rewrite !inE pos_mem.
by rewrite all_map; apply/allP => p /bs.
Qed.

Lemma cell_bounded p (t : nat) : p \in cell_of cells t -> num p < nv.
Proof. by case/vertex_of => v <-; rewrite posK. Qed.

Lemma card_set_of_key (t : nat) p : p \in cell_of cells t ->
  #|set_of (key (opposite cells t p))| = n.
Proof.
move=> pt; have tl : t < size (nats cells) by rewrite size_map (cell_lt pt).
rewrite card_set_of ?uniq_key // => [|q]; first by rewrite size_key // (size_cell (Ordinal tl)).
by rewrite mem_key => /andP[/cell_bounded].
Qed.

Lemma set_of_key_sub t p : set_of (key (opposite cells t p)) \subset M t.
Proof. by apply/subsetP => v; rewrite in_cell inE mem_key => /andP[]. Qed.

Lemma set_of_key_eq (t u : nat) p q :
  (set_of (key (opposite cells t p)) = set_of (key (opposite cells u q))) <->
  key (opposite cells t p) = key (opposite cells u q).
Proof.
split=> [/setP e|->//]; apply: key_eq => // r; apply/idP/idP => rk.
  have [v vr] : exists v, pos v = r by move: rk; rewrite mem_key => /andP[/vertex_of].
  by have := e v; rewrite !inE vr rk.
have [v vr] : exists v, pos v = r by move: rk; rewrite mem_key => /andP[/vertex_of].
by have := e v; rewrite !inE vr rk.
Qed.

(* A facet of cell t as a set of n vertices is one opposite some vertex.       *)
Lemma facet_opposite t (f : {set V}) : #|f| = n -> f \subset M t ->
  exists2 p, p \in cell_of cells t & set_of (key (opposite cells t p)) = f.
Proof.
move=> cf ft; have /card_gt0P[a] : 0 < #|M t :\: f|.
  by rewrite cardsD (setIidPr ft) cf card_vertices subSnn.
rewrite inE in_cell => /andP[af pt]; exists (pos a) => //; apply/esym/eqP.
rewrite eqEcard card_set_of_key // cf leqnn andbT; apply/subsetP => v vf.
rewrite inE mem_key -in_cell (subsetP ft) //=; apply: contra af => /eqP e.
suff -> : a = v by []. 
by apply/val_inj; rewrite /= -[LHS]posK -e posK.
Qed.

(* ---------- the cut -------------------------------------------------------- *)
Section Cut.
Hypothesis cut_keys : forall row, row \in cut ->
  sort Pos.leb row \in [seq key f | f <- all_facets (number cells)].

Lemma cutP (t : nat) p : p \in cell_of cells t ->
  (key (opposite cells t p) \in [seq sort Pos.leb row | row <- cut]) =
  (set_of (key (opposite cells t p)) \in C).
Proof.
move=> pt; apply/mapP/idP => [[row rc e]|].
  rewrite inE; apply/hasP; exists [seq num q | q <- row].
    rewrite mem_filter map_f // andbT all_map; apply/allP => q qr /=.
    have : q \in key (opposite cells t p) by rewrite e mem_sort.
    by rewrite mem_key => /andP[/cell_bounded].
  by apply/eqP/setP => v; rewrite !inE pos_mem e mem_sort.
rewrite inE => /hasP[g]; rewrite mem_filter => /andP[_ /mapP[row rc ->]] /eqP/setP e.
exists row => //; have /mapP[f /(mem_all_facets wf_uniq)[u fu ->] ek] := cut_keys rc.
rewrite ek; apply/set_of_key_eq/setP => v.
by have := e v; rewrite !inE pos_mem => ->; rewrite -ek mem_sort.
Qed.

(* ---------- glue ----------------------------------------------------------- *)
Variable c : trie bool.
Hypothesis faultless : fault (mate_all (number cells)) = None.
Hypothesis in_c : forall k, isSome (find_trie k c) = (k \in [seq sort Pos.leb row | row <- cut]).
Let es := uncut_edges c (mates (mate_all (number cells))).

Definition corner_of (x : V * T) : positive := corner_number cells x.2 (pos x.1).

Lemma pos_inj (v w : V) : pos v = pos w -> v = w.
Proof. by move=> /(congr1 num); rewrite !posK => /val_inj. Qed.

Lemma corner_of_inj x y : corner M x -> corner M y -> corner_of x = corner_of y -> x = y.
Proof.
case: x y => v t [w u]; rewrite /corner /= !in_cell => vt wu.
by case/(corner_number_inj vt wu) => /val_inj-> /pos_inj->.
Qed.

Lemma in_opposite v t p : v \in set_of (key (opposite cells t p)) ->
  (pos v, corner_of (v, t)) \in (opposite cells t p).2.
Proof. by rewrite inE mem_key mem_filter mem_sort => /andP[/mem_corner_number-> ->]. Qed.

Lemma glue_edge x y : glue M C x y ->
  (corner_of x, corner_of y) \in es \/ (corner_of y, corner_of x) \in es.
Proof.
case: x y => v t [w u] /and4P[/= /eqP<- vi a nC].
have [p pt pE] := facet_opposite (eqP a) (subsetIl _ _).
have [q qu qE] := facet_opposite (eqP a) (subsetIr _ _).
have kk : key (opposite cells t p) = key (opposite cells u q).
  by apply/set_of_key_eq; rewrite pE.
have fin : opposite cells t p \in all_facets (number cells).
  by apply/(mem_all_facets wf_uniq); exists t.
have gin : opposite cells u q \in all_facets (number cells).
  by apply/(mem_all_facets wf_uniq); exists u.
have vf := in_opposite (t := t) (p := p); rewrite pE in vf; have {}vf := vf _ vi.
have vg := in_opposite (t := u) (p := q); rewrite qE in vg; have {}vg := vg _ vi.
have nc : ~~ isSome (find_trie (key (opposite cells t p)) c) by rewrite in_c cutP // pE.
have [_ _ /(_ _ _ fin gin kk)[fg|fg|gf]] := matesP faultless.
- case: fg => e1 e2 _; have [/val_inj tu _] := corner_number_inj pt qu e2.
  by have := adjacent_neq a; rewrite tu eqxx.
- left; apply/uncut_edgesP.
  exists (opposite cells t p, opposite cells u q), ((pos v, corner_of (v, t)), (pos v, corner_of (v, u))).
  by split=> //=; rewrite mem_zip_numbered ?vf ?vg //= uniq_key ?wf_uniq.
right; apply/uncut_edgesP.
exists (opposite cells u q, opposite cells t p), ((pos v, corner_of (v, u)), (pos v, corner_of (v, t))).
split=> //=; first by rewrite -kk.
by rewrite mem_zip_numbered ?vf ?vg //= uniq_key ?wf_uniq.
Qed.

Lemma edge_glue a b : (a, b) \in es -> exists x y,
  [/\ corner M x, glue M C x y, a = corner_of x & b = corner_of y].
Proof.
move=> /uncut_edgesP[[g f] [[x y] [/= m nc z [-> ->]]]].
have [_ /(_ _ _ m)[gin fin k d] _] := matesP faultless.
have /(mem_all_facets wf_uniq)[t pt gE] := gin; have /(mem_all_facets wf_uniq)[u qu fE] := fin.
move: (g.1.1) (f.1.1) pt qu gE fE d => p q pt qu gE fE d; subst g f.
move: z; rewrite mem_zip_numbered ?uniq_key ?wf_uniq // => /and3P[xg yf /eqP xy].
have tl : t < size (nats cells) by rewrite size_map (cell_lt pt).
have ul : u < size (nats cells) by rewrite size_map (cell_lt qu).
move: (xg) (yf); rewrite !mem_filter !mem_sort => /andP[_ xt] /andP[_ yu].
have /andP[x1 /eqP x2] := row_corner_number wf_uniq xt.
have /andP[y1 /eqP y2] := row_corner_number wf_uniq yu.
have [v vx] := vertex_of x1.
have tu : Ordinal tl != Ordinal ul.
  apply/eqP => -[tu]; subst u; have := mem_key cells t p p; rewrite eqxx andbF k mem_key pt.
  by rewrite d.
have sf : set_of (key (opposite cells t p)) \subset M (Ordinal ul).
  by rewrite k; apply: (set_of_key_sub (Ordinal ul)).
have sg : set_of (key (opposite cells t p)) \subset M (Ordinal tl).
  exact: (set_of_key_sub (Ordinal tl)).
have cE := common_facet (card_set_of_key pt) tu sg sf.
exists (v, Ordinal tl), (v, Ordinal ul); split.
- by rewrite /corner /= in_cell vx.
- rewrite /glue /= eqxx /adjacent cE card_set_of_key // eqxx -cutP // -in_c nc andbT inE vx.
  by rewrite andbT; apply/mapP; exists x.
- by rewrite x2 /corner_of /= vx.
- by rewrite y2 /corner_of /= vx xy.
Qed.

(* Chains of edges are chains of uncut facets around a vertex.                 *)
Theorem eqv_glue x y : corner M x -> corner M y ->
  eqv es (corner_of x) (corner_of y) <-> connect (glue M C) x y.
Proof.
move=> cx cy; pose at_ a := odflt x [pick z | corner M z && (corner_of z == a)].
have atK z : corner M z -> at_ (corner_of z) = z.
  move=> cz; rewrite /at_; case: pickP => [z' /andP[cz' /eqP/corner_of_inj->] //|/(_ z)].
  by rewrite cz eqxx.
split.
  suff H a b : eqv es a b -> connect (glue M C) (at_ a) (at_ b) by move/H; rewrite !atK.
  elim=> {a b} [a|a b|a b _|a b d _ h1 _ h2].
  - exact: connect0.
  - move=> /edge_glue[x' [y' [cx' g -> ->]]]; rewrite !atK ?connect1 //.
    exact: connect_corner (connect1 g) cx'.
  - by rewrite glue_csym.
  - exact: connect_trans h1 h2.
move=> /connectP[s + e]; rewrite {}e {cy at_ atK}.
elim: s x cx => [|z s IHs] x cx /=; first by move=> _; exact: eqv_refl.
move=> /andP[xz /IHs zs]; have cz := connect_corner (connect1 xz) cx.
apply: eqv_trans (zs cz); case: (glue_edge xz) => [xz'|zx]; first exact: eqv_edge.
by apply/eqv_sym/eqv_edge.
Qed.

Theorem name_copy x y : corner M x -> corner M y ->
  (name (classes_of es) (corner_of x) == name (classes_of es) (corner_of y)) =
  (copy M C x == copy M C y).
Proof.
move=> cx cy; rewrite copy_eq; apply/eqP/idP => [/classesP|] h.
  exact/eqv_glue.
exact/classesP/eqv_glue.
Qed.
End Cut.

(* ---------- good facets are a pseudo-manifold ------------------------------ *)
Lemma facet_of (f : facet) : f \in all_facets (number cells) ->
  exists2 t : T, f.1.1 \in cell_of cells t & f = opposite cells t f.1.1.
Proof.
case/(mem_all_facets wf_uniq) => t ft fE; have tl : t < size (nats cells).
  by rewrite size_map (cell_lt ft).
by exists (Ordinal tl).
Qed.

Lemma pseudo_manifold_good : pseudo_manifold M <-> good (all_facets (number cells)).
Proof.
split=> [pm k|g f cf]; last first.
  have [->|[t0]] := set_0Vmem (cofaces M f); first by rewrite cards0.
  rewrite inE => ft0; have [p0 pt0 fE] := facet_opposite cf ft0.
  pose k := key (opposite cells t0 p0).
  have phi t : t \in cofaces M f -> exists2 p, p \in cell_of cells t & key (opposite cells t p) = k.
    rewrite inE => /(facet_opposite cf)[p pt e]; exists p => //.
    by apply/set_of_key_eq; rewrite e.
  have [le2 _] := g k; apply: leq_trans le2; rewrite cardE -(size_map (fun f => f)).
  pose fac t := odflt (opposite cells t0 p0) 
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
  rewrite size_map -(size_map fac); apply: uniq_leq_size.
    rewrite map_inj_in_uniq ?enum_uniq // => t u; rewrite !mem_enum => /facP[p pt [-> _]].
    move=> /facP[q qu [-> _]] [_ e _]; have [/val_inj] := corner_number_inj pt qu e.
    by [].
  move=> h /mapP[t]; rewrite mem_enum => /facP[p pt [-> pk]] ->.
  by rewrite mem_of_key pk eqxx; apply/(mem_all_facets wf_uniq); exists t.
have uk : uniq (of_key (all_facets (number cells)) k).
  by apply: filter_uniq; exact: uniq_all_facets.
have same f g : f \in of_key (all_facets (number cells)) k ->
    g \in of_key (all_facets (number cells)) k -> 
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
have cellP f : f \in of_key (all_facets (number cells)) k -> 
    exists2 t : T, f.1.1 \in cell_of cells t & f = opposite cells t f.1.1.
  by rewrite mem_of_key => /andP[_ /facet_of].
split; last first.
  rewrite map_inj_in_uniq // => f g fk gk e; have [t ft fE] := cellP f fk.
  have [u gu gE] := cellP g gk; exact: (same f g fk gk t u fE gE ft gu (or_introl e)).
case O: (of_key (all_facets (number cells)) k) => [//|f0 s]; rewrite -O.
have f0k : f0 \in of_key (all_facets (number cells)) k by rewrite O inE eqxx.
have [t0 ft0 f0E] := cellP f0 f0k.
pose at_ (f : facet) := odflt t0 [pick t : T | (f.1.1 \in cell_of cells t) && (f == opposite cells t f.1.1)].
have atP f : f \in of_key (all_facets (number cells)) k ->
    f.1.1 \in cell_of cells (at_ f) /\ f = opposite cells (at_ f) f.1.1.
  move=> /cellP[t ft fE]; rewrite /at_; case: pickP => [u /andP[fu /eqP ->] //|/(_ t)].
  by rewrite ft {1}fE eqxx.
have kE : k = key f0 by move: f0k; rewrite mem_of_key => /andP[/eqP].
apply: leq_trans (pm (set_of k) _); last by rewrite kE f0E card_set_of_key.
rewrite cardE -(size_map at_); apply: uniq_leq_size.
  rewrite map_inj_in_uniq // => f g fk gk e; have [ft fE] := atP f fk; have [gu gE] := atP g gk.
  exact: (same f g fk gk _ _ fE gE ft gu (or_intror e)).
move=> t /mapP[f fk ->]; rewrite mem_enum inE; have [ft fE] := atP f fk.
have -> : k = key f by move: fk; rewrite mem_of_key => /andP[/eqP].
by rewrite {1}fE; apply: set_of_key_sub.
Qed.
End Link.

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
have [//|tu] := eqVneq t u; rewrite /cell !(nth_map [::]) //=; apply/negP => /andP[/allP tu1 /allP tu2].
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
  apply/allP => row rc; rewrite -is_facetE //; have [[/(_ S) H _] _] := read_cutP (table (mate_all (number cells))) cut.
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

