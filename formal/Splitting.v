(* Does a path of classes lead from a sum to one vector, each step keeping a part that is zero where the whole is? *)
From Coq Require Import ZArith List Lia Znumtheory.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
From Crankstar Require Import Sums.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.

(** * The checker *)

Inductive step : Type :=
(* Keep the terms whose angle differs from num/den by a multiple of 1/modulus, turned by - num/den. *)
| Class (num den modulus : Z)
(* Angles are u/p + x, the denominator of x prime to p: keep class [first] less class [second], at their angles x. *)
| Compare (p first second : Z).

Definition in_class (s a : Z) (t : term) : bool := Z.eqb (Z.modulo (Z.sub t.1 a) s) Z0.
Definition class (s a : Z) (l : list term) : list term := [seq t <- l | in_class s a t].
Definition turn (a : Z) (l : list term) : list term := [seq (Z.sub t.1 a, t.2) | t <- l].
Definition scale (a : Z) (l : list term) : list term := [seq (Z.mul a t.1, t.2) | t <- l].
Definition negate (l : list term) : list term := [seq (t.1, Z.opp t.2) | t <- l].

(* Like directions added, zeros dropped. *)
Definition collected (N : Z) (l : list term) : list term := [seq t <- collect N l | negb (Z.eqb t.2 Z0)].

(* What all exponents and the conductor are multiples of. *)
Fixpoint common (g : Z) (l : list term) : Z :=
  match l with nil => g | (e, _) :: l' => common (Z.gcd g e) l' end.
Definition divide (g : Z) (l : list term) : list term := [seq (Z.div t.1 g, t.2) | t <- l].

Definition upto (k : Z) : list Z := [seq Z.of_nat i | i <- iota 0 (Z.to_nat k).+1].

(* Every prime up to n that divides N divides m. *)
Definition is_forced (N m n : Z) : bool :=
  all (fun d => Z.leb d 1 || negb (Z.eqb (Z.modulo N d) Z0) || negb (Z.eqb (Z.gcd d m) 1)) (upto n).

Definition is_prime (p : Z) : bool :=
  Z.ltb 1 p && all (fun d => Z.leb d 1 || Z.leb p d || negb (Z.eqb (Z.modulo p d) Z0)) (upto p).

(* 1 modulo q and 0 modulo p, where there is such a number. *)
Definition idempotent (p q : Z) : Z :=
  head Z0 [seq k <- [seq Z.add 1 (Z.mul j q) | j <- upto p] | Z.eqb (Z.modulo k p) Z0].

Fixpoint check_steps (N : Z) (l : list term) (steps : list step) : bool :=
  let l1 := collected N l in
  let g := common N l1 in
  let N' := Z.div N g in
  let l2 := divide g l1 in
  match steps with
  | nil => Z.eqb (Z.of_nat (size l2)) 1
  | Class num den m :: steps' =>
      let a := Z.div (Z.mul num N') den in
      Z.ltb Z0 den && Z.eqb (Z.mul a den) (Z.mul num N') && Z.ltb Z0 m
      && is_forced N' m (Z.of_nat (size l2))
      && check_steps N' (turn a (class (Z.div N' (Z.gcd N' m)) a l2)) steps'
  | Compare p u v :: steps' =>
      let q := Z.div N' p in
      let k := idempotent p q in
      let at_x u := scale k (class p (Z.mul u q) l2) in
      is_prime p && Z.eqb (Z.mul p q) N' && Z.eqb (Z.modulo k p) Z0 && Z.eqb (Z.modulo (Z.sub k 1) q) Z0
      && negb (Z.eqb (Z.modulo q p) Z0)
      && check_steps N' (at_x u ++ negate (at_x v)) steps'
  end.

Definition check_splitting (N : Z) (l : list term) (steps : list step) : bool :=
  Z.ltb Z0 N && check_steps N l steps.

(** * Proofs *)

Local Open Scope ring_scope.
Local Notation prime := Znumtheory.prime.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.
Local Arguments Z.div : simpl never. Local Arguments Z.modulo : simpl never. Local Arguments Z.gcd : simpl never.

Section Root.
Variables (F : numClosedFieldType) (N : Z) (z : F).
Hypothesis N_gt0 : Z.lt Z0 N.
Hypothesis prim_z : (Z.to_nat N).-primitive_root z.
Local Notation zpow := (zpow N z).
Local Notation value := (value N z).

Lemma zpow0 : zpow Z0 = 1. Proof. exact: (zpow_nat N_gt0 prim_z 0). Qed.

(* Exponents that differ by a multiple of N. *)
Lemma zpow_eq e f k : Z.sub e f = Z.mul k N -> zpow e = zpow f.
Proof.
move=> H; have -> : e = Z.add (Z.mul k N) f by lia.
by rewrite zpowD // -(zpow_mod N z (Z.mul k N)) Z.mod_mul ?zpow0 ?mul1r //; lia.
Qed.

Lemma zpow_unit e : zpow e != 0.
Proof.
apply/eqP => e0; have : zpow (Z.add e (Z.opp e)) = 0 by rewrite zpowD // e0 mul0r.
by rewrite Z.add_opp_diag_r zpow0 => /eqP; rewrite oner_eq0.
Qed.

Lemma zpowM e (k : Z) : zpow (Z.mul e k) = zpow e ^+ Z.to_nat (Z.modulo k N).
Proof.
have H := Z.mod_pos_bound k N N_gt0.
rewrite (zpow_exp N_gt0 prim_z) Z2Nat.id; last lia.
apply: (@zpow_eq _ _ (Z.mul e (Z.div k N))).
have := Z.div_mod k N; nia.
Qed.

Lemma value_scale a l : value (scale a l) = Sums.value N (zpow a) l.
Proof. by rewrite /Sums.value big_map; apply: eq_bigr => t _ /=; rewrite zpowM. Qed.

Lemma value_negate l : value (negate l) = - value l.
Proof. by rewrite /Sums.value big_map -sumrN; apply: eq_bigr => t _ /=; rewrite -mulNr -[Z.opp t.2]/(- t.2 : Z) !rmorphN. Qed.

Lemma value_turn a l : value (turn a l) = zpow (Z.opp a) * value l.
Proof.
rewrite /Sums.value big_map mulr_sumr; apply: eq_bigr => t _ /=.
have -> : Z.sub t.1 a = Z.add (Z.opp a) t.1 by lia.
by rewrite zpowD // mulrCA.
Qed.

Lemma value_collected l : value (collected N l) = value l.
Proof.
rewrite -[RHS](value_collect N z) /collected; elim: (collect N l) => //= -[e w] m IH.
by case: Z.eqb_spec => /= [->|_]; rewrite !value_cons -IH // mul0r add0r.
Qed.

Lemma turn0 l : turn Z0 l = l.
Proof. by rewrite /turn -[RHS]map_id; apply: eq_map => -[e w] /=; rewrite Z.sub_0_r. Qed.

(* Another primitive root: a zero stays zero. *)
Lemma prim_conj a : Z.gcd a N = Zpos 1 -> (Z.to_nat N).-primitive_root (zpow a).
Proof.
move=> aN; rewrite /Sums.zpow prim_root_exp_coprime // /coprime; set r := Z.to_nat _; set n := Z.to_nat N.
have [u rE] := dvdnP (dvdn_gcdl r n); have [v nE] := dvdnP (dvdn_gcdr r n).
move: (gcdn r n) rE nE => d rE nE.
have H := Z.mod_pos_bound a N N_gt0; have H' := Z.div_mod a N.
have : Z.divide (Z.of_nat d) (Z.gcd a N).
  apply: Z.gcd_greatest; last by exists (Z.of_nat v); rewrite /n in nE; lia.
  exists (Z.add (Z.mul (Z.of_nat v) (Z.div a N)) (Z.of_nat u)); rewrite /n /r in nE rE; nia.
by rewrite aN => /Z.divide_1_r; lia.
Qed.

Lemma zero_conj a l : Z.gcd a N = Zpos 1 -> value l = 0 -> value (scale a l) = 0.
Proof.
move=> aN; rewrite value_scale -!poly_value => /(zero_divides N_gt0 prim_z)[Q ->].
by rewrite rmorphM hornerM (Phi_root N_gt0 (prim_conj aN)) mulr0.
Qed.

(* The classes modulo p out of the conjugates. *)
Lemma fourier p q c l : Z.lt Z0 p -> N = Z.mul p q ->
  \sum_(j < Z.to_nat p) zpow (Z.opp (Z.mul (Z.mul (Z.of_nat j) q) c)) * value (scale (Z.add 1 (Z.mul (Z.of_nat j) q)) l)
  = (Z.to_nat p)%:R * value (class p c l).
Proof.
move=> p0 NE; elim: l => [|[e w] l IH] /=.
  by rewrite value_nil mulr0 big1 // => j _; rewrite mulr0.
set x := zpow (Z.mul q (Z.sub e c)).
transitivity ((int_of_Z w)%:~R * zpow e * (\sum_(j < Z.to_nat p) x ^+ j) + (Z.to_nat p)%:R * value (class p c l)).
  rewrite -IH mulr_sumr -big_split; apply: eq_bigr => j _ /=.
  rewrite [Sums.value N z (_ :: _)]value_cons mulrDr; congr (_ + _).
  rewrite mulrCA -mulrA; congr (_ * _); rewrite (zpow_exp N_gt0 prim_z) -!zpowD //.
  by congr (Sums.zpow _ _ _); ring.
have [q0 d] : Z.lt Z0 q /\ Z.sub e c = Z.add (Z.mul p (Z.div (Z.sub e c) p)) (Z.modulo (Z.sub e c) p).
  by split; [nia | apply: Z.div_mod; lia].
rewrite /class /=; case C: (in_class _ _ _) => /=.
  rewrite value_cons mulrDr; congr (_ + _).
  have -> : x = 1.
    apply/eqP; rewrite (zpow_eq1 N_gt0 prim_z) d; move/Z.eqb_spec: C => /= ->.
    by apply/Z.eqb_spec; rewrite Z.add_0_r Z.mul_assoc (Z.mul_comm q) -NE Z.mul_comm Z.mod_mul //; lia.
  by rewrite (eq_bigr (fun=> 1)) => [|j _]; rewrite ?expr1n // sumr_const card_ord mulrC.
rewrite geometric ?mulr0 ?add0r //.
  rewrite (zpow_exp N_gt0 prim_z) Z2Nat.id; last lia.
  apply/eqP; rewrite (zpow_eq1 N_gt0 prim_z); apply/Z.eqb_spec.
  have -> : Z.mul (Z.mul q (Z.sub e c)) p = Z.mul (Z.sub e c) N by lia.
  by rewrite Z.mod_mul //; lia.
rewrite (zpow_eq1 N_gt0 prim_z); apply/negP => /Z.eqb_spec H.
move/negP: C; apply; apply/Z.eqb_spec; rewrite /=.
move: H; rewrite NE (Z.mul_comm p) Zmult_mod_distr_l; nia.
Qed.

Lemma natr_neq0 p : Z.lt Z0 p -> (Z.to_nat p)%:R != 0 :> F.
Proof. by move=> p0; rewrite pnatr_eq0; lia. Qed.

(* p divides N twice: the classes modulo p vanish one by one. *)
Lemma square_classes p q c l : Z.lt Z0 p -> N = Z.mul p q -> Z.divide p q -> value l = 0 -> value (class p c l) = 0.
Proof.
move=> p0 NE [r qE] l0; apply/eqP; have := fourier c l p0 NE.
rewrite big1 => [/esym/eqP|j _]; first by rewrite mulf_eq0 (negbTE (natr_neq0 p0)).
rewrite zero_conj ?mulr0 //; apply/Z.bezout_1_gcd.
set i := Z.of_nat j; exists (Z.sub 1 (Z.mul i q)), (Z.mul (Z.mul i i) r).
rewrite [N]NE qE; nia.
Qed.

(* p divides N once: the classes modulo p, at angles without p, are equal. *)
Lemma single_classes p q k l : prime p -> N = Z.mul p q -> ~ Z.divide p q ->
  Z.divide p k -> Z.divide q (Z.sub k 1) -> value l = 0 ->
  forall c d, value (scale k (class p c l)) = value (scale k (class p d l)).
Proof.
move=> prime_p NE pq pk [j0 kE] l0; have p2 := prime_ge_2 _ prime_p; have q0 : Z.lt Z0 q by nia.
have p0 : Z.lt Z0 p by lia.
pose j1 := Z.modulo j0 p; have j1_bound := Z.mod_pos_bound j0 p p0.
pose f := value (scale (Z.add 1 (Z.mul j1 q)) l).
suff E c : value (scale k (class p c l)) = f / (Z.to_nat p)%:R by move=> c d; rewrite !E.
have kp : Z.divide p (Z.add 1 (Z.mul j1 q)).
  have [r rE] := pk; exists (Z.sub r (Z.mul (Z.div j0 p) q)).
  by have := Z.div_mod j0 p; rewrite -/j1; nia.
have j1_lt : (Z.to_nat j1 < Z.to_nat p)%N by rewrite /j1; lia.
have := fourier c l p0 NE; rewrite (bigD1 (Ordinal j1_lt)) //= Z2Nat.id; last by rewrite /j1; lia.
rewrite -/f big1 => [|j jn]; last first.
  rewrite zero_conj ?mulr0 // NE; apply/Zgcd_1_rel_prime/rel_prime_mult; last first.
    by apply/Zgcd_1_rel_prime/Z.bezout_1_gcd; exists 1, (Z.opp (Z.of_nat j)); lia.
  apply/rel_prime_sym/prime_rel_prime => // -[r rE].
  case: kp => r' rE'; have D : Z.divide p (Z.mul (Z.sub (Z.of_nat j) j1) q) by exists (Z.sub r r'); nia.
  case: (prime_mult _ prime_p _ _ D) => // -[i iE].
  have j_lt := ltn_ord j; move/eqP: jn; apply; apply: val_inj => /=.
  have : i = Z0 by rewrite /j1 in iE *; nia.
  by move=> i0; rewrite i0 in iE; rewrite /j1 in iE *; lia.
rewrite addr0 => /esym/(canRL (mulKf (natr_neq0 p0))) E; rewrite [RHS]mulrC.
have -> : value (scale k (class p c l)) = zpow (Z.mul (Z.mul j1 q) c) * value (class p c l).
  rewrite /Sums.value big_map mulr_sumr !big_filter; apply: eq_bigr => t /Z.eqb_spec tc /=.
  rewrite mulrCA; congr (_ * _); rewrite -zpowD //.
  apply: (@zpow_eq _ _ (Z.add (Z.mul (Z.div j0 p) t.1) (Z.mul j1 (Z.div (Z.sub t.1 c) p)))).
  have H := Z.div_mod j0 p; have H' := Z.div_mod (Z.sub t.1 c) p; rewrite tc in H'.
  have -> : k = Z.add 1 (Z.mul j0 q) by lia.
  rewrite NE; rewrite -/j1 in H; nia.
rewrite E mulrCA; congr (_ * _); rewrite mulrA -zpowD // Z.add_opp_diag_r zpow0 mul1r //.
Qed.

(* A common factor of N and all exponents can be omitted, and a common angle. *)
Lemma value_divide g N' a l : Z.lt Z0 g -> N = Z.mul g N' -> all (in_class g a) l ->
  value l = zpow a * Sums.value N' (z ^+ Z.to_nat g) (divide g (turn a l)).
Proof.
move=> g0 NE; have N'0 : Z.lt Z0 N' by nia.
elim: l => [|[e w] l IH] /=; first by rewrite !value_nil mulr0.
case/andP=> /Z.eqb_spec /= ea /IH E; rewrite !value_cons E mulrDr; congr (_ + _).
rewrite mulrCA; congr (_ * _); have H := Z.div_mod (Z.sub e a) g; rewrite ea in H.
rewrite [Sums.zpow N' _ _]/Sums.zpow; set x := Z.div _ _ in H *.
have xb := Z.mod_pos_bound x N' N'0; have xd := Z.div_mod x N'.
have -> : z ^+ Z.to_nat g = zpow g by rewrite -(zpow_nat N_gt0 prim_z) Z2Nat.id //; lia.
rewrite (zpow_exp N_gt0 prim_z) Z2Nat.id; last lia.
rewrite -zpowD //; apply: (@zpow_eq _ _ (Z.div x N')); rewrite NE; nia.
Qed.

Lemma prim_divide g N' : Z.lt Z0 g -> N = Z.mul g N' -> (Z.to_nat N').-primitive_root (z ^+ Z.to_nat g).
Proof.
move=> g0 NE; have E : Z.to_nat N = (Z.to_nat g * Z.to_nat N')%N by nia.
have -> : Z.to_nat g = (Z.to_nat N %/ Z.to_nat N')%N by rewrite E mulnK //; nia.
by apply: dvdn_prim_root => //; rewrite E dvdn_mull.
Qed.

End Root.

Lemma prime_divisor (x : Z) : Z.lt 1 x -> exists2 p, prime p & Z.divide p x.
Proof.
suff H (k : nat) y : Z.lt 1 y -> Z.le y (Z.of_nat k) -> exists2 p, prime p & Z.divide p y.
  by move=> x1; apply: (H (Z.to_nat x)) => //; lia.
elim: k y => [|k IH] y y1 yk; first lia.
case: (prime_dec y) => [py|/not_prime_divide[//|d [d_bound dy]]]; first by exists y => //; apply: Z.divide_refl.
have [||p pp pd] := IH d; try lia; exists p => //; exact: Z.divide_trans pd dy.
Qed.

(* p divides N twice, or no class modulo p is reached by all: the classes vanish one by one. *)
Lemma sparse_classes (F : numClosedFieldType) (N : Z) (z : F) p q c l :
  Z.lt Z0 N -> (Z.to_nat N).-primitive_root z -> prime p -> N = Z.mul p q ->
  Z.divide p q \/ Z.lt (Z.of_nat (size l)) p -> value N z l = 0 -> value N z (class p c l) = 0.
Proof.
move=> N0 prim_z prime_p NE H l0; have p2 := prime_ge_2 _ prime_p; have q0 : Z.lt Z0 q by nia.
case: (Zdivide_dec p q) => [pq|pq]; first by apply: (@square_classes F N z N0 prim_z p q c l) => //; lia.
case: H => // size_lt.
have [d dE] : exists d, class p d l = [::].
  suff [d dl] : exists d : 'I_(Z.to_nat p), ~~ has (in_class p (Z.of_nat d)) l.
    by exists (Z.of_nat d); apply/eqP; rewrite -size_eq0 size_filter -leqn0 leqNgt -has_count.
  apply/existsP; rewrite -negb_forall; apply/negP => /forallP all_d.
  pose r (t : term) := Z.to_nat (Z.modulo t.1 p).
  have sub : {subset iota 0 (Z.to_nat p) <= map r l}.
    move=> i; rewrite mem_iota add0n => /= i_lt; have /hasP[t tl /Z.eqb_spec tE] := all_d (Ordinal i_lt).
    move: tE => /= tE; apply/mapP; exists t => //; rewrite /r.
    have H := Z.div_mod (Z.sub t.1 (Z.of_nat i)) p ltac:(lia); rewrite tE in H.
    have -> : t.1 = Z.add (Z.of_nat i) (Z.mul (Z.div (Z.sub t.1 (Z.of_nat i)) p) p) by lia.
    by rewrite Z.mod_add ?Z.mod_small; lia.
  by have := uniq_leq_size (iota_uniq _ _) sub; rewrite size_iota size_map; lia.
have [k [pk qk]] : exists k, Z.divide p k /\ Z.divide q (Z.sub k 1).
  have /Zgcd_1_rel_prime/Z.gcd_bezout[u [v B]] := prime_rel_prime _ prime_p _ pq.
  by exists (Z.mul u p); split; [exists u; lia | exists (Z.opp v); lia].
have := single_classes N0 prim_z prime_p NE pq pk qk l0 c d; rewrite dE value_nil.
rewrite /value big_map big_filter => E0.
have k_unit : Z.gcd k q = Zpos 1.
  by apply/Z.bezout_1_gcd; case: qk => v E; exists 1, (Z.opp v); lia.
(* At angles c + p y the turn by k and that by 1 differ by one factor. *)
have [k1 k1E] := qk.
have : zpow N z (Z.mul (Z.sub k 1) c) * value N z (class p c l) = 0.
  rewrite -[RHS]E0 /value big_filter mulr_sumr; apply: eq_bigr => t /Z.eqb_spec tc.
  rewrite mulrCA; congr (_ * _); rewrite -zpowD //; apply: (@zpow_eq _ _ _ _ _ _ _ (Z.opp (Z.mul k1 (Z.div (Z.sub t.1 c) p)))) => //.
  have H' := Z.div_mod (Z.sub t.1 c) p; rewrite tc in H'; rewrite /= NE; nia.
by move/eqP; rewrite mulf_eq0 (negbTE (zpow_unit N0 prim_z _)) => /eqP.
Qed.

Lemma divide_turn_class (s p a : Z) l : Z.lt Z0 s -> Z.lt Z0 p ->
  class s Z0 (divide p (turn a (class p a l))) = divide p (turn a (class (Z.mul p s) a l)).
Proof.
move=> s0 p0; elim: l => //= -[e w] l IH; rewrite /class /in_class /=.
have H := Z.div_mod (Z.sub e a) p; have Hb := Z.mod_pos_bound (Z.sub e a) p p0.
have K := Z.div_mod (Z.div (Z.sub e a) p) s; have Kb := Z.mod_pos_bound (Z.div (Z.sub e a) p) s s0.
have -> : Z.modulo (Z.sub e a) (Z.mul p s) = Z.add (Z.modulo (Z.sub e a) p) (Z.mul p (Z.modulo (Z.div (Z.sub e a) p) s)).
  by apply: Z.rem_mul_r; lia.
case: (Z.eqb_spec (Z.modulo (Z.sub e a) p) Z0) => [->|np] /=; last first.
  by case: Z.eqb_spec => [|_]; [nia | exact: IH].
rewrite Z.sub_0_r; case: (Z.eqb_spec (Z.modulo (Z.div _ _) s) Z0) => [->|ns] /=.
  by rewrite Z.mul_0_r /= -IH /class /in_class.
by case: Z.eqb_spec => [|_]; [nia | exact: IH].
Qed.

Lemma class_all s a l : all (in_class s a) (class s a l). Proof. exact: filter_all. Qed.

(** The class step: classes modulo s vanish one by one, where each prime divides N/s or is above the number of terms. *)
Lemma forced_classes (F : numClosedFieldType) M n (k : nat) : Z.lt Z0 M -> forall (N : Z) (z : F) s a l,
  Z.lt Z0 N -> (Z.to_nat N).-primitive_root z -> Z.lt Z0 s -> Z.le s (Z.of_nat k) -> Z.divide (Z.mul s M) N ->
  (forall p, prime p -> Z.divide p N -> Z.divide p M \/ Z.lt n p) -> Z.le (Z.of_nat (size l)) n ->
  value N z l = 0 -> value N z (class s a l) = 0.
Proof.
move=> M0; elim: k => [|k IH] N z s a l N0 prim_z s0 sk sN H size_l l0; first lia.
case: (Z.eq_dec s 1) => [s1|s1].
  by rewrite s1 /class (eq_filter (a2 := predT)) ?filter_predT // => t; rewrite /in_class Z.mod_1_r.
have [|p prime_p [s' sE]] := @prime_divisor s; first lia.
have p2 := prime_ge_2 _ prime_p; have s'0 : Z.lt Z0 s' by nia.
have [r NE] := sN; pose N' := Z.mul (Z.mul r s') M.
have NE' : N = Z.mul p N' by rewrite NE sE /N'; lia.
have N'0 : Z.lt Z0 N' by nia.
have zero_p : value N z (class p a l) = 0.
  apply: (sparse_classes _ N0 prim_z prime_p NE') => //.
  have [|[r' ME]|pn] := H p prime_p; first by exists N'; lia.
    by left; exists (Z.mul (Z.mul r s') r'); rewrite /N' ME; lia.
  by right; lia.
have p0 : Z.lt Z0 p by lia.
rewrite sE Z.mul_comm (value_divide (g := p) (N' := N') (a := a) N0 prim_z p0 NE'); last first.
  apply/allP => t; rewrite mem_filter => /andP[/Z.eqb_spec H' _]; apply/Z.eqb_spec.
  apply/Z.mod_divide; first lia.
  have [i ->] : Z.divide (Z.mul p s') (Z.sub t.1 a).
    by apply/Z.mod_divide; [nia | exact: H'].
  by exists (Z.mul i s'); lia.
rewrite -divide_turn_class // IH ?mulr0 //; try lia.
- exact: (prim_divide N0 prim_z p0 NE').
- by nia.
- by exists r; rewrite /N'; lia.
- by move=> p' pp' [i iE]; apply: H => //; exists (Z.mul i p); rewrite NE' iE; ring.
- rewrite /divide /turn /class !size_map size_filter; apply: Z.le_trans size_l.
  by apply: inj_le; apply/leP; apply: count_size.
move: zero_p; rewrite (value_divide N0 prim_z p0 NE' (class_all _ _ _)) => /eqP.
by rewrite mulf_eq0 (negbTE (zpow_unit N0 prim_z _)) => /eqP.
Qed.

Lemma upto_mem k d : Z.le Z0 d -> Z.le d k -> d \in upto k.
Proof. by move=> d0 dk; apply/mapP; exists (Z.to_nat d); [rewrite mem_iota | ]; lia. Qed.

Lemma is_forced_sound N m n p : Z.lt Z0 N -> Z.lt Z0 m -> is_forced N m n -> prime p -> Z.divide p N -> Z.divide p (Z.gcd N m) \/ Z.lt n p.
Proof.
move=> N0 m0 /allP H prime_p pN; case: (Z.lt_ge_cases n p) => [|np]; [by right | left].
have p2 := prime_ge_2 _ prime_p; apply: Z.gcd_greatest => //.
have := H p (upto_mem _ np); rewrite (introF (Z.leb_spec0 _ _)) /=; last lia.
have /Z.mod_divide -> : Z.divide p N by []. 
  rewrite /= => /(_ ltac:(lia)) /Z.eqb_spec g1.
  case: (Zdivide_dec p m) => // /(prime_rel_prime _ prime_p)/Zgcd_1_rel_prime; by [].
by lia.
Qed.

Lemma is_prime_sound p : is_prime p -> prime p.
Proof.
case/andP => /Z.ltb_spec0 p1 /allP H; case: (prime_dec p) => // /not_prime_divide[//|d [d_bound dp]].
have := H d (upto_mem _ _); rewrite (introF (Z.leb_spec0 d 1)) ?(introF (Z.leb_spec0 p d)) /=; try lia.
by rewrite (proj2 (Z.mod_divide p d ltac:(lia)) dp) => /(_ ltac:(lia) ltac:(lia)).
Qed.

Lemma common_divides g l : Z.lt Z0 g ->
  [/\ Z.lt Z0 (common g l), Z.divide (common g l) g & all (in_class (common g l) Z0) l].
Proof.
elim: l g => [|[e w] l IH] g g0 /=; first by split => //; apply: Z.divide_refl.
have h0 : Z.lt Z0 (Z.gcd g e) by have := Z.gcd_nonneg g e; have := Z.gcd_eq_0_l g e; lia.
have [c0 cg ->] := IH _ h0; split=> //; first exact: Z.divide_trans cg (Z.gcd_divide_l _ _).
rewrite andbT; apply/Z.eqb_spec; rewrite Z.sub_0_r; apply/Z.mod_divide; first lia.
exact: Z.divide_trans cg (Z.gcd_divide_r _ _).
Qed.

Section Sound.
Variable F : numClosedFieldType.

Lemma check_steps_sound steps : forall (N : Z) (z : F) l,
  Z.lt Z0 N -> (Z.to_nat N).-primitive_root z -> check_steps N l steps -> value N z l <> 0.
Proof.
elim: steps => [|s steps IH] N z l N0 prim_z /=.
all: rewrite -(value_collected N z l).
all: have all_neq0 : all (fun t : term => ~~ Z.eqb t.2 Z0) (collected N l) by apply: filter_all.
all: move: (collected N l) all_neq0 => l1 all_neq0.
all: have [g0 [N' NE] gl] := common_divides l1 N0; move: (common N l1) g0 NE gl => g g0 NE gl.
all: have EN : Z.div N g = N' by rewrite NE Z.div_mul //; lia.
all: rewrite ?EN; rewrite Z.mul_comm in NE.
all: have N'0 : Z.lt Z0 N' by nia.
all: have prim' := prim_divide N0 prim_z g0 NE.
all: rewrite (value_divide N0 prim_z g0 NE gl) (zpow0 N0 prim_z) mul1r.
all: rewrite turn0.
  move=> /Z.eqb_spec; rewrite size_map; case: l1 all_neq0 gl => [|[e w] [|? ?]] //; last by move=> _ _ /=; lia.
  case/andP => /Z.eqb_spec w0 _ _ _; rewrite value_cons value_nil addr0 => /eqP; rewrite mulf_eq0 (negbTE (zpow_unit N'0 prim' _)) orbF.
  by rewrite intr_eq0 => /eqP w_eq0; apply: w0; rewrite -(int_of_ZK w) w_eq0.
set l2 := divide g l1; move: l2 {all_neq0 gl} => l2.
case: s => [num den m|p u v].
  case/andP=> /andP[/andP[/andP[/Z.ltb_spec0 den0 /Z.eqb_spec aE] /Z.ltb_spec0 m0] forced] /(IH _ _ _ N'0 prim') H l0.
  apply: H; rewrite (value_turn N'0 prim'); set M := Z.gcd N' m.
  have M0 : Z.lt Z0 M by rewrite /M; have := Z.gcd_nonneg N' m; have := Z.gcd_eq_0_l N' m; lia.
  have [s sE] := Z.gcd_divide_l N' m; rewrite -/M in sE.
  have -> : Z.div N' M = s by rewrite sE Z.div_mul //; lia.
  rewrite (@forced_classes F M (Z.of_nat (size l2)) (Z.to_nat s) M0 N' (z ^+ Z.to_nat g)) ?mulr0 //; try nia.
  - by exists 1; lia.
  - by move=> p pp pN; apply: is_forced_sound.
case/andP=> /andP[/andP[/andP[/andP[/is_prime_sound pp /Z.eqb_spec pq] /Z.eqb_spec kp] /Z.eqb_spec kq] /Z.eqb_spec qp].
move/(IH _ _ _ N'0 prim') => H l0; apply: H.
have p2 := prime_ge_2 _ pp.
have E := @single_classes _ N' _ N'0 prim' p (Z.div N' p) (idempotent p (Z.div N' p)) l2 pp (esym pq) _ _ _ l0.
rewrite value_cat value_negate (E _ _ _ _ (Z.mul v (Z.div N' p))) ?subrr //.
- by move=> [r rE]; apply: qp; rewrite rE Z.mod_mul //; lia.
- by apply/Z.mod_divide => //; lia.
- by apply/Z.mod_divide => //; nia.
Qed.

(** A splitting proves that a sum is not zero. *)
Theorem check_splitting_sound (N : Z) (z : F) l steps :
  Z.lt Z0 N -> (Z.to_nat N).-primitive_root z -> check_splitting N l steps -> value N z l <> 0.
Proof. by move=> N0 prim_z /andP[_]; apply: check_steps_sound. Qed.

End Sound.
