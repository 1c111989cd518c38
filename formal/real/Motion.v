(* Which part of the exact motion of an in-line six is left?  Pistons on centric slider-cranks, any crank radius, rod, mass and speed, all
   real numbers: the force on the engine, minus the second derivative of momentum, repeats every 60 degrees of the crank.  Where r < l the
   root and the derivatives are the ordinary ones; Coq gives them a value elsewhere too. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Local Open Scope R_scope.

(* Where the piston stands, psi radians after dead centre. *)
Definition piston (r l psi : R) : R := r * cos psi + sqrt (l * l - r * r * (sin psi * sin psi)).

Definition third : R := 2 * PI / 3.

(* The throws 0, 240, 120, 120, 240, 0 degrees. *)
Definition pistons (r l theta : R) : R :=
  piston r l theta + piston r l (theta + 2 * third) + piston r l (theta + third)
  + piston r l (theta + third) + piston r l (theta + 2 * third) + piston r l theta.

(* At the time t. *)
Definition exact_force (m r l omega t : R) : R := - m * Derive_n (fun t => pistons r l (omega * t)) 2 t.

Lemma cos_three x : cos x + cos (x + third) + cos (x + 2 * third) = 0.
Proof.
assert (T : third = PI - PI / 3) by (unfold third; field).
assert (C1 : cos third = - (1 / 2)) by (rewrite T, Rtrigo_facts.cos_pi_minus, cos_PI3; reflexivity).
assert (C2 : cos (2 * third) = - (1 / 2)) by (rewrite cos_2a_cos, C1; field).
assert (S2 : sin (2 * third) = - sin third) by (rewrite sin_2a, C1; field).
rewrite !cos_plus, C1, C2, S2; field.
Qed.

Lemma sin_half x : sin (x + PI) * sin (x + PI) = sin x * sin x.
Proof. rewrite neg_sin; ring. Qed.

(** Together the pistons stand where they stood 60 degrees before. *)
Theorem same_place r l theta : pistons r l (theta + PI / 3) = pistons r l theta.
Proof.
unfold pistons, piston.
assert (A := cos_three theta); assert (B := cos_three (theta + PI / 3)).
assert (P1 : theta + PI / 3 + third = theta + PI) by (unfold third; field).
assert (P2 : theta + PI / 3 + 2 * third = theta + third + PI) by (unfold third; field).
assert (P4 : theta + PI / 3 + PI = theta + 2 * third) by (unfold third; field).
rewrite P1, P2 in *; rewrite !sin_half.
replace (sin (theta + PI / 3) * sin (theta + PI / 3)) with (sin (theta + 2 * third) * sin (theta + 2 * third)) by (rewrite <- P4; apply sin_half).
set (a := sqrt (l * l - r * r * (sin theta * sin theta))).
set (b := sqrt (l * l - r * r * (sin (theta + third) * sin (theta + third)))).
set (c := sqrt (l * l - r * r * (sin (theta + 2 * third) * sin (theta + 2 * third)))).
nra.
Qed.

(** So the force is, whatever the motion's harmonics are. *)
Theorem force_repeats m r l omega t : omega <> 0 -> exact_force m r l omega (t + PI / 3 / omega) = exact_force m r l omega t.
Proof.
intro w; unfold exact_force; f_equal.
rewrite <- (Derive_n_comp_trans (fun t => pistons r l (omega * t)) 2 t (PI / 3 / omega)).
apply Derive_n_ext; intro u.
replace (omega * (u + PI / 3 / omega)) with (omega * u + PI / 3) by (field; exact w).
apply same_place.
Qed.
