(* What is left out where angles are small, and claims of the paper that are mathematics. *)
From Rederive Require Import Rederive Solutions.
From Coquelicot Require Import Coquelicot.

(* Taylor's remainders of sin and cos. *)
Lemma cos_remainder x : 0 <= 1 - cos x <= x ^ 2 / 2.
Proof.
  assert (H : forall y, 0 <= y -> y ^ 2 / 2 + cos y >= 1).
  { intros y Y; apply Rle_ge; replace 1 with (0 ^ 2 / 2 + cos 0) by (rewrite cos_0; field).
    apply (increases (fun y => y ^ 2 / 2 + cos y) (fun y => y - sin y)); [ exact Y | |].
    - intros z _; auto_derive; [ trivial | field ].
    - intros z Z; destruct (Req_dec z 0) as [-> | N]; [ rewrite sin_0; lra | assert (S := sin_lt_x z); lra ]. }
  assert (B := COS_bound x); split; [ lra | ].
  destruct (Rle_dec 0 x) as [P | P]; [ assert (Q := H x P); lra | ].
  assert (Q := H (- x)); rewrite cos_neg in Q; nra.
Qed.
Lemma sin_remainder_pos x : 0 <= x -> 0 <= x - sin x <= x ^ 3 / 6.
Proof.
  intro X; split.
  - destruct (Req_dec x 0) as [-> | N]; [ rewrite sin_0; lra | assert (S := sin_lt_x x); lra ].
  - enough (x - 0 ^ 3 / 6 - x + sin 0 <= x ^ 3 / 6 - x + sin x) by (rewrite sin_0 in *; lra).
    replace (x - 0 ^ 3 / 6 - x + sin 0) with (0 ^ 3 / 6 - 0 + sin 0) by (rewrite sin_0; field).
    apply (increases (fun x => x ^ 3 / 6 - x + sin x) (fun x => x ^ 2 / 2 - 1 + cos x)); [ exact X | |].
    + intros z _; auto_derive; [ trivial | field ].
    + intros z _; assert (C := cos_remainder z); lra.
Qed.
Lemma sin_remainder x : Rabs (x - sin x) <= Rabs x ^ 3 / 6.
Proof.
  destruct (Rle_dec 0 x) as [P | P].
  - assert (S := sin_remainder_pos x P); rewrite (Rabs_pos_eq x), Rabs_pos_eq; lra.
  - assert (S := sin_remainder_pos (- x)); rewrite sin_neg in S.
    rewrite (Rabs_left x), (Rabs_left1 (x - sin x)); lra.
Qed.

(* The linear equations (56), (97): what they leave out of (21) is of second order in the tilt alpha + side theta.
   side = 1 where theta < 0, -1 where theta > 0; u is u_gddot/g. *)
Lemma left_out p side u x : side ^ 2 = 1 ->
  Rabs (p ^ 2 * (u * cos x - side * sin x) - p ^ 2 * (u - side * x)) <= p ^ 2 * (Rabs u * (x ^ 2 / 2) +
    Rabs x ^ 3 / 6).
Proof.
  intro S; assert (C := cos_remainder x); assert (D := sin_remainder x); assert (P := pow2_ge_0 p).
  replace (_ - _) with (p ^ 2 * (- (u * (1 - cos x)) + side * (x - sin x))) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (p ^ 2) P); apply Rmult_le_compat_l; [ exact P | ].
  eapply Rle_trans; [ apply Rabs_triang | apply Rplus_le_compat ].
  - rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (1 - cos x)) by lra; assert (Q := Rabs_pos u); nra.
  - assert (E : Rabs side = 1) by (assert (N := Rabs_pos side); rewrite <- (pow2_abs side) in S; nra).
    rewrite Rabs_mult, E; lra.
Qed.
Section Small.
Variables g alpha p omega_p psi a_p t theta thetaddot : R.
Let u := a_p / g * sin (omega_p * t + psi).
Theorem derivation_56a :
  Rabs ((thetaddot + p ^ 2 * (u * cos (alpha + theta) - sin (alpha + theta))) -
        (left{56a} - (right{56a}))) <=
  p ^ 2 * (Rabs u * ((alpha + theta) ^ 2 / 2) + Rabs (alpha + theta) ^ 3 / 6).
Proof.
  eapply Rle_trans; [ | apply (left_out p 1 u (alpha + theta)); ring ].
  apply Req_le; f_equal; unfold u, Rdiv; ring.
Qed.
Theorem derivation_56b :
  Rabs ((thetaddot + p ^ 2 * (u * cos (alpha - theta) + sin (alpha - theta))) -
        (left{56b} - (right{56b}))) <=
  p ^ 2 * (Rabs u * ((alpha - theta) ^ 2 / 2) + Rabs (alpha - theta) ^ 3 / 6).
Proof.
  eapply Rle_trans; [ | apply (left_out p (- 1) u (alpha - theta)); ring ].
  apply Req_le; f_equal; unfold u, Rdiv; ring.
Qed.
(* With u29, a_p/(alpha g) = 1/cos(psi). *)
Theorem derivation_97 : let c := alpha * cos (omega_p * t + psi) / cos psi in
  Rabs ((thetaddot + p ^ 2 * (c * cos (alpha - theta) + sin (alpha - theta))) -
        (left{97} - (right{97}))) <=
  p ^ 2 * (Rabs c * ((alpha - theta) ^ 2 / 2) + Rabs (alpha - theta) ^ 3 / 6).
Proof.
  intro c; eapply Rle_trans; [ | apply (left_out p (- 1) c (alpha - theta)); ring ].
  apply Req_le; f_equal; unfold c, Rdiv; ring.
Qed.

(* u21, u29: alpha stands for tan(alpha). *)
Lemma tangent : 0 < alpha <= 1 -> Rabs (tan alpha - alpha) <= alpha ^ 3.
Proof.
  intro A; assert (C := cos_remainder alpha); assert (S := sin_remainder_pos alpha).
  assert (P : 1 / 2 <= cos alpha) by nra; assert (T : tan alpha * cos alpha = sin alpha) by (unfold tan; field; lra).
  apply Rabs_le; split; nra.
Qed.
Lemma amplitude_left_out x : 0 < g -> 0 < alpha <= 1 -> x <> 0 -> a_p * x = g * tan alpha ->
  Rabs (a_p / (g * alpha) - 1 / x) <= alpha ^ 2 / Rabs x.
Proof.
  intros G A X E; assert (T := tangent A).
  replace (a_p / (g * alpha) - 1 / x) with ((tan alpha - alpha) / (alpha * x)).
  - unfold Rdiv; rewrite Rabs_mult, Rabs_inv, Rabs_mult, (Rabs_pos_eq alpha) by (try apply
    Rmult_integral_contrapositive_currified; lra).
    assert (N := Rabs_pos_lt x X); apply (Rmult_le_reg_r (alpha * Rabs x)); [ nra | field_simplify;
      [ | nra | nra ] ]; nra.
  - replace (tan alpha) with (a_p * x / g) by (rewrite E; field; lra); field; repeat split; lra.
Qed.
Theorem derivation_u21 : 0 < g -> 0 < alpha <= 1 -> sin psi <> 0 -> a_p * sin psi = g * tan alpha ->
  Rabs (left{u21} - right{u21}) <= alpha ^ 2 / Rabs (sin psi).
Proof. apply amplitude_left_out. Qed.
Theorem derivation_u29 : 0 < g -> 0 < alpha <= 1 -> cos psi <> 0 -> a_p * cos psi = g * tan alpha ->
  Rabs (left{u29} - right{u29}) <= alpha ^ 2 / Rabs (cos psi).
Proof. rewrite (Rmult_comm alpha g); apply amplitude_left_out. Qed.
End Small.

(* A block that nothing lifts does not turn, and so does not overturn: from rest, under an acceleration of at most
   alpha g either way, what obeys (56a) until T has no theta < 0 in that time, and what obeys (56b) no theta > 0. *)
Lemma not_lifted alpha p T (f y v : R -> R) : 0 < p -> (forall t, 0 <= t <= T -> f t <= alpha) ->
  (forall t, 0 <= t <= T -> is_derive y t (v t)) ->
  (forall t, 0 <= t <= T -> is_derive v t (p ^ 2 * y t + p ^ 2 * alpha - p ^ 2 * f t)) ->
  y 0 = 0 -> v 0 = 0 -> forall t, 0 <= t <= T -> 0 <= y t.
Proof.
  intros P B D E Z R t I.
  assert (W : forall s, 0 <= s <= T -> 0 <= (v s + p * y s) * exp (- (p * s))).
  { intros s S; replace 0 with ((v 0 + p * y 0) * exp (- (p * 0))) by (rewrite Z, R; ring).
    apply (increases (fun s => (v s + p * y s) * exp (- (p * s))) (fun s => p ^ 2 * (alpha - f s) * exp (- (p * s))));
      [ lra | |]; intros z L; assert (L' : 0 <= z <= T) by lra.
    - assert (Dz := D z L'); assert (Ez := E z L'); derivatives; ring.
    - specialize (B z L'); assert (X := exp_pos (- (p * z))); assert (Q := pow2_ge_0 p).
      apply Rmult_le_pos; [ apply Rmult_le_pos | ]; lra. }
  assert (V : 0 <= y t * exp (p * t)).
  { replace 0 with (y 0 * exp (p * 0)) by (rewrite Z; ring).
    apply (increases (fun s => y s * exp (p * s)) (fun s => (v s + p * y s) * exp (p * s))); [ lra | |]; intros z L;
      assert (L' : 0 <= z <= T) by lra.
    - assert (Dz := D z L'); derivatives; ring.
    - assert (X := W z L'); assert (Y := exp_pos (- (p * z))); assert (Y' := exp_pos (p * z)).
      apply Rmult_le_pos; [ | lra ]; apply Rnot_lt_le; intro N; nra. }
  assert (X := exp_pos (p * t)); apply Rnot_lt_le; intro N; nra.
Qed.
Theorem claim_c69_nothing_lifts g alpha p T (u theta thetadot : R -> R) :
  0 < g -> 0 < p -> (forall t, Rabs (u t) <= alpha * g) ->
  (forall t, 0 <= t <= T -> is_derive theta t (thetadot t)) -> theta 0 = 0 -> thetadot 0 = 0 ->
  ((forall t, 0 <= t <= T -> is_derive thetadot t (p ^ 2 * theta t + p ^ 2 * alpha - p ^ 2 * (u t / g))) ->
   forall t, 0 <= t <= T -> 0 <= theta t) /\
  ((forall t, 0 <= t <= T -> is_derive thetadot t (p ^ 2 * theta t - p ^ 2 * alpha - p ^ 2 * (u t / g))) ->
   forall t, 0 <= t <= T -> theta t <= 0).
Proof.
  intros G P U D Z R.
  assert (B : forall t, - alpha <= u t / g <= alpha).
  { intro s; specialize (U s); apply Rabs_le_between in U.
    split; apply (Rmult_le_reg_r g); try exact G; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  split; intros E t I.
  - apply (not_lifted alpha p T (fun t => u t / g) theta thetadot); auto; intros; apply B.
  - enough (0 <= - theta t) by lra.
    apply (not_lifted alpha p T (fun t => - (u t / g)) (fun t => - theta t) (fun t => - thetadot t)); auto; try lra.
    + intros s _; specialize (B s); lra.
    + intros s S; assert (Ds := D s S); derivatives; ring.
    + intros s S; assert (Es := E s S); derivatives; ring.
Qed.
(* Fig. 12: 0.71157 alpha g, as it is labelled, lifts no block, whatever omega_p/p is. *)
Theorem claim_c61_does_not_lift g alpha p omega_p psi T (theta thetadot : R -> R) :
  0 < g -> 0 < alpha -> 0 < p -> let u t := 71157/10^5 * (alpha * g) * sin (omega_p * t + psi) in
  (forall t, 0 <= t <= T -> is_derive theta t (thetadot t)) -> theta 0 = 0 -> thetadot 0 = 0 ->
  ((forall t, 0 <= t <= T -> is_derive thetadot t (p ^ 2 * theta t + p ^ 2 * alpha - p ^ 2 * (u t / g))) ->
   forall t, 0 <= t <= T -> 0 <= theta t) /\
  ((forall t, 0 <= t <= T -> is_derive thetadot t (p ^ 2 * theta t - p ^ 2 * alpha - p ^ 2 * (u t / g))) ->
   forall t, 0 <= t <= T -> theta t <= 0).
Proof.
  intros G A P u; apply (claim_c69_nothing_lifts g alpha p T u theta thetadot G P).
  intro t; assert (S := SIN_bound (omega_p * t + psi)); assert (K : 0 < alpha * g) by pos; unfold u.
  apply Rabs_le_between; split; nra.
Qed.

(* (103) from rest is (78) at psi + pi/2: no curve of its own. *)
Theorem claim_c51_103_is_78_shifted p omega_p psi T_ex : 0 < p -> 0 < omega_p ->
  row{u28} ->
  (row{103, theta_0 := 0, thetadot_0 := 0, alpha := 1} <-> row{78, psi := psi + PI / 2}).
Proof.
  intros P W ->; rewrite sin_plus, cos_plus, sin_PI2, cos_PI2.
  replace (- (2 * PI - (psi + PI / 2)) / (omega_p / p)) with (- p * ((3 * PI / 2 - psi) / omega_p)) by (field; lra).
  apply (eq_by 1); [ lra | field; lra ].
Qed.

(* (r16), e after an impact at a distance d from the corner: larger than (46) unless d = 0. *)
Theorem claim_c22_away_from_the_corner R' alpha d : 0 < R' -> 0 < alpha < PI / 2 -> 0 < d ->
  R' * d * sin alpha < 4 / 3 * R' ^ 2 ->
  right{46b} < right{r16}.
Proof.
  intros R A D N; assert (Z := PI_RGT_0); assert (S := sin_gt_0 alpha); assert (B := SIN_bound alpha).
  apply -> Rlt_div_r; [ | lra ]; assert (0 < R' * d * sin alpha) by (repeat apply Rmult_lt_0_compat; lra).
  assert (0 < sin alpha ^ 2 <= 1) by nra; assert (0 < R' ^ 2) by nra; nra.
Qed.
