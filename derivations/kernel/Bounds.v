(* Numbers: what is proved by interval arithmetic. *)
From Coquelicot Require Import Coquelicot.
From Rederive Require Export Rederive Intervals.
Require Export Ranalysis5.
Export IntegerIntervals.
Ltac bounds := interval with (i_prec 60).

(* A root between two numbers at which a continuous function has different signs. *)
Lemma intermediate_value f a b :
  a < b -> (forall x, a <= x <= b -> continuity_pt f x) -> f a < 0 < f b \/ f b < 0 < f a ->
  exists x, a <= x <= b /\ f x = 0.
Proof.
  intros L C [S | S].
  - destruct (IVT_interv f a b C L (proj1 S) (proj2 S)) as [x P]; now exists x.
  - destruct (IVT_interv (opp_fct f) a b) as [x [P Q]]; unfold opp_fct in *; try lra.
    + intros; apply continuity_pt_opp; auto.
    + exists x; split; [ exact P | lra ].
Qed.
Lemma root_between f a b :
  a < b -> (forall x, a <= x <= b -> continuity_pt f x) -> f a < 0 < f b \/ f b < 0 < f a ->
  exists x, a < x < b /\ f x = 0.
Proof.
  intros L C S; destruct (intermediate_value f a b L C S) as [x [[A B] Z]]; exists x; repeat split; try exact Z.
  - destruct A as [A | ->]; [ exact A | lra ].
  - destruct B as [B | ->]; [ exact B | lra ].
Qed.
Lemma continuous_by_derivative (f : R -> R) (x : R) : ex_derive f x -> continuity_pt f x.
Proof. intro D; apply derivable_continuous_pt, ex_derive_Reals_0; exact D. Qed.
Ltac differs := first [ lra | apply Rminus_not_eq; first [ apply Rgt_not_eq; bounds | apply Rlt_not_eq; bounds ] ].
Ltac continuous :=
  intros;
  first
    [ reg; lra
    | unfold tan, cot, sec, csc, tanh, coth, sech, csch, sinh, cosh; apply continuous_by_derivative; auto_derive;
      repeat split; first [ lra | bounds | differs ] ].
Tactic Notation "zero_between" ident(x) constr(a) constr(b) constr(f) :=
  destruct (intermediate_value f a b) as [x [? ?]];
  [ lra | continuous | first [ left; split; bounds | right; split; bounds ] | cbv beta in * ].
(* Inverse functions by atan and ln: `interval` and `auto_derive` know no others. *)
Lemma asin_by_atan u : -1 < u < 1 -> asin u = atan (u / sqrt (1 - u ^ 2)).
Proof. intro U; rewrite asin_atan by exact U; unfold Rsqr; do 3 f_equal; ring. Qed.
Lemma acos_by_atan u : -1 < u < 1 -> acos u = PI / 2 - atan (u / sqrt (1 - u ^ 2)).
Proof. intro U; rewrite acos_asin by lra; now rewrite asin_by_atan. Qed.
Ltac inverses :=
  repeat match goal with
         | |- context [ asin ?u ] => rewrite (asin_by_atan u) by (split; bounds)
         | |- context [ acos ?u ] => rewrite (acos_by_atan u) by (split; bounds)
         end;
  unfold arcsinh.
(* A conjunction at a point: numbers, and functions of numbers. *)
Ltac at_the_point :=
  repeat apply conj;
  first [ reflexivity | lra | bounds | differs | solve [ field; repeat apply conj; differs ] ].
