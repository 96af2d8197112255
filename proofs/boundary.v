(* boundary.v : T10, the boundary of a pseudo-manifold is closed (mod 2).     *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Boundary.
Variables (n : nat) (V T : finType) (M : complex n V T).

(* facets with exactly one cell                                               *)
Definition bd : {set {set V}} := [set f : {set V} | (#|f| == n) && (#|cofaces M f| == 1)].
Definition facets : {set {set V}} := [set f : {set V} | (#|f| == n) && (0 < #|cofaces M f|)].

(* facets of t that contain the ridge r, |r| = n-1 : exactly two              *)
Lemma two_facets (r : {set V}) t : #|r|.+1 = n -> r \subset M t ->
  #|[set f : {set V} | [&& #|f| == n, r \subset f & f \subset M t]]| = 2.
Proof.
move=> cr rt; have c2 : #|M t :\: r| = 2.
  by rewrite cardsD (setIidPr rt) card_vertices -[in LHS]cr -addn2 addKn.
rewrite -c2; rewrite -(card_in_imset (f := fun v => v |: r) (D := M t :\: r)).
  apply: eq_card => f; rewrite inE; apply/and3P/imsetP => [[/eqP cf rf ft]|[v]].
    have /cards1P[v fv] : #|f :\: r| == 1 by rewrite cardsD (setIidPr rf) cf -cr subSnn.
    exists v.
      have : v \in f :\: r by rewrite fv inE.
      by rewrite !inE => /andP[-> /(subsetP ft) ->].
    rewrite -fv; apply/setP=> x; rewrite !inE.
    by case xr: (x \in r); rewrite ?orbT ?orbF //= (subsetP rf).
  rewrite inE => /andP[vr vt] ->; rewrite cardsU1 vr add1n cr eqxx subsetUr.
  by split=> //; rewrite subUset sub1set vt.
move=> v w; rewrite inE => /andP[vr _] _ /= e.
have : v \in w |: r by rewrite -e !inE eqxx.
by rewrite !inE (negPf vr) orbF => /eqP.
Qed.

Theorem T10_mod2 (r : {set V}) : pseudo_manifold M -> #|r|.+1 = n ->
  ~~ odd #|[set f in bd | r \subset f]|.
Proof.
move=> pm cr.
pose F := [set f : {set V} | (#|f| == n) && (r \subset f)].
have dbl : \sum_(f in F) #|cofaces M f| = 2 * #|[set t | r \subset M t]|.
  transitivity (\sum_(f in F) \sum_(t | f \subset M t) 1).
    by apply: eq_bigr => f _; rewrite sum1_card; apply: eq_card => t; rewrite !inE.
  rewrite (exchange_big_dep (fun t => r \subset M t)) /=; last first.
    by move=> f t; rewrite inE => /andP[_ rf] ft; exact: subset_trans rf ft.
  rewrite mulnC -sum_nat_const; apply: eq_big => [t|t rt]; first by rewrite inE.
  rewrite sum1_card -(two_facets cr rt); apply: eq_card => f.
  by rewrite unfold_in !inE andbA.
have odd_sum (A : {set {set V}}) (g : {set V} -> nat) :
    odd (\sum_(f in A) g f) = odd #|[set f in A | odd (g f)]|.
  have -> : #|[set f in A | odd (g f)]| = \sum_(f in A) odd (g f).
    by rewrite -sum1dep_card big_mkcondr; apply: eq_bigr => f _; case: odd.
  by rewrite !(big_morph odd oddD erefl); apply: eq_bigr => f _; rewrite oddb.
have := odd_sum F (fun f => #|cofaces M f|); rewrite dbl mul2n odd_double => /esym o.
rewrite (_ : [set f in bd | _] = [set f in F | odd #|cofaces M f|]) ?o //.
apply/setP=> f; rewrite !inE; case cf: (#|f| == n) => //=.
have := pm f (eqP cf); case: #|cofaces M f| => [|[|[|]]] //= _; rewrite ?andbF ?andbT //.
Qed.
End Boundary.

(* the boundary complex after unglue is closed                                *)
Corollary T10_unglue n (V T : finType) (M : complex n V T) (C : {set {set V}}) (r : {set V * T}) :
  pseudo_manifold M -> #|r|.+1 = n -> ~~ odd #|[set f in bd (unglue M C) | r \subset f]|.
Proof. by move=> pm; apply: T10_mod2; exact: T2_pseudo_manifold. Qed.
