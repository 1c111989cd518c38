(* Which of all orders are left, where they repeat after a long period?  The vectors as rays, which turn on by the same angle from order to
   order; those of one period are judged that may vanish, the others have a ray that no other reaches. *)
From Coq Require Import ZArith QArith List Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
From Crankstar Require Import Sums Splitting Engine Checker.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.

(** * The checker *)

(* (a, b, w): at order k it stands at k a + b, in turns, of weight w. *)
Definition ray := (Q * Q * Q)%type.
Definition at_order (k : Z) (rays : seq ray) : seq (Q * Q) := [seq (inject_Z k * r.1.1 + r.1.2, r.2)%q | r <- rays].

Definition rays_of (E : engine) (q : quantity) : seq ray :=
  [seq (match q with
        | Force Direct | Moment Direct => (throw c - bank c, bank c)
        | Force Reverse | Moment Reverse => (bank c - throw c, bank c)
        | Torque => (throw c - bank c, 0)
        end, cylinder_weight E q c)%q | c <- cylinders E].

(* The sum is the product of those of its factors: of one bank and of the banks, where these are alike. *)
Record factor := Factor {
  rays : seq ray;
  parts : Z;                       (* angles times this are whole *)
  scaled : Z;                      (* weights times this are whole *)
  forced : Z;                      (* which every prime up to the number of rays divides *)
  period : Z;                      (* orders after which the rays stand to each other as before *)
  modulus : Z; zeros : seq Z;      (* it vanishes at the orders with these residues *)
  judged : seq (Z * evidence)      (* rising *)
}.

Definition whole_ray (N D : Z) (r : ray) : bool := is_whole N r.1.1 && is_whole N r.1.2 && is_whole D r.2.

(* In whole numbers, and at order k. *)
Definition integral_rays (N D : Z) (l : seq ray) : seq (Z * Z * Z) := [seq (times N r.1.1, times N r.1.2, times D r.2) | r <- l].
Definition terms_at (k : Z) (l : seq (Z * Z * Z)) : list term := [seq (Z.add (Z.mul k r.1.1) r.1.2, r.2) | r <- l].

(* A vector that no other reaches by a multiple of the s-th part: the sum is not zero. *)
Definition alone (s : Z) (l : list term) : bool :=
  has (fun t => ~~ Z.eqb t.2 0 && Nat.eqb (size (class s t.1 l)) 1) l.

(* The same from order to order without a division: angles modulo s, what they turn on in two orders, weights. *)
Definition state_at (s k : Z) (l : seq (Z * Z * Z)) : seq (Z * Z * Z) :=
  [seq (Z.modulo (Z.add (Z.mul k r.1.1) r.1.2) s, Z.modulo (Z.mul 2 r.1.1) s, r.2) | r <- l].
Definition turn_on (s : Z) (l : seq (Z * Z * Z)) : seq (Z * Z * Z) :=
  [seq (let x := Z.add r.1.1 r.1.2 in if Z.ltb x s then x else Z.sub x s, r.1.2, r.2) | r <- l].
Definition lonely (l : seq (Z * Z * Z)) : bool :=
  has (fun r => ~~ Z.eqb r.2 0 && Nat.eqb (count (fun u => Z.eqb u.1.1 r.1.1) l) 1) l.

Fixpoint check_orders (f : factor) (s k : Z) (state : seq (Z * Z * Z)) (n : nat) (evs : seq (Z * evidence)) : bool :=
  match n with
  | O => true
  | S n' =>
      let zero := Z.modulo k (modulus f) \in zeros f in
      let left evs := ~~ zero && lonely state && check_orders f s (Z.add k 2) (turn_on s state) n' evs in
      match evs with
      | (r, ev) :: evs' =>
          if Z.eqb r k
          then check (at_order k (rays f)) ev && (claims_zero ev == zero) && check_orders f s (Z.add k 2) (turn_on s state) n' evs'
          else left evs
      | nil => left nil
      end
  end.

Definition check_factor (first : Z) (f : factor) : bool :=
  let: Factor l N D R M m zs evs := f in
  Z.ltb 0 N && Z.ltb 0 D && Z.ltb 0 R && Z.ltb 0 M && Z.ltb 0 m && Z.eqb (Z.modulo M 2) 0 && Z.eqb (Z.modulo M m) 0
  && all (whole_ray N D) l
  && all (fun r => is_whole M (r.1.1 - (head (0, 0, 0) l).1.1)%q) l
  && is_forced N R (Z.of_nat (size l))
  && (let s := Z.div N (Z.gcd N R) in check_orders f s first (state_at s first (integral_rays N D l)) (Z.to_nat (Z.div M 2)) evs).

Definition product (l m : seq ray) : seq ray :=
  flatten [seq [seq (r.1.1 + s.1.1, r.1.2 + s.1.2, r.2 * s.2)%q | s <- m] | r <- l].

Definition all_rays (fs : seq factor) : seq ray := foldr (fun f l => product (rays f) l) [:: (0, 0, 1)%q] fs.

(* Both angles of a ray in one number. *)
Definition key (N : Z) (r : ray) : Z := Z.add (Z.mul (Z.modulo (times N r.1.1) N) N) (Z.modulo (times N r.1.2) N).

Definition same_rays (N D : Z) (l m : seq ray) : bool :=
  Z.ltb 0 N && Z.ltb 0 D && all (whole_ray N D) l && all (whole_ray N D) m
  && all_zero (collect (Z.mul N N) ([seq (key N r, times D r.2) | r <- l] ++ [seq (key N r, Z.opp (times D r.2)) | r <- m])).

Definition check_recurrence (E : engine) (q : quantity) (first N D : Z) (fs : seq factor) : bool :=
  Z.leb 2 first && all (fun t => Z.leb (order t) 1) (turning_masses E)
  && same_rays N D (rays_of E q) (all_rays fs) && all (check_factor first) fs.

(* What is said of an order. *)
Fixpoint left_at (k : Z) (fs : seq factor) : Prop :=
  match fs with
  | nil => True
  | [:: f] => Z.modulo k (modulus f) \notin zeros f
  | f :: fs' => Z.modulo k (modulus f) \notin zeros f /\ left_at k fs'
  end.

(** * Proofs *)

Local Open Scope ring_scope.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.
Local Arguments Z.div : simpl never. Local Arguments Z.modulo : simpl never. Local Arguments Z.gcd : simpl never.
Local Arguments Pos.mul : simpl never.

Section Alone.
Variables (F : numClosedFieldType) (N : Z) (z : F).
Hypothesis N_gt0 : Z.lt 0 N.
Hypothesis prim_z : (Z.to_nat N).-primitive_root z.

Lemma alone_sound R l : Z.lt 0 R -> is_forced N R (Z.of_nat (size l)) -> alone (Z.div N (Z.gcd N R)) l -> value N z l <> 0.
Proof.
move=> R0 forced /hasP[t tl /andP[/Z.eqb_spec w0 /Nat.eqb_spec one]] l0.
set M := Z.gcd N R in one; have M0 : Z.lt 0 M by rewrite /M; have := Z.gcd_nonneg N R; have := Z.gcd_eq_0_l N R; lia.
have [s sE] := Z.gcd_divide_l N R; rewrite -/M in sE; rewrite sE Z.div_mul in one; last lia.
have t_in : t \in class s t.1 l.
  by rewrite mem_filter tl andbT /in_class Z.sub_diag Z.mod_0_l //; nia.
have class0 : value N z (class s t.1 l) = 0.
  apply: (@forced_classes F M (Z.of_nat (size l)) (Z.to_nat s) M0 N z) => //; try nia.
  - by exists 1; lia.
  - by move=> p pp pN; apply: is_forced_sound.
case: (class s t.1 l) one t_in class0 => [|u [|? ?]] // _; rewrite inE => /eqP <-.
case: t w0 {tl} => a w /= w0; rewrite value_cons value_nil addr0 => /eqP.
rewrite mulf_eq0 (negbTE (zpow_unit N_gt0 prim_z _)) orbF intr_eq0 => /eqP w_eq0.
by apply: w0; rewrite -(int_of_ZK w) w_eq0.
Qed.

End Alone.

Section Weighted.
Variable A : ringType.

(* Any function of the exponents, collected. *)
Definition weighted (f : Z -> A) (l : list term) : A := \sum_(t <- l) (int_of_Z t.2)%:~R * f t.1.

Lemma weighted_cons (f : Z -> A) t l : weighted f (t :: l) = (int_of_Z t.2)%:~R * f t.1 + weighted f l.
Proof. by rewrite /weighted big_cons. Qed.

Lemma weighted_add (f : Z -> A) a w l : weighted f (add_term a w l) = (int_of_Z w)%:~R * f a + weighted f l.
Proof.
elim: l => [|[a' w'] l IH] /=; first by rewrite weighted_cons.
case: (Z.eqb_spec a a') => [<-|_]; rewrite !weighted_cons /=; last by rewrite IH addrCA.
by rewrite -[Z.add w w']/((w + w') : Z) rmorphD rmorphD mulrDl addrA.
Qed.

Lemma weighted_collect (f : Z -> A) M l : all_zero (collect M l) -> \sum_(t <- l) (int_of_Z t.2)%:~R * f (Z.modulo t.1 M) = 0.
Proof.
have -> : \sum_(t <- l) (int_of_Z t.2)%:~R * f (Z.modulo t.1 M) = weighted f (collect M l).
  elim: l => [|[a w] l IH] /=; first by rewrite /weighted !big_nil.
  by rewrite big_cons weighted_add IH.
elim: (collect M l) => [|[a w] m IH] /=; first by rewrite /weighted big_nil.
by case/andP => /Z.eqb_spec -> /IH H; rewrite weighted_cons H mul0r addr0.
Qed.

End Weighted.

Section Rays.
Variables (F : numClosedFieldType) (e : circle F).

Lemma cis_part N m : Z.lt 0 N -> e (inject_Z m * part N)%q = zpow N (e (part N)) m.
Proof.
move=> N0; have d : Zpos (Qden (inject_Z m * part N)%q) = N by rewrite /= Z2Pos.id.
have n : Qnum (inject_Z m * part N)%q = m by rewrite /=; lia.
rewrite (cis_times e N0); last by rewrite /is_whole d n Z.mul_comm Z.mod_mul //; lia.
by congr (Sums.zpow _ _ _); rewrite /times d n Z.mul_comm Z.div_mul //; lia.
Qed.

Lemma whole_part N q : Z.lt 0 N -> is_whole N q -> (q == inject_Z (times N q) * part N)%q.
Proof.
move=> N0 /is_whole_times <-; have NE : (inject_Z N * part N == 1)%q by apply: (proj2 (part_times N0 N 1)); lia.
transitivity (inject_Z N * part N * q)%q; [by rewrite NE; ring | by ring].
Qed.

Lemma cis_ray N a b k : Z.lt 0 N -> is_whole N a -> is_whole N b ->
  e (inject_Z k * a + b)%q = zpow N (e (part N)) (Z.add (Z.mul k (times N a)) (times N b)).
Proof.
move=> N0 /(whole_part N0) wa /(whole_part N0) wb; rewrite -cis_part //; apply: cis_same.
rewrite inject_Z_plus inject_Z_mult {1}wa {1}wb; ring.
Qed.

Lemma total_rays N D k l : Z.lt 0 N -> Z.lt 0 D -> all (whole_ray N D) l ->
  total e (at_order k l) = value N (e (part N)) (terms_at k (integral_rays N D l)) / (int_of_Z D)%:~R.
Proof.
move=> N0 D0 whole; rewrite /total /value /at_order !big_map mulr_suml.
apply: (eq_sum_all whole) => r /andP[/andP[wa wb] wd] /=.
by rewrite (cis_ray _ N0 wa wb) (number_times F D0 wd) mulrAC.
Qed.

Lemma total_product k l m : total e (at_order k (product l m)) = total e (at_order k l) * total e (at_order k m).
Proof.
rewrite /total /product /at_order !big_map big_flatten big_map big_distrl; apply: eq_bigr => r _ /=.
rewrite big_map mulr_sumr; apply: eq_bigr => s _ /=; rewrite numberM [RHS]mulrACA -cis_add.
by congr (_ * _); apply: cis_same; ring.
Qed.

Lemma total_one k : total e (at_order k [:: (0, 0, 1)%q]) = 1.
Proof.
rewrite /total /= big_cons big_nil addr0 (@cis_whole _ _ _ 0); last by rewrite /=; ring.
by rewrite mulr1 (number_Z F 1).
Qed.

Lemma total_all k fs : total e (at_order k (all_rays fs)) = \prod_(f <- fs) total e (at_order k (rays f)).
Proof. by elim: fs => [|f fs IH]; rewrite ?big_nil ?big_cons /= ?total_one // total_product IH. Qed.

Lemma same_total N D k l m : same_rays N D l m -> total e (at_order k l) = total e (at_order k m).
Proof.
case/andP => /andP[/andP[/andP[/Z.ltb_spec0 N0 /Z.ltb_spec0 D0] wl] wm].
pose f (x : Z) := zpow N (e (part N)) (Z.add (Z.mul k (Z.div x N)) (Z.modulo x N)).
move/(weighted_collect f); rewrite big_cat !big_map /=.
have fE r : f (Z.modulo (key N r) (Z.mul N N)) = zpow N (e (part N)) (Z.add (Z.mul k (times N r.1.1)) (times N r.1.2)).
  set a := times N r.1.1; set b := times N r.1.2; rewrite /f /key -/a -/b.
  have ab := Z.mod_pos_bound a N N0; have bb := Z.mod_pos_bound b N N0.
  rewrite Z.mod_small; last nia.
  have -> : Z.div (Z.add (Z.mul (Z.modulo a N) N) (Z.modulo b N)) N = Z.modulo a N.
    by rewrite Z.add_comm Z.div_add ?Z.div_small //; lia.
  have -> : Z.modulo (Z.add (Z.mul (Z.modulo a N) N) (Z.modulo b N)) N = Z.modulo b N.
    by rewrite Z.add_comm Z.mod_add ?Z.mod_mod //; lia.
  apply: (@zpow_eq F N _ N0 (prim_part e N0) _ _ (Z.opp (Z.add (Z.mul k (Z.div a N)) (Z.div b N)))).
  have := Z.div_mod a N; have := Z.div_mod b N; nia.
rewrite (total_rays k N0 D0 wl) (total_rays k N0 D0 wm) /value !big_map /= => H; congr (_ / _).
apply/eqP; rewrite -subr_eq0 -sumrN; apply/eqP; rewrite -[RHS]H; congr (_ + _).
  by apply: eq_bigr => r _; rewrite fE.
apply: eq_bigr => r _; rewrite fE -mulNr; congr (_ * _).
by rewrite -[Z.opp (times D r.2)]/(- times D r.2 : Z) !rmorphN.
Qed.

(* From order to order of one period all rays turn by the same angle. *)
Lemma period_total M l k r : Z.lt 0 M -> Z.modulo (Z.sub k r) M = Z0 ->
  all (fun s => is_whole M (s.1.1 - (head (0, 0, 0) l).1.1)%q) l ->
  (total e (at_order k l) == 0) = (total e (at_order r l) == 0).
Proof.
move=> M0 kr whole; set a0 := (head _ l).1.1 in whole.
have [i iE] : exists i, Z.sub k r = Z.mul i M.
  by exists (Z.div (Z.sub k r) M); have := Z.div_mod (Z.sub k r) M; lia.
have -> : total e (at_order k l) = e (inject_Z (Z.sub k r) * a0)%q * total e (at_order r l).
  rewrite /total /at_order !big_map mulr_sumr; apply: (eq_sum_all whole) => s /is_whole_times ws /=.
  rewrite mulrCA; congr (_ * _); rewrite -cis_add.
  have kE : (inject_Z k == inject_Z r + inject_Z (Z.sub k r))%q by rewrite -inject_Z_plus; have -> : Z.add r (Z.sub k r) = k by lia.
  apply: (@cis_eq _ _ _ _ (Z.mul i (times M (s.1.1 - a0)%q))).
  rewrite inject_Z_mult -ws kE iE inject_Z_mult; ring.
by rewrite mulf_eq0 (negbTE (cis_neq0 _ _)).
Qed.

Lemma lonely_state s k l : Z.lt 0 s -> lonely (state_at s k l) = alone s (terms_at k l).
Proof.
move=> s0; rewrite /lonely /alone /state_at /terms_at !has_map; apply: eq_has => r /=; congr (_ && Nat.eqb _ _).
rewrite /class size_filter !count_map; apply: eq_count => u /=; rewrite /in_class /=.
set x := Z.add _ _; set y := Z.add _ _; have xd := Z.div_mod x s; have yd := Z.div_mod y s.
have xb := Z.mod_pos_bound x s s0; have yb := Z.mod_pos_bound y s s0.
case: (Z.eqb_spec (Z.modulo x s)) => E; case: Z.eqb_spec => // H.
  case: H; have -> : Z.sub x y = Z.mul (Z.sub (Z.div x s) (Z.div y s)) s by lia.
  by rewrite Z.mod_mul //; lia.
have xyd := Z.div_mod (Z.sub x y) s ltac:(lia); rewrite H in xyd; have {}xd := xd ltac:(lia); have {}yd := yd ltac:(lia).
pose d := Z.add (Z.sub (Z.div (Z.sub x y) s) (Z.div x s)) (Z.div y s).
have dE : Z.sub (Z.modulo x s) (Z.modulo y s) = Z.mul s d by rewrite /d; lia.
case: E; case: (Z.lt_total d 0) => [|[d0|]]; try nia; by rewrite d0 in dE; lia.
Qed.

Lemma turn_on_state s k l : Z.lt 0 s -> turn_on s (state_at s k l) = state_at s (Z.add k 2) l.
Proof.
move=> s0; rewrite /turn_on /state_at -map_comp; apply: eq_map => r /=; congr (_, _, _).
set a := r.1.1; set x := Z.add (Z.mul k a) _.
have -> : Z.add (Z.mul (Z.add k 2) a) r.1.2 = Z.add x (Z.mul 2 a) by rewrite /x; lia.
have xb := Z.mod_pos_bound x s s0; have ab := Z.mod_pos_bound (Z.mul 2 a) s s0.
rewrite Zplus_mod; case: Z.ltb_spec => H; first by symmetry; apply: Z.mod_small; lia.
have E : Z.add (Z.modulo x s) (Z.modulo (Z.mul 2 a) s) = Z.add (Z.sub (Z.add (Z.modulo x s) (Z.modulo (Z.mul 2 a) s)) s) (Z.mul 1 s) by lia.
rewrite [X in _ = Z.modulo X _]E Z.mod_add; last lia.
by symmetry; apply: Z.mod_small; lia.
Qed.

Lemma check_orders_sound f l s k n evs : Z.lt 0 s -> (forall r, alone s (terms_at r l) -> total e (at_order r (rays f)) <> 0) ->
  check_orders f s k (state_at s k l) n evs -> forall i, (i < n)%N -> let r := Z.add k (Z.mul 2 (Z.of_nat i)) in
  total e (at_order r (rays f)) <> 0 <-> Z.modulo r (modulus f) \notin zeros f.
Proof.
move=> s0 left; elim: n k evs => [|n IH] k evs //=; rewrite lonely_state // turn_on_state // => H i i_lt.
have step evs' : check_orders f s (Z.add k 2) (state_at s (Z.add k 2) l) n evs' ->
    (total e (at_order k (rays f)) <> 0 <-> Z.modulo k (modulus f) \notin zeros f) ->
    let r := Z.add k (Z.mul 2 (Z.of_nat i)) in total e (at_order r (rays f)) <> 0 <-> Z.modulo r (modulus f) \notin zeros f.
  case: i i_lt => [|i] i_lt ok here.
    by have -> : Z.add k (Z.mul 2 (Z.of_nat 0)) = k by lia.
  have -> : Z.add k (Z.mul 2 (Z.of_nat i.+1)) = Z.add (Z.add k 2) (Z.mul 2 (Z.of_nat i)) by lia.
  exact: IH ok _ _.
have left_here evs' : ~~ (Z.modulo k (modulus f) \in zeros f) && alone s (terms_at k l)
      && check_orders f s (Z.add k 2) (state_at s (Z.add k 2) l) n evs' ->
    let r := Z.add k (Z.mul 2 (Z.of_nat i)) in total e (at_order r (rays f)) <> 0 <-> Z.modulo r (modulus f) \notin zeros f.
  by case/andP => /andP[nz al] ok; apply: (step _ ok); split=> // _; exact: left.
case: evs H => [|[r ev] evs]; first exact: left_here.
case: Z.eqb_spec => [_|_]; last exact: left_here.
case/andP => /andP[/(@check_sound F e) sound /eqP same] ok; apply: (step _ ok).
by rewrite -same; case: (claims_zero ev) sound => v; split.
Qed.

Lemma check_factor_sound first f : check_factor first f -> forall k, Z.le first k -> Z.modulo (Z.sub k first) 2 = Z0 ->
  total e (at_order k (rays f)) <> 0 <-> Z.modulo k (modulus f) \notin zeros f.
Proof.
case: f => l N D R M m zs evs.
case/andP => /andP[/andP[/andP[/andP[/andP[/andP[/andP[/andP[/andP[/Z.ltb_spec0 N0 /Z.ltb_spec0 D0] /Z.ltb_spec0 R0] /Z.ltb_spec0 M0] /Z.ltb_spec0 m0] /Z.eqb_spec M2] /Z.eqb_spec Mm] whole] per] forced].
set s := Z.div N _; set f := Factor _ _ _ _ _ _ _ _ => ok k k_first k_second.
have s0 : Z.lt 0 s.
  apply: Z.div_str_pos; have := Z.divide_pos_le _ _ N0 (Z.gcd_divide_l N R).
  by have := Z.gcd_nonneg N R; have := Z.gcd_eq_0_l N R; lia.
have left r : alone s (terms_at r (integral_rays N D l)) -> total e (at_order r l) <> 0.
  move=> al; apply/eqP; rewrite (total_rays r N0 D0 whole) mulf_neq0 ?invr_neq0 ?Zint_neq0 //; apply/eqP.
  by apply: (alone_sound N0 (prim_part e N0) R0 _ al); rewrite !size_map.
have M_half := Z.div_mod M 2 ltac:(lia); rewrite M2 in M_half.
have kd := Z.div_mod (Z.sub k first) M ltac:(lia); have kb := Z.mod_pos_bound (Z.sub k first) M M0.
set d := Z.modulo (Z.sub k first) M in kd kb; set j := Z.div (Z.sub k first) M in kd.
have d2 : Z.modulo d 2 = Z0.
  have -> : d = Z.add (Z.sub k first) (Z.mul (Z.opp (Z.mul (Z.div M 2) j)) 2) by nia.
  by rewrite Z.mod_add.
have d_half := Z.div_mod d 2 ltac:(lia); rewrite d2 in d_half.
have i_lt : (Z.to_nat (Z.div d 2) < Z.to_nat (Z.div M 2))%N by lia.
have /= := @check_orders_sound f _ _ _ _ _ s0 left ok _ i_lt; rewrite Z2Nat.id; last lia.
set r := Z.add first _; have kr : Z.sub k r = Z.mul j M by rewrite /r; nia.
have -> : Z.modulo k m = Z.modulo r m.
  have [c cE] : exists c, M = Z.mul c m by exists (Z.div M m); have := Z.div_mod M m; lia.
  have -> : k = Z.add r (Z.mul (Z.mul j c) m) by nia.
  by rewrite Z.mod_add //; lia.
have E : (total e (at_order k l) == 0) = (total e (at_order r l) == 0).
  by apply: (period_total M0) => //; rewrite kr Z.mod_mul //; lia.
by move=> [H1 H2]; split=> [/eqP|H]; [rewrite E => /eqP | apply/eqP; rewrite E; apply/eqP]; auto.
Qed.

Variable E : engine.

Lemma vector_rays q k : Z.le 2 k -> all (fun t => Z.leb (order t) 1) (turning_masses E) ->
  vector e E q k = total e (at_order k (rays_of E q)).
Proof.
move=> k2 slow; rewrite /vector /vectors (filter_none slow) /=; last first.
  by move=> t /Z.leb_spec0 t1; rewrite /takes_part; case: Z.eqb_spec => //; lia.
rewrite cats0 /total /at_order /rays_of !big_map; apply: eq_bigr => c _ /=; congr (_ * _); apply: cis_same.
have S j : (inject_Z (Z.sub j 1) == inject_Z j - 1)%q by rewrite /Z.sub inject_Z_plus; apply: Qeq_refl.
have P j : (inject_Z (Z.add j 1) == inject_Z j + 1)%q by rewrite inject_Z_plus; apply: Qeq_refl.
by case: q => [[]|[]|] /=; rewrite ?S ?P; ring.
Qed.

Theorem recurrence q first N D fs : check_recurrence E q first N D fs = true ->
  forall k, Z.le first k -> Z.modulo (Z.sub k first) 2 = Z0 -> vector e E q k <> 0 <-> left_at k fs.
Proof.
case/andP => /andP[/andP[/Z.leb_spec0 first2 slow] same] ok k k_first k_second.
rewrite vector_rays //; last lia.
rewrite (same_total k same) total_all {same}; elim: fs ok => [_|f fs IH /andP[fok ok]].
  by rewrite big_nil; split=> // _; apply/eqP; exact: oner_neq0.
have H := check_factor_sound fok k_first k_second; have {}IH := IH ok.
rewrite big_cons; case: fs IH {ok} => [_|g fs IH]; first by rewrite big_nil mulr1.
rewrite -[left_at _ _]/(_ /\ left_at k (g :: fs)) -H -IH.
split=> [/eqP|[/eqP f0 /eqP g0]]; last by apply/eqP; rewrite mulf_neq0.
by rewrite mulf_eq0 negb_or => /andP[/eqP f0 /eqP g0].
Qed.

(** Every even order, and every odd one above 1: left where no factor has its residue. *)
Theorem even_recurrence q N D fs : check_recurrence E q 2 N D fs = true ->
  forall k, Z.le 2 k -> Z.modulo k 2 = Z0 -> vector e E q k <> 0 <-> left_at k fs.
Proof. by move/recurrence => H k k2 even; apply: H => //; rewrite Zminus_mod even. Qed.

Theorem odd_recurrence q N D fs : check_recurrence E q 3 N D fs = true ->
  forall k, Z.le 3 k -> Z.modulo k 2 = Zpos 1 -> vector e E q k <> 0 <-> left_at k fs.
Proof. by move/recurrence => H k k3 odd; apply: H => //; rewrite Zminus_mod odd. Qed.

End Rays.
