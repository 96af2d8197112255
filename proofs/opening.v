(******************************************************************************)
(* Which facets open (T3), and that the result is cut-regular (T4).           *)
(*   T3_opens T3_adjacent T3_mates == two cells lose their common facet iff   *)
(*               one of its vertices has their corners in two components      *)
(*   T3_boundary == hence the boundary after unglue, exactly                  *)
(*   T3_only     == a facet outside C never opens                             *)
(*   T3_old T3_old_boundary == nothing grows together; old boundary stays     *)
(*   T4_lifted T4_cut_regular == the result is cut-regular, whatever M was    *)
(* Definition 2 says that unglue adds these and only these triangles to the   *)
(* boundary. "Only these" is T3_only. "These" is false (Figure 7,             *)
(* examples.v); T3_boundary says what is true, and universal.v that no        *)
(* splitting of vertices can do better. C++: opened, shut of Relabelling, and *)
(* OpenedFacet::by.                                                           *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import connectivity complex isomorphism relabelling copies.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Opening.
Variables (n : nat) (V T : finType) (M : complex n V T).
Implicit Types (t u : T) (v : V) (C : {set {set V}}) (x y : V * T).

(* T3: cells share a facet after iff they did before and each of its vertices
   has its two corners in one component.                                      *)
Theorem T3_adjacent C t u : adjacent (unglue M C) t u =
  adjacent M t u && [forall v in common M t u, connect (glue M C) (v, t) (v, u)].
Proof.
rewrite adjacent_relabel; congr (_ && _); apply: eq_forallb => v.
by rewrite copy_eq.
Qed.

(* T3: an interior facet opens iff one of its vertices gets two copies there. *)
Theorem T3_opens C t u : adjacent M t u ->
  ~~ adjacent (unglue M C) t u = [exists v in common M t u, copy M C (v, t) != copy M C (v, u)].
Proof. by move=> tu; rewrite adjacent_relabel tu negb_forall_in. Qed.

(* T3, for half-facets: mates after are mates before that stay together.      *)
Theorem T3_mates C x y : mates (unglue M C) (after M C x) (after M C y) =
  mates M x y && [forall v in facet M x, copy M C (v, x.2) == copy M C (v, y.2)].
Proof. exact: mates_relabel. Qed.

(* T3: a half-facet is on the boundary after iff from each mate that it had
   some vertex has come apart (a pseudo-manifold allows at most one mate).    *)
Theorem T3_boundary C x : corner M x ->
  (facet (unglue M C) (after M C x) \in boundary (unglue M C)) =
  [forall y, mates M x y ==> [exists v in facet M x, copy M C (v, x.2) != copy M C (v, y.2)]].
Proof. exact: boundary_relabel. Qed.

(* T3: only facets of the cut open.                                           *)
Theorem T3_only C t u : adjacent M t u -> common M t u \notin C -> adjacent (unglue M C) t u.
Proof. by move=> tu nC; apply: (respects_adjacent (copyK M C) (@copy_respects _ _ _ M C)). Qed.

(* T3: cells that shared no facet do not share one now.                       *)
Theorem T3_old C t u : adjacent (unglue M C) t u -> adjacent M t u.
Proof. exact: adjacent_relabel_sub. Qed.

(* T3: what was boundary is boundary.                                         *)
Theorem T3_old_boundary C x : corner M x -> facet M x \in boundary M ->
  facet (unglue M C) (after M C x) \in boundary (unglue M C).
Proof.
move=> cx; rewrite boundaryP // => /existsPn no; rewrite T3_boundary //.
by apply/forallP => y; rewrite (negPf (no y)).
Qed.

(* T4: the copies hold together even if the facets of C that stayed shut are
   cut through: no cut of C would have any further effect.                    *)
Theorem T4_lifted C : regular (unglue M C) (lifted parent C).
Proof.
move=> w t u /imsetP[v vt ->] /imsetP[v' v'u e].
have vv' : v = v' by have := congr1 fst e; rewrite !copyK.
subst v'; have := connect_relabel (copyK M C) (v, t) (v, u) (@copy_respects _ _ _ M C).
by rewrite /up /= -e -(copy_eq M) e eqxx => ->.
Qed.

(* T4: the result is cut-regular, whatever the input was.                     *)
Theorem T4_cut_regular C : cut_regular (unglue M C).
Proof. exact: regularS (sub0set _) (@T4_lifted C). Qed.

End Opening.
