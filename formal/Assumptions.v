(* On which axioms do the theorems rest?  On none: formal/run reads what this prints. *)
From Crankstar Require Import Sums Splitting Engine Checker Shaking.

Print Assumptions vanishes.
Print Assumptions is_left.
Print Assumptions equal_lengths.
Print Assumptions unequal_lengths.
Print Assumptions every_even_order.
Print Assumptions no_shaking.
