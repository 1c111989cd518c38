(* Is there a circle, as the theorems on engines take one?  One in the algebraic numbers. *)
From Coq Require Import ZArith QArith List Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
From Crankstar Require Import Sums Splitting Engine Checker.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.

(* A primitive root of order (n+1)! above one of order n!. *)
Lemma root_above n (z : algC) : n`!.-primitive_root z ->
  exists x : algC, n.+1`!.-primitive_root x && (x ^+ n.+1 == z).
Proof.
move=> prim_z; have [y prim_y] := C_prim_root_exists (fact_gt0 n.+1).
have fE : (n.+1`! %/ n`!)%N = n.+1 by rewrite factS mulnK ?fact_gt0.
have prim_w : n`!.-primitive_root (y ^+ n.+1).
  by rewrite -[X in y ^+ X]fE; apply: dvdn_prim_root => //; rewrite factS dvdn_mull.
have [[i i_lt] /= zE] := prim_rootP prim_w (prim_expr_order prim_z).
have co_i : coprime i n`! by rewrite -(prim_root_exp_coprime _ prim_w) -zE.
suff [k [co_k kE]] : exists k, coprime k n.+1`! /\ (y ^+ n.+1) ^+ k = z.
  exists (y ^+ k); rewrite (prim_root_exp_coprime _ prim_y) co_k /=.
  by rewrite -kE -!exprM mulnC.
case: (boolP (coprime i n.+1)) => co; first by exists i; rewrite factS coprimeMr co co_i.
exists (i + n`!)%N; split; last by rewrite exprD (prim_expr_order prim_w) mulr1 zE.
have g1 : (1 < gcdn i n.+1)%N.
  by rewrite ltn_neqAle eq_sym gcdn_gt0 orbT andbT.
have p_prime := pdiv_prime g1; set p := pdiv _ in p_prime.
have p_i : (p %| i)%N := dvdn_trans (pdiv_dvd _) (dvdn_gcdl _ _).
have p_n : (p %| n.+1)%N := dvdn_trans (pdiv_dvd _) (dvdn_gcdr _ _).
have p_fact : ~~ (p %| n`!)%N.
  apply/negP => pf; have : (p %| gcdn i n`!)%N by rewrite dvdn_gcd p_i.
  by rewrite (eqP co_i) dvdn1 => /eqP p1; move: p_prime; rewrite p1.
have pE : p = n.+1.
  apply/eqP; rewrite eqn_leq (dvdn_leq _ p_n) //= leqNgt; apply/negP => p_lt.
  by move/negP: p_fact; apply; apply: dvdn_fact; rewrite prime_gt0.
have co_f : coprime (i + n`!) n`! by rewrite /coprime gcdnC gcdnDr gcdnC.
by rewrite factS coprimeMr co_f andbT coprime_sym -pE prime_coprime // dvdn_addr.
Qed.

Lemma root_zero : 0`!.-primitive_root (1 : algC). 
Proof.
have [m prim_m] := prim_order_exists (isT : (0 < 1)%N) (expr1n [ringType of algC] 1).
by rewrite dvdn1 => /eqP mE; rewrite mE in prim_m.
Qed.

(* zeta n is of order n!, and zeta n.+1 to the n.+1 is zeta n. *)
Fixpoint chain (n : nat) : {z : algC | n`!.-primitive_root z} :=
  match n with
  | O => exist _ 1 root_zero
  | S n' =>
      let above := sigW (root_above (svalP (chain n'))) in exist _ (sval above) (proj1 (andP (svalP above)))
  end.
Definition zeta n : algC := sval (chain n).

Lemma zeta_prim n : n`!.-primitive_root (zeta n). Proof. exact: (svalP (chain n)). Qed.
Lemma zeta_step n : zeta n.+1 ^+ n.+1 = zeta n.
Proof. by rewrite /zeta /=; case: (sigW _) => x /= /andP[_ /eqP]. Qed.

Lemma dvd_fact n m : (n`! %| (n + m)`!)%N.
Proof. by elim: m => [|m IH]; rewrite ?addn0 // addnS factS dvdn_mull. Qed.

Lemma zeta_up n m : zeta (n + m) ^+ ((n + m)`! %/ n`!) = zeta n.
Proof.
elim: m => [|m IH]; first by rewrite addn0 divnn fact_gt0 expr1.
by rewrite addnS factS -muln_divA ?dvd_fact // exprM zeta_step IH.
Qed.

Definition order (n : nat) : Z := Z.of_nat n`!.
Lemma order_gt0 n : Z.lt 0 (order n). Proof. by have := fact_gt0 n; rewrite /order; lia. Qed.
Lemma order_prim n : (Z.to_nat (order n)).-primitive_root (zeta n).
Proof. by rewrite Nat2Z.id; apply: zeta_prim. Qed.

(* t over the whole circle of order n!, where t times n! is whole. *)
Definition at_order (n : nat) (t : Q) : algC := zpow (order n) (zeta n) (times (order n) t).


Lemma whole_up n m t : is_whole (order n) t -> is_whole (order (n + m)) t.
Proof.
move=> /Z.eqb_spec H; apply/Z.eqb_spec; have [c E] := dvdnP (dvd_fact n m).
rewrite /order E Nat2Z.inj_mul -Z.mul_assoc.
by apply/Z.mod_divide => //; apply: Z.divide_mul_r; apply/Z.mod_divide.
Qed.

Lemma at_order_up n m t : is_whole (order n) t -> at_order (n + m) t = at_order n t.
Proof.
move=> whole; have whole' := whole_up m whole; have [c E] := dvdnP (dvd_fact n m).
have c0 : (0 < c)%N by have := fact_gt0 (n + m); rewrite E; case: c {E}.
have cE : ((n + m)`! %/ n`!)%N = c by rewrite E mulnK ?fact_gt0.
have zE : zpow (order (n + m)) (zeta (n + m)) (Z.of_nat c) = zeta n.
  by rewrite (zpow_nat (order_gt0 _) (order_prim _)) -cE zeta_up.
have tE : times (order (n + m)) t = Z.mul (Z.of_nat c) (times (order n) t).
  rewrite /times /order E Nat2Z.inj_mul -Z.mul_assoc Z.divide_div_mul_exact //.
  by apply/Z.mod_divide => //; apply/Z.eqb_spec: whole.
rewrite /at_order tE; set k := times _ t.
have kb := Z.mod_pos_bound k (order n) (order_gt0 n); have kd := Z.div_mod k (order n).
rewrite [RHS]/zpow -zE (zpow_exp (order_gt0 _) (order_prim _)) Z2Nat.id; last lia.
apply: (zpow_eq (order_gt0 _) (order_prim _) (k := Z.div k (order n))).
have oE : order (n + m) = Z.mul (Z.of_nat c) (order n) by rewrite /order E; lia.
have o0 := order_gt0 n; rewrite oE; have {}kd := kd ltac:(lia); nia.
Qed.

Definition turn_of (t : Q) : algC := at_order (Pos.to_nat (Qden t)) t.

Lemma den_whole t n : (Pos.to_nat (Qden t) <= n)%N -> is_whole (order n) t.
Proof.
move=> le; apply/Z.eqb_spec/Z.mod_divide => //; apply: Z.divide_mul_l.
have d : (Pos.to_nat (Qden t) %| n`!)%N by apply: dvdn_fact; rewrite le andbT; lia.
by have [c E] := dvdnP d; exists (Z.of_nat c); rewrite /order E; lia.
Qed.

Lemma turn_of_at t n : (Pos.to_nat (Qden t) <= n)%N -> turn_of t = at_order n t.
Proof. by move=> le; rewrite -(subnKC le) at_order_up //; apply: den_whole. Qed.

Lemma turn_of_add s t : turn_of (s + t)%q = turn_of s * turn_of t.
Proof.
pose n := (Pos.to_nat (Qden s) * Pos.to_nat (Qden t))%N.
have [sn tn] : (Pos.to_nat (Qden s) <= n)%N /\ (Pos.to_nat (Qden t) <= n)%N by rewrite /n; split; nia.
have un : (Pos.to_nat (Qden (s + t)%q) <= n)%N by rewrite /= /n Pos2Nat.inj_mul.
rewrite !(@turn_of_at _ n) // /at_order -(zpowD (order_gt0 n) (order_prim n)); congr zpow.
have S := is_whole_times (den_whole sn); have T := is_whole_times (den_whole tn).
have U := is_whole_times (den_whole un).
have : (inject_Z (times (order n) (s + t)) == inject_Z (times (order n) s + times (order n) t))%q.
  by rewrite inject_Z_plus -S -T -U; ring.
by rewrite /Qeq /= !Z.mul_1_r.
Qed.

Lemma turn_of_one t : turn_of t = 1 <-> exists n : Z, (t == inject_Z n)%q.
Proof.
rewrite /turn_of /at_order; set m := Pos.to_nat _.
have W : (inject_Z (order m) * t == inject_Z (times (order m) t))%q by apply/is_whole_times/den_whole.
have o0 := order_gt0 m.
split=> [/eqP|[n tE]].
  rewrite (zpow_eq1 o0 (order_prim m)) => /Z.eqb_spec H; exists (Z.div (times (order m) t) (order m)).
  have K := Z.div_mod (times (order m) t) (order m) ltac:(lia); rewrite H Z.add_0_r in K.
  apply: (proj1 (Qmult_inj_l _ _ (inject_Z (order m)) _)); last by rewrite W {1}K inject_Z_mult; apply: Qeq_refl.
  by rewrite /Qeq /=; lia.
apply/eqP; rewrite (zpow_eq1 o0 (order_prim m)); apply/Z.eqb_spec.
have : (inject_Z (times (order m) t) == inject_Z (n * order m))%q by rewrite -W tE -inject_Z_mult Z.mul_comm; apply: Qeq_refl.
by rewrite /Qeq /= !Z.mul_1_r => ->; rewrite Z.mod_mul //; lia.
Qed.

(** So the theorems are about something, without any axiom. *)
Definition a_circle : circle [numClosedFieldType of algC] := Circle turn_of_add turn_of_one.
