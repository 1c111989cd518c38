(* On which axioms do the theorems over the real numbers rest?  On those that formal/README.md names: formal/run reads what this prints. *)
From Crankstar.real Require Import RealForce Bridge Motion Place.

Definition theorems := (no_force, no_moment, no_torque, some_force, some_moment, some_torque, every_torque, every_force, every_moment, force_repeats, same_place).
Print Assumptions theorems.
