(* Are the two vectors of an order all of its force?  The shaking force of that order is made of them, at every crank angle. *)
From Coq Require Import ZArith QArith List Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
From Crankstar Require Import Sums Splitting Engine Checker.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.

Section Shaking.
Variables (F : numClosedFieldType) (e : circle F) (E : engine).

Lemma inject_sub x y : (inject_Z (Z.sub x y) == inject_Z x - inject_Z y)%q.
Proof. by rewrite /Z.sub inject_Z_plus inject_Z_opp; ring. Qed.

Lemma half_sum (w a b c : F) : 2%:R * (w * ((a + b) / 2%:R) * c) = w * (a * c) + w * (b * c).
Proof. by rewrite mulrA mulrCA [2%:R * _]mulrC divfK ?pnatr_eq0 // mulrDr mulrDl -!mulrA. Qed.

Lemma of_cylinder w k theta a b :
  2%:R * (w * cosine e (inject_Z k * (theta + (b - a)))%q * e a)
  = w * e (inject_Z k * b - inject_Z (k - 1) * a)%q * e (inject_Z k * theta)%q
    + w * e (inject_Z (k + 1) * a - inject_Z k * b)%q * e (- (inject_Z k * theta))%q.
Proof.
have one : (inject_Z 1 == 1)%q by [].
rewrite /cosine half_sum -!cis_add -!mulrA -!cis_add; congr (_ * _ + _ * _); apply: cis_same.
  by rewrite inject_sub one; ring.
by rewrite inject_Z_plus one; ring.
Qed.

Lemma of_turning k order U arm gamma s theta : order = k ->
  2%:R * (number F (inject_Z (order * order) * U * arm)%q * e (gamma + turned s (inject_Z k * theta))%q)
  = number F (inject_Z (2 * order * order) * U * arm)%q * e gamma * e (turned s (inject_Z k * theta))%q.
Proof.
move=> _; rewrite cis_add !mulrA; congr (_ * _ * _).
have -> : number F (inject_Z (2 * order * order) * U * arm)%q = number F (inject_Z 2 * (inject_Z (order * order) * U * arm))%q.
  by apply: number_eq; rewrite !inject_Z_mult; ring.
by rewrite [RHS]numberM number_Z -[LHS]mulrA.
Qed.

Variables (q : sense -> quantity) (arm : Q -> Q).
Hypothesis arm_of_q : q = Force /\ arm = (fun=> 1%q) \/ q = Moment /\ arm = (fun z => (z - plane E)%q).

Lemma lever_arm s z : lever E (q s) z = arm z.
Proof. by case: arm_of_q => -[-> ->]. Qed.

(** Twice the force of order k at theta: the direct vector turned by k theta, and the reverse one turned back. *)
Theorem shaking_vectors k theta :
  2%:R * shaking e E arm k theta
  = vector e E (q Direct) k * e (inject_Z k * theta)%q + vector e E (q Reverse) k * e (- (inject_Z k * theta))%q.
Proof.
rewrite /shaking /vector /vectors !total_cat /total !big_map !big_filter mulrDr !mulr_sumr.
rewrite !mulrDl addrACA; congr (_ + _).
  rewrite !mulr_suml -big_split; apply: eq_bigr => c _ /=; rewrite of_cylinder.
  by case: arm_of_q => -[qE armE]; rewrite qE armE.
rewrite !mulr_suml big_mkcond [X in _ = X + _]big_mkcond [X in _ = _ + X]big_mkcond -big_split; apply: eq_bigr => t _ /=.
have partE s : takes_part (q s) k t = Z.eqb (order t) k && same_sense s (turns t) by case: arm_of_q => -[-> _].
rewrite !partE; case: Z.eqb_spec => [ok|_] /=; last by rewrite addr0.
rewrite (of_turning _ _ _ _ _ ok) /turning_weight !lever_arm.
by case: (turns t) => /=; rewrite ?addr0 ?add0r.
Qed.

(** So the force of order k is zero at every crank angle exactly where both vectors are. *)
Theorem no_shaking k : Z.lt 0 k ->
  (forall theta, shaking e E arm k theta = 0) <-> (vector e E (q Direct) k = 0 /\ vector e E (q Reverse) k = 0).
Proof.
move=> k0; split=> [H|[H1 H2] theta]; last first.
  apply/eqP; have /eqP := shaking_vectors k theta; rewrite H1 H2 !mul0r addr0 mulf_eq0 pnatr_eq0 //.
set u := vector _ _ _ _; set v := vector _ _ _ _.
have S theta : u * e (inject_Z k * theta)%q + v * e (- (inject_Z k * theta))%q = 0.
  by rewrite -shaking_vectors H mulr0.
have kk theta : (inject_Z k * (theta / inject_Z k) == theta)%q.
  by apply: Qmult_div_r => k_eq0; move: k_eq0; rewrite /Qeq /=; lia.
have S1 theta : u * e theta + v * e (- theta)%q = 0.
  by rewrite -[RHS](S (theta / inject_Z k)%q); congr (_ * _ + _ * _); apply: cis_same; rewrite kk //; apply: Qeq_refl.
have one : e 0%q = 1 by apply: (@cis_whole _ _ _ 0).
have half : e (1 # 2)%q = -1.
  have /eqP : e (1 # 2)%q ^+ 2 = 1 by rewrite cis_exp; apply: (@cis_whole _ _ _ 1).
  rewrite sqrf_eq1 => /orP[/eqP|/eqP] // /cis_one[n]; rewrite /Qeq /=; lia.
have quarter : e (- (1 # 4))%q = - e (1 # 4)%q.
  by rewrite -mulN1r -half -cis_add; apply: (@cis_eq _ _ _ _ (-1)).
have := S1 0%q; have -> : e (- 0)%q = e 0%q by apply: cis_same.
rewrite one !mulr1 => /eqP; rewrite addr_eq0 => /eqP uv.
have := S1 (1 # 4)%q; rewrite quarter uv mulNr mulrN -opprD => /eqP.
rewrite oppr_eq0 -mulr2n mulrn_eq0 /= mulf_eq0 (negbTE (cis_neq0 e _)) orbF => /eqP v0.
by rewrite v0 oppr0.
Qed.

End Shaking.
