(* exec.v : executable unglue on lists of naturals (quick-find), proved equal  *)
(* to the specification; extractable.                                          *)
From mathcomp Require Import all_ssreflect.
From Cleave Require Import complex unglue.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---------- generic quick-find -------------------------------------------- *)
Section QuickFind.
Variable K : eqType.
Implicit Types (l : seq (K * K)) (es : seq (K * K)) (ks : seq K).

Fixpoint get l (k : K) : K :=
  if l is p :: l' then if p.1 == k then p.2 else get l' k else k.
Definition merge l (e : K * K) :=
  let la := get l e.1 in let lb := get l e.2 in
  [seq (p.1, if p.2 == lb then la else p.2) | p <- l].
Definition run ks es := foldl merge [seq (k, k) | k <- ks] es.

Inductive eqv ks es : K -> K -> Prop :=
| eqv_refl x : x \in ks -> eqv ks es x x
| eqv_step x y : (x, y) \in es -> eqv ks es x y
| eqv_sym x y : eqv ks es x y -> eqv ks es y x
| eqv_trans x y z : eqv ks es x y -> eqv ks es y z -> eqv ks es x z.

Definition inks ks es := all (fun e => (e.1 \in ks) && (e.2 \in ks)) es.

Lemma eqv_in ks es x y : inks ks es -> eqv ks es x y -> (x \in ks) && (y \in ks).
Proof.
move=> /allP ie; elim=> {x y} [x ->|x y /ie|x y _|x y z _ /andP[-> _] _ /andP[_ ->]] //.
by rewrite andbC.
Qed.

Lemma eqv_weak ks es e x y : eqv ks es x y -> eqv ks (rcons es e) x y.
Proof.
elim=> {x y} [x xk|x y xy|x y _|x y z _ h1 _ h2].
- exact: eqv_refl.
- by apply: eqv_step; rewrite mem_rcons inE xy orbT.
- exact: eqv_sym.
- exact: eqv_trans h1 h2.
Qed.

Lemma keys_merge l e : map fst (merge l e) = map fst l.
Proof. by rewrite -map_comp; apply: eq_map. Qed.

Lemma keys_run ks es : map fst (run ks es) = ks.
Proof.
rewrite /run; elim/last_ind: es => [|es e IH] /=.
  by rewrite -map_comp map_id.
by rewrite -cats1 foldl_cat /= keys_merge.
Qed.

Lemma get_map l (g : K -> K) k : k \in map fst l ->
  get [seq (p.1, g p.2) | p <- l] k = g (get l k).
Proof. by elim: l => //= p l IH; rewrite inE eq_sym; case: eqP => //= _ /IH. Qed.

Lemma get_merge l e k : k \in map fst l ->
  get (merge l e) k = if get l k == get l e.2 then get l e.1 else get l k.
Proof. by move=> kl; rewrite /merge (get_map (fun x => if x == _ then _ else x)). Qed.

Theorem runP ks es x y : inks ks es -> x \in ks -> y \in ks ->
  get (run ks es) x = get (run ks es) y <-> eqv ks es x y.
Proof.
elim/last_ind: es x y => [|es [a b] IH] x y.
  move=> _ xk yk; have id z : get (run ks [::]) z = z.
    by rewrite /run /=; elim: ks {xk yk} => //= k ks ->; case: eqP.
  rewrite !id; split=> [->|]; first exact: eqv_refl.
  by elim=> // {x y xk yk} [x y z _ -> _ ->].
rewrite /inks all_rcons => /andP[/= /andP[ak bk] ie] xk yk.
have IH' u v : u \in ks -> v \in ks -> get (run ks es) u = get (run ks es) v <-> eqv ks es u v.
  exact: IH.
have runE z : z \in ks -> get (run ks (rcons es (a, b))) z =
    if get (run ks es) z == get (run ks es) b then get (run ks es) a else get (run ks es) z.
  by move=> zk; rewrite {1}/run -cats1 foldl_cat /= get_merge // keys_run.
have ab : eqv ks (rcons es (a, b)) a b by apply: eqv_step; rewrite mem_rcons inE eqxx.
have lift u v : u \in ks -> v \in ks -> get (run ks es) u = get (run ks es) v ->
    eqv ks (rcons es (a, b)) u v.
  by move=> uk vk e; apply/eqv_weak/IH'.
split.
  rewrite !runE //; case: eqP => [xb|_]; case: eqP => [yb|_] e.
  - by apply: lift; rewrite // xb yb.
  - apply: eqv_trans (lift _ _ xk bk xb) _; apply: eqv_trans (eqv_sym ab) _.
    exact: lift.
  - apply: eqv_sym; apply: eqv_trans (lift _ _ yk bk yb) _.
    by apply: eqv_trans (eqv_sym ab) _; apply: lift.
  - exact: lift.
have ie' : inks ks (rcons es (a, b)) by rewrite /inks all_rcons /= ak bk.
elim=> {x y xk yk} [//|x y|x y _ -> //|x y z _ -> _ -> //].
rewrite mem_rcons inE => /orP[/eqP[-> ->]|xy].
  by rewrite !runE // eqxx; case: eqP.
have /andP[/= xk yk] := allP ie _ xy.
have /IH' e : eqv ks es x y by exact: eqv_step.
by rewrite !runE // e.
Qed.
End QuickFind.

(* ---------- meshes as lists ------------------------------------------------ *)
Definition cellsT := seq (seq nat).
Definition cell (cs : cellsT) t := nth [::] cs t.
Definition shared (a b : seq nat) := [seq v <- a | v \in b].
Definition same_set (a b : seq nat) := all (mem a) b && all (mem b) a.
Definition incut (cut : cellsT) f := has (same_set f) cut.
Definition gluedb n cs cut t u (v : nat) :=
  let f := shared (cell cs t) (cell cs u) in
  [&& v \in f, size f == n & ~~ incut cut f].
Definition corners (cs : cellsT) : seq (nat * nat) :=
  flatten [seq [seq (v, t) | v <- cell cs t] | t <- iota 0 (size cs)].
Definition edges n cs cut : seq ((nat * nat) * (nat * nat)) :=
  flatten [seq flatten [seq
     (let f := shared (cell cs t) (cell cs u) in
      if (size f == n) && ~~ incut cut f then [seq ((v, t), (v, u)) | v <- f] else [::])
     | u <- iota 0 (size cs)] | t <- iota 0 (size cs)].
Definition labels n cs cut := run (corners cs) (edges n cs cut).
(* result: cells with new vertex numbers, and the projection new -> old        *)
Definition unglue_exec n cs cut : cellsT * seq nat :=
  let l := labels n cs cut in
  let names := undup [seq get l c | c <- corners cs] in
  ([seq [seq index (get l (v, t)) names | v <- cell cs t] | t <- iota 0 (size cs)],
   map fst names).

Definition wf n nv (cs : cellsT) :=
  all (fun c => [&& size c == n.+1, uniq c & all (fun v => v < nv) c]) cs &&
  all (fun t => all (fun u => (t == u) || ~~ same_set (cell cs t) (cell cs u))
        (iota 0 (size cs))) (iota 0 (size cs)).

Lemma cornersP cs v t : ((v, t) \in corners cs) = (t < size cs) && (v \in cell cs t).
Proof.
apply/flatten_mapP/andP => [[u]|[ts vt]].
  by rewrite mem_iota add0n => us /mapP[w wu [-> ->]].
by exists t; rewrite ?mem_iota //; apply/mapP; exists v.
Qed.

Lemma edgesP n cs cut x y : ((x, y) \in edges n cs cut) =
  [&& x.2 < size cs, y.2 < size cs, x.1 == y.1 & gluedb n cs cut x.2 y.2 x.1].
Proof.
apply/flatten_mapP/idP => [[t]|/and4P[tx ty /eqP e /and3P[vf sf nc]]].
  rewrite mem_iota add0n => ts /flatten_mapP[u]; rewrite mem_iota add0n => us /=.
  case: ifP => // /andP[sf nc] /mapP[v vf [-> ->]] /=.
  by rewrite (ts : t < size cs) (us : u < size cs) eqxx /gluedb vf sf nc.
exists x.2; first by rewrite mem_iota.
apply/flatten_mapP; exists y.2; first by rewrite mem_iota.
rewrite /= sf nc /=; apply/mapP; exists x.1 => //.
by case: x y e {tx ty vf sf nc} => v t [w u] /= ->.
Qed.

Section Link.
Variables (n nv : nat) (cs : cellsT) (cut : cellsT).
Hypothesis ok : wf n nv cs.
Let nt := size cs.

Lemma cell_ok (t : 'I_nt) :
  [/\ size (cell cs t) = n.+1, uniq (cell cs t) & all (fun v => v < nv) (cell cs t)].
Proof. by case/andP: ok => /allP/(_ _ (mem_nth [::] (ltn_ord t)))/and3P[/eqP]. Qed.

Definition evert (t : 'I_nt) : {set 'I_nv} := [set v : 'I_nv | val v \in cell cs t].

Lemma card_seq (s : seq nat) : uniq s -> all (fun v => v < nv) s ->
  #|[set v : 'I_nv | val v \in s]| = size s.
Proof.
move=> us /allP bs; rewrite cardE -(size_map val); apply/perm_size/uniq_perm => //.
  by rewrite map_inj_uniq ?enum_uniq //; exact: val_inj.
move=> v; apply/mapP/idP => [[w]|vs]; first by rewrite mem_enum inE => ws ->.
by exists (Ordinal (bs _ vs)); rewrite // mem_enum inE.
Qed.

Lemma ecard t : #|evert t| = n.+1.
Proof. by have [<- u b] := cell_ok t; exact: card_seq. Qed.

Lemma evert_inj : injective evert.
Proof.
move=> t u /setP e; apply/val_inj/eqP/negPn/negP => tu.
case/andP: ok => _ /allP/(_ (val t)); rewrite mem_iota ltn_ord => /(_ isT).
move=> /allP/(_ (val u)); rewrite mem_iota ltn_ord (negPf tu) => /(_ isT) /=.
have [_ _ /allP bt] := cell_ok t; have [_ _ /allP bu] := cell_ok u.
case/negP; apply/andP; split; apply/allP => v vu /=.
  by have := e (Ordinal (bu _ vu)); rewrite !inE /= vu.
by have := e (Ordinal (bt _ vu)); rewrite !inE /= vu => <-.
Qed.

Definition ecomplex : complex n [finType of 'I_nv] [finType of 'I_nt] := Complex ecard evert_inj.
Definition ecut : {set {set 'I_nv}} :=
  [set f | has (fun g => f == [set v : 'I_nv | val v \in g]) [seq g <- cut | all (fun v => v < nv) g]].

Lemma ecommon t u : common ecomplex t u = [set v : 'I_nv | val v \in shared (cell cs t) (cell cs u)].
Proof. by apply/setP=> v; rewrite !inE mem_filter andbC. Qed.

Lemma shared_ok (t u : 'I_nt) : uniq (shared (cell cs t) (cell cs u)) /\
  all (fun v => v < nv) (shared (cell cs t) (cell cs u)).
Proof.
have [_ ut /allP bt] := cell_ok t; split; first exact: filter_uniq.
by apply/allP=> v; rewrite mem_filter => /andP[_ /bt].
Qed.

Lemma ecutP t u : (common ecomplex t u \in ecut) = incut cut (shared (cell cs t) (cell cs u)).
Proof.
have [_ /allP b] := shared_ok t u.
rewrite inE has_filter -filter_predI -has_filter /incut; apply: eq_has => g /=.
rewrite ecommon /same_set; apply/andP/andP => [[/eqP/setP e /allP bg]|[/allP gs /allP sg]].
  split; apply/allP => v vg /=.
    by have := e (Ordinal (bg _ vg)); rewrite !inE /= vg.
  by have := e (Ordinal (b _ vg)); rewrite !inE /= vg => <-.
split; last by apply/allP => v /gs /b.
by apply/eqP/setP => v; rewrite !inE; apply/idP/idP => [/sg|/gs].
Qed.

Lemma eglue (x y : 'I_nv * 'I_nt) :
  glue ecomplex ecut x y = (x.1 == y.1) && gluedb n cs cut x.2 y.2 x.1.
Proof.
rewrite /glue ecutP /gluedb /adjacent ecommon inE; congr [&& _, _, _ & _].
by have [us bs] := shared_ok x.2 y.2; rewrite card_seq.
Qed.

Definition enc (x : 'I_nv * 'I_nt) : nat * nat := (val x.1, val x.2).

Lemma inks_edges : inks (corners cs) (edges n cs cut).
Proof.
apply/allP => -[[v t] [w u]]; rewrite edgesP /= => /and4P[ts us /eqP <- /and3P[+ _ _]].
by rewrite mem_filter !cornersP ts us /= => /andP[-> ->].
Qed.

Lemma enc_corner x : corner ecomplex x -> enc x \in corners cs.
Proof. by case: x => v t; rewrite /corner /= inE /enc cornersP ltn_ord. Qed.

Lemma dec (c : nat * nat) : c \in corners cs -> exists x, c = enc x.
Proof.
case: c => v t; rewrite cornersP => /andP[ts vt].
have [_ _ /allP/(_ _ vt) vb] := cell_ok (Ordinal ts).
by exists (Ordinal vb, Ordinal ts).
Qed.

Lemma enc_inj : injective enc.
Proof. by move=> [v t] [w u] [/val_inj-> /val_inj->]. Qed.

Theorem exec_correct (x y : 'I_nv * 'I_nt) : corner ecomplex x -> corner ecomplex y ->
  (get (labels n cs cut) (enc x) == get (labels n cs cut) (enc y))
  = (copy ecomplex ecut x == copy ecomplex ecut y).
Proof.
move=> cx cy; rewrite copy_eq; apply/eqP/idP => [|].
  move/(runP inks_edges (enc_corner cx) (enc_corner cy)).
  suff H a b : eqv (corners cs) (edges n cs cut) a b ->
      forall x y, a = enc x -> b = enc y -> connect (glue ecomplex ecut) x y.
    by move=> /H; apply.
  elim=> {a b} [a _ x' y' -> /enc_inj-> //|a b ab x' y' ax by'|a b _ H x' y' ax by'|].
  - apply: connect1; rewrite eglue; move: ab; rewrite ax by' edgesP /=.
    by move=> /and4P[_ _ /eqP/val_inj-> ->]; rewrite eqxx.
  - by rewrite glue_csym; apply: H.
  - move=> a b c h1 H1 _ H2 x' y' ax cy'.
    have /andP[_ /dec[z bz]] := eqv_in inks_edges h1.
    exact: connect_trans (H1 _ _ ax bz) (H2 _ _ bz cy').
move=> /connectP[s + e]; rewrite {}e {cy}.
elim: s x cx => [|z s IHs] x cx //= /andP[xz zs].
have cz := connect_corner (connect1 xz) cx.
rewrite -(IHs z cz zs); apply/(runP inks_edges (enc_corner cx) (enc_corner cz)).
apply: eqv_step; rewrite edgesP /= !ltn_ord /=.
by move: xz; rewrite eglue => /andP[/eqP-> ->]; rewrite eqxx.
Qed.
End Link.

(* end to end: the output numbering realises the specified classes, and the     *)
(* returned projection maps each new number to its old vertex                  *)
Section Output.
Variables (n nv : nat) (cs cut : cellsT).
Hypothesis ok : wf n nv cs.
Let out := unglue_exec n cs cut.
Definition newnum v t : nat := nth 0 (cell out.1 t) (index v (cell cs t)).

Lemma newnumE v t : (v, t) \in corners cs -> newnum v t =
  index (get (labels n cs cut) (v, t)) (undup [seq get (labels n cs cut) c | c <- corners cs]).
Proof.
rewrite cornersP => /andP[ts vt]; rewrite /newnum /out /cell /=.
rewrite (nth_map 0) ?size_iota // nth_iota // add0n (nth_map 0) ?index_mem //.
by rewrite nth_index.
Qed.

Theorem unglue_exec_correct (x y : 'I_nv * 'I_(size cs)) :
  corner (ecomplex ok) x -> corner (ecomplex ok) y ->
  (newnum x.1 x.2 == newnum y.1 y.2) =
  (copy (ecomplex ok) (ecut nv cut) x == copy (ecomplex ok) (ecut nv cut) y).
Proof.
move=> cx cy; rewrite -exec_correct // !newnumE ?(enc_corner cx) ?(enc_corner cy) //.
apply/eqP/eqP => [e|->//].
have m z : corner (ecomplex ok) z -> get (labels n cs cut) (enc z) \in
    undup [seq get (labels n cs cut) c | c <- corners cs].
  by move=> cz; rewrite mem_undup; apply/map_f/(enc_corner cz).
by rewrite -[LHS](nth_index (0, 0) (m _ cx)) -[RHS](nth_index (0, 0) (m _ cy)) /enc e.
Qed.

Theorem unglue_exec_cells : size out.1 = size cs /\
  forall t, t < size cs -> size (cell out.1 t) = size (cell cs t).
Proof.
by split=> [|t ts]; rewrite /out /cell /= ?size_map ?size_iota // (nth_map 0) ?size_iota //
  size_map nth_iota.
Qed.
End Output.
