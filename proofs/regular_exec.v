(******************************************************************************)
(* Is a complex that is given as lists regular for a cut? Decided by running. *)
(*                                                                            *)
(*  regular_exec n cells cut == Some true: corners that share a vertex have   *)
(*                    one class; Some false: they have not; None: the lists   *)
(*                    are no pseudo-manifold with a cut of facets             *)
(*        regb n cs cut == the same on lists of natural numbers, for the      *)
(*                    complexes of listed_complex.v                           *)
(*                                                                            *)
(* Theorem regularP: what it answers is so. For an example, the script is     *)
(* `by apply: regular_by; vm_compute`, or irregular_by for the contrary       *)
(* (mathcomp's connect does not compute).                                     *)
(******************************************************************************)
From Coq Require Import PArith FMapPositive.
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue listed_complex tries quick_find half_facets.
From Cleave Require Import listed prepare denote valid certify_exec.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition regular_exec n (cells cut : seq (seq positive)) : option bool :=
  if prepare n cells cut is inr p then
    let s := classes_of (edges p) in
    Some (if find_clash (fun x => (x.1, name s x.2)) (corner_rows p) is None then true else false)
  else None.

Lemma regular_execP n nv cells cut b (ok : wf n nv (nats cells)) :
  regular_exec n cells cut = Some b ->
  reflect (regular (ecomplex ok) (ecut nv (nats cut))) b.
Proof.
rewrite /regular_exec; case P: prepare => [//|p] [<-].
have [-> _ _ names] := prepare_edges ok P.
have := find_clashP (fun x => (x.1, name (classes_of (edges p)) x.2)) (number cells).
case: find_clash => [[c d] bad|same]; constructor.
  case: bad => x [y [xl yl _ /= e ne]]; have [x' cx xE] := listed_corner ok xl.
  have [y' cy yE] := listed_corner ok yl.
  rewrite xE yE /= in e ne => r; case/negP: ne; rewrite names // copy_eq.
  case: x' y' cx cy e {xE yE} => v t [w u] /= vt wu /pos_inj e; subst w; exact: r.
move=> v t u vt vu; rewrite -copy_eq -names //; apply/eqP.
exact: (same _ _ (corner_listed (x := (v, t)) vt) (corner_listed (x := (v, u)) vu)).
Qed.

Definition positives (cs : cellsT) : seq (seq positive) := [seq [seq pos v | v <- c] | c <- cs].

Lemma positivesK : cancel positives nats.
Proof.
move=> cs; rewrite /nats /positives -map_comp -[RHS]map_id; apply: eq_map => c /=.
by rewrite -map_comp -[RHS]map_id; apply: eq_map => v /=; exact: posK.
Qed.

Definition regb n (cs cut : cellsT) : option bool := regular_exec n (positives cs) (positives cut).

Theorem regularP n nv cs cut b (ok : wf n nv cs) : regb n cs cut = Some b ->
  reflect (regular (ecomplex ok) (ecut nv cut)) b.
Proof.
rewrite /regb; have := positivesK cs; have := positivesK cut.
move: (positives cs) (positives cut) => p q e e'; subst cs; subst cut.
exact: regular_execP.
Qed.

Corollary regular_by n nv cs cut (ok : wf n nv cs) : regb n cs cut = Some true ->
  regular (ecomplex ok) (ecut nv cut).
Proof. by move/(regularP ok)=> /elimT; apply. Qed.

Corollary irregular_by n nv cs cut (ok : wf n nv cs) : regb n cs cut = Some false ->
  ~ regular (ecomplex ok) (ecut nv cut).
Proof. by move/(regularP ok)=> /elimF; apply. Qed.
