(* The motion after one impact, in the pulse or behind it, for omega_p/p = 3 and alpha = 1/4. *)
From Rederive Require Import Rederive Bounds Solutions Limits Thresholds.
From Coquelicot Require Import Coquelicot.
From Rederive Require Import ImpactInPulse.

(* Free motion to the right from b on: what decides is theta - alpha + thetadot/p. *)
Section Free.
Variables p alpha b : R.
Variables y v : R -> R.
Hypotheses (p_pos : 0 < p) (y_rate : forall t, is_derive y t (v t)) (v_continuous : forall t, continuous v t)
  (obeys : forall t, b < t -> is_derive v t (p ^ 2 * y t - p ^ 2 * alpha)) (alpha_pos : 0 < alpha).
Let growing := y b - alpha + v b / p.
Let dying := y b - alpha - v b / p.
Lemma free_right t : b <= t -> y t = v b / p * sinh (p * (t - b)) + (y b - alpha) * cosh (p * (t - b)) + alpha.
Proof.
  intro L; apply (agrees_until p b p_pos t y v
    (fun t => v b / p * sinh (p * (t - b)) + (y b - alpha) * cosh (p * (t - b)) + alpha)
    (fun t => p * (v b / p * cosh (p * (t - b)) + (y b - alpha) * sinh (p * (t - b)))) (fun _ => - p ^ 2 * alpha));
    try assumption; unfold sinh, cosh.
  - intros s S; specialize (obeys s ltac:(lra)); replace (_ + _) with (p ^ 2 * y s - p ^ 2 * alpha) by ring;
    exact obeys.
  - intro; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - intro; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - rewrite Rminus_eq_0, Rmult_0_r, Ropp_0, exp_0; field; lra.
  - rewrite Rminus_eq_0, Rmult_0_r, Ropp_0, exp_0; field; lra.
  - lra.
Qed.
Lemma by_exponentials t : b <= t ->
  y t = growing / 2 * exp (p * (t - b)) + dying / 2 * exp (- (p * (t - b))) + alpha.
Proof. intro L; rewrite (free_right t L); unfold growing, dying, sinh, cosh; field; lra. Qed.
Lemma stays_free : 0 <= y b -> 0 <= growing -> forall t, b < t -> 0 < y t.
Proof.
  intros right P t L; rewrite by_exponentials by lra; set (E' := exp (p * (t - b))); set (F' := exp (- (p * (t - b)))).
  assert (Q : 1 < E') by (unfold E'; rewrite <- exp_0; apply exp_increasing; nra);
    assert (R : 0 < F') by apply exp_pos.
  assert (U : E' * F' = 1) by (unfold E', F'; rewrite <- exp_plus, Rplus_opp_r; apply exp_0); assert (F' < 1) by nra.
  assert (S : growing + dying = 2 * (y b - alpha)) by (unfold growing, dying; ring); destruct (Rle_dec 0 dying); nra.
Qed.
Lemma free_fate :
  (0 < growing -> forall m, exists S, forall t, S < t -> m < y t) /\ (growing = 0 -> tends_to y alpha) /\
  (growing < 0 -> exists S, forall t, S < t -> y t < 0).
Proof.
  split; [ | split ].
  - intros P m; destruct (exponential_beats p (growing / 2) (dying / 2) (m - alpha)) as [S B]; [ lra | lra | ].
    exists (Rmax b (S + b)); intros t T; assert (X := Rmax_l b (S + b)); assert (Y := Rmax_r b (S + b)).
    rewrite by_exponentials by lra; specialize (B (t - b)); lra.
  - intro Z; rewrite (tends_to_from b y (fun t => v b / p * sinh (p * (t - b)) + (y b - alpha) * cosh (p * (t - b)) +
      alpha)) by (intros; apply free_right; lra).
    apply dies_away; unfold growing in Z; lra.
  - intro P; destruct (exponential_beats p (- (growing / 2)) (- (dying / 2)) alpha) as [S B]; [ lra | lra | ].
    exists (Rmax b (S + b)); intros t T; assert (X := Rmax_l b (S + b)); assert (Y := Rmax_r b (S + b)).
    rewrite by_exponentials by lra; specialize (B (t - b)); lra.
Qed.
End Free.

(* An impact at t_i, the first. What goes to the right from it with e of (46) obeys (56b) until T_ex and (61b) from
   then on. The amplitude is a_p = alpha g/sin psi, alpha is 1/4, omega_p is 3 p. *)
Definition first_impact (x : R -> R) t_i := 0 < t_i /\ x t_i = 0 /\ forall t, 0 < t < t_i -> x t < 0.
Definition goes_on p psi (u : R -> R) t_i (y v : R -> R) :=
  (forall t, is_derive y t (v t)) /\ (forall t, continuous v t) /\ y t_i = 0 /\ v t_i = e * u t_i /\
  (forall t, t_i < t < T_ex (3 * p) psi -> is_derive v t
    (p ^ 2 * y t - p ^ 2 * (1 / 4) - p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t + psi))) /\
  (forall t, t_i < t -> T_ex (3 * p) psi < t -> is_derive v t (p ^ 2 * y t - p ^ 2 * (1 / 4))).
Lemma going_says p psi u t_i y v : goes_on p psi u t_i y v ->
  (forall t, t_i < t < T_ex (3 * p) psi ->
    is_derive v t (p ^ 2 * y t + (right{56b, a_p/g := 1 / 4 / sin psi, alpha := 1 / 4, omega_p := 3 * p}))) /\
  (forall t, t_i < t -> T_ex (3 * p) psi < t -> is_derive v t (p ^ 2 * y t + right{61b, alpha := 1 / 4})).
Proof.
  intros [_ [_ [_ [_ [V W]]]]]; split; [ intros t I; specialize (V t I); same_derivative V | ].
  intros t I J; specialize (W t I J); same_derivative W.
Qed.
(* What is positive somewhere after t_i and negative in the end is 0 in between. *)
Lemma comes_back_to_0 (y v : R -> R) t_i : (forall t, is_derive y t (v t)) -> y t_i = 0 -> 0 < v t_i ->
  (exists S, forall t, S < t -> y t < 0) -> exists t, t_i < t /\ y t = 0.
Proof.
  intros Y Z P [S B]; destruct (proj1 (is_derive_Reals _ _ _) (Y t_i) (v t_i) P) as [d A].
  assert (L := Rmax_l (t_i + d) S); assert (L' := Rmax_r (t_i + d) S); assert (d_pos := cond_pos d).
  set (h := d / 2); assert (K : 0 < h < d) by (unfold h; lra); specialize (A h ltac:(lra)).
  rewrite Rabs_pos_eq, Z, Rminus_0_r in A by lra; specialize (A ltac:(lra)); apply Rabs_def2 in A.
  assert (Q : 0 < y (t_i + h)).
  { replace (y (t_i + h)) with (y (t_i + h) / h * h) by (field; lra); apply Rmult_lt_0_compat; lra. }
  destruct (intermediate_value y (t_i + h) (Rmax (t_i + d) S + 1)) as [t [I O]].
  - lra.
  - intros; apply continuity_pt_filterlim, (ex_derive_continuous y); eexists; apply Y.
  - right; split; [ apply B; lra | exact Q ].
  - exists t; split; [ lra | exact O ].
Qed.

(* The sign that decides after the pulse: (e thetadot/p)^2 - alpha^2 at an impact behind it, by its energy, in
   (alpha/(10 sin psi))^2. *)
Definition cosh_end psi := (exp ((2 * PI - psi) / 3) + exp (- ((2 * PI - psi) / 3))) / 2.
Definition sinh_end psi := (exp ((2 * PI - psi) / 3) - exp (- ((2 * PI - psi) / 3))) / 2.
Definition surplus psi := e ^ 2 * (18 + 10 * sin psi ^ 2 + 54 * sin psi * sinh_end psi - 18 * cos psi * cosh_end psi) -
  100 * sin psi ^ 2.
Definition surplus_rate psi := 20 * cos psi * (3 * e ^ 2 * sinh_end psi - (10 - e ^ 2) * sin psi).
Lemma surplus_derivative psi : is_derive surplus psi (surplus_rate psi).
Proof. unfold surplus, surplus_rate, sinh_end, cosh_end, Rdiv, Rminus; auto_derive; [ trivial | field ]. Qed.
Lemma surplus_grows a b : 0 < a -> a < b -> b <= 1 / 2 -> surplus a < surplus b.
Proof.
  intros A L B; apply (grows surplus surplus_rate); [ exact L | intros; apply surplus_derivative | intros x X ].
  assert (0 <= x <= 1 / 2) by lra; unfold surplus_rate, sinh_end, e; interval with (i_prec 30, i_bisect x).
Qed.
(* One psi at which it is 0: (92a) and (96) have one solution with psi up to 1/2; beyond, the block is back before. *)
Definition critical_psi psi := 28982226002789352/10^17 < psi < 28982226002789353/10^17 /\ surplus psi = 0.
Theorem critical_impact_behind :
  exists psi, critical_psi psi /\ forall x, 0 < x <= 1 / 2 -> surplus x = 0 -> x = psi.
Proof.
  assert (A : surplus (28982226002789352/10^17) < 0) by (unfold surplus, sinh_end, cosh_end, e; interval with (i_prec
    80)).
  assert (B : 0 < surplus (28982226002789353/10^17)) by (unfold surplus, sinh_end, cosh_end, e; interval with (i_prec
    80)).
  destruct (root_between surplus (28982226002789352/10^17) (28982226002789353/10^17)) as [psi C];
    [ lra | | left; split; assumption | ].
  - intros x X; apply continuity_pt_filterlim, (ex_derive_continuous surplus); eexists; apply surplus_derivative.
  - exists psi; split; [ exact C | intros x X Z; destruct C as [I C] ].
    destruct (Rtotal_order x psi) as [L | [L | L]]; [ | exact L | ].
    + assert (S := surplus_grows x psi); lra.
    + assert (S := surplus_grows psi x); lra.
Qed.

(* An impact behind the pulse, with E = exp (p (t_i - T_ex)): its energy is that at T_ex. *)
Lemma energy_at_impact a b alpha E' U : a < 0 -> 0 < alpha -> 1 < E' -> E' * U = 1 ->
  (a + alpha + b) / 2 * E' + (a + alpha - b) / 2 * U - alpha = 0 ->
  let w := (a + alpha + b) / 2 * E' - (a + alpha - b) / 2 * U in 0 < w /\ w ^ 2 = alpha ^ 2 - (a + alpha) ^ 2 + b ^ 2.
Proof.
  intros A P L I Z w; set (g := a + alpha + b) in *; set (d := a + alpha - b) in *; split.
  - assert (X : g * (1 + E') > 2 * alpha).
    { assert (D' : d = (2 * alpha - g * E') * E').
      { transitivity (d * (E' * U)); [ rewrite I; ring | replace (d * (E' * U)) with (d * U * E') by ring ].
        f_equal; lra. }
      assert (S : g + d < 2 * alpha) by (unfold g, d; lra); rewrite D' in S; nra. }
    unfold w; assert (0 < g) by nra; nra.
  - replace (w ^ 2) with ((g / 2 * E' + d / 2 * U) ^ 2 - g * d * (E' * U)) by (unfold w; field).
    replace (g / 2 * E' + d / 2 * U) with alpha by lra; rewrite I; unfold g, d; ring.
Qed.
Lemma surplus_is psi : let T := (2 * PI - psi) / 3 in
  e ^ 2 * ((10 * sin psi) ^ 2 - (before psi T + 10 * sin psi) ^ 2 + before_rate psi T ^ 2) - (10 * sin psi) ^ 2 =
  surplus psi.
Proof.
  intro T; assert (A : 3 * T = - psi + 2 * INR 1 * PI) by (unfold T; simpl; field); assert (P := pyth psi).
  unfold before, before_rate, surplus, N, D, E, cosh_end, sinh_end; fold T; rewrite A, sin_period, cos_period, sin_neg,
    cos_neg.
  assert (X := exp_pos T); rewrite exp_Ropp; field_simplify_eq; [ ring [P] | lra ].
Qed.

(* From rest to the impact and on. *)
Section Motion.
Variables p psi : R.
Variables x u : R -> R.
Hypotheses (p_pos : 0 < p) (range : 0 < psi < PI) (motion : is_the_motion (1 / 4) p (3 * p) psi x u).
Let k := 1 / 4 / (10 * sin psi).
Let last := T_ex (3 * p) psi.
Lemma sine_pos : 0 < sin psi. Proof. apply sin_gt_0; lra. Qed.
Lemma k_pos : 0 < k. Proof. assert (S := sine_pos); unfold k; pos. Qed.
Lemma last_is : p * last = end_of_pulse psi /\ 0 < last.
Proof.
  assert (P := PI_RGT_0); unfold last, T_ex, end_of_pulse; split; [ field; lra | apply Rdiv_lt_0_compat; lra ].
Qed.
Lemma to_the_left t : 0 <= t <= last -> x t = k * before psi (p * t) /\ u t = p * (k * before_rate psi (p * t)).
Proof.
  intro T; destruct (the_motion_is (1 / 4) p (3 * p) psi p_pos ltac:(lra) range x u motion) as [A _].
  destruct (A t T) as [-> ->]; assert (S := sine_pos).
  unfold theta, thetadot, before, before_rate, N, D, E, k; replace (3 * p * t) with (3 * (p * t)) by ring;
    rewrite sin_plus, cos_plus; split; field; repeat split; nra.
Qed.
Lemma starts_to_the_left : psi < PI / 2 -> exists a, 0 < a /\ forall t, 0 < t <= a -> x t < 0.
Proof.
  intro L; assert (K := k_pos); assert (S := sine_pos); assert (C : 0 < cos psi) by (apply cos_gt_0; lra).
  assert (A := Rmin_l (1 / 2) (cos psi)); assert (B := Rmin_r (1 / 2) (cos psi)).
  assert (M : 0 < Rmin (1 / 2) (cos psi)) by (apply Rmin_glb_lt; lra); set (d := Rmin _ _) in *; clearbody d.
  exists (d / p); split; [ apply Rdiv_lt_0_compat; lra | intros t T ].
  assert (T' : 0 < p * t <= d).
  { split; [ nra | apply (Rmult_le_reg_r (/ p)); [ now apply Rinv_0_lt_compat | ] ].
    replace (p * t * / p) with t by (field; lra); exact (proj2 T). }
  assert (Z : end_of_pulse psi > 1 / 2) by (unfold end_of_pulse; assert (3 < PI) by bounds; lra).
  destruct last_is as [I _]; destruct (to_the_left t) as [-> _]; [ split; [ | apply (Rmult_le_reg_l p) ]; lra | ].
  destruct (near_the_start (p * t) ltac:(lra)) as [[Y _] [X _]]; assert (Q := SIN_bound psi).
  assert (V : 0 <= (1 - sin psi) * (p * t)) by (apply Rmult_le_pos; lra).
  set (r := p * t) in *; clearbody r; unfold before; assert (0 < sin psi * (r * D r - N r)) by (apply
    Rmult_lt_0_compat; assumption).
  assert (0 <= (cos psi - sin psi * r) * D r) by (apply Rmult_le_pos; lra); nra.
Qed.
Lemma first_impact_from_the_left t_i : first_impact x t_i -> psi < PI / 2.
Proof.
  intros [P [_ L]]; apply Rnot_le_lt; intro Q; assert (K := k_pos); assert (S := sine_pos).
  assert (A := Rmin_l (t_i / 2) (1 / 2 / p)); assert (B := Rmin_r (t_i / 2) (1 / 2 / p)).
  assert (M : 0 < Rmin (t_i / 2) (1 / 2 / p)) by (apply Rmin_glb_lt; [ | apply Rdiv_lt_0_compat ]; lra).
  set (t := Rmin _ _) in *; clearbody t; specialize (L t ltac:(lra)).
  assert (T' : 0 < p * t <= 1 / 2) by (split; [ nra | replace (1 / 2) with (p * (1 / 2 / p)) by (field; lra); nra ]).
  assert (Z : end_of_pulse psi > 1 / 2) by (unfold end_of_pulse; assert (3 < PI) by bounds; lra).
  destruct last_is as [I _]; destruct (to_the_left t) as [X _]; [ split; [ | apply (Rmult_le_reg_l p) ]; lra | ].
  destruct (near_the_start (p * t) T') as [[Y Y'] _]; assert (C : cos psi <= 0) by (apply
    cos_le_0; lra).
  assert (0 < before psi (p * t)) by (unfold before; nra); nra.
Qed.
(* A motion to the right from t_i on while the pulse lasts. *)
Definition to_the_right t_i t := k * after psi (p * t_i) (p * (t - t_i)).
Definition to_the_right_rate t_i t := p * (k * after_rate psi (p * t_i) (p * (t - t_i))).
Lemma to_the_right_derivative t_i t : is_derive (to_the_right t_i) t (to_the_right_rate t_i t).
Proof. unfold to_the_right, to_the_right_rate, after, after_rate; auto_derive; [ trivial | unfold Rminus; field ]. Qed.
Lemma to_the_right_solves t_i t : is_derive (to_the_right_rate t_i) t (p ^ 2 * to_the_right t_i t +
  (- p ^ 2 * (1 / 4) - p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t + psi))).
Proof.
  assert (S := sine_pos); replace (3 * p * t) with (3 * (p * t_i + p * (t - t_i))) by ring.
  unfold to_the_right, to_the_right_rate, k, after, after_rate; auto_derive; [ trivial | unfold Rminus; field; lra ].
Qed.
Lemma to_the_right_start t_i : 0 <= t_i <= last -> to_the_right t_i t_i = 0 /\ to_the_right_rate t_i t_i = e * u t_i.
Proof.
  intro L; destruct (to_the_left t_i L) as [_ B]; destruct (after_start psi (p * t_i)) as [S0 S1].
  unfold to_the_right, to_the_right_rate; rewrite Rminus_eq_0, Rmult_0_r, S0, S1, B; split; ring.
Qed.

Section After_impact.
Variables c t_i : R.
Variables y v : R -> R.
Hypotheses (crit : critical c) (impact_first : first_impact x t_i) (goes : goes_on p psi u t_i y v).
Definition fate s := (0 < s -> (forall t, t_i < t -> 0 < y t) /\ forall m, exists S, forall t, S < t -> m < y t) /\
  (s = 0 -> (forall t, t_i < t -> 0 < y t) /\ tends_to y (1 / 4)) /\ (s < 0 -> exists t, t_i < t /\ y t = 0).
Lemma positive_multiple m s : 0 < m -> fate (m * s) -> fate s.
Proof.
  intros M [A [B C]]; split; [ intro; apply A; nra | split; [ intros ->; apply B; ring | intro; apply C; nra ] ].
Qed.

Lemma during : t_i <= last -> let tau := p * t_i in
  (0 < tau <= (2 * PI - psi) / 3 /\ before psi tau = 0) /\ fate (margin tau).
Proof.
  intros L tau; destruct goes as [Y [C [Y0 [V0 [V W]]]]]; fold last in V, W; destruct impact_first as [P [Z _]];
    assert (K := k_pos).
  assert (S := sine_pos); destruct last_is as [I _]; assert (Q := first_impact_from_the_left t_i impact_first).
  destruct (to_the_left t_i) as [A B]; [ lra | rewrite A in Z; fold tau in Z, B ].
  assert (F' : before psi tau = 0) by (destruct (Rmult_integral _ _ Z); lra).
  assert (T : 0 < tau <= (2 * PI - psi) / 3) by (fold (end_of_pulse psi); rewrite <- I; unfold tau; split; nra).
  split; [ split; assumption | ]; assert (R := rate_pos psi tau range T F'); assert (e_range := e_pos).
  destruct (to_the_right_start t_i ltac:(lra)) as [S0 S1].
  assert (X : forall t, t_i <= t <= last -> y t = to_the_right t_i t /\ v t = to_the_right_rate t_i t).
  { apply (agrees_until p t_i p_pos last y v (to_the_right t_i) (to_the_right_rate t_i)
      (fun t => - p ^ 2 * (1 / 4) - p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t + psi))); try assumption;
        try congruence.
    - intros t H; specialize (V t H); replace (_ + _) with (p ^ 2 * y t - p ^ 2 * (1 / 4) -
        p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t + psi)) by ring; exact V.
    - apply to_the_right_derivative.
    - apply to_the_right_solves. }
  assert (G' : y last - 1 / 4 + v last / p = k * (sin psi * margin tau)).
  { destruct (X last) as [-> ->]; [ lra | rewrite <- (after_end psi tau range T F') ].
    replace (end_of_pulse psi - tau) with (p * (last - t_i)) by (rewrite <- I; unfold tau; ring).
    unfold to_the_right, to_the_right_rate, k; fold tau; field; lra. }
  assert (obeys : forall t, last < t -> is_derive v t (p ^ 2 * y t - p ^ 2 * (1 / 4))) by (intros; apply W; lra).
  destruct (free_fate p (1 / 4) last y v p_pos Y C obeys) as [over [at_it under]].
  assert (stays := stays_free p (1 / 4) last y v p_pos Y C obeys ltac:(lra)); rewrite G' in *.
  assert (pi_bound : PI / 3 < 111 / 100) by bounds; assert (M := margin_sign c tau crit (tau_bound psi tau range T)).
  assert (right : 0 <= margin tau -> forall t, t_i < t -> 0 < y t).
  { intros N; assert (J : PI / 3 <= tau).
    { destruct crit as [J _]; destruct M as [M _]; apply Rnot_lt_le; intro; assert (margin tau < 0) by (apply M; lra);
      lra. }
    assert (H : forall t, t_i < t <= last -> 0 < y t).
    { intros t J'; destruct (X t) as [-> _]; [ lra | apply Rmult_lt_0_compat; [ exact K | ] ].
      apply stays_right; try assumption; [ lra | ]; rewrite <- I; unfold tau; nra. }
    intros t J'; destruct (Rle_dec t last) as [O | O]; [ apply H; lra | apply stays; [ | | lra ] ].
    - destruct L as [L | L]; [ apply Rlt_le, H; lra | rewrite <- L, Y0; lra ].
    - apply Rmult_le_pos; [ lra | nra ]. }
  split; [ | split ].
  - intro N; split; [ apply right; lra | apply over; apply Rmult_lt_0_compat; [ | apply Rmult_lt_0_compat ];
    assumption ].
  - intro N; split; [ apply right; lra | apply at_it; rewrite N; ring ].
  - intro N; apply (comes_back_to_0 y v t_i Y Y0); [ rewrite V0, B; pos | apply under ].
    assert (0 < k * sin psi) by (apply Rmult_lt_0_compat; assumption); nra.
Qed.

Lemma afterwards : last < t_i -> psi < 1 / 2 /\ fate (surplus psi).
Proof.
  intros L; destruct goes as [Y [C [Y0 [V0 [_ W]]]]]; fold last in W; destruct impact_first as [P [Z B]];
    assert (K := k_pos).
  assert (S := sine_pos); destruct last_is as [I J]; assert (Q := first_impact_from_the_left t_i impact_first).
  destruct (the_motion_is (1 / 4) p (3 * p) psi p_pos ltac:(lra) range x u motion) as [M M'].
  destruct (M last) as [A A']; [ split; [ lra | apply Rle_refl ] | ]; destruct (M' t_i ltac:(fold last; lra)) as [X V].
  destruct (to_the_left last) as [A1 A1']; [ lra | rewrite I in A1, A1' ]; fold last in A, A', X, V.
  assert (neg : x last < 0) by (apply B; lra); split.
  - apply Rnot_le_lt; intro N'; assert (0 < before psi (end_of_pulse psi)); [ | nra ].
    assert (R : 1 / 2 <= psi <= 158 / 100) by (assert (PI < 315 / 100) by bounds; lra).
    unfold before, N, D, end_of_pulse; clear - R; interval with (i_prec 30, i_bisect psi).
  - rewrite Z, free_by_exponentials in X by exact p_pos; fold last in X; rewrite <- A, <- A' in X.
    destruct (energy_at_impact (x last) (u last / p) (1 / 4) (exp (p * (t_i - last))) (exp (- (p * (t_i - last))))) as
      [w_pos E2]; try lra.
    + rewrite <- exp_0; apply exp_increasing; nra.
    + rewrite <- exp_plus, Rplus_opp_r; apply exp_0.
    + set (w := _ - _) in w_pos, E2; assert (V' : u t_i = p * w).
      { rewrite V; unfold freedot; fold last; rewrite <- A, <- A'; unfold w; field; lra. }
      assert (e_range := e_pos); destruct (free_fate p (1 / 4) t_i y v p_pos Y C) as [over [at_it under]];
        [ intros; apply W; lra | ].
      assert (stays := stays_free p (1 / 4) t_i y v p_pos Y C ltac:(intros; apply W; lra) ltac:(lra)).
      rewrite V0, Y0, V' in *; replace (0 - 1 / 4 + e * (p * w) / p) with (e * w - 1 / 4) in * by (field; lra).
      apply (positive_multiple (k ^ 2)); [ nra | ].
      replace (k ^ 2 * surplus psi) with ((e * w - 1 / 4) * (e * w + 1 / 4)).
      2: { rewrite <- surplus_is; fold (end_of_pulse psi); transitivity (e ^ 2 * w ^ 2 - (1 / 4) ^ 2); [ ring | ].
           rewrite E2, A1, A1'; unfold k; field; lra. }
      assert (0 < e * w) by nra; split; [ | split ].
      * intro; split; [ apply stays | apply over ]; nra.
      * intro; split; [ apply stays | apply at_it ]; nra.
      * intro; apply (comes_back_to_0 y v t_i Y Y0); [ rewrite V0; nra | apply under; nra ].
Qed.
End After_impact.
End Motion.
