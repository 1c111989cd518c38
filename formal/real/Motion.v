(* How does an engine move exactly, all orders together?  Pistons on centric slider-cranks of one rod, any crank radius, rod, mass and speed, all
   real numbers.  The force on the engine is minus the second derivative of momentum: where the pistons stand as before, it repeats.  Where r < l
   the root and the derivatives are the ordinary ones; Coq gives them a value elsewhere too. *)
From Coq Require Import QArith Reals Qreals List.
From Coquelicot Require Import Coquelicot.
From Crankstar Require Import Engine.
From Crankstar.real Require Import RealForce.
Local Open Scope R_scope.

(* Where the piston stands, psi radians after dead centre. *)
Definition piston (r l psi : R) : R := r * cos psi + sqrt (l * l - r * r * (sin psi * sin psi)).

(* All of them, each by its mass and along its bank: the part along the reference direction with [axis] = cos, across it with sin.  The
   crank radii of the engine are in the unit r. *)
Definition pistons (axis : R -> R) (E : engine) (r l theta : R) : R :=
  sum_of (fun p => Q2R (mass p) * piston (r * Q2R (radius p)) l (theta + radians (throw p - bank p)) * axis (radians (bank p))) (cylinders E).

(* At the time t; the masses of the engine are in the unit m. *)
Definition exact_part (axis : R -> R) (E : engine) (m r l omega t : R) : R :=
  - m * Derive_n (fun t => pistons axis E r l (omega * t)) 2 t.
Definition exact_force (E : engine) (m r l omega t : R) : R * R := (exact_part cos E m r l omega t, exact_part sin E m r l omega t).

(** After the turn s of the crank the force is as before, whatever the harmonics of the motion are. *)
Theorem force_repeats E s r l :
  (forall theta, pistons cos E r l (theta + radians s) = pistons cos E r l theta /\ pistons sin E r l (theta + radians s) = pistons sin E r l theta) ->
  forall m omega t, omega <> 0 -> exact_force E m r l omega (t + radians s / omega) = exact_force E m r l omega t.
Proof.
intros same m omega t w; unfold exact_force, exact_part.
assert (step : forall u, omega * (u + radians s / omega) = omega * u + radians s) by (intro u; field; exact w).
f_equal; f_equal; rewrite <- (Derive_n_comp_trans _ 2 t (radians s / omega)); apply Derive_n_ext; intro u; rewrite step; apply same.
Qed.
