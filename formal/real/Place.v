(* Do the pistons of an engine stand together as they did a turn s before?  What the root of the motion adds repeats every half turn, and is
   compared piston by piston; what the cosine adds is the force of order 1, which is zero. *)
From Coq Require Import ZArith QArith Reals Qreals List Lia Lra.
From mathcomp Require Import all_ssreflect all_algebra ssrZ Rstruct.
From mathcomp.real_closed Require Import complex.
From Crankstar Require Import Sums Splitting Engine Checker EveryOrder.
From Crankstar.real Require Import RealForce Bridge Motion.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Delimit Scope R_scope with re.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.
Local Arguments Z.div : simpl never. Local Arguments Z.modulo : simpl never.

(* How far a piston is through its half turn, and its bank, in N-th parts, as one number; [on] turns it on. *)
Definition place_key (N on : Z) (p : cylinder) : Z :=
  Z.add (Z.mul (Z.modulo (Z.add (Z.sub (times N (throw p)) (times N (bank p))) on) (Z.div N 2)) N) (Z.modulo (times N (bank p)) N).

Definition whole_piston (N D : Z) (rho : Q) (p : cylinder) : bool :=
  is_whole N (throw p) && is_whole N (bank p) && is_whole D (mass p) && Qeq_bool (radius p) rho.

(* Angles times N and masses times D are whole. *)
Definition check_place (E : engine) (s : Q) (N D : Z) (rho : Q) : bool :=
  Z.ltb 0 N && Z.eqb (Z.modulo N 2) 0 && Z.ltb 0 D && is_whole N s && Nat.eqb (size (turning_masses E)) 0
  && all (whole_piston N D rho) (cylinders E)
  && all_zero (collect (Z.mul N N) ([seq (place_key N (times N s) p, times D (mass p)) | p <- cylinders E]
       ++ [seq (place_key N 0 p, Z.opp (times D (mass p))) | p <- cylinders E])).

Local Open Scope R_scope.

Lemma ex_turn x n : ex (x + 2 * PI * IZR n) = ex x.
Proof.
have := exD x (radians (inject_Z n)); rewrite ex_Z mulr1 => <-; congr ex; by rewrite /radians Q2R_Z.
Qed.

Lemma cos_turn x n : cos (x + 2 * PI * IZR n) = cos x.
Proof. exact: (congr1 (fun z : complex R => complex.Re z) (ex_turn x n)). Qed.

Lemma sin_turn x n : sin (x + 2 * PI * IZR n) = sin x.
Proof. exact: (congr1 (fun z : complex R => complex.Im z) (ex_turn x n)). Qed.

Definition root (r l psi : R) : R := sqrt (l * l - r * r * (sin psi * sin psi)).

(* It repeats every half turn. *)
Lemma root_turn r l x n : root r l (x + PI * IZR n) = root r l x.
Proof.
rewrite /root; congr sqrt; congr (_ - _ * _).
have half y : sin y * sin y = (1 - cos (2 * y)) / 2 by rewrite cos_2a_sin; field.
rewrite !half; congr ((1 - _) / 2); rewrite -(cos_turn (2 * x) n); congr cos; ring.
Qed.

Lemma Q2R_times N q : Z.lt 0 N -> is_whole N q -> Q2R q = IZR (times N q) / IZR N.
Proof.
move=> N0 /is_whole_times/Qeq_eqR; rewrite Q2R_mult !Q2R_Z => <-; field; apply: not_0_IZR; lia.
Qed.

Section Place.
Variables (E : engine) (s : Q) (N D : Z) (rho : Q).
Hypothesis ok : check_place E s N D rho = true.
Variables (axis : R -> R) (r l : R).
Hypothesis turns : forall x n, axis (x + 2 * PI * IZR n) = axis x.

Definition roots (on : R) : R :=
  sum_of (fun p => Q2R (mass p) * root (r * Q2R rho) l (on + radians (throw p - bank p)) * axis (radians (bank p))) (cylinders E).

Lemma roots_repeat theta : roots (theta + radians s) = roots theta.
Proof.
case/andP: (ok) => /andP[/andP[/andP[/andP[/andP[/Z.ltb_spec0 N0 /Z.eqb_spec N2] /Z.ltb_spec0 D0] ws] _] whole] same.
have N_half := Z.div_mod N 2 ltac:(lia); rewrite N2 in N_half; set H := Z.div N 2 in N_half.
have H0 : Z.lt 0 H by lia.
have NR : IZR N <> 0 by apply: not_0_IZR; lia.
have DR : IZR D <> 0 by apply: not_0_IZR; lia.
pose f (x : Z) : R := root (r * Q2R rho) l (theta + 2 * PI * IZR (Z.div x N) / IZR N) * axis (2 * PI * IZR (Z.modulo x N) / IZR N).
have := weighted_collect (A := R_ringType) f same; rewrite big_cat !big_map /=.
have fE on p : whole_piston N D rho p ->
    f (Z.modulo (place_key N on p) (Z.mul N N))
    = root (r * Q2R rho) l (theta + 2 * PI * (IZR on / IZR N) + radians (throw p - bank p)) * axis (radians (bank p)).
  case/andP => /andP[/andP[wt wb] _] _; rewrite /f /place_key; set a := Z.add _ on; set b := times N (bank p).
  have ab := Z.mod_pos_bound a H H0; have bb := Z.mod_pos_bound b N N0; rewrite -/H.
  rewrite (Z.mod_small _ (Z.mul N N)); last nia.
  have -> : Z.div (Z.add (Z.mul (Z.modulo a H) N) (Z.modulo b N)) N = Z.modulo a H.
    by rewrite Z.add_comm Z.div_add ?Z.div_small //; lia.
  have -> : Z.modulo (Z.add (Z.mul (Z.modulo a H) N) (Z.modulo b N)) N = Z.modulo b N.
    by rewrite Z.add_comm Z.mod_add ?Z.mod_mod //; lia.
  have aE : IZR (Z.modulo a H) = IZR a - IZR N / 2 * IZR (Z.div a H).
    have := Z.div_mod a H ltac:(lia) => /(congr1 IZR); rewrite plus_IZR mult_IZR.
    by have /(congr1 IZR) := N_half; rewrite plus_IZR mult_IZR => -> ->; field.
  have bE : IZR (Z.modulo b N) = IZR b - IZR N * IZR (Z.div b N).
    by have := Z.div_mod b N ltac:(lia) => /(congr1 IZR); rewrite plus_IZR mult_IZR => ->; ring.
  congr (_ * _).
    rewrite -(root_turn _ _ _ (Z.div a H)) aE; congr root.
    rewrite /radians /Qminus Q2R_plus Q2R_opp (Q2R_times N0 wt) (Q2R_times N0 wb) /a -/b plus_IZR minus_IZR; field; exact: NR.
  rewrite -(turns _ (Z.div b N)) bE; congr axis; rewrite /radians (Q2R_times N0 wb) -/b; field; exact: NR.
pose g on p : R := Q2R (mass p) * root (r * Q2R rho) l (theta + 2 * PI * (IZR on / IZR N) + radians (throw p - bank p)) * axis (radians (bank p)).
have gE on : (\sum_(p <- cylinders E) (int_of_Z (times D (mass p)))%:~R * f (Z.modulo (place_key N on p) (Z.mul N N)))%R
    = IZR D * sum_of (g on) (cylinders E).
  elim: (cylinders E) whole => [_|p c IH /andP[wp wc]]; first by rewrite big_nil Rmult_0_r.
  rewrite big_cons (IH wc) fE // int_IZR /= /g; case/andP: wp => /andP[_ wd] _; rewrite (Q2R_times D0 wd).
  have E1 (m x y t : R) : m * (x * y) + IZR D * t = IZR D * (m / IZR D * x * y + t) by field.
  exact: E1.
have oE on : (\sum_(p <- cylinders E) (int_of_Z (Z.opp (times D (mass p))))%:~R * f (Z.modulo (place_key N on p) (Z.mul N N)))%R
    = - (\sum_(p <- cylinders E) (int_of_Z (times D (mass p)))%:~R * f (Z.modulo (place_key N on p) (Z.mul N N)))%R.
  elim: (cylinders E) => [|p c IH]; first by rewrite !big_nil; exact: (esym Ropp_0).
  rewrite !big_cons IH !int_IZR opp_IZR.
  have E1 (x y t : R) : - x * y + - t = - (x * y + t) by ring.
  exact: E1.
rewrite oE !gE => sum0.
have sumE on : sum_of (g on) (cylinders E) = roots (theta + 2 * PI * (IZR on / IZR N)) by [].
have {}sum0 : IZR D * sum_of (g (times N s)) (cylinders E) = IZR D * sum_of (g Z0) (cylinders E) by apply: Rminus_diag_uniq; exact: sum0.
have := Rmult_eq_reg_l _ _ _ sum0 DR; rewrite !sumE -(Q2R_times N0 ws).
have -> : theta + 2 * PI * (0 / IZR N) = theta by field.
by [].
Qed.

End Place.

(** Together the pistons stand where they stood a turn s before. *)
Theorem same_place E s N D rho : check_place E s N D rho = true ->
  vector real_circle E (Force Direct) 1 = 0%R -> vector real_circle E (Force Reverse) 1 = 0%R ->
  forall r l theta, pistons cos E r l (theta + radians s) = pistons cos E r l theta /\ pistons sin E r l (theta + radians s) = pistons sin E r l theta.
Proof.
move=> ok d0 v0 r l theta.
have none : turning_masses E = nil.
  by case/andP: (ok) => /andP[/andP[_ /Nat.eqb_spec]]; case: (turning_masses E).
have whole : all (whole_piston N D rho) (cylinders E) by case/andP: (ok) => /andP[_].
have share : shared (1, 0) E 1 by left.
have first x := no_force share d0 v0 x.
(* The cosine and the root apart. *)
have split axis x : pistons axis E r l x
    = r * part_along axis (1, 0) E (fun=> 1%q) 1 x + roots E rho axis r l x.
  rewrite /pistons /part_along /roots none /= Rplus_0_r.
  elim: (cylinders E) whole => [_|p c IH /andP[wp wc]] /=; first by ring.
  rewrite IH //; case/andP: wp => _ /Qeq_bool_iff/Qeq_eqR rE.
  have q1 : Q2R 1%q = 1 := Q2R_Z 1.
  rewrite /piston /root /of_piston /harmonic !Q2R_mult rE q1 /fst /snd !Rmult_1_l; ring.
have E1 x : part_along cos (1, 0) E (fun=> 1%q) 1 x = 0 by exact: (congr1 fst (first x)).
have E2 x : part_along sin (1, 0) E (fun=> 1%q) 1 x = 0 by exact: (congr1 snd (first x)).
by rewrite !split !E1 !E2 (roots_repeat ok _ _ cos_turn) (roots_repeat ok _ _ sin_turn).
Qed.
