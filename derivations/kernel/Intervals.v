(* Interval arithmetic with Coq's own integers: it assumes nothing of the machine's numbers. There is no proof of
   ours in this file: it is the library's functor for these numbers. *)
From Interval Require Import Float.Specific_stdz Float.Specific_ops.
From Interval Require Export Tactic.

Module Integers := SpecificFloat StdZRadix2.
Module IntegerIntervals := IntervalTactic Integers.
