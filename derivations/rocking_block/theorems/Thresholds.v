(* The amplitude at which a block that rocks to one side overturns without impact, (71). The pulse is
   a_p sin(omega_p t + psi) with sin psi = alpha g/a_p, from rest, until T_ex = (2 pi - psi)/omega_p; the block
   is linear. w stands for omega_p/p. *)
From Rederive Require Import Rederive Bounds Solutions Limits.
From Coquelicot Require Import Coquelicot.

(* (71) says that this is 0. *)
Definition excess w psi := cos psi - w * sin psi - exp (- ((2 * PI - psi) / w)).
Lemma excess_says w psi : excess w psi = 0 <-> row{71, omega_p/p := w}.
Proof. unfold excess; replace (- (2 * PI - psi) / w) with (- ((2 * PI - psi) / w)) by (unfold Rdiv; ring); lra. Qed.
Ltac same_derivative D :=
  match type of D with is_derive _ _ ?d => match goal with |- is_derive _ _ ?e =>
    replace e with d by (unfold Rdiv; ring); exact D end end.

(* One threshold, whatever w is: positive at 0, decreasing to the right angle, negative beyond. *)
Lemma excess_at_rest w : 0 < w -> 0 < excess w 0.
Proof.
  intro W; unfold excess; rewrite cos_0, sin_0.
  assert (P : 0 < (2 * PI - 0) / w) by (assert (Q := PI_RGT_0); pos).
  assert (E := exp_increasing _ _ (Ropp_lt_gt_0_contravar _ P)); rewrite exp_0 in E; lra.
Qed.
Lemma excess_decreases w x y : 0 < w -> 0 <= x -> x < y -> y <= PI / 2 -> excess w y < excess w x.
Proof.
  intros W X L Y; assert (P := PI_RGT_0); unfold excess.
  assert (C : cos y < cos x) by (apply cos_decreasing_1; lra).
  assert (S : sin x < sin y) by (apply sin_increasing_1; lra).
  assert (E : exp (- ((2 * PI - x) / w)) < exp (- ((2 * PI - y) / w))).
  { apply exp_increasing, Ropp_lt_contravar, Rmult_lt_compat_r; [ apply Rinv_0_lt_compat | ]; lra. }
  nra.
Qed.
Lemma excess_negative w x : 0 < w -> PI / 2 <= x <= PI -> excess w x < 0.
Proof.
  intros W X; unfold excess.
  assert (C := cos_le_0 x); assert (S := sin_ge_0 x); assert (E := exp_pos (- ((2 * PI - x) / w))).
  assert (P := PI_RGT_0); nra.
Qed.
Lemma excess_continuous w x : 0 < w -> continuity_pt (excess w) x.
Proof. intro W; unfold excess; reg; lra. Qed.

Theorem threshold_exists w : 0 < w -> exists psi, 0 < psi < PI / 2 /\ excess w psi = 0.
Proof.
  intro W; assert (P := PI_RGT_0); assert (A := excess_at_rest w W).
  assert (B : excess w (PI / 2) < 0) by (apply excess_negative; lra).
  destruct (intermediate_value (excess w) 0 (PI / 2)) as [psi [I Z]];
    [ lra | intros; now apply excess_continuous | right; lra | ].
  exists psi; repeat split; try assumption.
  - destruct (Req_dec psi 0) as [-> |]; lra.
  - destruct (Req_dec psi (PI / 2)) as [-> |]; lra.
Qed.
Lemma sign_of_excess w psi x :
  0 < w -> 0 < psi < PI -> excess w psi = 0 -> 0 < x < PI -> (x < psi <-> 0 < excess w x).
Proof.
  intros W I Z X.
  assert (H : psi < PI / 2) by (apply Rnot_le_lt; intro; assert (N := excess_negative w psi W); lra).
  split; intro L.
  - rewrite <- Z; apply excess_decreases; lra.
  - apply Rnot_le_lt; intro N; destruct (Rle_lt_dec x (PI / 2)) as [S | S].
    + destruct N as [N | N]; [ assert (D := excess_decreases w psi x W); lra | subst; lra ].
    + assert (D := excess_negative w x W); lra.
Qed.
Theorem threshold_is_unique w x y :
  0 < w -> 0 < x < PI -> 0 < y < PI -> excess w x = 0 -> excess w y = 0 -> x = y.
Proof.
  intros W X Y A B.
  assert (P := sign_of_excess w x y W X A Y); assert (Q := sign_of_excess w y x W Y B X); lra.
Qed.
Lemma enclosed w a b psi :
  0 < w -> 0 < a < b -> b < PI -> 0 < excess w a -> excess w b < 0 -> 0 < psi < PI -> excess w psi = 0 -> a < psi < b.
Proof.
  intros W A B P N I Z.
  assert (Q := sign_of_excess w psi a W I Z); assert (R := sign_of_excess w psi b W I Z).
  split; [ lra | apply Rnot_le_lt; intros [L | <-]; lra ].
Qed.

(* The response (57a) with the constants (70), and its rate (59a), in hyperbolic functions by exponentials. *)
Section Response.
Variables alpha p omega_p psi : R.
Hypotheses (alpha_pos : 0 < alpha) (p_pos : 0 < p) (omega_pos : 0 < omega_p) (psi_range : 0 < psi < PI).

Let A_1 := - (alpha * omega_p * p * cos psi) / (sin psi * (omega_p ^ 2 + p ^ 2)).
Let A_2 := alpha * omega_p ^ 2 / (omega_p ^ 2 + p ^ 2).
Definition theta t :=
  A_1 * ((exp (p * t) - exp (- (p * t))) / 2) + A_2 * ((exp (p * t) + exp (- (p * t))) / 2) +
  alpha * p ^ 2 * sin (omega_p * t + psi) / (sin psi * (omega_p ^ 2 + p ^ 2)) - alpha.
Definition thetadot t :=
  p * (A_1 * ((exp (p * t) + exp (- (p * t))) / 2) + A_2 * ((exp (p * t) - exp (- (p * t))) / 2)) +
  alpha * p ^ 2 * omega_p * cos (omega_p * t + psi) / (sin psi * (omega_p ^ 2 + p ^ 2)).
Definition T_ex := (2 * PI - psi) / omega_p.

Lemma sin_psi_pos : 0 < sin psi. Proof. apply sin_gt_0; lra. Qed.
Lemma squares_pos : 0 < omega_p ^ 2 + p ^ 2. Proof. nra. Qed.

(* It solves (56a) with a_p/g = alpha/sin psi, from rest. *)
Lemma theta_derivative t : is_derive theta t (thetadot t).
Proof.
  assert (S := sin_psi_pos); assert (Q := squares_pos).
  unfold theta, thetadot; auto_derive; [ repeat split; lra | field; split; lra ].
Qed.
Theorem response_solves t :
  is_derive thetadot t (p ^ 2 * theta t + p ^ 2 * alpha - p ^ 2 * (alpha / sin psi) * sin (omega_p * t + psi)).
Proof.
  assert (S := sin_psi_pos); assert (Q := squares_pos).
  unfold theta, thetadot; auto_derive; [ repeat split; lra | field; split; lra ].
Qed.
Lemma response_says t : is_derive thetadot t (p ^ 2 * theta t + (right{56a, a_p/g := alpha / sin psi})).
Proof. same_derivative (response_solves t). Qed.
Theorem response_starts_at_rest : theta 0 = 0 /\ thetadot 0 = 0.
Proof.
  assert (S := sin_psi_pos); assert (Q := squares_pos); unfold theta, thetadot, A_1, A_2.
  rewrite !Rmult_0_r, Ropp_0, !exp_0, Rplus_0_l; split; field; split; lra.
Qed.

(* The free motion after the pulse, (62a) with (66); s is the time since T_ex. *)
Definition free s :=
  thetadot T_ex / p * ((exp (p * s) - exp (- (p * s))) / 2) +
  (theta T_ex + alpha) * ((exp (p * s) + exp (- (p * s))) / 2) - alpha.
Definition freedot s :=
  thetadot T_ex * ((exp (p * s) + exp (- (p * s))) / 2) +
  p * (theta T_ex + alpha) * ((exp (p * s) - exp (- (p * s))) / 2).
Theorem free_solves s : is_derive free s (freedot s) /\ is_derive freedot s (p ^ 2 * free s + right{61a}) /\
  free 0 = theta T_ex /\ freedot 0 = thetadot T_ex.
Proof.
  unfold free, freedot; split; [ | split; [ | split ] ].
  - auto_derive; [ lra | field; lra ].
  - auto_derive; [ lra | field; lra ].
  - rewrite !Rmult_0_r, Ropp_0, !exp_0; field; lra.
  - rewrite !Rmult_0_r, Ropp_0, !exp_0; lra.
Qed.

(* (71) from (68): what decides is theta + alpha + thetadot/p at the end of the pulse. *)
Lemma growing_part :
  theta T_ex + alpha + thetadot T_ex / p =
  - (alpha * omega_p * p * exp (p * T_ex) / (sin psi * (omega_p ^ 2 + p ^ 2))) * excess (omega_p / p) psi.
Proof.
  assert (S := sin_psi_pos); assert (Q := squares_pos).
  assert (E : exp (- ((2 * PI - psi) / (omega_p / p))) = / exp (p * T_ex)).
  { rewrite <- exp_Ropp; f_equal; unfold T_ex; field; lra. }
  assert (C : omega_p * T_ex + psi = 0 + 2 * INR 1 * PI) by (unfold T_ex; simpl; field; lra).
  unfold theta, thetadot, excess, A_1, A_2; rewrite E, C, sin_period, cos_period, sin_0, cos_0, exp_Ropp.
  assert (N := exp_nonzero (p * T_ex)); field; repeat split; try lra; assumption.
Qed.
Lemma free_by_exponentials s :
  free s = (theta T_ex + alpha + thetadot T_ex / p) / 2 * exp (p * s) +
           (theta T_ex + alpha - thetadot T_ex / p) / 2 * exp (- (p * s)) - alpha.
Proof. unfold free; field; lra. Qed.

(* What the pulse asks for exceeds alpha, its value at the start, until its phase is pi - psi, and never after that.
  *)
Lemma sine_above x : psi < x < PI - psi -> sin psi < sin x.
Proof.
  intro X; destruct (Rle_dec x (PI / 2)) as [L | L]; [ apply sin_increasing_1; lra | ].
  rewrite <- (sin_PI_x x); apply sin_increasing_1; lra.
Qed.
Lemma sine_below x : psi < PI / 2 -> PI - psi < x <= 2 * PI -> sin x < sin psi.
Proof.
  intros H X; assert (S := sin_psi_pos); destruct (Rle_dec x PI) as [L | L].
  - rewrite <- (sin_PI_x x); apply sin_increasing_1; lra.
  - assert (N := sin_le_0 x); lra.
Qed.
(* Where the block does not come back, thetadot + p theta is negative while the pulse lasts: its product with
   exp (- p t) falls from 0 as long as the pulse exceeds alpha, and then rises to a value that is negative. So
   theta exp (p t) falls. *)
Lemma growing_part_negative : 0 < excess (omega_p / p) psi -> theta T_ex + alpha + thetadot T_ex / p < 0.
Proof.
  intro E; assert (S := sin_psi_pos); assert (Q := squares_pos); rewrite growing_part.
  assert (0 < alpha * omega_p * p * exp (p * T_ex) / (sin psi * (omega_p ^ 2 + p ^ 2))) by pos; nra.
Qed.
Lemma negative_until_the_end :
  theta T_ex + alpha + thetadot T_ex / p <= 0 -> psi < PI / 2 -> forall t, 0 < t <= T_ex -> theta t < 0.
Proof.
  intros G H; assert (S := sin_psi_pos); assert (L := PI_RGT_0).
  destruct response_starts_at_rest as [T0 V0].
  assert (phase : forall a b t, a <= omega_p * t + psi < b <-> (a - psi) / omega_p <= t < (b - psi) / omega_p).
  { intros a b t; assert (A : a <= omega_p * t + psi <-> (a - psi) / omega_p <= t) by (apply (le_by omega_p); [ lra |
    field;
      lra ]); assert (B : omega_p * t + psi < b <-> t < (b - psi) / omega_p) by (apply (lt_by omega_p); [ lra | field;
      lra ]); tauto. }
  set (m := (PI - psi - psi) / omega_p).
  assert (M : 0 < m) by (unfold m; apply Rdiv_lt_0_compat; lra).
  assert (M' : omega_p * m + psi = PI - psi) by (unfold m; field; lra).
  assert (T' : omega_p * T_ex + psi = 2 * PI) by (unfold T_ex; field; lra).
  set (V := fun t => (thetadot t + p * theta t) * exp (- (p * t))).
  set (V' := fun t => - (p ^ 2 * alpha / sin psi * (sin (omega_p * t + psi) - sin psi) * exp (- (p * t)))).
  assert (D : forall t, is_derive V t (V' t)).
  { intro t; assert (A := theta_derivative t); assert (B := response_solves t); unfold V, V'; derivatives; field;
    lra. }
  assert (K : 0 < p ^ 2 * alpha / sin psi) by pos.
  assert (X : forall t, 0 < t <= T_ex -> V t < 0).
  { intros t [P N]; destruct (Rle_dec t m) as [C | C].
    - enough (- V 0 < - V t) by (unfold V in *; rewrite T0, V0 in *; lra).
      apply (grows (fun t => - V t) (fun t => - V' t)); [ exact P | |].
      + intros x _; assert (Dx := D x); derivatives; ring.
      + intros x I; unfold V'; rewrite Ropp_involutive; apply Rmult_lt_0_compat; [ | apply exp_pos ].
        assert (A := sine_above (omega_p * x + psi)); apply Rmult_lt_0_compat; [ exact K | nra ].
    - apply Rle_lt_trans with (V T_ex).
      + apply (increases V V'); [ exact N | intros; apply D | ].
        intros x I; unfold V'; assert (A := sine_below (omega_p * x + psi) H).
        assert (B := exp_pos (- (p * x))); assert (A' : sin (omega_p * x + psi) < sin psi) by (apply A; split; nra).
        assert (0 < p ^ 2 * alpha / sin psi * (sin psi - sin (omega_p * x + psi))) by (apply Rmult_lt_0_compat; lra);
          nra.
      + unfold V; assert (B := exp_pos (- (p * T_ex))).
        assert (thetadot T_ex + p * theta T_ex < 0).
        { replace (thetadot T_ex) with (p * (thetadot T_ex / p)) by (field; lra); nra. }
        nra. }
  intros t I; assert (B := exp_pos (p * t)).
  enough (- (theta 0 * exp (p * 0)) < - (theta t * exp (p * t))) by (rewrite T0 in *; nra).
  apply (grows (fun t => - (theta t * exp (p * t))) (fun t => - ((thetadot t + p * theta t) * exp (p * t)))); [ lra |
    |].
  - intros x _; assert (A := theta_derivative x); derivatives; ring.
  - intros x J; assert (Y := X x); unfold V in Y; assert (Z := exp_pos (- (p * x))); assert (Z' := exp_pos (p * x));
    nra.
Qed.

Lemma no_impact : 0 < excess (omega_p / p) psi -> forall t, 0 < t <= T_ex -> theta t < 0.
Proof.
  intro E; apply negative_until_the_end; [ apply Rlt_le, growing_part_negative, E | ].
  apply Rnot_le_lt; intro; assert (N := excess_negative (omega_p / p) psi ltac:(pos)); lra.
Qed.

(* Above the threshold, where psi is smaller, the block overturns, and nowhere before does it come back to theta = 0,
   where it would strike the ground; below it, it comes back. *)
Theorem overturns : 0 < excess (omega_p / p) psi ->
  (forall t, 0 < t <= T_ex -> theta t < 0) /\ (forall s, 0 <= s -> free s < 0) /\
  forall m, exists T, forall s, T < s -> free s < m.
Proof.
  intro E; assert (N := no_impact E); assert (G := growing_part_negative E); split; [ exact N | split ].
  - intros s I; rewrite free_by_exponentials.
    assert (U : exp (p * s) * exp (- (p * s)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    assert (P := exp_ineq1_le (p * s)); assert (Q := exp_pos (- (p * s))); assert (1 <= exp (p * s)) by nra.
    assert (exp (- (p * s)) <= 1) by nra; assert (L := PI_RGT_0).
    assert (0 < T_ex) by (unfold T_ex; apply Rdiv_lt_0_compat; lra); specialize (N T_ex).
    set (d := theta T_ex + alpha - thetadot T_ex / p) in *; set (g := theta T_ex + alpha + thetadot T_ex / p) in *.
    assert (g + d < 2 * alpha) by (unfold g, d; lra); destruct (Rle_dec 0 d); nra.
  - intro m; destruct (exponential_beats p (- ((theta T_ex + alpha + thetadot T_ex / p) / 2))
             (- ((theta T_ex + alpha - thetadot T_ex / p) / 2)) (- (m + alpha))) as [T H]; [ lra | lra | ].
    exists T; intros s L; rewrite free_by_exponentials; specialize (H s L); lra.
Qed.
Theorem comes_back : excess (omega_p / p) psi < 0 -> forall m, exists T, forall s, T < s -> m < free s.
Proof.
  intros E m; assert (S := sin_psi_pos); assert (Q := squares_pos).
  assert (G : 0 < theta T_ex + alpha + thetadot T_ex / p).
  { rewrite growing_part; assert (0 < alpha * omega_p * p * exp (p * T_ex) / (sin psi * (omega_p ^ 2 +
    p ^ 2))) by pos; nra. }
  destruct (exponential_beats p ((theta T_ex + alpha + thetadot T_ex / p) / 2)
             ((theta T_ex + alpha - thetadot T_ex / p) / 2) (m + alpha)) as [T H]; [ lra | lra | ].
  exists T; intros s L; rewrite free_by_exponentials; specialize (H s L); lra.
Qed.

(* One motion: x is at rest at 0, obeys (56a) until T_ex, and (61a) from then on. *)
Definition is_the_motion (x v : R -> R) :=
  (forall t, is_derive x t (v t)) /\ (forall t, continuous v t) /\ x 0 = 0 /\ v 0 = 0 /\
  (forall t, 0 < t < T_ex ->
    is_derive v t (p ^ 2 * x t + p ^ 2 * alpha - p ^ 2 * (alpha / sin psi) * sin (omega_p * t + psi))) /\
  (forall t, T_ex < t -> is_derive v t (p ^ 2 * x t + p ^ 2 * alpha)).
Lemma motion_says x v : is_the_motion x v ->
  (forall t, 0 < t < T_ex -> is_derive v t (p ^ 2 * x t + (right{56a, a_p/g := alpha / sin psi}))) /\
  (forall t, T_ex < t -> is_derive v t (p ^ 2 * x t + right{61a})).
Proof.
  intros [_ [_ [_ [_ [V W]]]]]; split; intros t I; [ specialize (V t I); same_derivative V | exact (W t I) ].
Qed.
Lemma T_ex_pos : 0 < T_ex.
Proof. assert (L := PI_RGT_0); unfold T_ex; apply Rdiv_lt_0_compat; lra. Qed.
Lemma the_motion_is x v : is_the_motion x v ->
  (forall t, 0 <= t <= T_ex -> x t = theta t /\ v t = thetadot t) /\
  forall t, T_ex <= t -> x t = free (t - T_ex) /\ v t = freedot (t - T_ex).
Proof.
  intros [X [C [X0 [V0 [V W]]]]]; assert (P := T_ex_pos); destruct response_starts_at_rest as [T0 R0].
  assert (A : forall t, 0 <= t <= T_ex -> x t = theta t /\ v t = thetadot t).
  { apply (agrees_until p 0 p_pos T_ex x v theta thetadot
      (fun t => p ^ 2 * alpha - p ^ 2 * (alpha / sin psi) * sin (omega_p * t + psi))); try assumption; try congruence.
    - intros t I; specialize (V t I); replace (_ + _) with (p ^ 2 * x t + p ^ 2 * alpha - p ^ 2 * (alpha / sin psi) *
        sin (omega_p * t + psi)) by ring; exact V.
    - apply theta_derivative.
    - intro t; assert (S := response_solves t); replace (_ + (_ - _)) with (p ^ 2 * theta t + p ^ 2 * alpha -
        p ^ 2 * (alpha / sin psi) * sin (omega_p * t + psi)) by ring; exact S. }
  split; [ exact A | intros t I ]; destruct (A T_ex) as [E F]; [ lra | ].
  apply (agrees_until p T_ex p_pos t x v (fun t => free (t - T_ex)) (fun t => freedot (t - T_ex))
    (fun _ => p ^ 2 * alpha)); try assumption.
  - intros s J; apply W; lra.
  - intro s; unfold free, freedot; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - intro s; unfold free, freedot; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - rewrite E, Rminus_eq_0; symmetry; apply (free_solves 0).
  - rewrite F, Rminus_eq_0; symmetry; apply (free_solves 0).
  - lra.
Qed.
(* There is such a motion. *)
Theorem threshold_instance : exists x v, is_the_motion x v.
Proof.
  assert (S := sin_psi_pos); assert (P := T_ex_pos); destruct response_starts_at_rest as [T0 R0].
  set (w := fun t => freedot (t - T_ex)).
  set (pulse := fun t => p ^ 2 * theta t + p ^ 2 * alpha - p ^ 2 * (alpha / sin psi) * sin (omega_p * t + psi)).
  assert (F0 : theta T_ex = free (T_ex - T_ex)) by (rewrite Rminus_eq_0; symmetry; apply (free_solves 0)).
  assert (W0 : thetadot T_ex = w T_ex) by (unfold w; rewrite Rminus_eq_0; symmetry; apply (free_solves 0)).
  assert (X := glued theta thetadot (fun t => free (t - T_ex)) w T_ex theta_derivative).
  assert (V := glued thetadot pulse w (fun t => p ^ 2 * free (t - T_ex) + p ^ 2 * alpha) T_ex response_solves).
  assert (Dx : forall t, is_derive (fun t => free (t - T_ex)) t (w t)) by (intro; unfold free, w, freedot; auto_derive;
    [ trivial | unfold Rminus; field; lra ]).
  assert (Dw : forall t, is_derive w t (p ^ 2 * free (t - T_ex) + p ^ 2 * alpha)) by (intro; unfold free, w, freedot;
    auto_derive; [ trivial | unfold Rminus; field; lra ]).
  specialize (X Dx F0 W0); specialize (V Dw W0).
  assert (E : pulse T_ex = p ^ 2 * free (T_ex - T_ex) + p ^ 2 * alpha).
  { rewrite <- F0; unfold pulse; replace (omega_p * T_ex + psi) with (2 * PI) by (unfold T_ex; field; lra).
    rewrite sin_2PI; ring. }
  specialize (V E); exists (fun t => if Rle_dec t T_ex then theta t else free (t - T_ex)),
    (fun t => if Rle_dec t T_ex then thetadot t else w t).
  split; [ exact X | split; [ intro t; apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply V | ] ].
  destruct (Rle_dec 0 T_ex) as [_ | N]; [ | lra ]; split; [ exact T0 | split; [ exact R0 | split ] ]; intros t I;
    specialize (V t); destruct (Rle_dec t T_ex); try lra; exact V.
Qed.
(* (71) is its threshold: above it the block overturns and strikes nothing before, below it the block comes back, and
   at it, and there alone, the block tends to the equilibrium. *)
Theorem threshold_of_the_motion x v : is_the_motion x v ->
  (0 < excess (omega_p / p) psi ->
    (forall t, 0 < t -> x t < 0) /\ forall m, exists T, forall t, T < t -> x t < m) /\
  (excess (omega_p / p) psi < 0 -> forall m, exists T, forall t, T < t -> m < x t) /\
  (excess (omega_p / p) psi = 0 <-> tends_to x (- alpha)).
Proof.
  intro M; destruct (the_motion_is x v M) as [A B]; split; [ | split ].
  - intro E; destruct (overturns E) as [N [F G]]; split.
    + intros t I; destruct (Rle_dec t T_ex); [ rewrite (proj1 (A t ltac:(lra))); apply N; lra |
        rewrite (proj1 (B t ltac:(lra))); apply F; lra ].
    + intro m; destruct (G m) as [T H]; exists (Rmax T_ex (T + T_ex)); intros t I.
      assert (L := Rmax_l T_ex (T + T_ex)); assert (L' := Rmax_r T_ex (T + T_ex)); rewrite (proj1 (B t ltac:(lra)));
      apply H; lra.
  - intros E m; destruct (comes_back E m) as [T H]; exists (Rmax T_ex (T + T_ex)); intros t I.
    assert (L := Rmax_l T_ex (T + T_ex)); assert (L' := Rmax_r T_ex (T + T_ex)); rewrite (proj1 (B t ltac:(lra)));
      apply H; lra.
  - rewrite (tends_to_from T_ex x (fun t => thetadot T_ex / p * sinh (p * (t - T_ex)) +
      (theta T_ex + alpha) * cosh (p * (t - T_ex)) + - alpha)) by (intros t I; apply B; lra).
    rewrite dies_away by exact p_pos; assert (G := growing_part); assert (S := sin_psi_pos); assert (Q :=
      squares_pos).
    assert (K : 0 < alpha * omega_p * p * exp (p * T_ex) / (sin psi * (omega_p ^ 2 + p ^ 2))) by pos.
    split; intro E; [ rewrite E in G; lra | nra ].
Qed.
(* At it, it strikes nothing either. *)
Lemma no_impact_at_the_threshold x v :
  is_the_motion x v -> excess (omega_p / p) psi = 0 -> forall t, 0 < t -> x t < 0.
Proof.
  intros M Z; destruct (the_motion_is x v M) as [A B]; assert (P := T_ex_pos); assert (L := PI_RGT_0).
  assert (G : theta T_ex + alpha + thetadot T_ex / p = 0) by (rewrite growing_part, Z; ring).
  assert (N : forall t, 0 < t <= T_ex -> theta t < 0).
  { apply negative_until_the_end; [ lra | apply Rnot_le_lt; intro ].
    assert (E := excess_negative (omega_p / p) psi ltac:(pos)); lra. }
  intros t I; destruct (Rle_dec t T_ex); [ rewrite (proj1 (A t ltac:(lra))); apply N; lra | ].
  rewrite (proj1 (B t ltac:(lra))), free_by_exponentials, G; specialize (N T_ex ltac:(lra)).
  assert (U := exp_pos (- (p * (t - T_ex)))); assert (exp (- (p * (t - T_ex))) < exp 0) by (apply exp_increasing; nra).
  rewrite exp_0 in *; nra.
Qed.
End Response.

(* The thresholds for omega_p/p = 1, 2, 3, 4: one root between 0 and pi, and the amplitude a_p/(alpha g) =
  1/sin psi. *)
Definition is_threshold w psi := 0 < psi < PI /\ excess w psi = 0.
Ltac signs := unfold excess; interval with (i_prec 100).
Lemma threshold_between w a b :
  0 < w -> 0 < a < b -> b < PI -> 0 < excess w a -> excess w b < 0 ->
  exists psi, is_threshold w psi /\ a < psi < b /\ forall x, is_threshold w x -> x = psi.
Proof.
  intros W A B P N; destruct (threshold_exists w W) as [psi [I Z]]; assert (L := PI_RGT_0).
  assert (I' : 0 < psi < PI) by lra; exists psi; repeat split; try lra.
  - now apply (enclosed w a b psi).
  - now apply (enclosed w a b psi).
  - intros x [X Y]; now apply (threshold_is_unique w).
Qed.
Ltac threshold w a b :=
  let psi := fresh "psi" in
  destruct (threshold_between w a b) as [psi [T [I U]]]; [ lra | lra | bounds | signs | signs | ];
  exists psi; split; [ exact T | split; [ exact I | split; [ exact U | split; interval with (i_prec 100) ] ] ].
Theorem threshold_at_1 : exists psi, is_threshold 1 psi /\ 78251032547928250/10^17 < psi < 78251032547928251/10^17 /\
  (forall x, is_threshold 1 x -> x = psi) /\ 1418315335578850/10^15 < / sin psi < 1418315335578851/10^15.
Proof. threshold 1 (78251032547928250/10^17) (78251032547928251/10^17). Qed.
Theorem threshold_at_2 : exists psi, is_threshold 2 psi /\ 43956897744261313/10^17 < psi < 43956897744261314/10^17 /\
  (forall x, is_threshold 2 x -> x = psi) /\ 2349903126955640/10^15 < / sin psi < 2349903126955641/10^15.
Proof. threshold 2 (43956897744261313/10^17) (43956897744261314/10^17). Qed.
Theorem threshold_at_3 : exists psi, is_threshold 3 psi /\ 27900041809555304/10^17 < psi < 27900041809555305/10^17 /\
  (forall x, is_threshold 3 x -> x = psi) /\ 3631149872444794/10^15 < / sin psi < 3631149872444795/10^15.
Proof. threshold 3 (27900041809555304/10^17) (27900041809555305/10^17). Qed.
Theorem threshold_at_4 : exists psi, is_threshold 4 psi /\ 19205592348801668/10^17 < psi < 19205592348801669/10^17 /\
  (forall x, is_threshold 4 x -> x = psi) /\ 5238964357601738/10^15 < / sin psi < 5238964357601739/10^15.
Proof. threshold 4 (19205592348801668/10^17) (19205592348801669/10^17). Qed.

(* Fig. 8 and Fig. 9 print amplitudes in units of alpha g at which the block is said not to overturn without impact.
   They are above the threshold of the linear block, which overturns there. *)
Lemma overturns_above w a alpha p psi threshold x v :
  0 < alpha -> 0 < p -> 0 < w -> 0 < psi <= PI / 2 -> is_threshold w threshold -> / sin threshold < a -> / sin psi =
    a ->
  is_the_motion alpha p (w * p) psi x v -> (forall t, 0 < t -> x t < 0) /\ forall m, exists T, forall t, T < t -> x t
    < m.
Proof.
  intros A P W I [X Z] B S M; assert (L := PI_RGT_0).
  apply (threshold_of_the_motion alpha p (w * p) psi A P ltac:(nra) ltac:(lra) x v M).
  replace (w * p / p) with w by (field; lra); apply (sign_of_excess w threshold psi); try lra.
  apply Rnot_le_lt; intro N; assert (H : threshold < PI / 2).
  { apply Rnot_le_lt; intro; assert (E := excess_negative w threshold W); lra. }
  assert (D : sin threshold <= sin psi) by (apply sin_incr_1; lra).
  assert (E : 0 < sin threshold) by (apply sin_gt_0; lra).
  assert (F : / sin psi <= / sin threshold) by (apply Rinv_le_contravar; lra); lra.
Qed.
Theorem claim_c54_figure_8_is_not_linear alpha p psi x v :
  0 < alpha -> 0 < p -> 0 < psi <= PI / 2 -> / sin psi = 235766/10^5 -> is_the_motion alpha p (2 * p) psi x v ->
  (forall t, 0 < t -> x t < 0) /\ forall m, exists T, forall t, T < t -> x t < m.
Proof.
  intros A P I S; destruct threshold_at_2 as [c [X [_ [_ C]]]].
  apply (overturns_above 2 (235766/10^5) alpha p psi c); try assumption; lra.
Qed.
Theorem claim_c55_figure_9_is_not_linear alpha p psi x v :
  0 < alpha -> 0 < p -> 0 < psi <= PI / 2 -> / sin psi = 53230/10^4 -> is_the_motion alpha p (4 * p) psi x v ->
  (forall t, 0 < t -> x t < 0) /\ forall m, exists T, forall t, T < t -> x t < m.
Proof.
  intros A P I S; destruct threshold_at_4 as [c [X [_ [_ C]]]].
  apply (overturns_above 4 (53230/10^4) alpha p psi c); try assumption; lra.
Qed.
