(* The motion that just overturns. It tends to the equilibrium where the block would stand on its corner, theta = -
   alpha or alpha, and gets there at no time: what the paper says of a time t* is said here of the limit. The other
   motions do not tend to it, so that what follows is said both ways, down to the thresholds. *)
From Rederive Require Import Rederive Solutions Limits.
From Coquelicot Require Import Coquelicot.

(* The ground is at rest after t_o, (21). side = 1 where theta < 0, -1 where theta > 0. *)
Section Equilibrium.
Variables p alpha side t_o theta_star : R.
Variables theta thetadot thetaddot : R -> R.
Hypotheses (p_pos : 0 < p) (sides : side ^ 2 = 1) (acute : 0 < alpha < PI / 2).
Hypothesis range : - (PI / 2) < theta_star < PI / 2.
Hypothesis moves : forall t, t_o < t -> is_derive theta t (thetadot t) /\ is_derive thetadot t (thetaddot t).
Hypothesis equation_21 : forall t, t_o < t ->
  thetaddot t + p ^ 2 * (0 * cos (alpha + side * theta t) - side * sin (alpha + side * theta t)) = 0.
Hypothesis has_limit : tends_to theta theta_star.
Lemma stands_still : p ^ 2 * side * sin (alpha + side * theta_star) = 0 /\ tends_to thetadot 0.
Proof.
  apply (comes_to_rest t_o theta thetadot (fun t => p ^ 2 * side * sin (alpha + side * theta t)) theta_star).
  - intros t L; destruct (moves t L) as [A B]; split; [ exact A | ].
    replace (_ * _) with (thetaddot t) by (specialize (equation_21 t L); lra); exact B.
  - exact has_limit.
  - apply (is_lim_comp_continuous theta (fun x => p ^ 2 * side * sin (alpha + side * x)) p_infty theta_star).
    + exact has_limit.
    + apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; trivial.
Qed.
(* from 21a, 21b, criterion *)
Theorem derivation_60a_60c_u19b : theta_star = - side * alpha.
Proof.
  destruct stands_still as [E _]; assert (Q := PI_RGT_0); assert (C : side = 1 \/ side = - 1) by nra.
  assert (Z : sin (alpha + side * theta_star) = 0) by (assert (0 < p ^ 2) by nra; destruct C; subst side; nra).
  destruct (Rtotal_order (alpha + side * theta_star) 0) as [L | [L | L]].
  - assert (sin (- (alpha + side * theta_star)) > 0) by (apply sin_gt_0; destruct C; subst side; lra);
    rewrite sin_neg in *; lra.
  - destruct C; subst side; lra.
  - assert (sin (alpha + side * theta_star) > 0) by (apply sin_gt_0; destruct C; subst side; lra); lra.
Qed.
(* from 21a, 21b, criterion *)
Theorem derivation_60b_u19a : tends_to thetadot 0.
Proof. exact (proj2 stands_still). Qed.
End Equilibrium.

(* What is left of A sinh + B cosh in the criterion is the growing part. *)
Lemma growing_part A B x k : A * cosh x + B * sinh x + k + (A * sinh x + B * cosh x) = (A + B) * exp x + k.
Proof. unfold sinh, cosh; field. Qed.
Lemma by_growing_part p l A B x k y v : p <> 0 -> y = A * sinh x + B * cosh x + l ->
  v / p = A * cosh x + B * sinh x + k -> (v + p * (y - l) = 0 <-> (A + B) * exp x + k = 0).
Proof.
  intros P Y V; apply (eq_by p); [ exact P | rewrite <- growing_part, <- V, Y; field; exact P ].
Qed.
Lemma rate_dies_away p t_o A B : 0 < p ->
  (tends_to (fun t => A * cosh (p * (t - t_o)) + B * sinh (p * (t - t_o))) 0 <-> A = - B).
Proof.
  intro P; rewrite (tends_to_ext _ (fun t => B * sinh (p * (t - t_o)) + A * cosh (p * (t - t_o)) + 0)) by (intro;
    ring).
  rewrite dies_away by exact P; split; lra.
Qed.

(* The linear block. The pulse ends at T_ex; theta is the free motion after it, with the values at T_ex that the
   pulse leaves, and w stands for omega_p/p. *)
Section Linear.
Variables alpha p omega_p psi T_ex : R.
Hypotheses (alpha_pos : 0 < alpha) (p_pos : 0 < p) (omega_pos : 0 < omega_p).
Variables theta thetadot : R -> R.
Let w := omega_p / p.
Lemma w_pos : 0 < w. Proof. unfold w; pos. Qed.
Ltac by_factor k :=
  let W := fresh in let X := fresh in assert (W := w_pos); rewrite ?exp_Ropp; assert (X := exp_pos (p * T_ex));
  apply (eq_by k); [ nz | ].

(* theta < 0 *)
Section Left.
Variables Abar_1 Abar_2 : R.
Hypothesis equation_62a : forall t,
  theta t = Abar_1 * sinh (p * (t - T_ex)) + Abar_2 * cosh (p * (t - T_ex)) - alpha.
Hypothesis equation_63a : forall t,
  thetadot t / p = Abar_1 * cosh (p * (t - T_ex)) + Abar_2 * sinh (p * (t - T_ex)).
(* from 60c, 62a *)
Theorem derivation_65a : tends_to theta (- alpha) <->
  tends_to (fun t => Abar_1 * sinh (p * (t - T_ex)) + Abar_2 * cosh (p * (t - T_ex)) - alpha) (- alpha).
Proof. apply tends_to_ext, equation_62a. Qed.
(* from 60b, 63a *)
Theorem derivation_65b : tends_to thetadot 0 <->
  tends_to (fun t => Abar_1 * cosh (p * (t - T_ex)) + Abar_2 * sinh (p * (t - T_ex))) 0.
Proof. rewrite (tends_to_scaled p) by lra; apply tends_to_ext, equation_63a. Qed.
(* Each of the two says it. *)
(* from 65a, 65b *)
Theorem derivation_67 :
  (tends_to (fun t => Abar_1 * sinh (p * (t - T_ex)) + Abar_2 * cosh (p * (t - T_ex)) - alpha) (- alpha) <->
   Abar_1 = - Abar_2) /\
  (tends_to (fun t => Abar_1 * cosh (p * (t - T_ex)) + Abar_2 * sinh (p * (t - T_ex))) 0 <-> Abar_1 = - Abar_2).
Proof. split; [ now apply dies_away | now apply rate_dies_away ]. Qed.
Hypotheses (equation_66a : Abar_1 = thetadot T_ex / p) (equation_66b : Abar_2 = theta T_ex + alpha).
(* from 66a, 66b, 67 *)
Theorem derivation_68 : tends_to theta (- alpha) <-> thetadot T_ex + p * (theta T_ex + alpha) = 0.
Proof.
  rewrite derivation_65a, (proj1 derivation_67), equation_66a, equation_66b.
  apply (eq_by (/ p)); [ nz | field; lra ].
Qed.
Lemma criterion_left A_1 A_2 : sin psi <> 0 ->
  theta T_ex = A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha ->
  thetadot T_ex / p = A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / sin psi) ->
  (tends_to theta (- alpha) <-> (A_1 + A_2) * exp (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / sin psi) = 0).
Proof.
  intros S E F; rewrite derivation_68; rewrite <- (by_growing_part p (- alpha) _ _ _ _ _ _ (Rgt_not_eq _ _ p_pos) E
    F).
  apply (eq_by 1); [ lra | ring ].
Qed.
(* from 68, 69a, 69b, 70a, 70b, u20 *)
Theorem derivation_71 A_1 A_2 : sin psi <> 0 -> T_ex = (2 * PI - psi) / omega_p ->
  theta T_ex = A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha ->
  thetadot T_ex / p = A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / sin psi) ->
  A_1 = - alpha * w / (1 + w ^ 2) * cot psi -> A_2 = alpha * w ^ 2 / (1 + w ^ 2) ->
  (tends_to theta (- alpha) <-> cos psi - w * sin psi = exp (- ((2 * PI - psi) / w))).
Proof.
  intros S T E F -> ->; rewrite (criterion_left _ _ S E F); unfold cot.
  replace ((2 * PI - psi) / w) with (p * T_ex) by (rewrite T; unfold w; field; lra).
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
(* from 58a, 58b, 68, 69a, 69b *)
Theorem derivation_104 A_1 A_2 theta_0 thetadot_0 : sin psi <> 0 ->
  theta T_ex = A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha ->
  thetadot T_ex / p = A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / sin psi) ->
  A_1 = thetadot_0 / p - alpha * w / (1 + w ^ 2) * cot psi -> A_2 = theta_0 + alpha - alpha / (1 + w ^ 2) ->
  (tends_to theta (- alpha) <->
   cos psi - (w + 1 / alpha * (theta_0 + thetadot_0 / p) * (1 / w + w)) * sin psi = exp (- (p * T_ex))).
Proof.
  intros S E F -> ->; rewrite (criterion_left _ _ S E F); unfold cot.
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
End Left.

(* theta > 0 *)
Section Right.
Variables Abar_3 Abar_4 : R.
Hypothesis equation_62b : forall t,
  theta t = Abar_3 * sinh (p * (t - T_ex)) + Abar_4 * cosh (p * (t - T_ex)) + alpha.
Hypothesis equation_63b : forall t,
  thetadot t / p = Abar_3 * cosh (p * (t - T_ex)) + Abar_4 * sinh (p * (t - T_ex)).
(* from 60a, 62b *)
Theorem derivation_72a : tends_to theta alpha <->
  tends_to (fun t => Abar_3 * sinh (p * (t - T_ex)) + Abar_4 * cosh (p * (t - T_ex)) + alpha) alpha.
Proof. apply tends_to_ext, equation_62b. Qed.
(* from 60b, 63b *)
Theorem derivation_72b : tends_to thetadot 0 <->
  tends_to (fun t => Abar_3 * cosh (p * (t - T_ex)) + Abar_4 * sinh (p * (t - T_ex))) 0.
Proof. rewrite (tends_to_scaled p) by lra; apply tends_to_ext, equation_63b. Qed.
(* Each of the two says it. *)
(* from 72a, 72b *)
Theorem derivation_74 :
  (tends_to (fun t => Abar_3 * sinh (p * (t - T_ex)) + Abar_4 * cosh (p * (t - T_ex)) + alpha) alpha <->
   Abar_3 = - Abar_4) /\
  (tends_to (fun t => Abar_3 * cosh (p * (t - T_ex)) + Abar_4 * sinh (p * (t - T_ex))) 0 <-> Abar_3 = - Abar_4).
Proof. split; [ now apply dies_away | now apply rate_dies_away ]. Qed.
Hypotheses (equation_73a : Abar_3 = thetadot T_ex / p) (equation_73b : Abar_4 = theta T_ex - alpha).
(* from 73a, 73b, 74 *)
Theorem derivation_75 : tends_to theta alpha <-> thetadot T_ex + p * (theta T_ex - alpha) = 0.
Proof.
  rewrite derivation_72a, (proj1 derivation_74), equation_73a, equation_73b.
  apply (eq_by (/ p)); [ nz | field; lra ].
Qed.
Lemma criterion_right A_3 A_4 x k :
  theta T_ex = A_3 * sinh x + A_4 * cosh x + alpha -> thetadot T_ex / p = A_3 * cosh x + A_4 * sinh x + k ->
  (tends_to theta alpha <-> (A_3 + A_4) * exp x + k = 0).
Proof.
  intros E F; rewrite derivation_75; exact (by_growing_part p alpha _ _ _ _ _ _ (Rgt_not_eq _ _ p_pos) E F).
Qed.
(* from 75, 76a, 76b, 77a, 77b, u20 *)
Theorem derivation_78 A_3 A_4 : sin psi <> 0 -> T_ex = (2 * PI - psi) / omega_p ->
  theta T_ex = A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha ->
  thetadot T_ex / p = A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / sin psi) ->
  A_3 = - alpha * w / (1 + w ^ 2) * cot psi -> A_4 = - alpha * (2 + w ^ 2) / (1 + w ^ 2) ->
  (tends_to theta alpha <-> (w + 2 / w) * sin psi + cos psi = exp (- ((2 * PI - psi) / w))).
Proof.
  intros S T E F -> ->; rewrite (criterion_right _ _ _ _ E F); unfold cot.
  replace ((2 * PI - psi) / w) with (p * T_ex) by (rewrite T; unfold w; field; lra).
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
(* The cosine pulse. *)
(* from 75, 101a, 101b *)
Theorem derivation_102 A_3 A_4 : cos psi <> 0 ->
  theta T_ex = A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha ->
  thetadot T_ex / p = A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / cos psi) ->
  (tends_to theta alpha <-> A_3 + A_4 = - alpha * w / (1 + w ^ 2) * (1 / cos psi) * exp (- (p * T_ex))).
Proof.
  intros C E F; rewrite (criterion_right _ _ _ _ E F).
  by_factor (exp (p * T_ex)); field; repeat split; nz.
Qed.
(* from 100a, 100b, 102 *)
Theorem derivation_103 A_3 A_4 theta_0 thetadot_0 : cos psi <> 0 ->
  theta T_ex = A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha ->
  thetadot T_ex / p = A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * (1 / cos psi) ->
  A_3 = thetadot_0 / p + alpha * w / (1 + w ^ 2) * tan psi -> A_4 = theta_0 - alpha * (2 + w ^ 2) / (1 + w ^ 2) ->
  (tends_to theta alpha <->
   (2 / w + w - 1 / alpha * (theta_0 + thetadot_0 / p) * (1 / w + w)) * cos psi - sin psi = exp (- (p * T_ex))).
Proof.
  intros C E F -> ->; rewrite (derivation_102 _ _ C E F); unfold tan.
  by_factor (- (alpha * w / (1 + w ^ 2) / cos psi)); field; repeat split; nz.
Qed.
(* From rest the block starts to turn to theta > 0 where the phase of the pulse is pi - psi, (r14); it ends after
   (pi/2 + psi)/omega_p. The motion until then is x. *)
(* from 75, 97, r14, rest *)
Theorem derivation_r15 (x x_dot : R -> R) : cos psi <> 0 -> T_ex = (PI / 2 + psi) / omega_p ->
  (forall t, is_derive x t (x_dot t)) ->
  (forall t, is_derive x_dot t
    (p ^ 2 * x t - p ^ 2 * alpha - p ^ 2 * alpha * cos (omega_p * t + (PI - psi)) / cos psi)) ->
  x 0 = 0 -> x_dot 0 = 0 -> theta T_ex = x T_ex -> thetadot T_ex = x_dot T_ex ->
  (tends_to theta alpha <-> w * cos psi - sin psi = exp (- ((PI / 2 + psi) / w))).
Proof.
  intros C T D E Z V F G; assert (W := w_pos); assert (Q : 0 < omega_p ^ 2 + p ^ 2) by nra.
  set (k := alpha / (1 + w ^ 2) / cos psi).
  assert (K : omega_p = w * p) by (unfold w; field; lra).
  destruct (all_solutions p 0 p_pos x x_dot (fun t => k * cos (omega_p * t + (PI - psi)) + alpha)
    (fun t => - (omega_p * k * sin (omega_p * t + (PI - psi))))
    (fun t => - p ^ 2 * alpha - p ^ 2 * alpha * cos (omega_p * t + (PI - psi)) / cos psi)) with (t := T_ex) as [A B].
  - exact D.
  - intro t; specialize (E t); match type of E with is_derive _ _ ?d => match goal with |- is_derive _ _ ?c =>
      replace c with d by ring end end; exact E.
  - intro t; auto_derive; [ trivial | ring ].
  - intro t; auto_derive; [ trivial | unfold k; rewrite K; field; repeat split; nz ].
  - assert (end_of_it : omega_p * T_ex + (PI - psi) = 3 * (PI / 2)) by (rewrite T; field; lra).
    rewrite end_of_it, cos_3PI2, Z, V, !Rminus_0_r, Rmult_0_r, Rplus_0_l in A.
    rewrite end_of_it, sin_3PI2, Z, V, !Rminus_0_r, Rmult_0_r, Rplus_0_l in B.
    rewrite <- F in A; rewrite <- G in B.
    rewrite sin_minus, cos_minus, sin_PI, cos_PI in A, B.
    rewrite (criterion_right (omega_p * k * sin psi / p) (k * cos psi - alpha) (p * T_ex) (omega_p * k / p))
      by (rewrite ?A, ?B; field; lra).
    replace ((PI / 2 + psi) / w) with (p * T_ex) by (rewrite T; unfold w; field; lra).
    unfold k; rewrite K.
    by_factor (- (alpha * w / (1 + w ^ 2) / cos psi * exp (p * T_ex))); field; repeat split; nz.
Qed.

(* An impact at t_i, before the pulse ends. *)
Variables t_i A_3 A_4 : R.
Hypothesis starts : sin psi <> 0.
Hypothesis equation_80a : theta T_ex = A_3 * sinh (p * (T_ex - t_i)) + A_4 * cosh (p * (T_ex - t_i)) + alpha.
Hypothesis equation_80b : thetadot T_ex / p =
  A_3 * cosh (p * (T_ex - t_i)) + A_4 * sinh (p * (T_ex - t_i)) + alpha * w / (1 + w ^ 2) * (1 / sin psi).
(* from 75, 80a, 80b *)
Theorem derivation_83 : tends_to theta alpha <->
  (A_3 + A_4) * exp (p * (T_ex - t_i)) = - alpha * w / (1 + w ^ 2) * (1 / sin psi).
Proof.
  rewrite (criterion_right _ _ _ _ equation_80a equation_80b).
  assert (W := w_pos); apply (eq_by 1); [ lra | field; repeat split; nz ].
Qed.
Variables e thetadot_before : R.
Hypothesis equation_81 : A_4 = - alpha - alpha / (1 + w ^ 2) * sin (omega_p * t_i + psi) / sin psi.
Hypothesis equation_82 :
  A_3 = e * thetadot_before / p - alpha * w / (1 + w ^ 2) * cos (omega_p * t_i + psi) / sin psi.
(* from 81, 82, 83 *)
Theorem derivation_87a : tends_to theta alpha <->
  (1 + w ^ 2) * (e * thetadot_before / (alpha * p) - 1) * sin psi - w * cos (omega_p * t_i + psi) -
    sin (omega_p * t_i + psi) = - w * exp (- (p * (T_ex - t_i))).
Proof.
  rewrite derivation_83, equation_81, equation_82, exp_Ropp.
  assert (W := w_pos); assert (X := exp_pos (p * (T_ex - t_i))).
  apply (eq_by (alpha / (1 + w ^ 2) / sin psi * exp (p * (T_ex - t_i)))); [ nz | field; repeat split; nz ].
Qed.
(* As it should read: with t_i for t. *)
(* from 87a, 87b *)
Theorem derivation_88 : thetadot_before / p = alpha * w / (1 + w ^ 2) *
    ((cos (omega_p * t_i) - cosh (p * t_i)) / tan psi + w * sinh (p * t_i) - sin (omega_p * t_i)) ->
  cos psi <> 0 ->
  (tends_to theta alpha <->
   e * (cosh (p * t_i) - cos (omega_p * t_i)) * cos psi +
     (e * (sin (omega_p * t_i) - w * sinh (p * t_i)) + 1 / w + w) * sin psi +
     cos (omega_p * t_i + psi) + 1 / w * sin (omega_p * t_i + psi) = exp (- (p * (T_ex - t_i)))).
Proof.
  intros B C; rewrite derivation_87a; assert (W := w_pos).
  replace (e * thetadot_before / (alpha * p)) with (e / alpha * (thetadot_before / p)) by (field; lra).
  rewrite B; unfold tan; apply (eq_by (- w)); [ nz | field; repeat split; nz ].
Qed.
End Right.

(* An impact at t_i, after the pulse. *)
Section Late.
Variables t_i c_1 c_2 : R.
Hypothesis equation_93a : forall t, theta t = c_1 * sinh (p * (t - t_i)) + c_2 * cosh (p * (t - t_i)) + alpha.
Hypothesis equation_93b : forall t, thetadot t / p = c_1 * cosh (p * (t - t_i)) + c_2 * sinh (p * (t - t_i)).
Hypotheses (equation_u24 : c_2 = - alpha) (equation_u25a : c_1 = thetadot t_i / p).
(* As they should read: thetadot t_i is the rate after the impact. *)
(* from 60a, 93a, u24, u25a *)
Theorem derivation_94a : tends_to theta alpha <->
  tends_to (fun t => thetadot t_i / p * sinh (p * (t - t_i)) - alpha * cosh (p * (t - t_i)) + alpha) alpha.
Proof. apply tends_to_ext; intro; rewrite equation_93a, equation_u24, equation_u25a; ring. Qed.
(* from 60b, 93b, u24, u25a *)
Theorem derivation_94b : tends_to thetadot 0 <->
  tends_to (fun t => thetadot t_i / p * cosh (p * (t - t_i)) - alpha * sinh (p * (t - t_i))) 0.
Proof.
  rewrite (tends_to_scaled p) by lra; apply tends_to_ext; intro; rewrite equation_93b, equation_u24, equation_u25a;
    ring.
Qed.
(* Each of the two says it. *)
(* from 94a, 94b *)
Theorem derivation_95a :
  (tends_to theta alpha <-> thetadot t_i - p * alpha = 0) /\ (tends_to thetadot 0 <-> thetadot t_i - p * alpha = 0).
Proof.
  assert (E : thetadot t_i / p = - - alpha <-> thetadot t_i - p * alpha = 0) by (apply (eq_by (/ p)); [ nz | field;
    lra ]).
  rewrite derivation_94a, derivation_94b, <- E; split.
  - rewrite (tends_to_ext _ (fun t => thetadot t_i / p * sinh (p * (t - t_i)) + - alpha * cosh (p * (t - t_i)) +
    alpha))
      by (intro; ring); now apply dies_away.
  - rewrite (tends_to_ext _ (fun t => thetadot t_i / p * cosh (p * (t - t_i)) + - alpha * sinh (p * (t - t_i))))
      by (intro; ring); now apply rate_dies_away.
Qed.
Variables e thetadot_before : R.
Hypothesis equation_u23 : thetadot t_i = e * thetadot_before.
(* from 95a, u23 *)
Theorem derivation_95b : tends_to theta alpha <-> e * thetadot_before - p * alpha = 0.
Proof. rewrite <- equation_u23; apply derivation_95a. Qed.
(* from 92b, 95b *)
Theorem derivation_96 : sin psi <> 0 -> cos psi <> 0 -> thetadot_before = alpha * omega_p / (1 + w ^ 2) *
    ((w * sinh (p * T_ex) - cosh (p * T_ex) / tan psi + 1 / sin psi) * cosh (p * (t_i - T_ex)) +
     (w * cosh (p * T_ex) - sinh (p * T_ex) / tan psi) * sinh (p * (t_i - T_ex))) ->
  (tends_to theta alpha <-> e * w / (1 + w ^ 2) *
    ((w * sinh (p * T_ex) - cosh (p * T_ex) / tan psi + 1 / sin psi) * cosh (p * (t_i - T_ex)) +
     (w * cosh (p * T_ex) - sinh (p * T_ex) / tan psi) * sinh (p * (t_i - T_ex))) = 1).
Proof.
  intros S C E; rewrite derivation_95b, E; assert (W := w_pos).
  replace omega_p with (w * p) by (unfold w; field; lra); unfold tan.
  apply (eq_by (alpha * p)); [ nz | field; repeat split; nz ].
Qed.
(* With (92a), theta = 0 at t_i, and (92b), what the rate before the impact has to do with the end of the pulse. *)
Let X := w / (1 + w ^ 2) * (w * sinh (p * T_ex) - cosh (p * T_ex) / tan psi + 1 / sin psi).
Let Y := w / (1 + w ^ 2) * (w * cosh (p * T_ex) - sinh (p * T_ex) / tan psi).
Hypotheses (sine : sin psi <> 0) (cosine : cos psi <> 0) (e_pos : 0 < e).
Hypothesis equation_92a :
  w / (1 + w ^ 2) * ((cosh (p * T_ex) / tan psi - w * sinh (p * T_ex) - 1 / sin psi) * sinh (p * (t_i - T_ex)) +
                     (sinh (p * T_ex) / tan psi - w * cosh (p * T_ex)) * cosh (p * (t_i - T_ex))) = - 1.
Hypothesis equation_92b : thetadot_before = alpha * omega_p / (1 + w ^ 2) *
    ((w * sinh (p * T_ex) - cosh (p * T_ex) / tan psi + 1 / sin psi) * cosh (p * (t_i - T_ex)) +
     (w * cosh (p * T_ex) - sinh (p * T_ex) / tan psi) * sinh (p * (t_i - T_ex))).
Hypothesis comes_back : 0 < thetadot_before.
Lemma squares_differ : (thetadot_before / (p * alpha)) ^ 2 - 1 = w ^ 2 / (1 + w ^ 2) ^ 2 *
  (2 / sin psi ^ 2 - 1 - w ^ 2 + 2 / sin psi * (w * sinh (p * T_ex) - cot psi * cosh (p * T_ex))).
Proof.
  assert (W := w_pos); assert (A : X * sinh (p * (t_i - T_ex)) + Y * cosh (p * (t_i - T_ex)) = 1) by (unfold X, Y;
    lra).
  assert (B : thetadot_before / (p * alpha) = X * cosh (p * (t_i - T_ex)) + Y * sinh (p * (t_i - T_ex))).
  { rewrite equation_92b; unfold X, Y; replace omega_p with (w * p) by (unfold w; field; lra); unfold tan; field;
      repeat split; nz. }
  assert (D := hyperbolic (p * (t_i - T_ex))); assert (D' := hyperbolic (p * T_ex)); assert (P := pyth psi).
  transitivity (X ^ 2 - Y ^ 2).
  - rewrite B; transitivity ((X * cosh (p * (t_i - T_ex)) + Y * sinh (p * (t_i - T_ex))) ^ 2 -
      (X * sinh (p * (t_i - T_ex)) + Y * cosh (p * (t_i - T_ex))) ^ 2); [ rewrite A; ring | ring [D] ].
  - unfold X, Y, tan, cot; field [D' P]; repeat split; nz.
Qed.
(* from 92a, 92b, 95b *)
Theorem derivation_r9 : e * thetadot_before - p * alpha = 0 <-> w ^ 2 / (1 + w ^ 2) ^ 2 *
  (2 / sin psi ^ 2 - 1 - w ^ 2 + 2 / sin psi * (w * sinh (p * T_ex) - cot psi * cosh (p * T_ex))) = 1 / e ^ 2 - 1.
Proof.
  rewrite <- squares_differ; assert (K : 0 < e * thetadot_before + p * alpha) by (assert (0 < p * alpha) by pos; nra).
  apply (eq_by (e ^ 2 * (p * alpha) ^ 2 / (e * thetadot_before + p * alpha))); [ nz | field; repeat split; nz ].
Qed.
(* It overturns where the rate after the impact is larger than p alpha. *)
(* from 92a, 92b, 95b *)
Theorem derivation_r10 : e * thetadot_before > p * alpha <-> w ^ 2 / (1 + w ^ 2) ^ 2 *
  (2 / sin psi ^ 2 - 1 - w ^ 2 + 2 / sin psi * (w * sinh (p * T_ex) - cot psi * cosh (p * T_ex))) > 1 / e ^ 2 - 1.
Proof.
  rewrite <- squares_differ; assert (K : 0 < e * thetadot_before + p * alpha) by (assert (0 < p * alpha) by pos; nra).
  apply (lt_by (e ^ 2 * (p * alpha) ^ 2 / (e * thetadot_before + p * alpha))); [ pos | field; repeat split; nz ].
Qed.
(* from 92a, 92b, 95b *)
Theorem derivation_r11 : e * thetadot_before - p * alpha = 0 ->
  exp (p * (t_i - T_ex)) * w / (1 + w ^ 2) * ((w - cot psi) * exp (p * T_ex) + 1 / sin psi) = 1 + 1 / e.
Proof.
  intro E; assert (W := w_pos).
  assert (A : X * sinh (p * (t_i - T_ex)) + Y * cosh (p * (t_i - T_ex)) = 1) by (unfold X, Y; lra).
  assert (B : X * cosh (p * (t_i - T_ex)) + Y * sinh (p * (t_i - T_ex)) = 1 / e).
  { replace (1 / e) with (thetadot_before / (p * alpha)).
    - rewrite equation_92b; unfold X, Y; replace omega_p with (w * p) by (unfold w; field; lra); unfold tan; field;
        repeat split; nz.
    - replace (p * alpha) with (e * thetadot_before) by lra; field; split; lra. }
  transitivity (X * sinh (p * (t_i - T_ex)) + Y * cosh (p * (t_i - T_ex)) + 1 / e); [ rewrite <- B | now rewrite A ].
  rewrite <- !sum_is_exp; unfold X, Y, tan, cot; field; repeat split; nz.
Qed.
End Late.
(* A block that just comes back after the pulse: with (68) all but true, what it falls short of, |thetadot_ex/p +
   theta_ex + alpha|, bounds how far its rate at the impact is from p alpha. *)
(* from 68, 89a, 89b *)
Theorem derivation_r12 t_i thetadot_before : let short := thetadot T_ex / p + (theta T_ex + alpha) in
  0 = thetadot T_ex / p * sinh (p * (t_i - T_ex)) + (theta T_ex + alpha) * cosh (p * (t_i - T_ex)) - alpha ->
  thetadot_before / p =
    thetadot T_ex / p * cosh (p * (t_i - T_ex)) + (theta T_ex + alpha) * sinh (p * (t_i - T_ex)) ->
  0 < thetadot_before ->
  Rabs (thetadot_before - p * alpha) <= p / alpha * Rabs short * (Rabs short + 2 * Rabs (theta T_ex + alpha)).
Proof.
  intros short Z V S; set (v := thetadot T_ex / p) in *; set (q := theta T_ex + alpha) in *.
  assert (D := hyperbolic (p * (t_i - T_ex))); set (u := thetadot_before / p) in *.
  assert (E : u ^ 2 - alpha ^ 2 = short * (short - 2 * q)).
  { unfold short; rewrite V; replace alpha with (v * sinh (p * (t_i - T_ex)) + q * cosh (p * (t_i - T_ex))) by lra.
    ring [D]. }
  assert (U : 0 < u) by (unfold u; pos).
  assert (F : (u - alpha) * (u + alpha) = short * (short - 2 * q)) by (rewrite <- E; ring).
  assert (G : Rabs (u - alpha) * (u + alpha) = Rabs short * Rabs (short - 2 * q)).
  { rewrite <- Rabs_mult, <- F, Rabs_mult, (Rabs_pos_eq (u + alpha)); lra. }
  assert (T := Rabs_triang short (- (2 * q))); rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) in T by lra.
  replace (thetadot_before - p * alpha) with (p * (u - alpha)) by (unfold u; field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq p) by lra; apply (Rmult_le_reg_r (alpha / p)); [ pos | ].
  replace (p * Rabs (u - alpha) * (alpha / p)) with (Rabs (u - alpha) * alpha) by (field; lra).
  replace (_ * (alpha / p)) with (Rabs short * (Rabs short + 2 * Rabs q)) by (field; lra).
  assert (N := Rabs_pos (u - alpha)); assert (N' := Rabs_pos short); unfold Rminus in *; nra.
Qed.
End Linear.
