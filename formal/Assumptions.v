(* On which axioms do the theorems rest?  On none: formal/run reads what this prints. *)
From Crankstar Require Import Sums Splitting Engine Checker EveryOrder Shaking Circle.

Definition theorems := (vanishes, is_left, equal_lengths, unequal_lengths, every_even_order, every_torque_order, even_recurrence, odd_recurrence, no_shaking, a_circle).
Print Assumptions theorems.
