(******************************************************************************)
(* When is a set of edges of a graph the set of edges between two sets of     *)
(* vertices?  Iff every closed walk uses an even number of them.  Graph: the  *)
(* cells of a complex, or of a star, joined where they share a facet; edges:  *)
(* the facets of a cut.                                                       *)
(*      parity x t p == the walk t, p_0, p_1, .. uses an odd number of the    *)
(*                      edges that x marks                                    *)
(* loop_parity x s   == so does the closed walk s_0, s_1, .., s_0             *)
(* even_walks e x    == no closed walk in e has odd parity                    *)
(* labelling e x lab == the marked edges are those between different labels   *)
(* Main theorems: labellingP, loop_labelling                                  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Parity.
Variables (T : finType) (e : rel T) (x : T -> T -> bool).
Implicit Types (t u : T) (p s : seq T) (lab : T -> bool).

Definition parity t p := odd (count id (pairmap x t p)).
Definition loop_parity s := if s is t :: p then parity t (rcons p t) else false.
Definition even_walks := forall t p, path e t p -> last t p = t -> parity t p = false.
Definition labelling lab := forall t u, e t u -> x t u = lab t (+) lab u.

Lemma parity_cons t u p : parity t (u :: p) = x t u (+) parity u p.
Proof. by rewrite /parity /= oddD oddb. Qed.

Lemma parity_cat t p q : parity t (p ++ q) = parity t p (+) parity (last t p) q.
Proof. by rewrite /parity pairmap_cat count_cat oddD. Qed.

Lemma parity_rcons t p u : parity t (rcons p u) = parity t p (+) x (last t p) u.
Proof. by rewrite -cats1 parity_cat parity_cons addbF. Qed.

Lemma labelling_walk lab t p : labelling lab -> path e t p ->
  parity t p = lab t (+) lab (last t p).
Proof.
move=> labE; elim: p t => [|u p IHp] t /=; first by rewrite addbb.
by move=> /andP[tu up]; rewrite parity_cons IHp // labE // addbA addbK.
Qed.

Hypothesis e_sym : symmetric e.
Hypothesis x_sym : forall t u, e t u -> x t u = x u t.

(* Two copies of the graph, joined crosswise over the marked edges.           *)
Let double : rel (T * bool) := fun y z => e y.1 z.1 && (z.2 == y.2 (+) x y.1 z.1).

Let double_sym : connect_sym double.
Proof.
apply: sym_connect_sym => -[t a] [u b]; rewrite /double /= e_sym.
case eut: (e u t) => //=; rewrite -(x_sym eut).
by case: a b (x u t) => [] [] [].
Qed.

Let double_walk t p a : path e t p -> connect double (t, a) (last t p, a (+) parity t p).
Proof.
elim: p t a => [|u p IHp] t a /=; first by rewrite addbF connect0.
move=> /andP[tu /IHp up]; rewrite parity_cons addbA; apply: connect_trans (up _).
by apply: connect1; rewrite /double /= tu eqxx.
Qed.

Let walk_double y z : connect double y z ->
  exists2 p, path e y.1 p & last y.1 p = z.1 /\ y.2 (+) parity y.1 p = z.2.
Proof.
move=> /connectP[q + ->{z}]; elim: q y => [|z q IHq] y /=.
  by exists [::] => //; rewrite addbF.
move=> /andP[/andP[yz /eqP z2] /IHq[p zp [l par]]]; exists (z.1 :: p); rewrite /= ?yz //.
by split=> //; rewrite parity_cons addbA -z2.
Qed.

(* Marked edges are those between two sets iff no closed walk is odd.  The    *)
(* label of a vertex is the parity of any walk to it from the root of its     *)
(* piece.                                                                     *)
Theorem labellingP : even_walks <-> exists lab, labelling lab.
Proof.
split=> [even | [lab labE] t p tp closed]; last first.
  by rewrite (labelling_walk labE tp) closed addbb.
have no_both t y : connect double y (t, false) -> connect double y (t, true) -> false.
  rewrite double_sym => yf yt; have /walk_double[p /= tp [closed]] := connect_trans yf yt.
  by rewrite (even t p tp closed).
pose lab t := connect double (root e t, false) (t, true); exists lab.
have labP t b : connect double (root e t, false) (t, b) -> lab t = b.
  by case: b => // f; apply/negP => /(no_both _ _ f).
have lab_root t : connect double (root e t, false) (t, lab t).
  have: connect e (root e t) t by rewrite sym_connect_sym // connect_root.
  move=> /connectP[p tp tE]; rewrite {2 3}tE.
  have := double_walk false tp; rewrite -tE => f.
  by rewrite (labP _ _ f).
move=> t u tu; suff -> : lab u = lab t (+) x t u by rewrite addbA addbb.
apply: labP; have -> : root e u = root e t.
  by apply/esym/eqP; rewrite root_connect ?connect1 //; exact: sym_connect_sym.
by apply: connect_trans (lab_root t) (connect1 _); rewrite /double /= tu eqxx.
Qed.
End Parity.

Section Loop.
Variables (T : finType) (x : T -> T -> bool).
Implicit Types (t u : T) (p s : seq T).

Lemma loop_steps t p : uniq (t :: p) ->
  [seq x u (next (t :: p) u) | u <- t :: p] = pairmap x t (rcons p t).
Proof.
move=> us; apply: (@eq_from_nth _ false); rewrite size_map.
  by rewrite size_pairmap size_rcons.
move=> i i_s; rewrite (nth_map t) // (nth_pairmap t) ?size_rcons // next_nth mem_nth //.
rewrite index_uniq // -rcons_cons !nth_rcons i_s; move: i_s; rewrite /= ltnS leq_eqVlt.
by case/orP => [/eqP->|-> //]; rewrite ltnn eqxx [nth t p _]nth_default.
Qed.

Lemma loop_parityE s : uniq s -> loop_parity x s = odd (count (fun t => x t (next s t)) s).
Proof. by case: s => // t p us; rewrite /= /parity -loop_steps // count_map. Qed.

(* On a loop that is even, the parity of the way from its first element is a  *)
(* label: it changes over the marked steps and only there.                    *)
Lemma loop_labelling s : uniq s -> loop_parity x s = false ->
  exists lab : T -> bool, {in s, forall t, x t (next s t) = lab t (+) lab (next s t)}.
Proof.
case: s => [|t0 p] us even; first by exists xpredT.
pose lab t := parity x t0 (take (index t (t0 :: p)) p); exists lab => t /(nthP t0)[i].
move=> i_s <-; set s := t0 :: p in us i_s *.
have lab_nth j : j <= size p -> lab (nth t0 s j) = parity x t0 (take j p).
  by move=> jp; rewrite /lab index_uniq.
rewrite next_nth mem_nth // index_uniq // lab_nth //; move: i_s; rewrite /= ltnS leq_eqVlt.
case/orP => [/eqP-> | i_p].
  rewrite [nth t0 p _]nth_default // (lab_nth 0) // take0 take_size addbF.
  move: even; rewrite /= parity_rcons (last_nth t0) => /negbT.
  by case: parity; case: (x _ _).
rewrite -[nth t0 p i]/(nth t0 s i.+1) lab_nth // (take_nth t0) // parity_rcons.
rewrite addKb (_ : last t0 (take i p) = nth t0 s i) //.
by rewrite (last_nth t0) size_take i_p -[t0 :: _]/(take i.+1 s) nth_take.
Qed.
End Loop.
