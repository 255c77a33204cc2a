(* The amplitudes at which a block overturns after one impact, (86) with (88) and (92a) with (96), for omega_p/p = 3
   and alpha = 1/4. *)
From Rederive Require Import Rederive Bounds Solutions Limits Thresholds.
From Coquelicot Require Import Coquelicot.
From Rederive Require Import ImpactInPulse AfterImpact.

(* The first zero of a function that is negative at first and positive later. *)
Lemma first_zero f a b :
  (forall t : R, continuous f t) -> 0 < a -> (forall t, 0 < t <= a -> f t < 0) -> a < b -> 0 < f b ->
  exists c, 0 < c /\ f c = 0 /\ forall t, 0 < t < c -> f t < 0.
Proof.
  intros C A N L P; destruct (completeness (fun t => a <= t /\ forall s, 0 < s <= t -> f s < 0)) as [c [U M]].
  - exists b; intros t [_ B]; apply Rnot_lt_le; intro I; specialize (B b ltac:(lra)); lra.
  - exists a; split; [ lra | exact N ].
  - assert (K : a <= c) by (apply U; split; [ lra | exact N ]).
    assert (B : forall t, 0 < t < c -> f t < 0).
    { intros t T; apply Rnot_le_lt; intro S; enough (c <= t) by lra; apply M; intros s [_ W].
      apply Rnot_lt_le; intro I; specialize (W t ltac:(lra)); lra. }
    exists c; split; [ lra | split; [ | exact B ] ].
    assert (near : forall eps, 0 < eps -> exists d, 0 < d /\ forall t, Rabs (t - c) < d -> Rabs (f t - f c) < eps).
    { intros eps E; destruct (proj1 (filterlim_locally f (f c)) (C c) (mkposreal eps E)) as [d W].
      exists d; split; [ apply cond_pos | intros t T; exact (W t T) ]. }
    destruct (Rtotal_order (f c) 0) as [Z | [Z | Z]]; [ exfalso | exact Z | exfalso ].
    + destruct (near (- f c) ltac:(lra)) as [d [Q W]]; enough (c + d / 2 <= c) by lra; apply U; split; [ lra | ].
      intros s S; destruct (Rlt_dec s c) as [I | I]; [ apply B; lra | ].
      specialize (W s ltac:(rewrite Rabs_pos_eq; lra)); apply Rabs_def2 in W; lra.
    + destruct (near (f c) Z) as [d [Q W]].
      assert (X := Rmax_l (c - d / 2) (c / 2)); assert (Y := Rmax_r (c - d / 2) (c / 2)).
      assert (V : Rmax (c - d / 2) (c / 2) < c) by (apply Rmax_lub_lt; lra); set (s := Rmax _ _) in *.
      specialize (W s ltac:(rewrite Rabs_left1; lra)); apply Rabs_def2 in W; specialize (B s ltac:(lra)); lra.
Qed.
(* Which amplitudes lead to an impact: all below (71). *)
Lemma strikes p psi psi_a x u : 0 < p -> 0 < psi < PI -> is_threshold 3 psi_a -> is_the_motion (1 / 4) p (3 * p) psi x
  u ->
  ((exists t_i, first_impact x t_i) <-> psi_a < psi < PI / 2).
Proof.
  intros P R [A Z] M; assert (W : 3 * p / p = 3) by (field; lra).
  destruct (threshold_of_the_motion (1 / 4) p (3 * p) psi ltac:(lra) P ltac:(lra) R x u M) as [over [under _]].
  assert (at_it := no_impact_at_the_threshold (1 / 4) p (3 * p) psi ltac:(lra) P ltac:(lra) R x u M).
  rewrite W in *; assert (S := sign_of_excess 3 psi_a psi ltac:(lra) A Z R); split.
  - intros [t_i I]; split; [ | exact (first_impact_from_the_left p psi x u P R M t_i I) ].
    destruct I as [T [I _]]; apply Rnot_le_lt; intros [L | L].
    + destruct (over ltac:(tauto)) as [N _]; specialize (N t_i T); lra.
    + specialize (at_it ltac:(now rewrite L) t_i T); lra.
  - intros [L H]; destruct (starts_to_the_left p psi x u P R M H) as [a [Q N]].
    assert (E : excess 3 psi < 0).
    { apply Rnot_le_lt; intros [X | X]; [ apply S in X; lra | ].
      rewrite (threshold_is_unique 3 psi psi_a ltac:(lra) R A (eq_sym X) Z) in L; lra. }
    destruct (under E 0) as [T B]; assert (U := Rmax_l a T); assert (U' := Rmax_r a T).
    destruct M as [D _]; destruct (first_zero x a (Rmax a T + 1)) as [c I]; [ | lra | exact N | lra | apply B; lra | ].
    + intro; apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply D.
    + exists c; exact I.
Qed.

(* psi goes from 0 to pi, as for (71): the pulse starts at alpha g, and its amplitude is alpha g/sin psi. Below pi/2
   it grows at first and lifts the block to the left; from pi/2 on it falls at once, and nothing moves to the left.
   So 1/sin psi runs over all amplitudes above alpha g, in alpha g, and a smaller psi is a larger amplitude.
   The block comes back and strikes just at the amplitudes below (71), psi_a. Of these, just those between two
   thresholds overturn it after one impact: 1.40009..., psi_c, which is (86) with (88), and 3.49917..., psi_b, which
   is (92a) with (96). At each of the two it tends to the unstable equilibrium. Below the first, and from the second
   up to (71), 3.63114..., it comes back and strikes again; what it does then is not said.
   y is the motion to the right, which is the block's until it is 0 again. *)
Theorem one_impact_at_3 : exists psi_a psi_b psi_c, is_threshold 3 psi_a /\ psi_a < psi_b /\
  28982226002789352/10^17 < psi_b < 28982226002789353/10^17 /\
  79553019246260927/10^17 < psi_c < 79553019246260928/10^17 /\
  3499171892200844/10^15 < / sin psi_b < 3499171892200845/10^15 /\
  1400099818153277/10^15 < / sin psi_c < 1400099818153278/10^15 /\
  forall p psi x u, 0 < p -> 0 < psi < PI -> is_the_motion (1 / 4) p (3 * p) psi x u ->
    ((exists t_i, first_impact x t_i) <-> psi_a < psi < PI / 2) /\
    forall t_i y v, first_impact x t_i -> goes_on p psi u t_i y v ->
      (psi_b < psi < psi_c -> (forall t, t_i < t -> 0 < y t) /\ forall m, exists S, forall t, S < t -> m < y t) /\
      (psi = psi_b \/ psi = psi_c -> (forall t, t_i < t -> 0 < y t) /\ tends_to y (1 / 4)) /\
      (psi < psi_b \/ psi_c < psi -> exists t, t_i < t /\ y t = 0).
Proof.
  destruct threshold_at_3 as [psi_a [T [A _]]]; destruct critical_impact_behind as [psi_b [[B surplus_b] _]].
  destruct critical_impact as [c [crit _]]; assert (C := crit); destruct C as [C margin_c].
  exists psi_a, psi_b, (PI / 2 - atan (cot_psi c)).
  split; [ exact T | split; [ lra | split; [ exact B | ] ] ].
  assert (R : 79553019246260927/10^17 < PI / 2 - atan (cot_psi c) < 79553019246260928/10^17) by (unfold cot_psi, N, D;
    split; interval with (i_prec 80)).
  split; [ exact R | split; [ split; interval with (i_prec 80) | split ] ].
  { set (psi_c := PI / 2 - atan (cot_psi c)) in *; clearbody psi_c; split; interval with (i_prec 80). }
  intros p psi x u P I M; split; [ exact (strikes p psi psi_a x u P I T M) | intros t_i y v F G ].
  set (psi_c := PI / 2 - atan (cot_psi c)) in *; assert (X := last_is p psi P I).
  destruct (Rle_dec t_i (T_ex (3 * p) psi)) as [L | L].
  - destruct (during p psi x u P I M c t_i y v crit F G L) as [[J Z] [over [at_it under]]].
    set (tau := p * t_i) in *; assert (K := psi_is psi tau I J Z); assert (J' := tau_bound psi tau I J).
    assert (S := margin_sign c tau crit J').
    assert (low : 38 / 100 < psi).
    { assert (Q : cot_psi tau <= cot_psi (21 / 10)).
      { destruct (Req_dec tau (21 / 10)) as [-> | O]; [ lra | apply Rlt_le, cot_grows; lra ]. }
      assert (V : cot_psi (21 / 10) < 24 / 10) by (unfold cot_psi, N, D; interval with (i_prec 30)).
      assert (W := atan_increasing (cot_psi tau) (24 / 10) ltac:(lra)).
      assert (38 / 100 < PI / 2 - atan (24 / 10)) by (interval with (i_prec 30)); lra. }
    assert (order : forall a b, 0 < a -> a < b -> b <= 21 / 10 -> PI / 2 - atan (cot_psi b) < PI / 2 - atan (cot_psi
      a)).
    { intros a b Q V W; assert (Y := atan_increasing _ _ (cot_grows a b Q V W)); lra. }
    destruct (Rtotal_order tau c) as [Q | [Q | Q]].
    + assert (O := order tau c ltac:(lra) Q ltac:(lra)); fold psi_c in O; rewrite <- K in O.
      split; [ intros; lra | split; [ intros; lra | intros; apply under, S, Q ] ].
    + assert (O : psi = psi_c) by (rewrite K, Q; reflexivity).
      split; [ intros; lra | split; [ intros; apply at_it; rewrite Q; exact margin_c | intros; lra ] ].
    + assert (O := order c tau ltac:(lra) Q ltac:(lra)); fold psi_c in O; rewrite <- K in O.
      split; [ intros; apply over, S, Q | split; intros; lra ].
  - destruct (afterwards p psi x u P I M t_i y v F G ltac:(lra)) as [high [over [at_it under]]].
    split; [ intros; apply over | split; [ intros; apply at_it | intros; apply under ] ].
    + rewrite <- surplus_b; apply surplus_grows; lra.
    + replace psi with psi_b by lra; exact surplus_b.
    + rewrite <- surplus_b; apply surplus_grows; lra.
Qed.

(* There is such a motion, whatever p is, for each psi that leads to an impact. *)
Theorem one_impact_motion_exists p psi psi_a : 0 < p -> is_threshold 3 psi_a -> psi_a < psi < PI / 2 ->
  exists x u t_i y v, is_the_motion (1 / 4) p (3 * p) psi x u /\ first_impact x t_i /\ goes_on p psi u t_i y v.
Proof.
  intros P T R; assert (Q := PI_RGT_0); assert (I : 0 < psi < PI) by (destruct T; lra).
  destruct (threshold_instance (1 / 4) p (3 * p) psi P ltac:(lra) I) as [x [u M]].
  destruct (proj2 (strikes p psi psi_a x u P I T M) R) as [t_i F]; exists x, u, t_i.
  set (V := e * u t_i); set (k := 1 / 4 / (10 * sin psi)); assert (S := sine_pos psi I).
  set (last := T_ex (3 * p) psi).
  set (free y v b t := v / p * sinh (p * (t - b)) + (y - 1 / 4) * cosh (p * (t - b)) + 1 / 4).
  set (rate y v b t := v * cosh (p * (t - b)) + p * (y - 1 / 4) * sinh (p * (t - b))).
  assert (D1 : forall y v b t, is_derive (free y v b) t (rate y v b t)) by (intros; unfold free, rate, sinh, cosh;
    auto_derive; [ trivial | unfold Rminus; field; lra ]).
  assert (D2 : forall y v b t, is_derive (rate y v b) t (p ^ 2 * free y v b t - p ^ 2 * (1 / 4))) by (intros;
    unfold free, rate, sinh, cosh; auto_derive; [ trivial | unfold Rminus; field; lra ]).
  assert (E : forall y v b, free y v b b = y /\ rate y v b b = v) by (intros; unfold free, rate;
    rewrite Rminus_eq_0, Rmult_0_r, sinh_0, cosh_0; split; ring).
  destruct (Rle_dec last t_i) as [L | L].
  - exists (free 0 V t_i), (rate 0 V t_i); destruct (E 0 V t_i) as [E1 E2]; split; [ exact M | split; [ exact F | ] ].
    unfold goes_on; fold last; split; [ apply D1 | split; [ | split; [ exact E1 | split; [ exact E2 | split ] ] ] ].
    + intro; apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply D2.
    + intros; lra.
    + intros; apply D2.
  - destruct F as [F0 F1]; destruct (to_the_right_start p psi x u P I M t_i) as [Y0 V0]; [ fold last; lra | ].
    set (y := to_the_right p psi t_i) in *; set (v := to_the_right_rate p psi t_i) in *.
    assert (Dy : forall t, is_derive y t (v t)) by apply to_the_right_derivative.
    assert (Dv : forall t, is_derive v t (p ^ 2 * y t - p ^ 2 * (1 / 4) - p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t +
      psi))).
    { intro t; assert (O := to_the_right_solves p psi I t_i t); replace (_ - _ - _) with (p ^ 2 * y t +
        (- p ^ 2 * (1 / 4) - p ^ 2 * (1 / 4 / sin psi) * sin (3 * p * t + psi))) by ring; exact O. }
    destruct (E (y last) (v last) last) as [E1 E2].
    assert (Gy := glued y v (free (y last) (v last) last) (rate (y last) (v last) last) last Dy
      (D1 (y last) (v last) last) (eq_sym E1) (eq_sym E2)).
    assert (Gv := glued v _ (rate (y last) (v last) last) _ last Dv (D2 (y last) (v last) last) (eq_sym E2)).
    cbv beta in Gv; rewrite E1 in Gv; specialize (Gv ltac:(unfold last, T_ex; replace (3 * p * ((2 * PI - psi) / (3 *
      p)) + psi) with (2 * PI) by (field; lra); rewrite sin_2PI; ring)).
    exists (fun t => if Rle_dec t last then y t else free (y last) (v last) last t),
      (fun t => if Rle_dec t last then v t else rate (y last) (v last) last t).
    split; [ exact M | split; [ split; assumption | unfold goes_on; fold last ] ].
    destruct (Rle_dec t_i last) as [_ | N]; [ | lra ].
    split; [ exact Gy | split; [ | split; [ exact Y0 | split; [ exact V0 | split ] ] ] ].
    + intro; apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply Gv.
    + intros t J; specialize (Gv t); destruct (Rle_dec t last); [ exact Gv | lra ].
    + intros t J J'; specialize (Gv t); destruct (Rle_dec t last); [ lra | exact Gv ].
Qed.
