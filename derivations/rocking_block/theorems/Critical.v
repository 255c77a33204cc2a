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
Lemma equilibrium : theta_star = - side * alpha.
Proof.
  destruct stands_still as [E _]; assert (Q := PI_RGT_0); assert (C : side = 1 \/ side = - 1) by nra.
  assert (Z : sin (alpha + side * theta_star) = 0) by (assert (0 < p ^ 2) by nra; destruct C; subst side; nra).
  destruct (Rtotal_order (alpha + side * theta_star) 0) as [L | [L | L]].
  - assert (sin (- (alpha + side * theta_star)) > 0) by (apply sin_gt_0; destruct C; subst side; lra);
    rewrite sin_neg in *; lra.
  - destruct C; subst side; lra.
  - assert (sin (alpha + side * theta_star) > 0) by (apply sin_gt_0; destruct C; subst side; lra); lra.
Qed.
Theorem derivation_60a_60c_u19b : (side = 1 -> row{60c}) /\ (side = -1 -> row{60a} /\ row{u19b}).
Proof. assert (E := equilibrium); split; intro L; rewrite L in E; repeat split; lra. Qed.
Theorem derivation_60b_u19a : tends_to thetadot right{60b}.
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
(* The rows have exp(-p x) for what is exp(-(p x)) here. *)
Ltac opposite := rewrite ?Ropp_mult_distr_l_reverse.
Ltac by_factor k :=
  let W := fresh in let X := fresh in assert (W := w_pos); rewrite ?exp_Ropp; assert (X := exp_pos (p * T_ex));
  apply (eq_by k); [ nz | ].

(* theta < 0 *)
Section Left.
Variables Abar_1 Abar_2 : R.
Hypothesis equation_62a : forall t, row{62a at t, t_o := T_ex}.
Hypothesis equation_63a : forall t, row{63a at t, t_o := T_ex}.
Theorem derivation_65a : tends_to theta (- alpha) <->
  tends_to (fun t => right{65a}) (- alpha).
Proof. apply tends_to_ext, equation_62a. Qed.
Theorem derivation_65b : tends_to thetadot 0 <->
  tends_to (fun t => right{65b}) 0.
Proof. rewrite (tends_to_scaled p) by lra; apply tends_to_ext, equation_63a. Qed.
(* Each of the two says it. *)
Theorem derivation_67 :
  (tends_to (fun t => right{65a}) (- alpha) <->
   row{67}) /\
  (tends_to (fun t => right{65b}) 0 <-> row{67}).
Proof. split; [ now apply dies_away | now apply rate_dies_away ]. Qed.
Hypotheses (equation_66a : row{66a, thetadot_ex := thetadot T_ex}) (equation_66b : row{66b, theta_ex := theta T_ex}).
Theorem derivation_68 : tends_to theta (- alpha) <-> row{68, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}.
Proof.
  rewrite derivation_65a, (proj1 derivation_67), equation_66a, equation_66b.
  apply (eq_by (/ p)); [ nz | field; lra ].
Qed.
Lemma criterion_left A_1 A_2 : sin psi <> 0 ->
  row{69a, theta_ex := theta T_ex} ->
  row{69b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  (tends_to theta (- alpha) <-> (A_1 + A_2) * exp (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi = 0).
Proof.
  intros S E F; rewrite derivation_68; rewrite <- (by_growing_part p (- alpha) _ _ _ _ _ _ (Rgt_not_eq _ _ p_pos) E
    F).
  apply (eq_by 1); [ lra | ring ].
Qed.
Theorem derivation_71 A_1 A_2 : sin psi <> 0 -> row{u20} ->
  row{69a, theta_ex := theta T_ex} ->
  row{69b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  row{70a, omega_p/p := w} -> row{70b, omega_p/p := w} ->
  (tends_to theta (- alpha) <-> row{71, omega_p/p := w}).
Proof.
  intros S T E F -> ->; rewrite (criterion_left _ _ S E F); unfold cot.
  replace (- (2 * PI - psi) / w) with (- (p * T_ex)) by (rewrite T; unfold w; field; lra).
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
Theorem derivation_104 A_1 A_2 theta_0 thetadot_0 : sin psi <> 0 ->
  row{69a, theta_ex := theta T_ex} ->
  row{69b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  row{58a, omega_p/p := w} -> row{58b, omega_p/p := w} ->
  (tends_to theta (- alpha) <->
   row{104, omega_p/p := w}).
Proof.
  intros S E F -> ->; rewrite (criterion_left _ _ S E F); unfold cot; opposite.
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
End Left.

(* theta > 0 *)
Section Right.
Variables Abar_3 Abar_4 : R.
Hypothesis equation_62b : forall t, row{62b at t, t_o := T_ex}.
Hypothesis equation_63b : forall t, row{63b at t, t_o := T_ex}.
Theorem derivation_72a : tends_to theta alpha <->
  tends_to (fun t => right{72a}) alpha.
Proof. apply tends_to_ext, equation_62b. Qed.
Theorem derivation_72b : tends_to thetadot 0 <->
  tends_to (fun t => right{72b}) 0.
Proof. rewrite (tends_to_scaled p) by lra; apply tends_to_ext, equation_63b. Qed.
(* Each of the two says it. *)
Theorem derivation_74 :
  (tends_to (fun t => right{72a}) alpha <->
   row{74}) /\
  (tends_to (fun t => right{72b}) 0 <-> row{74}).
Proof. split; [ now apply dies_away | now apply rate_dies_away ]. Qed.
Hypotheses (equation_73a : row{73a, thetadot_ex := thetadot T_ex}) (equation_73b : row{73b, theta_ex := theta T_ex}).
Theorem derivation_75 : tends_to theta alpha <-> row{75, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}.
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
Theorem derivation_78 A_3 A_4 : sin psi <> 0 -> row{u20} ->
  row{76a, theta_ex := theta T_ex} ->
  row{76b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  row{77a, omega_p/p := w} -> row{77b, omega_p/p := w} ->
  (tends_to theta alpha <-> row{78, omega_p/p := w}).
Proof.
  intros S T E F -> ->; rewrite (criterion_right _ _ _ _ E F); unfold cot.
  replace (- (2 * PI - psi) / w) with (- (p * T_ex)) by (rewrite T; unfold w; field; lra).
  by_factor (- (alpha * w / (1 + w ^ 2) / sin psi * exp (p * T_ex))); field; repeat split; nz.
Qed.
(* The cosine pulse. *)
Theorem derivation_102 A_3 A_4 : cos psi <> 0 ->
  row{101a, theta_ex := theta T_ex} ->
  row{101b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  (tends_to theta alpha <-> row{102, omega_p/p := w}).
Proof.
  intros C E F; rewrite (criterion_right _ _ _ _ E F); opposite.
  by_factor (exp (p * T_ex)); field; repeat split; nz.
Qed.
Theorem derivation_103 A_3 A_4 theta_0 thetadot_0 : cos psi <> 0 ->
  row{101a, theta_ex := theta T_ex} ->
  row{101b, thetadot_ex := thetadot T_ex, omega_p/p := w} ->
  row{100a, omega_p/p := w} -> row{100b, omega_p/p := w} ->
  (tends_to theta alpha <->
   row{103, omega_p/p := w}).
Proof.
  intros C E F -> ->; rewrite (derivation_102 _ _ C E F); unfold tan; opposite.
  by_factor (- (alpha * w / (1 + w ^ 2) / cos psi)); field; repeat split; nz.
Qed.
(* From rest the block starts to turn to theta > 0 where the phase of the pulse is pi - psi, (r14); it ends after
   (pi/2 + psi)/omega_p. The motion until then is x. *)
Theorem derivation_r15 (x x_dot : R -> R) : cos psi <> 0 -> T_ex = (PI / 2 + psi) / omega_p ->
  (forall t, is_derive x t (x_dot t)) ->
  (forall t, is_derive x_dot t
    (p ^ 2 * x t - p ^ 2 * alpha - p ^ 2 * alpha * cos (omega_p * t + (PI - psi)) / cos psi)) ->
  x 0 = 0 -> x_dot 0 = 0 -> theta T_ex = x T_ex -> thetadot T_ex = x_dot T_ex ->
  (tends_to theta alpha <-> row{r15, omega_p/p := w}).
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
    replace (- (PI / 2 + psi) / w) with (- (p * T_ex)) by (rewrite T; unfold w; field; lra).
    unfold k; rewrite K.
    by_factor (- (alpha * w / (1 + w ^ 2) / cos psi * exp (p * T_ex))); field; repeat split; nz.
Qed.

(* An impact at t_i, before the pulse ends. *)
Variables t_i A_3 A_4 : R.
Hypothesis starts : sin psi <> 0.
Hypothesis equation_80a : row{80a, theta_ex := theta T_ex}.
Hypothesis equation_80b : row{80b, thetadot_ex := thetadot T_ex, omega_p/p := w}.
Theorem derivation_83 : tends_to theta alpha <->
  row{83, omega_p/p := w}.
Proof.
  rewrite (criterion_right _ _ _ _ equation_80a equation_80b).
  assert (W := w_pos); apply (eq_by 1); [ lra | field; repeat split; nz ].
Qed.
Variables e thetadot_before : R.
Hypothesis equation_81 : row{81, omega_p/p := w}.
Hypothesis equation_82 : row{82, omega_p/p := w}.
Theorem derivation_87a : tends_to theta alpha <->
  row{87a, omega_p/p := w}.
Proof.
  rewrite derivation_83, equation_81, equation_82; opposite; rewrite exp_Ropp.
  assert (W := w_pos); assert (X := exp_pos (p * (T_ex - t_i))).
  apply (eq_by (alpha / (1 + w ^ 2) / sin psi * exp (p * (T_ex - t_i)))); [ nz | field; repeat split; nz ].
Qed.
(* As it should read: with t_i for t. *)
Theorem derivation_88 : row{87b, omega_p/p := w} ->
  cos psi <> 0 ->
  (tends_to theta alpha <->
   row{88, omega_p/p := w}).
Proof.
  intros B C; rewrite derivation_87a; assert (W := w_pos).
  replace (p * (t_i - T_ex)) with (- p * (T_ex - t_i)) by ring.
  replace (e * thetadot_before / (alpha * p)) with (e / alpha * (thetadot_before / p)) by (field; lra).
  rewrite B; unfold tan; apply (eq_by (- w)); [ nz | field; repeat split; nz ].
Qed.
End Right.

(* An impact at t_i, after the pulse. *)
Section Late.
Variables t_i c_1 c_2 : R.
Hypothesis equation_93a : forall t, row{93a at t}.
Hypothesis equation_93b : forall t, row{93b at t}.
Hypotheses (equation_u24 : row{u24}) (equation_u25a : row{u25a, thetadot_after := thetadot t_i}).
(* As they should read: thetadot t_i is the rate after the impact. *)
Theorem derivation_94a : tends_to theta alpha <->
  tends_to (fun t => left{94a, t_star := t, thetadot_after := thetadot t_i} + alpha) alpha.
Proof. apply tends_to_ext; intro; rewrite equation_93a, equation_u24, equation_u25a; field; lra. Qed.
Theorem derivation_94b : tends_to thetadot 0 <->
  tends_to (fun t => left{94b, t_star := t, thetadot_after := thetadot t_i}) 0.
Proof.
  rewrite (tends_to_scaled p) by lra; apply tends_to_ext; intro; rewrite equation_93b, equation_u24, equation_u25a;
    field; lra.
Qed.
(* Each of the two says it. *)
Theorem derivation_95a :
  (tends_to theta alpha <-> row{95a, thetadot_after := thetadot t_i}) /\
  (tends_to thetadot 0 <-> row{95a, thetadot_after := thetadot t_i}).
Proof.
  assert (E : thetadot t_i / p = - - alpha <-> thetadot t_i - p * alpha = 0) by (apply (eq_by (/ p)); [ nz | field;
    lra ]).
  rewrite derivation_94a, derivation_94b, <- E; split.
  - rewrite (tends_to_ext _ (fun t => thetadot t_i / p * sinh (p * (t - t_i)) + - alpha * cosh (p * (t - t_i)) +
    alpha))
      by (intro; field; lra); now apply dies_away.
  - rewrite (tends_to_ext _ (fun t => thetadot t_i / p * cosh (p * (t - t_i)) + - alpha * sinh (p * (t - t_i))))
      by (intro; field; lra); now apply rate_dies_away.
Qed.
Variables e thetadot_before : R.
Hypothesis equation_u23 : row{u23, thetadot_after := thetadot t_i}.
Theorem derivation_95b : tends_to theta alpha <-> row{95b}.
Proof. rewrite <- equation_u23; apply derivation_95a. Qed.
Theorem derivation_96 : sin psi <> 0 -> cos psi <> 0 -> row{92b, omega_p/p := w} ->
  (tends_to theta alpha <-> row{96, omega_p/p := w}).
Proof.
  intros S C E; rewrite derivation_95b, E; assert (W := w_pos).
  replace omega_p with (w * p) by (unfold w; field; lra); unfold tan.
  apply (eq_by (alpha * p)); [ nz | field; repeat split; nz ].
Qed.
(* With (92a), theta = 0 at t_i, and (92b), what the rate before the impact has to do with the end of the pulse. *)
Let X := w / (1 + w ^ 2) * (w * sinh (p * T_ex) - cosh (p * T_ex) / tan psi + 1 / sin psi).
Let Y := w / (1 + w ^ 2) * (w * cosh (p * T_ex) - sinh (p * T_ex) / tan psi).
Hypotheses (sine : sin psi <> 0) (cosine : cos psi <> 0) (e_pos : 0 < e).
Hypothesis equation_92a : row{92a, omega_p/p := w}.
Hypothesis equation_92b : row{92b, omega_p/p := w}.
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
Theorem derivation_r9 : row{95b} <-> row{r9, omega_p/p := w}.
Proof.
  rewrite <- squares_differ; assert (K : 0 < e * thetadot_before + p * alpha) by (assert (0 < p * alpha) by pos; nra).
  apply (eq_by (e ^ 2 * (p * alpha) ^ 2 / (e * thetadot_before + p * alpha))); [ nz | field; repeat split; nz ].
Qed.
(* It overturns where the rate after the impact is larger than p alpha. *)
Theorem derivation_r10 : e * thetadot_before > p * alpha <-> row{r10, omega_p/p := w}.
Proof.
  rewrite <- squares_differ; assert (K : 0 < e * thetadot_before + p * alpha) by (assert (0 < p * alpha) by pos; nra).
  apply (lt_by (e ^ 2 * (p * alpha) ^ 2 / (e * thetadot_before + p * alpha))); [ pos | field; repeat split; nz ].
Qed.
Theorem derivation_r11 : row{95b} ->
  row{r11, omega_p/p := w}.
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
