(* On which axioms do the theorems over the real numbers rest?  On those that formal/README.md names: formal/run reads what this prints. *)
From Crankstar.real Require Import RealForce Bridge Motion.

Definition theorems := (no_force, no_moment, no_torque, some_force, some_moment, some_torque, force_every_even, moment_every_even, force_repeats).
Print Assumptions theorems.
