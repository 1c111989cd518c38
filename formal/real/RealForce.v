(* What is the shaking force at a real crank angle?  Definitions only: who reads a theorem over the real numbers has to trust these lines,
   and Engine.v, whose record of rational numbers they read. *)
From Coq Require Import ZArith QArith Reals Qreals List.
From Crankstar Require Import Engine.
Local Open Scope R_scope.

(* An angle in turns as one in radians. *)
Definition radians (t : Q) : R := 2 * PI * Q2R t.

Definition sum_of {T : Type} (f : T -> R) (l : list T) : R := fold_right (fun x s => f x + s) 0 l.

(* Order k of what a piston does, psi radians after its dead centre: the real part of c exp(i k psi).  The number c = c_k, here the pair of
   its real and imaginary part, is the motion's: of a rod without offset (c_k, 0), and (1, 0) in order 1. *)
Definition harmonic (c : R * R) (k : Z) (psi : R) : R := fst c * cos (IZR k * psi) - snd c * sin (IZR k * psi).

(* While the crank is at theta. *)
Definition of_piston (c : R * R) (k : Z) (theta : R) (p : cylinder) : R := harmonic c k (theta + radians (throw p - bank p)).

Definition signed (s : sense) (x : R) : R := match s with Direct => x | Reverse => - x end.

(* Order k of the force (or the moment, by its arms) over omega^2, of all pistons and of the masses that turn with this order.  Its part
   along the reference direction with [axis] = cos, across it with sin. *)
Definition part_along (axis : R -> R) (c : R * R) (E : engine) (arm : Q -> Q) (k : Z) (theta : R) : R :=
  sum_of (fun p => Q2R (mass p * radius p * arm (position p)) * of_piston c k theta p * axis (radians (bank p))) (cylinders E)
  + sum_of (fun t => Q2R (inject_Z (order t * order t) * mass_radius t * arm (place t)) * axis (radians (angle t) + signed (turns t) (IZR k * theta)))
    (filter (fun t => Z.eqb (order t) k) (turning_masses E)).

Definition both_parts (c : R * R) (E : engine) (arm : Q -> Q) (k : Z) (theta : R) : R * R :=
  (part_along cos c E arm k theta, part_along sin c E arm k theta).

Definition force (c : R * R) (E : engine) : Z -> R -> R * R := both_parts c E (fun _ => 1%Q).
Definition moment (c : R * R) (E : engine) : Z -> R -> R * R := both_parts c E (fun z => (z - plane E)%Q).

(* Order k of the inertia torque over omega^2, where the number c is that of the torque of one piston. *)
Definition torque (c : R * R) (E : engine) (k : Z) (theta : R) : R :=
  sum_of (fun p => Q2R (mass p * radius p * radius p) * of_piston c k theta p) (cylinders E).

(* The whole of an engine in parts, each with its own number c.  A cylinder may take part in two, and has the sum of their numbers. *)
Definition together (parts : list (R -> R * R)) (theta : R) : R * R :=
  (sum_of (fun f => fst (f theta)) parts, sum_of (fun f => snd (f theta)) parts).
Definition torques_together (parts : list (R -> R)) (theta : R) : R := sum_of (fun f => f theta) parts.
