(* An impact while the pulse lasts, (86), and the motion after it, (88), for omega_p/p = 3 and alpha = 1/4.
   Angles are in units of alpha/(10 sin psi), times in units of 1/p. *)
From Rederive Require Import Rederive Bounds Solutions.
From Coquelicot Require Import Coquelicot.

(* Before the impact: (57a) with (70) is sin psi N - cos psi D. *)
Definition N t := 9 * ((exp t + exp (- t)) / 2) + cos (3 * t) - 10.
Definition D t := 3 * ((exp t - exp (- t)) / 2) - sin (3 * t).
Definition E t := (exp t + exp (- t)) / 2 - cos (3 * t).
Definition F t := (exp t - exp (- t)) / 2 + 3 * sin (3 * t).
Definition G t := (exp t + exp (- t)) / 2 + 9 * cos (3 * t).
Definition H t := (exp t - exp (- t)) / 2 - 27 * sin (3 * t).
Lemma N_derivative t : is_derive N t (3 * D t). Proof. unfold N, D; auto_derive; [ trivial | field ]. Qed.
Lemma D_derivative t : is_derive D t (3 * E t). Proof. unfold D, E; auto_derive; [ trivial | field ]. Qed.
Lemma E_derivative t : is_derive E t (F t). Proof. unfold E, F; auto_derive; [ trivial | field ]. Qed.
Lemma F_derivative t : is_derive F t (G t). Proof. unfold F, G; auto_derive; [ trivial | field ]. Qed.
Lemma G_derivative t : is_derive G t (H t). Proof. unfold G, H; auto_derive; [ trivial | field ]. Qed.
Definition before psi t := sin psi * N t - cos psi * D t.
Definition before_rate psi t := 3 * (sin psi * D t - cos psi * E t).

(* Near 0: what is 0 there and has a positive derivative is positive. *)
Lemma from_zero f d b : f 0 = 0 -> (forall x : R, is_derive f x (d x)) -> (forall x, 0 < x <= b -> 0 < d x) ->
  forall t, 0 < t <= b -> 0 < f t.
Proof. intros Z I S t T; rewrite <- Z; apply (grows f d); [ lra | auto | intros; apply S; lra ]. Qed.
Section Near_zero.
Variables N D E F G H : R -> R.
Variable b : R.
Hypotheses (N' : forall t, is_derive N t (3 * D t)) (D' : forall t, is_derive D t (3 * E t))
  (E' : forall t, is_derive E t (F t)) (F' : forall t, is_derive F t (G t)) (G' : forall t, is_derive G t (H t))
  (N0 : N 0 = 0) (D0 : D 0 = 0) (E0 : E 0 = 0) (F0 : F 0 = 0)
  (G_pos : forall t, 0 < t <= b -> 0 < G t) (H_neg : forall t, 0 < t <= b -> H t < 0).
Ltac rises f d :=
  apply (from_zero f d);
  [ rewrite ?N0, ?D0, ?E0, ?F0; ring
  | let x := fresh in intro x; assert (N1 := N' x); assert (D1 := D' x); assert (E1 := E' x); assert (F1 := F' x);
    assert (G1 := G' x);
    derivatives; ring
  | intros t T ].
Lemma near_zero s : 0 < s <= b -> (0 < D s /\ 0 < N s) /\ 0 < s * D s - N s /\ 0 < D s * D s - N s * E s.
Proof.
  assert (PF : forall t, 0 < t <= b -> 0 < F t) by (rises F G; auto).
  assert (PE : forall t, 0 < t <= b -> 0 < E t) by (rises E F; auto).
  assert (PD : forall t, 0 < t <= b -> 0 < D t) by (rises D (fun t => 3 * E t); specialize (PE t T); lra).
  assert (PN : forall t, 0 < t <= b -> 0 < N t) by (rises N (fun t => 3 * D t); specialize (PD t T); lra).
  assert (A : forall t, 0 < t <= b -> 0 < t * F t - E t) by (rises (fun t => t * F t - E t) (fun t => t * G t);
    apply Rmult_lt_0_compat; [ lra | now apply G_pos ]).
  assert (B : forall t, 0 < t <= b -> 0 < 3 * t * E t - 2 * D t) by (rises (fun t => 3 * t * E t - 2 * D t)
    (fun t => 3 * (t * F t - E t)); specialize (A t T); lra).
  assert (C : forall t, 0 < t <= b -> 0 < t * D t - N t) by (rises (fun t => t * D t - N t)
    (fun t => 3 * t * E t - 2 * D t); auto).
  assert (P : forall t, 0 < t <= b -> 0 < 6 * E t * F t - D t * G t).
  { rises (fun t => 6 * E t * F t - D t * G t) (fun t => 6 * F t * F t + 3 * E t * G t - D t * H t).
    specialize (PF t T); specialize (PE t T); specialize (PD t T); specialize (G_pos t T); specialize (H_neg t T).
    assert (0 < F t * F t) by nra; assert (0 < E t * G t) by nra; assert (0 < D t * - H t) by nra; lra. }
  assert (Q : forall t, 0 < t <= b -> 0 < 9 * E t * E t - N t * G t).
  { rises (fun t => 9 * E t * E t - N t * G t) (fun t => 18 * E t * F t - 3 * D t * G t - N t * H t).
    specialize (P t T); specialize (PN t T); specialize (H_neg t T); assert (0 < N t * - H t) by nra; lra. }
  assert (R : forall t, 0 < t <= b -> 0 < 3 * D t * E t - N t * F t) by (rises (fun t => 3 * D t * E t - N t * F t)
    (fun t => 9 * E t * E t - N t * G t); auto).
  assert (S : forall t, 0 < t <= b -> 0 < D t * D t - N t * E t) by (rises (fun t => D t * D t - N t * E t)
    (fun t => 3 * D t * E t - N t * F t); auto).
  intro T; repeat split; auto.
Qed.
End Near_zero.
Ltac at_zero := unfold N, D, E, F, G, H; rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0, ?cos_0; lra.
Lemma near_the_start t :
  0 < t <= 1 / 2 -> (0 < D t /\ 0 < N t) /\ 0 < t * D t - N t /\ 0 < D t * D t - N t * E t.
Proof.
  apply (near_zero N D E F G H (1 / 2) N_derivative D_derivative E_derivative F_derivative G_derivative);
    [ at_zero | at_zero | at_zero | at_zero | |]; clear t; intros t T.
  - destruct T; unfold G; interval with (i_prec 30, i_bisect t).
  - enough (0 < - H t) by lra; revert t T; apply (from_zero _ (fun t => 81 * cos (3 * t) - (exp t + exp (- t)) / 2)).
    + at_zero.
    + intro; unfold H; auto_derive; [ trivial | field ].
    + intros t [A B]; interval with (i_prec 30, i_bisect t).
Qed.

(* The whole pulse lasts for less than 21/10. *)
Lemma D_pos t : 0 < t <= 21 / 10 -> 0 < D t.
Proof.
  intro T; destruct (Rle_dec t (1 / 2)); [ apply near_the_start; lra | assert (1 / 2 <= t <= 21 / 10) by lra ].
  unfold D; interval with (i_prec 30, i_bisect t).
Qed.
Lemma convex t : 0 < t <= 21 / 10 -> 0 < D t * D t - N t * E t.
Proof.
  intro T; destruct (Rle_dec t (1 / 2)); [ apply near_the_start; lra | assert (1 / 2 <= t <= 21 / 10) by lra ].
  unfold D, N, E; interval with (i_prec 30, i_bisect t).
Qed.
(* Along the impacts psi is a function of tau, (86): cot psi = N/D, which grows. *)
Definition cot_psi t := N t / D t.
Definition cot_rate t := 3 * (D t * D t - N t * E t) / (D t * D t).
Lemma cot_derivative t : 0 < t <= 21 / 10 -> is_derive cot_psi t (cot_rate t).
Proof.
  intro T; assert (P := D_pos t T); unfold cot_psi, cot_rate; assert (A := N_derivative t);
    assert (B := D_derivative t).
  derivatives; [ lra | field; lra ].
Qed.
Lemma cot_grows a b : 0 < a -> a < b -> b <= 21 / 10 -> cot_psi a < cot_psi b.
Proof.
  intros A L B; apply (grows cot_psi cot_rate); [ exact L | intros; apply cot_derivative; lra | intros x X ].
  assert (P := D_pos x ltac:(lra)); assert (Q := convex x ltac:(lra)); unfold cot_rate; apply Rdiv_lt_0_compat; nra.
Qed.

(* After it, with e of (46): the growing part of theta - alpha at the end of the pulse, times 10/alpha, (88). *)
Definition e := right{46b, alpha := 1 / 4}.
Definition impact c t := 3 * e * (D t - c * E t) - 10 - (c * sin (3 * t) +
  cos (3 * t)) - 3 * (c * cos (3 * t) - sin (3 * t)).
Definition impact_rate c c' t :=
  3 * e * (3 * E t - c' * E t - c * F t) - (c' * sin (3 * t) + 3 * c * cos (3 * t) - 3 * sin (3 * t)) -
  3 * (c' * cos (3 * t) - 3 * c * sin (3 * t) - 3 * cos (3 * t)).
Definition margin_at c t := impact c t * exp ((3 * PI / 2 + atan c) / 3 - t) + 3 * sqrt (1 + c ^ 2).
Definition margin t := margin_at (cot_psi t) t.
Definition margin_rate c c' t :=
  (impact_rate c c' t + impact c t * (c' / (3 * (1 + c ^ 2)) - 1)) * exp ((3 * PI / 2 + atan c) / 3 - t) +
  3 * c * c' / sqrt (1 + c ^ 2).
Lemma margin_derivative t : 0 < t <= 21 / 10 -> is_derive margin t (margin_rate (cot_psi t) (cot_rate t) t).
Proof.
  intro T; assert (C := cot_derivative t T); unfold margin, margin_at, margin_rate, impact_rate, impact.
  assert (A := D_derivative t); assert (B := E_derivative t).
  assert (Q : 0 < 1 + cot_psi t ^ 2) by nra; assert (S := sqrt_lt_R0 _ Q).
  set (r := fun t => sqrt (1 + cot_psi t ^ 2)); set (a := fun t => atan (cot_psi t)).
  assert (U : is_derive r t (cot_psi t * cot_rate t / r t)).
  { apply (is_derive_ext (fun t => sqrt (1 + cot_psi t * cot_psi t))); [ intro; unfold r; f_equal; ring | unfold r ].
    replace (1 + cot_psi t ^ 2) with (1 + cot_psi t * cot_psi t) in * by ring; derivatives; [ lra | field; lra ]. }
  assert (V : is_derive a t (cot_rate t / (1 + cot_psi t ^ 2))).
  { unfold a; derivatives; unfold Rsqr; field; lra. }
  change (sqrt (1 + cot_psi t ^ 2)) with (r t) in *; change (atan (cot_psi t)) with (a t).
  apply (is_derive_ext (fun t => (3 * e * (D t - cot_psi t * E t) - 10 - (cot_psi t * sin (3 * t) + cos (3 * t)) -
    3 * (cot_psi t * cos (3 * t) - sin (3 * t))) * exp ((3 * PI / 2 + a t) / 3 - t) + 3 * r t)); [ reflexivity | ].
  clearbody r a; derivatives; unfold Rdiv; field; lra.
Qed.
Ltac at_tau := unfold margin, margin_at, impact, cot_psi, N, D, E, e.
Lemma margin_early t : 0 < t <= 1 / 2 -> margin t < 0.
Proof.
  intro T; destruct (near_the_start t T) as [[P A] [B _]].
  assert (C : 0 <= cot_psi t <= 1 / 2).
  { unfold cot_psi; split; [ apply Rle_mult_inv_pos; lra | apply (Rmult_le_reg_r (D t)); [ exact P | ] ].
    unfold Rdiv at 1; rewrite Rmult_assoc, Rinv_l; nra. }
  unfold margin, margin_at, impact, D, E, e; set (c := cot_psi t) in *; assert (T' : 0 <= t <= 1 / 2) by lra.
  clearbody c; clear - C T'; interval with (i_prec 30, i_bisect t, i_bisect c).
Qed.
Lemma margin_grows a b : 1 <= a -> a < b -> b <= 6 / 5 -> margin a < margin b.
Proof.
  intros A L B; apply (grows margin (fun t => margin_rate (cot_psi t) (cot_rate t) t)); [ exact L | |].
  - intros; apply margin_derivative; lra.
  - intros t T; assert (1 <= t <= 6 / 5) by lra; unfold margin_rate, impact_rate, impact, cot_rate, cot_psi, N, D, E,
    F, e.
    interval with (i_prec 30, i_bisect t).
Qed.
Lemma margin_before t : 1 / 2 <= t <= 1 -> margin t < 0.
Proof. intro T; at_tau; interval with (i_prec 30, i_bisect t). Qed.
Lemma margin_behind t : 6 / 5 <= t <= 21 / 10 -> 0 < margin t.
Proof. intro T; at_tau; interval with (i_prec 30, i_bisect t). Qed.
(* One impact time of all the pulse, and so one psi, at which the margin is 0: (86) and (88) have one solution. *)
Definition critical tau := 1110818479511090701377/10^21 < tau < 1110818479511090701378/10^21 /\ margin tau = 0.
Lemma margin_sign c t : critical c -> 0 < t <= 21 / 10 -> (t < c -> margin t < 0) /\ (c < t -> 0 < margin t).
Proof.
  intros [C Z] T; destruct (Rle_dec t (1 / 2)); [ assert (A := margin_early t); split; [ intros; apply A | ]; lra | ].
  destruct (Rle_dec t 1); [ assert (A := margin_before t); split; [ intros; apply A | ]; lra | ].
  destruct (Rle_dec (6 / 5) t); [ assert (A := margin_behind t); split; [ | intros; apply A ]; lra | ].
  split; intro L; [ assert (A := margin_grows t c) | assert (A := margin_grows c t) ]; lra.
Qed.
Theorem critical_impact :
  exists tau, critical tau /\ forall t, 0 < t <= 21 / 10 -> margin t = 0 -> t = tau.
Proof.
  assert (A : margin (1110818479511090701377/10^21) < 0) by (at_tau; interval with (i_prec 90)).
  assert (B : 0 < margin (1110818479511090701378/10^21)) by (at_tau; interval with (i_prec 90)).
  destruct (root_between margin (1110818479511090701377/10^21) (1110818479511090701378/10^21)) as [tau C];
    [ lra | | left; split; assumption | ].
  - intros x X; apply continuity_pt_filterlim, (ex_derive_continuous margin); eexists; apply margin_derivative; lra.
  - exists tau; split; [ exact C | intros t T Z; assert (S := margin_sign tau t C T) ].
    destruct (Rtotal_order t tau) as [L | [L | L]]; [ | exact L | ]; lra.
Qed.

(* What psi is at an impact while the pulse lasts, and the motion after it: a_3 sinh + a_4 cosh + sin + 10 sin psi. *)
Section At_impact.
Variables psi tau : R.
Hypotheses (range : 0 < psi < PI) (inside : 0 < tau <= (2 * PI - psi) / 3) (impact_at : before psi tau = 0).
Lemma sin_pos : 0 < sin psi. Proof. apply sin_gt_0; lra. Qed.
Lemma tau_bound : 0 < tau <= 21 / 10.
Proof. split; [ lra | apply Rle_trans with ((2 * PI - psi) / 3); [ lra | ] ]; assert (PI < 315 / 100) by bounds;
  lra. Qed.
Lemma cot_is : cot_psi tau = cos psi / sin psi.
Proof.
  assert (P := sin_pos); assert (Q := D_pos tau tau_bound); unfold before, cot_psi in *.
  apply (Rmult_eq_reg_r (D tau * sin psi)); [ field_simplify; lra | nra ].
Qed.
Lemma psi_is : psi = PI / 2 - atan (cot_psi tau).
Proof.
  rewrite cot_is; assert (X : cos psi / sin psi = tan (PI / 2 - psi)) by (unfold tan; rewrite sin_shift, cos_shift;
    reflexivity); rewrite X, atan_tan; lra.
Qed.
Lemma rate_pos : 0 < before_rate psi tau.
Proof.
  assert (P := sin_pos); assert (Q := D_pos tau tau_bound); assert (C := convex tau tau_bound).
  assert (X : cos psi * D tau = sin psi * N tau) by (unfold before in *; lra).
  apply (Rmult_lt_reg_l (D tau)); [ exact Q | ]; rewrite Rmult_0_r; unfold before_rate.
  replace (D tau * _) with (3 * (sin psi * (D tau * D tau - N tau * E tau))) by ring [X].
  assert (0 < sin psi * (D tau * D tau - N tau * E tau)) by (apply Rmult_lt_0_compat; assumption); lra.
Qed.
Lemma root_at : sqrt (1 + cot_psi tau ^ 2) = / sin psi.
Proof.
  assert (P := sin_pos); rewrite cot_is; apply root_is; [ apply Rlt_le, Rinv_0_lt_compat; lra | ].
  assert (Q := pyth psi); field_simplify; [ rewrite Q; field; lra | lra | lra ].
Qed.
Definition end_of_pulse := (2 * PI - psi) / 3.
Definition a_3 := e * before_rate psi tau - 3 * cos (3 * tau + psi).
Definition a_4 := - 10 * sin psi - sin (3 * tau + psi).
Lemma margin_is : (a_3 + a_4) * exp (end_of_pulse - tau) + 3 = sin psi * margin tau.
Proof.
  assert (P := sin_pos); unfold margin, margin_at; rewrite root_at; unfold impact.
  replace ((3 * PI / 2 + atan (cot_psi tau)) / 3 - tau) with (end_of_pulse - tau) by (unfold end_of_pulse;
    rewrite psi_is at 1; field).
  rewrite cot_is; unfold a_3, a_4, before_rate; rewrite sin_plus, cos_plus; field; lra.
Qed.
Definition after s := a_3 * ((exp s - exp (- s)) / 2) + a_4 * ((exp s + exp (- s)) / 2) + sin (3 * (tau + s) +
  psi) + 10 * sin psi.
Definition after_rate s := a_3 * ((exp s + exp (- s)) / 2) + a_4 * ((exp s - exp (- s)) / 2) + 3 * cos (3 * (tau +
  s) + psi).
Lemma after_derivative s : is_derive after s (after_rate s).
Proof. unfold after, after_rate; auto_derive; [ trivial | field ]. Qed.
Lemma after_rate_derivative s : is_derive after_rate s (after s - 10 * (sin (3 * (tau + s) + psi) + sin psi)).
Proof. unfold after, after_rate; auto_derive; [ trivial | field ]. Qed.
Lemma after_start : after 0 = 0 /\ after_rate 0 = e * before_rate psi tau.
Proof. unfold after, after_rate, a_3, a_4; rewrite Rplus_0_r, Ropp_0, exp_0; split; field. Qed.
Lemma after_end :
  after (end_of_pulse - tau) - 10 * sin psi + after_rate (end_of_pulse - tau) = sin psi * margin tau.
Proof.
  rewrite <- margin_is; unfold after, after_rate; replace (3 * (tau + (end_of_pulse - tau)) + psi) with (2 * PI) by
    (unfold end_of_pulse; field).
  rewrite sin_2PI, cos_2PI; field.
Qed.
(* Where it overturns it stays on the right: theta + thetadot, times exp (- s), rises until the phase is 2 pi - psi and
   falls then, and is positive at both ends. *)
Lemma e_pos : 0 < e < 1.
Proof. unfold e; split; bounds. Qed.
Lemma stays_right : psi <= PI / 2 -> PI / 3 <= tau -> 0 <= margin tau -> forall s, 0 < s <= end_of_pulse - tau -> 0 <
  after s.
Proof.
  intros Q L M s S; assert (P := sin_pos); assert (R := rate_pos); assert (K := e_pos); destruct after_start as [A B].
  assert (Z := after_end); set (last := end_of_pulse - tau) in *.
  set (V := fun s => (after_rate s + after s) * exp (- s)).
  set (V' := fun s => - (10 * (sin (3 * (tau + s) + psi) + sin psi) * exp (- s))).
  assert (Dv : forall s, is_derive V s (V' s)).
  { intro r; assert (A' := after_derivative r); assert (B' := after_rate_derivative r); unfold V, V'; derivatives;
    ring. }
  assert (V0 : 0 < V 0) by (unfold V; rewrite A, B, Ropp_0, exp_0; nra).
  assert (VT : 0 < V last) by (unfold V; assert (Y := exp_pos (- last)); apply Rmult_lt_0_compat; nra).
  assert (X : forall s, 0 < s <= last -> 0 < V s).
  { intros r I; assert (End : 3 * (tau + last) + psi = 2 * PI) by (unfold last, end_of_pulse; field).
    destruct (Rle_dec (3 * (tau + r) + psi) (2 * PI - psi)) as [O | O].
    - apply Rlt_le_trans with (V 0); [ exact V0 | apply (increases V V'); [ lra | intros; apply Dv | ] ].
      intros q J; unfold V'; assert (Y := exp_pos (- q)).
      assert (W : sin (3 * (tau + q) + psi) <= - sin psi).
      { replace (3 * (tau + q) + psi) with (3 * (tau + q) + psi - PI + PI) by ring; rewrite neg_sin.
        apply Ropp_le_contravar; destruct (Rle_dec (3 * (tau + q) + psi - PI) (PI / 2)).
        - apply sin_incr_1; lra.
        - rewrite <- (sin_PI_x (3 * (tau + q) + psi - PI)); apply sin_incr_1; lra. }
      nra.
    - apply Rlt_le_trans with (V last); [ exact VT | ].
      enough (- V r <= - V last) by lra; apply (increases (fun s => - V s) (fun s => - V' s)); [ lra | |].
      + intros q _; assert (Dq := Dv q); derivatives; ring.
      + intros q J; unfold V'; assert (Y := exp_pos (- q)); assert (W : - sin psi <= sin (3 * (tau + q) + psi)).
        { replace (3 * (tau + q) + psi) with (3 * (tau + q) + psi - 2 * PI + 2 * INR 1 * PI) by (simpl; ring).
          rewrite sin_period, <- sin_neg; apply sin_incr_1; lra. }
        nra. }
  enough (after 0 * exp 0 < after s * exp s) by (assert (Y := exp_pos s); rewrite A in *; nra).
  apply (grows (fun s => after s * exp s) (fun s => (after_rate s + after s) * exp s)); [ lra | |].
  - intros r _; assert (Dr := after_derivative r); derivatives; ring.
  - intros r I; assert (Y := X r ltac:(lra)); unfold V in Y; assert (U := exp_pos r); assert (U' := exp_pos (- r));
    nra.
Qed.
End At_impact.
