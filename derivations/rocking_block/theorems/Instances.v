(* Where hypotheses of theorems might contradict each other: points at which all of them hold, and the theorem with
   them. What a free motion has at its start can be chosen, so that most of them are whole families. *)
From Rederive Require Import Rederive Bounds Solutions Limits Responses Critical.
From Coquelicot Require Import Coquelicot.

(* The equilibrium itself is a motion with that limit. *)
Theorem instance_60a p alpha side : 0 < p -> side ^ 2 = 1 -> 0 < alpha < PI / 2 ->
  exists theta thetadot thetaddot : R -> R,
  (forall t, is_derive theta t (thetadot t) /\ is_derive thetadot t (thetaddot t)) /\
  (forall t, thetaddot t + p ^ 2 * (0 * cos (alpha + side * theta t) - side * sin (alpha + side * theta t)) = 0) /\
  tends_to theta (- side * alpha) /\ tends_to thetadot 0.
Proof.
  intros P S A; exists (fun _ => - side * alpha), (fun _ => 0), (fun _ => 0).
  split; [ | split; [ | split ] ]; try apply is_lim_const.
  - intro t; split; auto_derive; trivial.
  - intro t; replace (alpha + side * (- side * alpha)) with 0 by ring [S]; rewrite sin_0; ring.
Qed.

(* A free motion about the equilibrium l that has y and p v at t_o. *)
Section Free.
Variables p t_o l y v : R.
Hypothesis p_pos : 0 < p.
Definition moves_freely (theta thetadot : R -> R) A B :=
  (forall t, is_derive theta t (thetadot t)) /\
  (forall t, theta t = A * sinh (p * (t - t_o)) + B * cosh (p * (t - t_o)) + l) /\
  (forall t, thetadot t / p = A * cosh (p * (t - t_o)) + B * sinh (p * (t - t_o))) /\
  A = thetadot t_o / p /\ B = theta t_o - l /\ theta t_o = y /\ thetadot t_o / p = v.
Lemma free_motion : exists theta thetadot A B, moves_freely theta thetadot A B.
Proof.
  exists (fun t => v * sinh (p * (t - t_o)) + (y - l) * cosh (p * (t - t_o)) + l),
    (fun t => p * (v * cosh (p * (t - t_o)) + (y - l) * sinh (p * (t - t_o)))), v, (y - l).
  assert (Z : p * (t_o - t_o) = 0) by ring; split.
  - intro t; unfold sinh, cosh; auto_derive; [ trivial | unfold Rminus; field ].
  - repeat split; intros; rewrite ?Z, ?sinh_0, ?cosh_0; field; lra.
Qed.
End Free.
Ltac motion p t_o l y v theta thetadot :=
  let M := fresh in destruct (free_motion p t_o l y v) as [theta [thetadot [?A [?B M]]]]; [ assumption | ];
  exists theta, thetadot, A, B; split; [ exact M | destruct M as [?D [?E [?F [?G [?H [?Y ?V]]]]]] ].

Section Left.
Variables alpha p omega_p psi : R.
Hypotheses (alpha_pos : 0 < alpha) (p_pos : 0 < p) (omega_pos : 0 < omega_p) (starts : sin psi <> 0).
Let w := omega_p / p.
Let T_ex := (2 * PI - psi) / omega_p.
(* (67) and (68), whatever the pulse leaves. *)
Theorem instance_68 y v : exists theta thetadot Abar_1 Abar_2,
  moves_freely p T_ex (- alpha) y v theta thetadot Abar_1 Abar_2 /\
  (tends_to theta (- alpha) <-> row{68, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}).
Proof. motion p T_ex (- alpha) y v theta thetadot; apply (derivation_68 alpha p T_ex) with A B; auto; lra. Qed.
Theorem instance_71 : exists theta thetadot Abar_1 Abar_2,
  let A_1 := - alpha * w / (1 + w ^ 2) * cot psi in let A_2 := alpha * w ^ 2 / (1 + w ^ 2) in
  moves_freely p T_ex (- alpha) (A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha)
    (A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi)
    theta thetadot Abar_1 Abar_2 /\
  (tends_to theta (- alpha) <-> row{71, omega_p/p := w}).
Proof.
  set (A_1 := - alpha * w / (1 + w ^ 2) * cot psi); set (A_2 := alpha * w ^ 2 / (1 + w ^ 2)).
  motion p T_ex (- alpha) (A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha)
    (A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi) theta thetadot.
  apply (derivation_71 alpha p omega_p psi T_ex) with thetadot A B A_1 A_2; auto; lra.
Qed.
Theorem instance_104 theta_0 thetadot_0 : exists theta thetadot Abar_1 Abar_2,
  let A_1 := thetadot_0 / p - alpha * w / (1 + w ^ 2) * cot psi in
  let A_2 := theta_0 + alpha - alpha / (1 + w ^ 2) in
  moves_freely p T_ex (- alpha) (A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha)
    (A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi)
    theta thetadot Abar_1 Abar_2 /\
  (tends_to theta (- alpha) <->
   row{104, omega_p/p := w}).
Proof.
  set (A_1 := thetadot_0 / p - alpha * w / (1 + w ^ 2) * cot psi); set (A_2 := theta_0 + alpha - alpha / (1 + w ^ 2)).
  motion p T_ex (- alpha) (A_1 * sinh (p * T_ex) + A_2 * cosh (p * T_ex) - alpha)
    (A_1 * cosh (p * T_ex) + A_2 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi) theta thetadot.
  apply (derivation_104 alpha p omega_p psi T_ex) with thetadot A B A_1 A_2; auto; lra.
Qed.
End Left.

Section Right.
Variables alpha p omega_p psi T_ex : R.
Hypotheses (alpha_pos : 0 < alpha) (p_pos : 0 < p) (omega_pos : 0 < omega_p).
Let w := omega_p / p.
(* (74) and (75) *)
Theorem instance_75 y v : exists theta thetadot Abar_3 Abar_4,
  moves_freely p T_ex alpha y v theta thetadot Abar_3 Abar_4 /\
  (tends_to theta alpha <-> row{75, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}).
Proof. motion p T_ex alpha y v theta thetadot; apply (derivation_75 alpha p T_ex) with A B; auto; lra. Qed.
Theorem instance_78 : sin psi <> 0 -> row{u20} -> exists theta thetadot Abar_3 Abar_4,
  let A_3 := - alpha * w / (1 + w ^ 2) * cot psi in let A_4 := - alpha * (2 + w ^ 2) / (1 + w ^ 2) in
  moves_freely p T_ex alpha (A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha)
    (A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi)
    theta thetadot Abar_3 Abar_4 /\
  (tends_to theta alpha <-> row{78, omega_p/p := w}).
Proof.
  intros S T; set (A_3 := - alpha * w / (1 + w ^ 2) * cot psi); set (A_4 := - alpha * (2 + w ^ 2) / (1 + w ^ 2)).
  motion p T_ex alpha (A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha)
    (A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / sin psi) theta thetadot.
  apply (derivation_78 alpha p omega_p psi T_ex) with thetadot A B A_3 A_4; auto; lra.
Qed.
(* (102) and (103) *)
Theorem instance_103 theta_0 thetadot_0 : cos psi <> 0 -> exists theta thetadot Abar_3 Abar_4,
  let A_3 := thetadot_0 / p + alpha * w / (1 + w ^ 2) * tan psi in
  let A_4 := theta_0 - alpha * (2 + w ^ 2) / (1 + w ^ 2) in
  moves_freely p T_ex alpha (A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha)
    (A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / cos psi)
    theta thetadot Abar_3 Abar_4 /\
  (tends_to theta alpha <-> row{102, omega_p/p := w}) /\
  (tends_to theta alpha <->
   row{103, omega_p/p := w}).
Proof.
  intro C; set (A_3 := thetadot_0 / p + alpha * w / (1 + w ^ 2) * tan psi).
  set (A_4 := theta_0 - alpha * (2 + w ^ 2) / (1 + w ^ 2)).
  motion p T_ex alpha (A_3 * sinh (p * T_ex) + A_4 * cosh (p * T_ex) + alpha)
    (A_3 * cosh (p * T_ex) + A_4 * sinh (p * T_ex) + alpha * w / (1 + w ^ 2) * 1 / cos psi) theta thetadot; split.
  - apply (derivation_102 alpha p omega_p psi T_ex) with thetadot A B; auto; lra.
  - apply (derivation_103 alpha p omega_p psi T_ex) with thetadot A B A_3 A_4; auto; lra.
Qed.
(* (83), (87a) and (88) *)
Theorem instance_88 t_i e : sin psi <> 0 -> cos psi <> 0 -> exists theta thetadot Abar_3 Abar_4,
  let thetadot_before := p * (alpha * w / (1 + w ^ 2) *
    ((cos (omega_p * t_i) - cosh (p * t_i)) / tan psi + w * sinh (p * t_i) - sin (omega_p * t_i))) in
  let A_3 := e * thetadot_before / p - alpha * w / (1 + w ^ 2) * cos (omega_p * t_i + psi) / sin psi in
  let A_4 := - alpha - alpha / (1 + w ^ 2) * sin (omega_p * t_i + psi) / sin psi in
  moves_freely p T_ex alpha (A_3 * sinh (p * (T_ex - t_i)) + A_4 * cosh (p * (T_ex - t_i)) + alpha)
    (A_3 * cosh (p * (T_ex - t_i)) + A_4 * sinh (p * (T_ex - t_i)) + alpha * w / (1 + w ^ 2) * 1 / sin psi)
    theta thetadot Abar_3 Abar_4 /\
  (tends_to theta alpha <->
   row{88, omega_p/p := w}).
Proof.
  intros S C; set (thetadot_before := p * (alpha * w / (1 + w ^ 2) *
    ((cos (omega_p * t_i) - cosh (p * t_i)) / tan psi + w * sinh (p * t_i) - sin (omega_p * t_i)))).
  set (A_3 := e * thetadot_before / p - alpha * w / (1 + w ^ 2) * cos (omega_p * t_i + psi) / sin psi).
  set (A_4 := - alpha - alpha / (1 + w ^ 2) * sin (omega_p * t_i + psi) / sin psi).
  motion p T_ex alpha (A_3 * sinh (p * (T_ex - t_i)) + A_4 * cosh (p * (T_ex - t_i)) + alpha)
    (A_3 * cosh (p * (T_ex - t_i)) + A_4 * sinh (p * (T_ex - t_i)) + alpha * w / (1 + w ^ 2) * 1 / sin psi)
    theta thetadot.
  apply (derivation_88 alpha p omega_p psi T_ex) with thetadot A B A_3 A_4 thetadot_before; auto.
  apply Rinv_r_simpl_m; lra.
Qed.
(* (94) and (95) *)
Theorem instance_95a t_i thetadot_before e : exists theta thetadot c_1 c_2,
  moves_freely p t_i alpha 0 (e * thetadot_before / p) theta thetadot c_1 c_2 /\
  (tends_to theta alpha <-> row{95a, thetadot_after := thetadot t_i}) /\ (tends_to thetadot 0 <-> row{95a, thetadot_after := thetadot t_i}) /\
  (tends_to theta alpha <-> row{95b}).
Proof.
  motion p t_i alpha 0 (e * thetadot_before / p) theta thetadot.
  assert (Z : B = - alpha) by lra; assert (K := derivation_95a alpha p p_pos theta thetadot t_i A B E F Z G).
  split; [ apply K | split; [ apply K | ] ].
  apply (derivation_95b alpha p p_pos theta thetadot t_i A B); auto.
  apply (Rmult_eq_reg_r (/ p)); [ exact V | nz ].
Qed.
End Right.

(* (92a), (92b), (96) and r9 to r11: psi = pi/4, omega_p = p = 1, and the time of the return to theta = 0,
   where X sinh + Y cosh is 1. *)
Lemma is_one X Y : 0 < X + Y -> 0 < X - Y -> exists x, X * sinh x + Y * cosh x = 1 /\ 0 < X * cosh x + Y * sinh x.
Proof.
  intros P Q; assert (S : 0 < 1 + (X ^ 2 - Y ^ 2)) by nra; assert (R := sqrt_lt_R0 _ S).
  assert (S' := square_of_root _ (Rlt_le _ _ S)); set (r := sqrt (1 + (X ^ 2 - Y ^ 2))) in *.
  assert (Z : 0 < (1 + r) / (X + Y)) by (apply Rdiv_lt_0_compat; lra); exists (ln ((1 + r) / (X + Y))).
  unfold sinh, cosh; rewrite exp_Ropp, exp_ln by exact Z.
  assert (H : (1 + r) * (r - 1) = (X + Y) * (X - Y)) by lra.
  assert (I : / ((1 + r) / (X + Y)) = (r - 1) / (X - Y)).
  { apply (Rmult_eq_reg_r ((1 + r) * (X - Y))); [ | apply Rmult_integral_contrapositive_currified; lra ].
    transitivity ((X + Y) * (X - Y)); [ field; lra | rewrite <- H; field; lra ]. }
  rewrite I; split.
  - field; lra.
  - replace (_ + _) with r by (field; lra); exact R.
Qed.
Section Back.
Let alpha := 1.
Let p := 1.
Let omega_p := 1.
Let psi := PI / 4.
Let w := omega_p / p.
Let T_ex := (2 * PI - psi) / omega_p.
Theorem instance_92a e : 0 < e -> exists t_i theta thetadot Abar_1 Abar_2,
  moves_freely p T_ex (- alpha)
    (- alpha * w / (1 + w ^ 2) * cot psi * sinh (p * T_ex) + alpha * w ^ 2 / (1 + w ^ 2) * cosh (p * T_ex) - alpha)
    (- alpha * w / (1 + w ^ 2) * cot psi * cosh (p * T_ex) + alpha * w ^ 2 / (1 + w ^ 2) * sinh (p * T_ex) +
      alpha * w / (1 + w ^ 2) * 1 / sin psi) theta thetadot Abar_1 Abar_2 /\
  row{u22, theta_i := theta t_i} /\ 0 < thetadot t_i /\
  (row{95b, thetadot_before := thetadot t_i} <-> row{r9, omega_p/p := w}).
Proof.
  intro I; assert (S : 0 < sin psi) by (apply sin_gt_0; unfold psi; bounds).
  assert (C : 0 < cos psi) by (apply cos_gt_0; unfold psi; bounds).
  assert (cot_1 : cot psi = 1) by (replace (cot psi) with (/ tan psi) by (unfold cot, tan; field; lra);
    unfold psi; rewrite tan_PI4; lra).
  assert (W : w = 1) by (unfold w, omega_p, p; field).
  set (X := 1 / 2 * (sinh T_ex - cosh T_ex + 1 / sin psi)); set (Y := 1 / 2 * (cosh T_ex - sinh T_ex)).
  destruct (is_one X Y) as [x [A B]].
  - unfold X, Y; assert (0 < 1 / sin psi) by (apply Rdiv_lt_0_compat; lra); lra.
  - unfold X, Y, sinh, cosh, T_ex, psi, omega_p; interval with (i_prec 60).
  - destruct (free_motion p T_ex (- alpha)
      (- alpha * w / (1 + w ^ 2) * cot psi * sinh (p * T_ex) + alpha * w ^ 2 / (1 + w ^ 2) * cosh (p * T_ex) - alpha)
      (- alpha * w / (1 + w ^ 2) * cot psi * cosh (p * T_ex) + alpha * w ^ 2 / (1 + w ^ 2) * sinh (p * T_ex) +
        alpha * w / (1 + w ^ 2) * 1 / sin psi)) as [theta [thetadot [a [b M]]]]; [ unfold p; lra | ].
    exists (T_ex + x), theta, thetadot, a, b; split; [ exact M | destruct M as [D [E [F [G [H [U V]]]]]] ].
    assert (Z : p * (T_ex + x - T_ex) = x) by (unfold p; ring).
    assert (Ga : a = X) by (rewrite G, V, W, cot_1; unfold X, alpha, p; rewrite !Rmult_1_l; field; lra).
    assert (Hb : b = Y) by (rewrite H, U, W, cot_1; unfold Y, alpha, p; rewrite !Rmult_1_l; field).
    assert (at_0 : theta (T_ex + x) = 0) by (rewrite E, Z, Ga, Hb, A; unfold alpha; ring).
    assert (rising : 0 < thetadot (T_ex + x)).
    { replace (thetadot (T_ex + x)) with (thetadot (T_ex + x) / p) by (unfold p; field); rewrite F, Z, Ga, Hb; exact
      B. }
    split; [ exact at_0 | split; [ exact rising | ] ].
    assert (one : 0 < 1) by lra.
    assert (E' : forall t, theta t = a * sinh (p * (t - T_ex)) + b * cosh (p * (t - T_ex)) - alpha) by exact E.
    apply (derivation_r9 alpha p omega_p psi T_ex one one one (T_ex + x)); try assumption; try lra.
    + apply (derivation_92a alpha p omega_p psi one one one theta thetadot D T_ex T_ex (T_ex + x) a b E' U V); auto;
      lra.
    + apply (derivation_92b alpha p omega_p psi one one theta thetadot D T_ex T_ex (T_ex + x) a b E' U V); auto; lra.
Qed.
End Back.

(* The impact, (46) and r16; the start, (28a) and (51a). *)
Theorem instance_r16 m R' alpha d thetadot_minus : 0 < m -> 0 < R' -> thetadot_minus <> 0 ->
  4 / 3 * R' ^ 2 - R' * d * sin alpha <> 0 -> exists thetadot_plus P,
  P = m * (R' * thetadot_plus * sin (alpha - 0)) - m * (- R' * thetadot_minus * sin (alpha + 0)) /\
  4 / 3 * m * R' ^ 2 * thetadot_plus - m * R' ^ 2 * (4 / 3 - 2 * sin alpha ^ 2) * thetadot_minus = P * d.
Proof.
  intros M R T N; exists (thetadot_minus * (4 / 3 * R' ^ 2 - 2 * R' ^ 2 * sin alpha ^ 2 + R' * d * sin alpha) /
    (4 / 3 * R' ^ 2 - R' * d * sin alpha)); eexists; split; [ reflexivity | ].
  rewrite Rplus_0_r, Rminus_0_r; field; lra.
Qed.
Theorem instance_28a m g R' alpha p a_p lambda : 0 < m -> 0 < g -> 0 < R' -> 0 < alpha < PI / 2 ->
  row{28b} -> exists thetaddot_0 H_0 V_0,
  H_0 = m * (lambda * a_p + R' * cos alpha * thetaddot_0) /\ V_0 = m * (g - R' * sin alpha * thetaddot_0) /\
  (forall J_c, row{u2} -> H_0 * (R' * cos alpha) - V_0 * (R' * sin alpha) + J_c * thetaddot_0 = 0) /\
  row{28a} /\
  (row{u11} -> 0 < V_0).
Proof.
  intros M G R A P; assert (C : 0 < cos alpha) by (apply cos_gt_0; lra); assert (S : 0 < sin alpha) by (apply
    sin_gt_0;
    lra).
  exists (p ^ 2 * sin alpha * (1 - lambda * a_p / (g * tan alpha))); do 2 eexists.
  split; [ reflexivity | split; [ reflexivity | split; [ | split; [ reflexivity | ] ] ] ].
  - intros J_c ->; assert (Q := pyth alpha); rewrite P; unfold tan; field [Q]; lra.
  - intros ->; replace (g * tan alpha / (g * tan alpha)) with 1 by (field; unfold tan; split; [ nz | lra ]).
    replace (m * _) with (m * g) by ring; pos.
Qed.
