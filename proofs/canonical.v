(******************************************************************************)
(* The numbering of vertices that every writer uses (T12). While an incision  *)
(* lives, its vertex ids are handles: a new copy gets the least free id. So   *)
(* two sequences of cuts with the same scored set may end with different ids. *)
(* Say that a mesh has the vertices 0 to 9. If cut A comes first, then cut B, *)
(* the copy that A opens is 10 and that of B is 11; if B comes first, it is   *)
(* the other way round. But the partition of the corners into vertices does   *)
(* not depend on the order (T12_alone), so neither do names that are made of  *)
(* the partition and the original numbers alone: each vertex is named by its  *)
(* least corner. Original vertices have the numbers 0 to #|V| - 1; that of v  *)
(* is enum_rank v.                                                            *)
(*              rank x == the number of the corner x; any that is injective   *)
(*                        will do, the library's is corner_number             *)
(*               lab x == the vertex of the corner x after some cuts; corners *)
(*                        that share one shared one at the start (lab_home)   *)
(*         least lab x == the least corner of the vertex of x;                *)
(*                        Complex::a_corner                                   *)
(*             first x == the least corner of the vertex x had at the start   *)
(*          kept lab x == the vertex of x holds first x. It keeps the number  *)
(*                        of the original; the others are copies.             *)
(*          copies lab == the least corners of the copies, ascending by the   *)
(*                        original vertex, then by themselves                 *)
(*     canonical lab x == the number of the vertex of x: that of the original *)
(*                        if it is kept; the copies follow in their order,    *)
(*                        from #|V| on; canonical of incision.cpp             *)
(*      keeps lab lab' == a corner that is the least of its vertex both before*)
(*                        and after a cut or a stitch keeps its id, as        *)
(*                        Ungluing::commit and VertexUnions have it           *)
(*          handed lab == the ids lab come from those of the start by cuts and*)
(*                        stitches that keep ids in this way                  *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Canonical.
Variables (n : nat) (V T : finType) (M : complex n V T) (rank : V * T -> nat).
Hypothesis rank_inj : {in corner M &, injective rank}.
Implicit Types (v : V) (t u : T) (x y z : V * T).

Section Least.
Variables (W : eqType) (lab : V * T -> W).

Definition least x := [arg min_(y < x | corner M y && (lab y == lab x)) rank y].

Lemma leastP x : corner M x -> [/\ corner M (least x), lab (least x) = lab x &
  forall y, corner M y -> lab y = lab x -> rank (least x) <= rank y].
Proof.
move=> cx; rewrite /least; case: arg_minnP => [|y /andP[cy /eqP e] min]; first by rewrite cx /=.
by split=> // z cz ez; apply: min; rewrite cz ez eqxx.
Qed.

Lemma least_unique x y : corner M x -> corner M y -> lab y = lab x ->
  (forall z, corner M z -> lab z = lab x -> rank y <= rank z) -> least x = y.
Proof.
move=> cx cy e min; have [cl el lmin] := leastP cx.
by apply: rank_inj => //; apply/eqP; rewrite eqn_leq lmin ?min.
Qed.

Lemma least_eq x y : corner M x -> corner M y -> (least x == least y) = (lab x == lab y).
Proof.
move=> cx cy; have [cl el min] := leastP cy; have [_ ex _] := leastP cx.
apply/eqP/eqP => [e|e]; first by rewrite -ex e.
by apply: least_unique => // [|z cz ez]; [rewrite e | apply: min => //; rewrite ez].
Qed.

Lemma least_least x : corner M x -> least (least x) = least x.
Proof. by move=> cx; have [cl el _] := leastP cx; apply/eqP; rewrite least_eq // el. Qed.

End Least.

Definition first := least fst.

Lemma first_eq x y : corner M x -> corner M y -> x.1 = y.1 -> first x = first y.
Proof. by move=> cx cy e; apply/eqP; rewrite least_eq // e. Qed.

Section Names.
Variables (W : eqType) (lab : V * T -> W).
Hypothesis lab_home : {in corner M &, forall x y, lab x = lab y -> x.1 = y.1}.
Local Notation least := (least lab).

Definition kept x := lab (first x) == lab x.

Lemma kept_eq x y : corner M x -> corner M y -> lab x = lab y -> kept x = kept y.
Proof. by move=> cx cy e; rewrite /kept e (first_eq cx cy) //; exact: lab_home. Qed.

Definition precedes y z :=
  (enum_rank y.1 < enum_rank z.1) || (y.1 == z.1) && (rank y <= rank z).
Definition copies := sort precedes (enum [set y | [&& corner M y, least y == y & ~~ kept y]]).

Definition canonical x : nat :=
  if kept x then enum_rank x.1 : nat else #|V| + index (least x) copies.

Lemma mem_copies y : (y \in copies) = [&& corner M y, least y == y & ~~ kept y].
Proof. by rewrite mem_sort mem_enum inE. Qed.

Lemma copies_uniq : uniq copies. Proof. by rewrite sort_uniq enum_uniq. Qed.

Lemma least_copies x : corner M x -> (least x \in copies) = ~~ kept x.
Proof.
move=> cx; have [cl el _] := leastP lab cx.
by rewrite mem_copies cl least_least // eqxx (kept_eq cl cx el).
Qed.

Lemma canonical_lt x : corner M x -> canonical x < #|V| + size copies.
Proof.
move=> cx; rewrite /canonical; case k: (kept x); first exact: ltn_addr.
by rewrite ltn_add2l index_mem least_copies // k.
Qed.

(* T12: two corners get the same number iff they share their vertex.          *)
Theorem T12_canonical_injective x y : corner M x -> corner M y ->
  (canonical x == canonical y) = (lab x == lab y).
Proof.
move=> cx cy; apply/eqP/eqP => [|e]; last first.
  rewrite /canonical (kept_eq cx cy e) (lab_home cx cy e).
  by have /eqP-> : least x == least y by rewrite least_eq // e.
have lt v k : (enum_rank v : nat) = #|V| + k -> False.
  by move=> e; have := ltn_ord (enum_rank v); rewrite e -ltn_subRL subnn.
rewrite /canonical; case kx: (kept x).
  case ky: (kept y) => /= => [/ord_inj/enum_rank_inj e|/lt[]].
  by rewrite -(eqP kx) -(eqP ky) (first_eq cx cy e).
case ky: (kept y) => /= => [/esym/lt[]|/addnI e]; apply/eqP; rewrite -least_eq //; apply/eqP.
by rewrite -[LHS](nth_index x (s := copies)) ?e ?nth_index ?least_copies ?kx ?ky.
Qed.

(* T12: a vertex that is not split keeps its number.                          *)
Theorem T12_canonical_whole x : corner M x ->
  (forall y, corner M y -> y.1 = x.1 -> lab y = lab x) -> canonical x = enum_rank x.1.
Proof.
move=> cx whole; have [cf ef _] := leastP fst cx.
by rewrite /canonical /kept (whole _ cf ef) eqxx.
Qed.

(* T12: of a vertex that is split, the part with its least corner keeps the
   number.                                                                    *)
Theorem T12_canonical_first x : corner M x ->
  (canonical x == enum_rank x.1 :> nat) = (lab x == lab (first x)).
Proof.
move=> cx; rewrite [RHS]eq_sym -/(kept x) /canonical; case: (kept x); first exact: eqxx.
by apply/negbTE; rewrite neq_ltn orbC (leq_trans (ltn_ord _)) // leq_addr.
Qed.

(* T12: no number is left out, if every original vertex is one of a cell.     *)
Theorem T12_canonical_range i : used M = setT ->
  (i < #|V| + size copies) <-> exists2 x, corner M x & canonical x = i.
Proof.
move=> all; split=> [|[x cx <-]]; last exact: canonical_lt.
have [lt _|le] := ltnP i #|V|.
  pose v := enum_val (Ordinal lt); have /usedP[t vt] : v \in used M by rewrite all inE.
  have cx : corner M (v, t) by [].
  have [cf ef _] := leastP fst cx; exists (first (v, t)) => //.
  by rewrite /canonical /kept (first_eq cf cx) // eqxx ef enum_valK.
rewrite -{1}(subnKC le) ltn_add2l => lt.
have [c _] : exists c, c \in copies by case: copies lt => // c s _; exists c; rewrite inE eqxx.
pose y := nth c copies (i - #|V|); have : y \in copies by exact: mem_nth.
rewrite mem_copies => /and3P[cy /eqP ly /negbTE ky]; exists y => //.
by rewrite /canonical ky ly index_uniq ?copies_uniq // subnKC.
Qed.

(* T12: copies come in the order of their originals, and of their least
   corners if they have the same original.                                    *)
Theorem T12_canonical_order x y : corner M x -> corner M y ->
  ~~ kept x -> ~~ kept y -> canonical x < canonical y -> precedes (least x) (least y).
Proof.
move=> cx cy kx ky; rewrite /canonical (negPf kx) (negPf ky) ltn_add2l.
have tr : transitive precedes.
  move=> b a c; rewrite /precedes => /orP[ab|/andP[/eqP-> ab]] /orP[bc|/andP[/eqP<- bc]].
  - by rewrite (ltn_trans ab bc).
  - by rewrite ab.
  - by rewrite bc.
  - by rewrite eqxx (leq_trans ab bc) orbT.
have tot : total precedes.
  move=> a b; rewrite /precedes; have [e|ne] := eqVneq a.1 b.1.
    by rewrite e ltnn leq_total.
  rewrite !orbF -neq_ltn.
  by apply: contra ne => /eqP/val_inj/enum_rank_inj/eqP.
move=> lt; rewrite -[least x](nth_index x (s := copies)) ?least_copies //.
rewrite -[least y](nth_index x (s := copies)) ?least_copies //.
by apply: (sorted_ltn_nth tr) lt; rewrite ?sort_sorted ?inE ?index_mem ?least_copies.
Qed.

End Names.

(* T12: the numbers depend on the partition of corners into vertices alone.   *)
Theorem T12_canonical_partition (W W' : eqType) (lab : V * T -> W) (lab' : V * T -> W') :
  {in corner M &, forall x y, (lab x == lab y) = (lab' x == lab' y)} ->
  {in corner M, canonical lab =1 canonical lab'}.
Proof.
move=> same x cx.
have kE y : corner M y -> kept lab y = kept lab' y.
  by move=> cy; have [cf _ _] := leastP fst cy; rewrite /kept same.
have lE y : corner M y -> least lab y = least lab' y.
  move=> cy; have [cl el min] := leastP lab' cy.
  apply: least_unique => // [|z cz /eqP ez]; first by apply/eqP; rewrite same // el.
  by apply: min => //; apply/eqP; rewrite -same.
rewrite /canonical kE // lE //; congr (if _ then _ else _ + index _ _).
rewrite /copies; congr (sort _ _); apply: eq_enum => y; rewrite !inE.
by case cy: (corner M y) => //=; rewrite kE // lE.
Qed.

(* Ids while an incision lives, of any type.                                  *)
Section Handles.
Variables (I : eqType) (id_of : V -> I).
Implicit Types lab : V * T -> I.

Definition keeps lab lab' :=
  forall x, corner M x -> least lab x = x -> least lab' x = x -> lab' x = lab x.

Inductive handed : (V * T -> I) -> Prop :=
| at_start : handed (fun x => id_of x.1)
| handed_on lab lab' : handed lab -> keeps lab lab' ->
    {in corner M &, forall x y, lab' x = lab' y -> x.1 = y.1} -> handed lab'.

(* T12: at all times the part of v with its least corner has the id of v
   itself, so the writer may tell copies from originals by their ids.         *)
Theorem T12_handles lab : injective id_of -> handed lab ->
  {in corner M, forall x, kept lab x = (lab x == id_of x.1)}.
Proof.
move=> id_inj h x cx; have [cf ef min] := leastP fst cx.
have own l : {in corner M &, forall y z, l y = l z :> I -> y.1 = z.1} ->
    least l (first x) = first x.
  move=> lp; apply: least_unique => // z cz e.
  by apply: min => //; rewrite -ef; exact: lp e.
suff [e _] : lab (first x) = id_of x.1 /\ least lab (first x) = first x by rewrite /kept e eq_sym.
elim: h => [|l l' _ [<- ll] keep lp].
  by rewrite ef; split=> //; apply: own => y z _ _ /id_inj.
by split; [apply: keep => //; exact: own | exact: own].
Qed.

(* T12: to take the latest cut back gives the very ids from before it: lab
   before the cut, lab' after it, lab2 after the stitch.                      *)
Theorem T12_handles_undo lab lab' lab2 : keeps lab lab' -> keeps lab' lab2 ->
  {in corner M &, forall x y, lab' x = lab' y -> lab x = lab y} ->
  {in corner M &, forall x y, (lab2 x == lab2 y) = (lab x == lab y)} ->
  {in corner M, lab2 =1 lab}.
Proof.
move=> k1 k2 cut back x cx; have [cy exy min] := leastP lab cx; set y := least lab x in cy exy min.
have l0 : least lab y = y by exact: least_least.
have l1 : least lab' y = y.
  apply: least_unique => // z cz /(cut _ _ cz cy) e.
  by apply: min => //; rewrite e.
have l2 : least lab2 y = y.
  apply: least_unique => // z cz /eqP; rewrite back // => /eqP e.
  by apply: min => //; rewrite e.
by rewrite -exy -(k1 y) // -(k2 y) //; apply/eqP; rewrite back // exy.
Qed.
End Handles.

End Canonical.
