(******************************************************************************)
(* The complex that lists of positives denote, and why prepare.v is right     *)
(* about it.                                                                  *)
(*                                                                            *)
(*            nats rows == the rows with vertex p as the natural number p - 1 *)
(*                         (num p); listed_complex.v makes of these           *)
(*         set_of s     == the vertices listed in s, as a set                 *)
(*          corner_of x == the number of corner x                             *)
(*                                                                            *)
(* Theorems: eqv_glue (chains of uncut edges are chains of glued corners),    *)
(* name_copy (so the classes of corners are those of unglue).                 *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue listed_complex tries quick_find half_facets.
From Cleave Require Import listed prepare.
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
  exists (opposite cells t p, opposite cells u q).
  exists ((pos v, corner_of (v, t)), (pos v, corner_of (v, u))).
  by split=> //=; rewrite mem_zip_numbered ?vf ?vg //= uniq_key ?wf_uniq.
right; apply/uncut_edgesP.
exists (opposite cells u q, opposite cells t p).
exists ((pos v, corner_of (v, u)), (pos v, corner_of (v, t))).
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

End Link.
