(* Does a sum that vanishes over every circle make the real force vanish?  The circle exp(2 pi i t) of Coq's real numbers, and the force
   as its two vectors. *)
From Coq Require Import ZArith QArith Reals Qreals List Lia Lra.
From mathcomp Require Import all_ssreflect all_algebra ssrZ Rstruct.
From mathcomp.real_closed Require Import complex.
From Crankstar Require Import Sums Splitting Engine Checker Shaking.
From Crankstar.real Require Import RealForce.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Delimit Scope R_scope with re.
Local Open Scope ring_scope.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.

Definition C : numClosedFieldType := [numClosedFieldType of complex R_rcfType].

(** * The circle *)

Definition ex (x : R) : C := Complex (cos x) (sin x).

Lemma complex_eq (x y : C) : complex.Re x = complex.Re y -> complex.Im x = complex.Im y -> x = y.
Proof. by move=> re im; apply/eqP; rewrite eq_complex re im !eqxx. Qed.

Lemma exD x y : ex (x + y)%re = ex x * ex y.
Proof. by apply: complex_eq; [exact: cos_plus | rewrite /= sin_plus; exact: Rplus_comm]. Qed.

Lemma ex0 : ex 0%re = 1.
Proof. by rewrite /ex cos_0 sin_0. Qed.

Lemma ex_half x : ex (- (PI / 2))%re = - ex (PI / 2)%re /\ ex x != 0.
Proof.
split; first by apply: complex_eq; rewrite /= ?cos_neg ?sin_neg ?cos_PI2 ?oppr0.
apply/eqP => x0; have := exD x (- x)%re.
by rewrite x0 mul0r Rplus_opp_r ex0 => /eqP; rewrite oner_eq0.
Qed.

Lemma Q2R_Z n : Q2R (inject_Z n) = IZR n.
Proof. by rewrite /Q2R /= Rinv_1 Rmult_1_r. Qed.

Lemma radians_same s t : (s == t)%q -> radians s = radians t.
Proof. by move=> /Qeq_eqR H; rewrite /radians H. Qed.

Lemma turn_add s t : ex (radians (s + t)%q) = ex (radians s) * ex (radians t).
Proof. by rewrite /radians Q2R_plus Rmult_plus_distr_l exD. Qed.

Lemma cos_1 t : cos (radians t) = 1%re -> exists n : Z, (t == inject_Z n)%q.
Proof.
rewrite /radians Rmult_assoc cos_2a_sin => H.
have S : Rsqr (sin (PI * Q2R t)%re) = 0%re.
  by rewrite /Rsqr; apply: (Rmult_eq_reg_l 2%re); [lra | lra].
case: (sin_eq_0_0 _ (Rsqr_0_uniq _ S)) => n nE; exists n; apply: eqR_Qeq; rewrite Q2R_Z.
apply: (Rmult_eq_reg_l PI); last exact: PI_neq0.
by rewrite nE Rmult_comm.
Qed.

Lemma ex_Z n : ex (radians (inject_Z n)) = 1.
Proof.
have ex1 : ex (2 * PI)%re = 1 by rewrite /ex cos_2PI sin_2PI.
have exN m : ex (2 * PI * INR m)%re = 1.
  elim: m => [|m IH]; first by rewrite /= Rmult_0_r ex0.
  by rewrite S_INR Rmult_plus_distr_l Rmult_1_r exD IH ex1 mul1r.
rewrite /radians Q2R_Z; case: n => [|p|p]; first by rewrite Rmult_0_r ex0.
  by rewrite -(positive_nat_Z p) -INR_IZR_INZ exN.
have : ex (2 * PI * IZR (Z.neg p))%re * ex (2 * PI * IZR (Z.pos p))%re = 1.
  by rewrite -exD -Rmult_plus_distr_l -plus_IZR (_ : Z.add (Z.neg p) (Z.pos p) = Z0) ?Rmult_0_r ?ex0 //; lia.
by rewrite -(positive_nat_Z p) -INR_IZR_INZ exN mulr1.
Qed.

Lemma turn_one t : ex (radians t) = 1 <-> exists n : Z, (t == inject_Z n)%q.
Proof.
split=> [H|[n nE]]; last by rewrite (radians_same nE) ex_Z.
by apply: cos_1; exact: (congr1 (fun z : complex R => complex.Re z) H).
Qed.

Definition real_circle : circle C := Circle turn_add turn_one.

(** * Rational numbers as real ones *)

Lemma int_IZR n : (int_of_Z n)%:~R = IZR n :> R.
Proof.
case: n => [|p|p] //=.
  by rewrite -(positive_nat_Z p) -INR_IZR_INZ INRE.
have -> : IZR (Z.neg p) = - IZR (Z.pos p) :> R by [].
have p0 : (0 < Pos.to_nat p)%N by apply/ssrnat.ltP; exact: Pos2Nat.is_pos.
by rewrite -(positive_nat_Z p) -INR_IZR_INZ INRE NegzE prednK // mulrNz.
Qed.

Notation real := (real_complex R).
Local Notation realM := (rmorphM (ComplexField.real_complex_rmorphism R_rcfType)).

Lemma number_real q : number C q = real (Q2R q).
Proof.
have d0 : IZR (Z.pos (Qden q)) != 0 :> R.
  apply/eqP; by apply: (not_0_IZR (Z.pos (Qden q))).
rewrite /number -!(rmorph_int (ComplexField.real_complex_rmorphism R_rcfType)) !int_IZR /=.
rewrite -[X in _ / X]/(real _) -(fmorphV (ComplexField.real_complex_rmorphism R_rcfType)) /= -realM /=; congr (real _).
by rewrite /GRing.inv /= /Rinvx d0.
Qed.

Lemma real_ex (w x : R) : (Complex (w * cos x) (w * sin x) : C) = real w * ex x.
Proof. by apply: complex_eq; rewrite /= mul0r ?subr0 ?addr0. Qed.

Lemma sum_of_big T (f : T -> R) l : sum_of f l = \sum_(x <- l) f x.
Proof. by elim: l => [|x l IH]; rewrite ?big_nil // big_cons -IH. Qed.

Lemma real_sum T (f : T -> R) l : real (sum_of f l) = \sum_(x <- l) real (f x).
Proof. by rewrite sum_of_big (rmorph_sum (ComplexField.real_complex_rmorphism R_rcfType)). Qed.

Lemma Complex_sum T (f g : T -> R) l :
  (Complex (sum_of f l) (sum_of g l) : C) = \sum_(x <- l) (Complex (f x) (g x) : C).
Proof. by rewrite !sum_of_big; elim: l => [|x l IH]; rewrite ?big_nil // !big_cons -IH. Qed.

(** * The force as its two vectors *)

Section Vectors.
Variable c : R * R.

(* The number of the motion, and its conjugate. *)
Definition direct : C := Complex c.1 c.2.
Definition reverse : C := Complex c.1 (- c.2).

Lemma direct_neq0 : c <> (0%re, 0%re) -> direct != 0 /\ reverse != 0.
Proof.
move=> c0; rewrite !eq_complex /= oppr_eq0.
by split; apply/negP => /andP[/eqP a0 /eqP b0]; apply: c0; rewrite (surjective_pairing c) a0 b0.
Qed.

Lemma two_harmonics k psi : 2%:R * real (harmonic c k psi) = direct * ex (IZR k * psi)%re + reverse * ex (- (IZR k * psi))%re.
Proof.
have re a b x y : (a * x - b * y + (a * x - b * y) = a * x - b * y + (a * x - - b * - y))%re by ring.
have im a b x y : (0 + 0 = a * y + b * x + (a * - y + - b * x))%re by ring.
rewrite mulr_natl mulr2n; apply: complex_eq; rewrite /= /harmonic cos_neg sin_neg; [exact: re | exact: im].
Qed.

(* Twice order k of a piston at b, seen from its bank a. *)
Lemma of_cylinder k theta a b :
  2%:R * (real (harmonic c k (theta + radians (b - a)%q)%re) * ex (radians a))
  = direct * real_circle (inject_Z k * b - inject_Z (k - 1) * a)%q * ex (IZR k * theta)%re
    + reverse * real_circle (inject_Z (k + 1) * a - inject_Z k * b)%q * ex (- (IZR k * theta))%re.
Proof.
rewrite mulrA two_harmonics mulrDl -!mulrA /= -!exD; congr (_ * ex _ + _ * ex _);
  rewrite /radians /Qminus !Q2R_plus !Q2R_opp !Q2R_mult !Q2R_Z ?minus_IZR ?plus_IZR; ring.
Qed.

Lemma of_turning_mass n U arm g (x : R) :
  2%:R * (number C (inject_Z (n * n) * U * arm)%q * ex (radians g + x)%re)
  = number C (inject_Z (2 * n * n) * U * arm)%q * ex (radians g) * ex x.
Proof.
rewrite exD !mulrA; congr (_ * _ * _).
have -> : number C (inject_Z (2 * n * n) * U * arm)%q = number C (inject_Z 2 * (inject_Z (n * n) * U * arm))%q.
  by apply: number_eq; rewrite !inject_Z_mult; ring.
by rewrite [RHS]numberM number_Z -[LHS]mulrA.
Qed.

Variables (E : engine) (q : sense -> quantity) (arm : Q -> Q).
Hypothesis arm_of_q : q = Force /\ arm = (fun=> 1%q) \/ q = Moment /\ arm = (fun z => (z - plane E)%q).

(* The number c may be any where no mass turns with this order; else it is 1, as that of the first order. *)
Definition shared (k : Z) : Prop := c = (1%re, 0%re) \/ all (fun t => ~~ Z.eqb (order t) k) (turning_masses E) = true.

Lemma two_vectors k theta : shared k ->
  2%:R * (Complex (part_along cos c E arm k theta) (part_along sin c E arm k theta) : C)
  = direct * vector real_circle E (q Direct) k * ex (IZR k * theta)%re
    + reverse * vector real_circle E (q Reverse) k * ex (- (IZR k * theta))%re.
Proof.
move=> share; pose turning s := total real_circle [seq (angle t, turning_weight E (q s) t) | t <- turning_masses E & takes_part (q s) k t].
have one s : direct * turning s = turning s /\ reverse * turning s = turning s.
  case: share => [c1 | none]; first by rewrite /direct /reverse c1 /= oppr0 !mul1r.
  suff -> : turning s = 0 by rewrite !mulr0.
  rewrite /turning (_ : [seq t <- _ | _] = [::]) /total ?big_nil //.
  rewrite (filter_none none) // => t /negbTE; rewrite /takes_part => ->; by case: (q s).
have -> : (Complex (part_along cos c E arm k theta) (part_along sin c E arm k theta) : C) =
   \sum_(p <- cylinders E) (number C (mass p * radius p * arm (position p))%q * (real (of_piston c k theta p) * ex (radians (bank p))))
   + \sum_(t <- [seq t <- turning_masses E | Z.eqb (order t) k])
      (number C (inject_Z (order t * order t) * mass_radius t * arm (place t))%q * ex (radians (angle t) + signed (turns t) (IZR k * theta))%re).
  rewrite /part_along -[LHS]/(Complex _ _ + Complex _ _ : C) !Complex_sum.
  congr (_ + _); apply: eq_bigr => x _; rewrite real_ex; last by rewrite number_real.
  by rewrite mulrA number_real -realM.
rewrite /vector /vectors !total_cat -![total _ [seq _ | t <- turning_masses E & _]]/(turning _).
rewrite !mulrDr (proj1 (one _)) (proj2 (one _)) [(direct * _ + _) * _]mulrDl [(reverse * _ + _) * _]mulrDl addrACA; congr (_ + _).
  rewrite /total !big_map !mulr_sumr !mulr_suml -big_split; apply: eq_bigr => p _ /=.
  rewrite mulrCA of_cylinder mulrDr.
  have swap (w d a x : C) : w * (d * a * x) = d * (w * a) * x by rewrite !mulrA [w * d]mulrC.
  by case: arm_of_q => -[-> ->]; congr (_ + _); exact: swap.
rewrite /turning /total !big_map !big_filter mulr_sumr !mulr_suml.
rewrite big_mkcond [X in _ = X + _]big_mkcond [X in _ = _ + X]big_mkcond -big_split; apply: eq_bigr => t _ /=.
have partE s : takes_part (q s) k t = Z.eqb (order t) k && same_sense s (turns t) by case: arm_of_q => -[-> _].
rewrite !partE; case: Z.eqb_spec => [ok|_] /=; last by rewrite addr0.
rewrite of_turning_mass /turning_weight !(lever_arm arm_of_q).
by case: (turns t) => /=; rewrite ?addr0 ?add0r.
Qed.

Lemma none_at k theta : both_parts c E arm k theta = (0%re, 0%re) <->
  2%:R * (Complex (part_along cos c E arm k theta) (part_along sin c E arm k theta) : C) = 0.
Proof.
rewrite /both_parts; split=> [[-> ->] | /eqP]; first exact: mulr0.
by rewrite mulf_eq0 pnatr_eq0 /= eq_complex => /andP[/eqP /= -> /eqP /= ->].
Qed.

Lemma vectors_vanish k : shared k ->
  vector real_circle E (q Direct) k = 0 -> vector real_circle E (q Reverse) k = 0 ->
  forall theta, both_parts c E arm k theta = (0%re, 0%re).
Proof. by move=> share d r theta; apply/none_at; rewrite two_vectors // d r !mulr0 !mul0r addr0. Qed.

(* One of two angles a quarter of a turn of the order apart shows what is left. *)
Lemma vectors_left k : shared k -> Z.lt 0 k -> c <> (0%re, 0%re) ->
  vector real_circle E (q Direct) k <> 0 \/ vector real_circle E (q Reverse) k <> 0 ->
  exists theta, both_parts c E arm k theta <> (0%re, 0%re).
Proof.
move=> share k0 /direct_neq0[d0 r0] left.
set u := vector _ _ (q Direct) _ in left; set v := vector _ _ (q Reverse) _ in left.
have S x : both_parts c E arm k (x / IZR k)%re = (0%re, 0%re) -> direct * u * ex x + reverse * v * ex (- x)%re = 0.
  have kx : (IZR k * (x / IZR k))%re = x by field; apply: not_0_IZR; lia.
  by move/none_at; rewrite two_vectors // kx.
case: (both_parts c E arm k (0 / IZR k)%re =P (0%re, 0%re)) => [/S | ]; last by eexists; eassumption.
case: (both_parts c E arm k (PI / 2 / IZR k)%re =P (0%re, 0%re)) => [/S | ]; last by eexists; eassumption.
have [-> i0] := ex_half (PI / 2)%re; rewrite Ropp_0 ex0 !mulr1 mulrN -mulNr -mulrDl => /eqP.
rewrite mulf_eq0 (negbTE i0) orbF subr_eq0 => /eqP uv; rewrite uv -mulr2n => /eqP.
rewrite mulrn_eq0 mulf_eq0 (negbTE r0) /= => /eqP v0; move/eqP: uv.
by rewrite v0 mulr0 mulf_eq0 (negbTE d0) /= => /eqP u0; case: left.
Qed.

(* What is known of every order k above 1, where nothing turns faster than the crank. *)
Lemma vectors_of_every k (direct_left reverse_left : Prop) : all (fun t => Z.leb (order t) 1) (turning_masses E) = true ->
  Z.le 2 k -> c <> (0%re, 0%re) ->
  (vector real_circle E (q Direct) k <> 0 <-> direct_left) -> (vector real_circle E (q Reverse) k <> 0 <-> reverse_left) ->
  (exists theta, both_parts c E arm k theta <> (0%re, 0%re)) <-> direct_left \/ reverse_left.
Proof.
move=> slow k2 c0 <- <-; have k0 : Z.lt 0 k by lia.
have share : shared k.
  by right; apply: sub_all slow => t /Z.leb_spec0 t1; apply/negP => /Z.eqb_spec; lia.
split=> [[theta left]|]; last exact: vectors_left.
case: (vector real_circle E (q Direct) k =P 0) => [u0 | ]; last by left.
by right=> v0; apply: left; exact: vectors_vanish.
Qed.

End Vectors.

(** * The torque as its vector *)

Lemma Re_sum T (f : T -> C) l : complex.Re (\sum_(x <- l) f x) = sum_of (fun x => complex.Re (f x)) l.
Proof.
have D (x y : C) : complex.Re (x + y) = (complex.Re x + complex.Re y)%re by case: x; case: y.
by elim: l => [|x l IH]; rewrite ?big_nil // big_cons D IH.
Qed.

Lemma Re_real w (z : C) : complex.Re (real w * z) = (w * complex.Re z)%re.
Proof. case: z => a b; have E : (w * a - 0 * b = w * a)%re by ring. exact: E. Qed.

Lemma torque_vector c E k theta : torque c E k theta = complex.Re (direct c * vector real_circle E Torque k * ex (IZR k * theta)%re).
Proof.
have none : [seq t <- turning_masses E | takes_part Torque k t] = [::].
  by elim: (turning_masses E) => //= t l ->; rewrite /takes_part andbF.
rewrite /vector /vectors none cats0 /total big_map mulr_sumr mulr_suml Re_sum /torque.
elim: (cylinders E) => //= p l ->; congr (_ + _)%re.
rewrite number_real mulrCA -mulrA Re_real; congr (_ * _)%re.
have angles x : (radians (inject_Z k * x)%q + IZR k * theta = IZR k * (theta + radians x))%re.
  by rewrite /radians Q2R_mult Q2R_Z; ring.
by rewrite -mulrA -exD angles.
Qed.

(** * What a file on an engine proves with *)

(* The number of the first order, where masses that turn are in one sum with the pistons. *)
Lemma one_is_other : (1, 0)%re <> (0, 0)%re.
Proof. by case=> /R1_neq_R0. Qed.

Section Verdicts.
Variable E : engine.

Theorem no_force c k : shared c E k ->
  vector real_circle E (Force Direct) k = 0 -> vector real_circle E (Force Reverse) k = 0 -> forall theta, force c E k theta = (0%re, 0%re).
Proof. by apply: vectors_vanish; left. Qed.

Theorem no_moment c k : shared c E k ->
  vector real_circle E (Moment Direct) k = 0 -> vector real_circle E (Moment Reverse) k = 0 -> forall theta, moment c E k theta = (0%re, 0%re).
Proof. by apply: vectors_vanish; right. Qed.

Theorem some_force c k : shared c E k -> Z.lt 0 k -> c <> (0%re, 0%re) ->
  vector real_circle E (Force Direct) k <> 0 \/ vector real_circle E (Force Reverse) k <> 0 -> exists theta, force c E k theta <> (0%re, 0%re).
Proof. by apply: vectors_left; left. Qed.

Theorem some_moment c k : shared c E k -> Z.lt 0 k -> c <> (0%re, 0%re) ->
  vector real_circle E (Moment Direct) k <> 0 \/ vector real_circle E (Moment Reverse) k <> 0 -> exists theta, moment c E k theta <> (0%re, 0%re).
Proof. by apply: vectors_left; right. Qed.

Lemma above_one k : Z.le 3 k -> Z.le 2 k.
Proof. lia. Qed.

Theorem every_force c k (a b : Prop) : all (fun t => Z.leb (order t) 1) (turning_masses E) = true -> Z.le 2 k -> c <> (0%re, 0%re) ->
  (vector real_circle E (Force Direct) k <> 0 <-> a) -> (vector real_circle E (Force Reverse) k <> 0 <-> b) ->
  (exists theta, force c E k theta <> (0%re, 0%re)) <-> a \/ b.
Proof. by apply: vectors_of_every; left. Qed.

Theorem every_moment c k (a b : Prop) : all (fun t => Z.leb (order t) 1) (turning_masses E) = true -> Z.le 2 k -> c <> (0%re, 0%re) ->
  (vector real_circle E (Moment Direct) k <> 0 <-> a) -> (vector real_circle E (Moment Reverse) k <> 0 <-> b) ->
  (exists theta, moment c E k theta <> (0%re, 0%re)) <-> a \/ b.
Proof. by apply: vectors_of_every; right. Qed.

Theorem no_torque c k : vector real_circle E Torque k = 0 -> forall theta, torque c E k theta = 0%re.
Proof. by move=> v0 theta; rewrite torque_vector v0 mulr0 mul0r. Qed.

Theorem some_torque c k : Z.lt 0 k -> c <> (0%re, 0%re) -> vector real_circle E Torque k <> 0 -> exists theta, torque c E k theta <> 0%re.
Proof.
move=> k0 /direct_neq0[d0 _] /eqP left.
have kx x : (IZR k * (x / IZR k))%re = x by field; apply: not_0_IZR; lia.
case: (torque c E k (0 / IZR k)%re =P 0%re) => [|]; last by eexists; eassumption.
case: (torque c E k (PI / 2 / IZR k)%re =P 0%re) => [|]; last by eexists; eassumption.
rewrite !torque_vector !kx; move: (mulf_neq0 d0 left); case: (_ * _) => a b ab0.
rewrite /= cos_PI2 sin_PI2 cos_0 sin_0 !mulr0 !mulr1 subr0 sub0r => /eqP; rewrite oppr_eq0 => /eqP b0 a0.
by move: ab0; rewrite a0 b0 eqxx.
Qed.

Theorem every_torque c k (a : Prop) : Z.le 1 k -> c <> (0%re, 0%re) -> (vector real_circle E Torque k <> 0 <-> a) ->
  (exists theta, torque c E k theta <> 0%re) <-> a.
Proof.
move=> k1 c0 <-; split=> [[theta left]|]; last by apply: some_torque => //; lia.
by move=> v0; apply: left; exact: no_torque.
Qed.

End Verdicts.

(** ** In parts *)

Lemma no_parts theta : together nil theta = (0%re, 0%re).
Proof. by []. Qed.

Theorem and_part f parts : (forall theta, f theta = (0%re, 0%re)) -> (forall theta, together parts theta = (0%re, 0%re)) ->
  forall theta, together (f :: parts) theta = (0%re, 0%re).
Proof. by move=> f0 p0 theta; have := p0 theta; rewrite /together /= f0 /= !Rplus_0_l. Qed.

Lemma no_torque_parts theta : torques_together nil theta = 0%re.
Proof. by []. Qed.

Theorem and_torque_part f parts : (forall theta, f theta = 0%re) -> (forall theta, torques_together parts theta = 0%re) ->
  forall theta, torques_together (f :: parts) theta = 0%re.
Proof. by move=> f0 p0 theta; have := p0 theta; rewrite /torques_together /= f0 Rplus_0_l. Qed.
