(* Functions by their derivatives (Coquelicot's): constants, growing functions, and the solutions of
   y'' = p^2 y + f, which are one and the hyperbolic functions. *)
From Rederive Require Import Rederive.
From Coquelicot Require Import Coquelicot.

(* The derivative of what is built from functions whose derivatives are hypotheses. *)
Ltac derivatives :=
  auto_derive;
  [ repeat split; try (eexists; eassumption)
  | repeat match goal with H : is_derive ?f ?t ?d |- _ =>
      change (Derive (fun x => f x) t) with (Derive f t); rewrite ?(is_derive_unique f t d H); clear H end;
        unfold Rminus ].

Lemma hyperbolic x : cosh x ^ 2 = 1 + sinh x ^ 2.
Proof. enough (cosh x ^ 2 - sinh x ^ 2 = 1) by lra; transitivity (exp x * exp (- x)).
  - unfold cosh, sinh; field.
  - rewrite <- exp_plus, Rplus_opp_r; apply exp_0.
Qed.
Lemma sum_is_exp x : cosh x + sinh x = exp x.
Proof. unfold cosh, sinh; field. Qed.
(* A function whose derivative is 0 is a constant. *)
Lemma constant f : (forall t : R, is_derive f t 0) -> forall s t : R, f s = f t.
Proof.
  intros D s t; destruct (Rtotal_order s t) as [L | [-> | L]]; [ | reflexivity | symmetry ];
    apply (eq_is_derive f); auto.
Qed.
(* A function whose derivative is not negative grows. *)
Lemma increases (f d : R -> R) a b : a <= b ->
  (forall x, a <= x <= b -> is_derive f x (d x)) -> (forall x, a <= x <= b -> 0 <= d x) -> f a <= f b.
Proof.
  intros L D S; destruct (MVT_gen f a b d) as [c [I E]].
  - intros x X; rewrite Rmin_left, Rmax_right in X by exact L; apply D; lra.
  - intros x X; rewrite Rmin_left, Rmax_right in X by exact L.
    apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D; exact X.
  - rewrite Rmin_left, Rmax_right in I by exact L; specialize (S c I); nra.
Qed.
(* The same, strictly. *)
Lemma grows (f d : R -> R) a b : a < b ->
  (forall x, a <= x <= b -> is_derive f x (d x)) -> (forall x, a < x < b -> 0 < d x) -> f a < f b.
Proof.
  intros L D S; destruct (MVT_cor2 f d a b L) as [c [E I]]; [ intros; apply is_derive_Reals; auto | ].
  specialize (S c I); nra.
Qed.
(* A growing exponential is larger than everything else. *)
Lemma exponential_beats p k c m :
  0 < p -> 0 < k -> exists T, forall s, T < s -> m < k * exp (p * s) + c * exp (- (p * s)).
Proof.
  intros P0 K; exists (Rmax 0 ((Rabs c + Rabs m) / (k * p))); intros s L.
  assert (P : 0 < s) by (eapply Rle_lt_trans; [ apply Rmax_l | exact L ]).
  assert (B : (Rabs c + Rabs m) / (k * p) < s) by (eapply Rle_lt_trans; [ apply Rmax_r | exact L ]).
  assert (D : Rabs c + Rabs m < k * (p * s)).
  { apply (Rmult_lt_compat_r (k * p)) in B; [ | nra ]; unfold Rdiv in B.
    rewrite Rmult_assoc, Rinv_l in B; nra. }
  assert (G := exp_ineq1 (p * s)); assert (U : exp (- (p * s)) <= 1).
  { rewrite <- exp_0; apply Rlt_le, exp_increasing; nra. }
  assert (V := exp_pos (- (p * s))); assert (X := Rle_abs m).
  assert (Y : - Rabs c <= c) by (unfold Rabs; destruct (Rcase_abs c); lra).
  assert (Z := Rabs_pos c); assert (p * s <> 0) by nra; nra.
Qed.

(* y'' = p^2 y + f: two solutions that agree at t_0 with their rates agree always. *)
Section Unique.
Variables p t_0 : R.
Hypothesis p_pos : 0 < p.
Lemma only_zero (y v : R -> R) :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive v t (p ^ 2 * y t)) -> y t_0 = 0 -> v t_0 = 0 ->
  forall t, y t = 0 /\ v t = 0.
Proof.
  intros Y V Y0 V0 t.
  assert (E : forall q, q ^ 2 = p ^ 2 -> v t + q * y t = 0).
  { intros q Q; assert (C : (v t + q * y t) * exp (- (q * t)) = (v t_0 + q * y t_0) * exp (- (q * t_0))).
    { apply (constant (fun t => (v t + q * y t) * exp (- (q * t)))); intro s.
      assert (Ys := Y s); assert (Vs := V s); derivatives; ring [Q]. }
    rewrite Y0, V0 in C; assert (P := exp_pos (- (q * t))); nra. }
  assert (A := E p eq_refl); assert (B := E (- p) ltac:(ring)); split; nra.
Qed.

(* All solutions, from one. *)
Lemma all_solutions (y v y_1 v_1 f : R -> R) :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive v t (p ^ 2 * y t + f t)) ->
  (forall t, is_derive y_1 t (v_1 t)) -> (forall t, is_derive v_1 t (p ^ 2 * y_1 t + f t)) ->
  forall t, y t = (v t_0 - v_1 t_0) / p * sinh (p * (t - t_0)) + (y t_0 - y_1 t_0) * cosh (p * (t - t_0)) + y_1 t /\
            v t / p = (v t_0 - v_1 t_0) / p * cosh (p * (t - t_0)) + (y t_0 - y_1 t_0) * sinh (p * (t - t_0)) +
              v_1 t / p.
Proof.
  intros Y V Y1 V1 t; set (A := (v t_0 - v_1 t_0) / p); set (B := y t_0 - y_1 t_0).
  destruct (only_zero (fun t => y t - y_1 t - (A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0))))
              (fun t => v t - v_1 t - p * (A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0))))) with (t := t) as [P
                Q].
  - intro s; unfold sinh, cosh; assert (D := Y s); assert (D1 := Y1 s).
    derivatives; field.
  - intro s; unfold sinh, cosh; assert (D := V s); assert (D1 := V1 s).
    derivatives; field.
  - replace (t_0 - t_0) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; unfold B; ring.
  - replace (t_0 - t_0) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; unfold A; field; lra.
  - split; [ lra | apply (Rmult_eq_reg_l p); [ | lra ]; unfold Rdiv; rewrite Rmult_plus_distr_l ].
    replace (p * (v t * / p)) with (v t) by (field; lra); replace (p * (v_1 t * / p)) with (v_1 t) by (field; lra);
      lra.
Qed.
(* From the form of the response follows that of its rate. *)
Lemma rate_of (y v y_1 v_1 : R -> R) A B :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive y_1 t (v_1 t)) ->
  (forall t, y t = A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t) ->
  forall t, v t / p = A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0)) + v_1 t / p.
Proof.
  intros Y Y1 E t; assert (D : is_derive y t (p * (A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0))) + v_1 t)).
  { apply (is_derive_ext (fun t => A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t)); [ intro;
    now rewrite E | ].
    unfold sinh, cosh; assert (D1 := Y1 t); derivatives; field. }
  rewrite <- (is_derive_unique y t _ (Y t)), (is_derive_unique y t _ D); field; lra.
Qed.
End Unique.
