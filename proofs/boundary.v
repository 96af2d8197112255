(******************************************************************************)
(* The boundary of a pseudo-manifold is closed (T10, modulo two).             *)
(*   T10_mod2   == every ridge, that is every set of n - 1 vertices, lies in  *)
(*                 an even number of boundary facets (the paper shows the     *)
(*                 boundary of a tetrahedral mesh as a surface, which it is   *)
(*                 not always; that it has no rim is true always)             *)
(*   T10_unglue == so it is after unglue                                      *)
(* For coherent complexes oriented_boundary.v says more, with signs.          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* A sum is odd iff an odd number of its terms are.                           *)
Lemma odd_sum (I : finType) (A : {set I}) (F : I -> nat) :
  odd (\sum_(i in A) F i) = odd #|[set i in A | odd (F i)]|.
Proof.
rewrite -sum1dep_card big_mkcondr !(big_morph odd oddD erefl).
by apply: eq_bigr => i _; case: odd.
Qed.

Section Boundary.
Variables (n : nat) (V T : finType) (M : complex n V T).

(* The facets of a cell that contain one of its ridges: there are two.        *)
Lemma two_facets (r : {set V}) t : #|r|.+1 = n -> r \subset M t ->
  #|[set f : {set V} | [&& #|f| == n, r \subset f & f \subset M t]]| = 2.
Proof.
move=> cr rt; have <- : #|M t :\: r| = 2.
  by rewrite cardsD (setIidPr rt) card_vertices -[in LHS]cr -addn2 addKn.
have inj : {in M t :\: r &, injective (fun v => facet M (v, t))}.
  by move=> v w; rewrite inE => /andP[_ vt] _ /(facet_inj vt).
rewrite -(card_in_imset inj); apply: eq_card => f; rewrite inE.
apply/and3P/imsetP => [[/eqP cf rf ft]|[v]].
  have [v vt fE] := facetP ft cf; exists v => //; rewrite inE vt andbT.
  by move: rf; rewrite fE => /subsetP rf; apply/negP => /rf; rewrite !inE eqxx.
rewrite inE => /andP[vr vt] ->; rewrite card_facet // facet_sub; split=> //.
by rewrite subsetD1 rt vr.
Qed.

(* T10: the boundary of a pseudo-manifold is closed: an even number of its
   facets meet in each ridge r.                                               *)
Theorem T10_mod2 (r : {set V}) : pseudo_manifold M -> #|r|.+1 = n ->
  ~~ odd #|[set f in boundary M | r \subset f]|.
Proof.
move=> pm cr; pose F := [set f : {set V} | (#|f| == n) && (r \subset f)].
have twice : \sum_(f in F) #|cofaces M f| = 2 * #|[set t | r \subset M t]|.
  transitivity (\sum_(f in F) \sum_(t | f \subset M t) 1).
    by apply: eq_bigr => f _; rewrite sum1_card; apply: eq_card => t; rewrite !inE.
  rewrite (exchange_big_dep (fun t => r \subset M t)) /=; last first.
    by move=> f t; rewrite inE => /andP[_ rf] ft; exact: subset_trans rf ft.
  rewrite mulnC -sum_nat_const; apply: eq_big => [t|t rt]; first by rewrite inE.
  rewrite sum1_card -(two_facets cr rt); apply: eq_card => f.
  by rewrite unfold_in !inE andbA.
have := odd_sum F (fun f => #|cofaces M f|); rewrite twice mul2n odd_double => /esym even.
rewrite (_ : [set f in boundary M | _] = [set f in F | odd #|cofaces M f|]) ?even //.
apply/setP=> f; rewrite !inE; case cf: (#|f| == n) => //=.
by case: #|_| (pm f (eqP cf)) => [|[|[|]]] //= _; rewrite ?andbF ?andbT.
Qed.

End Boundary.

(* T10: the boundary is closed after unglue as well.                          *)
Theorem T10_unglue n (V T : finType) (M : complex n V T) (C : {set {set V}})
    (r : {set V * T}) :
  pseudo_manifold M -> #|r|.+1 = n -> ~~ odd #|[set f in boundary (unglue M C) | r \subset f]|.
Proof. by move=> pm; apply: T10_mod2; exact: T2_pseudo_manifold. Qed.
