(******************************************************************************)
(* Connectivity: what the rest needs about fingraph's connect and says        *)
(* nothing of meshes. connect e is the reflexive and transitive closure of e; *)
(* root e picks one element of each of its classes.                           *)
(*   connect_homo == a map that sends steps to paths sends paths to paths     *)
(*   connect_inv  == what every step leaves alone, every path leaves alone    *)
(*   connect_stay == what every step carries on, every path carries on        *)
(*   connect_sub_in == connect_sub for a relation that never leaves a set     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Connectivity.
Variables (A B : finType) (e : rel A) (e' : rel B).

Lemma connect_homo (f : A -> B) :
    (forall x y, e x y -> connect e' (f x) (f y)) ->
  forall x y, connect e x y -> connect e' (f x) (f y).
Proof.
move=> fe x y /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[xz zs].
exact: connect_trans (fe _ _ xz) (IHs _ zs).
Qed.

Lemma connect_stay (P : A -> Prop) :
    (forall x y, e x y -> P x -> P y) ->
  forall x y, connect e x y -> P x -> P y.
Proof.
move=> eP x y /connectP[s + ->{y}]; elim: s x => [|z s IHs] x //= /andP[xz zs] Px.
exact: IHs zs (eP _ _ xz Px).
Qed.

Lemma connect_inv (D : Type) (f : A -> D) :
  (forall x y, e x y -> f x = f y) -> forall x y, connect e x y -> f x = f y.
Proof. by move=> ef x y /(@connect_stay (fun z => f x = f z)); apply=> // z w /ef <-. Qed.

Lemma connect_sub_in (e2 : rel A) (P : A -> Prop) :
    (forall x y, P x -> e x y -> connect e2 x y /\ P y) ->
  forall x y, P x -> connect e x y -> connect e2 x y.
Proof.
move=> sub x y Px /(@connect_stay (fun z => P z /\ connect e2 x z)).
case=> // z w zw [Pz xz]; have [zw2 Pw] := sub _ _ Pz zw.
by split=> //; apply: connect_trans zw2.
Qed.

End Connectivity.
