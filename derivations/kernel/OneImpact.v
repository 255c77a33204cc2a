(* An amplitude at which a block just overturns after one impact, (86) and (88), for omega_p/p = 3 and alpha = 1/4: the
   only one with psi in [3/4, 21/25]. That there is no smaller one is not proved.
   Angles are in units of alpha/(10 sin psi), times in units of 1/p. *)
From Rederive Require Import Rederive Bounds Solutions.
From Coquelicot Require Import Coquelicot.

(* Before the impact: (57a) with (70) is sin psi N - cos psi D. *)
Definition N t := 9 * ((exp t + exp (- t)) / 2) + cos (3 * t) - 10.
Definition D t := 3 * ((exp t - exp (- t)) / 2) - sin (3 * t).
Definition E t := (exp t + exp (- t)) / 2 - cos (3 * t).
Definition F t := (exp t - exp (- t)) / 2 + 3 * sin (3 * t).
Definition G t := (exp t + exp (- t)) / 2 + 9 * cos (3 * t).
Lemma N_derivative t : is_derive N t (3 * D t). Proof. unfold N, D; auto_derive; [ trivial | field ]. Qed.
Lemma D_derivative t : is_derive D t (3 * E t). Proof. unfold D, E; auto_derive; [ trivial | field ]. Qed.
Lemma E_derivative t : is_derive E t (F t). Proof. unfold E, F; auto_derive; [ trivial | field ]. Qed.
Lemma F_derivative t : is_derive F t (G t). Proof. unfold F, G; auto_derive; [ trivial | field ]. Qed.
Definition before psi t := sin psi * N t - cos psi * D t.
Definition before_rate psi t := 3 * (sin psi * D t - cos psi * E t).
Lemma before_derivative psi t : is_derive (before psi) t (before_rate psi t).
Proof. unfold before, before_rate; assert (A := N_derivative t); assert (B := D_derivative t); derivatives; ring. Qed.
Ltac at_zero := rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0, ?cos_0; lra.

Section First.
Variable psi : R.
Hypothesis range : 3 / 4 <= psi <= 21 / 25.
Lemma starts_to_the_left t : 0 < t <= 1 / 8 -> before psi t < 0.
Proof.
  intro T.
  assert (C : forall x, 0 < x <= 1 / 8 -> 0 < cos psi * F x - 3 * sin psi * E x).
  { intros x X; replace 0 with (cos psi * F 0 - 3 * sin psi * E 0) by (unfold F, E; at_zero).
    apply (grows (fun x => cos psi * F x - 3 * sin psi * E x) (fun x => cos psi * G x - 3 * sin psi * F x));
      [ lra | |].
    - intros y _; assert (A := F_derivative y); assert (B := E_derivative y); derivatives; ring.
    - intros y Y; assert (0 <= y <= 1 / 8) by lra; unfold F, G; interval with (i_prec 40, i_bisect y, i_bisect psi). }
  assert (B : forall x, 0 < x <= 1 / 8 -> 0 < cos psi * E x - sin psi * D x).
  { intros x X; replace 0 with (cos psi * E 0 - sin psi * D 0) by (unfold D, E; at_zero).
    apply (grows (fun x => cos psi * E x - sin psi * D x) (fun x => cos psi * F x - 3 * sin psi * E x)); [ lra | |].
    - intros y _; assert (P := E_derivative y); assert (Q := D_derivative y); derivatives; ring.
    - intros y Y; apply C; lra. }
  enough (- before psi 0 < - before psi t) by (unfold before, N, D in *;
    rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0, ?cos_0 in *; lra).
  apply (grows (fun x => - before psi x) (fun x => - before_rate psi x)); [ lra | |].
  - intros y _; assert (P := before_derivative psi y); derivatives; ring.
  - intros y Y; unfold before_rate; specialize (B y); lra.
Qed.
Lemma falls t : 1 / 8 <= t <= 1 / 2 -> before_rate psi t < 0.
Proof. intro T; unfold before_rate, D, E; interval with (i_prec 40, i_bisect t, i_bisect psi). Qed.
Lemma stays_left t : 1 / 2 <= t <= 9 / 10 -> before psi t < 0.
Proof. intro T; unfold before, N, D; interval with (i_prec 40, i_bisect t, i_bisect psi). Qed.
Lemma rises t : 9 / 10 <= t <= 6 / 5 -> 0 < before_rate psi t.
Proof. intro T; unfold before_rate, D, E; interval with (i_prec 40, i_bisect t, i_bisect psi). Qed.
Lemma is_back : 0 < before psi (6 / 5).
Proof. unfold before, N, D; interval with (i_prec 40, i_bisect psi). Qed.

Theorem first_impact : exists tau, 9 / 10 < tau < 6 / 5 /\ before psi tau = 0 /\ forall t, 0 < t < tau ->
  before psi t < 0.
Proof.
  assert (A : before psi (9 / 10) < 0) by (apply stays_left; lra).
  destruct (intermediate_value (before psi) (9 / 10) (6 / 5)) as [tau [I Z]].
  - lra.
  - intros; apply continuity_pt_filterlim, (ex_derive_continuous (before psi)); eexists; apply before_derivative.
  - left; split; [ exact A | exact is_back ].
  - assert (I' : 9 / 10 < tau < 6 / 5).
    { assert (B := is_back); split; apply Rnot_le_lt; intro L;
        [ assert (X : tau = 9 / 10) by lra | assert (X : tau = 6 / 5) by lra ]; rewrite X in Z; lra. }
    exists tau; split; [ exact I' | split; [ exact Z | intros t T ] ].
    destruct (Rle_dec t (1 / 8)) as [L | L]; [ apply starts_to_the_left; lra | ].
    destruct (Rle_dec t (1 / 2)) as [M | M].
    { assert (S : before psi (1 / 8) < 0) by (apply starts_to_the_left; lra).
      enough (- before psi (1 / 8) < - before psi t) by lra.
      apply (grows (fun x => - before psi x) (fun x => - before_rate psi x)); [ lra | |].
      - intros y _; assert (P := before_derivative psi y); derivatives; ring.
      - intros y Y; assert (Q := falls y); lra. }
    destruct (Rle_dec t (9 / 10)) as [O | O]; [ apply stays_left; lra | ].
    rewrite <- Z; apply (grows (before psi) (before_rate psi)); [ lra | |].
    + intros; apply before_derivative.
    + intros; apply rises; lra.
Qed.
End First.

(* Along the impacts psi is a function of tau, (86): cot psi = N/D. *)
Definition cot_psi t := N t / D t.
Lemma D_pos t : 9 / 10 <= t <= 6 / 5 -> 1 < D t.
Proof. intro T; unfold D; interval with (i_prec 40, i_bisect t). Qed.
Definition cot_rate t := 3 * (D t ^ 2 - N t * E t) / D t ^ 2.
Lemma cot_derivative t : 9 / 10 <= t <= 6 / 5 -> is_derive cot_psi t (cot_rate t).
Proof.
  intro T; assert (P := D_pos t T); unfold cot_psi, cot_rate; assert (A := N_derivative t);
    assert (B := D_derivative t).
  derivatives; [ lra | field; lra ].
Qed.
Lemma cot_rate_pos t : 9 / 10 <= t <= 6 / 5 -> 1 / 2 < cot_rate t < 2.
Proof.
  intro T; assert (P := D_pos t T); unfold cot_rate, N, D, E in *; split; interval with (i_prec 40, i_bisect t).
Qed.
Lemma cot_grows a b : 9 / 10 <= a -> a < b -> b <= 6 / 5 -> cot_psi a < cot_psi b.
Proof.
  intros A L B; apply (grows cot_psi cot_rate); [ exact L | intros; apply cot_derivative; lra | ].
  intros x X; assert (P := cot_rate_pos x); lra.
Qed.

(* After it, with e of (46): the growing part of theta - alpha at the end of the pulse, times 10/alpha, (88). *)
Definition e := 1 - 3 / 2 * sin (1 / 4) ^ 2.
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
Lemma margin_derivative t : 9 / 10 <= t <= 6 / 5 -> is_derive margin t (margin_rate (cot_psi t) (cot_rate t) t).
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
Lemma margin_grows_there t : 9 / 10 <= t <= 6 / 5 -> 0 < margin_rate (cot_psi t) (cot_rate t) t.
Proof.
  intro T; assert (P := D_pos t T); unfold margin_rate, impact_rate, impact, cot_rate, cot_psi, N, D, E, F, e in *.
  interval with (i_prec 40, i_bisect t, i_depth 12).
Qed.
Lemma margin_grows a b : 9 / 10 <= a -> a < b -> b <= 6 / 5 -> margin a < margin b.
Proof.
  intros A L B; apply (grows margin (fun t => margin_rate (cot_psi t) (cot_rate t) t)); [ exact L | |].
  - intros; apply margin_derivative; lra.
  - intros; apply margin_grows_there; lra.
Qed.

(* One impact time, and one psi, at which the margin is 0. *)
Ltac at_tau := unfold margin, margin_at, impact, cot_psi, N, D, E, e.
Theorem critical_impact : exists tau, 111081847951109070/10^17 < tau < 111081847951109071/10^17 /\ margin tau = 0.
Proof.
  destruct (intermediate_value margin (111081847951109070/10^17) (111081847951109071/10^17)) as [tau [I Z]].
  - lra.
  - intros x X; apply continuity_pt_filterlim, (ex_derive_continuous margin); eexists; apply margin_derivative; lra.
  - left; split; at_tau; interval with (i_prec 100).
  - assert (A : margin (111081847951109070/10^17) < 0) by (at_tau; interval with (i_prec 100)).
    assert (B : 0 < margin (111081847951109071/10^17)) by (at_tau; interval with (i_prec 100)).
    exists tau; repeat split; try exact Z; apply Rnot_le_lt; intro L;
      [ assert (X : tau = 111081847951109070/10^17) by lra | assert (X : tau = 111081847951109071/10^17) by lra ];
      rewrite X in Z; lra.
Qed.

(* What psi is at an impact. *)
Section At_impact.
Variables psi tau : R.
Hypotheses (range : 3 / 4 <= psi <= 21 / 25) (inside : 9 / 10 < tau < 6 / 5) (impact_at : before psi tau = 0).
Lemma sin_pos : 0 < sin psi. Proof. bounds. Qed.
Lemma cot_is : cot_psi tau = cos psi / sin psi.
Proof.
  assert (P := sin_pos); assert (Q := D_pos tau); unfold before, cot_psi in *.
  apply (Rmult_eq_reg_r (D tau * sin psi)); [ field_simplify; lra | nra ].
Qed.
Lemma psi_is : psi = PI / 2 - atan (cot_psi tau).
Proof.
  rewrite cot_is; assert (X : cos psi / sin psi = tan (PI / 2 - psi)) by (unfold tan; rewrite sin_shift, cos_shift;
    reflexivity); rewrite X.
  rewrite atan_tan; [ lra | split; bounds ].
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
(* The motion after it: a_3 sinh + a_4 cosh + sin + 10 sin psi, from 0. *)
Definition after s := a_3 * ((exp s - exp (- s)) / 2) + a_4 * ((exp s + exp (- s)) / 2) + sin (3 * (tau + s) +
  psi) + 10 * sin psi.
Definition after_rate s := a_3 * ((exp s + exp (- s)) / 2) + a_4 * ((exp s - exp (- s)) / 2) + 3 * cos (3 * (tau +
  s) + psi).
Lemma after_derivative s : is_derive after s (after_rate s).
Proof. unfold after, after_rate; auto_derive; [ trivial | field ]. Qed.
End At_impact.
Lemma stays_right psi tau s : 3 / 4 <= psi <= 7956 / 10000 -> 111 / 100 <= tau <= 6 / 5 -> 0 <= s <= 3 / 4 ->
  0 < after_rate psi tau s.
Proof.
  intros P T S; unfold after_rate, a_3, a_4, before_rate, D, E, e.
  interval with (i_prec 30, i_bisect s, i_bisect tau, i_bisect psi).
Qed.

(* The motion in time: x, u to the left from rest until t_i; y, v to the right until the end of the pulse, (46) at the
   impact; z, w when the ground is at rest. The amplitude is a_p = alpha g/sin psi, alpha is 1/4, omega_p is 3 p. *)
Definition solves (y v f : R -> R) := (forall t, is_derive y t (v t)) /\ forall t, is_derive v t (f t).
Section Motion.
Variables p psi t_i T_ex : R.
Variables x u y v z w : R -> R.
Let alpha := 1 / 4.
Let pulse t := alpha / sin psi * sin (3 * p * t + psi).
Definition rocks_with_one_impact :=
  (solves x u (fun t => p ^ 2 * x t + p ^ 2 * alpha - p ^ 2 * pulse t) /\ x 0 = 0 /\ u 0 = 0) /\
  (0 < t_i /\ x t_i = 0 /\ forall t, 0 < t < t_i -> x t < 0) /\
  (solves y v (fun t => p ^ 2 * y t - p ^ 2 * alpha - p ^ 2 * pulse t) /\ y t_i = 0 /\ v t_i = e * u t_i) /\
  T_ex = (2 * PI - psi) / (3 * p) /\
  (solves z w (fun t => p ^ 2 * z t - p ^ 2 * alpha) /\ z T_ex = y T_ex /\ w T_ex = v T_ex).
Hypotheses (p_pos : 0 < p) (range : 3 / 4 <= psi <= 21 / 25) (motion : rocks_with_one_impact).
Let k := alpha / (10 * sin psi).
Let tau := p * t_i.
Lemma k_pos : 0 < k. Proof. assert (P := sin_pos psi range); unfold k, alpha; pos. Qed.

Lemma to_the_left t : x t = k * before psi (p * t) /\ u t / p = k * before_rate psi (p * t).
Proof.
  destruct motion as [[[X U] [X0 U0]] _]; assert (P := sin_pos psi range).
  destruct (all_solutions p 0 p_pos x u (fun t => k * before psi (p * t)) (fun t => p * (k * before_rate psi (p * t)))
              (fun t => p ^ 2 * alpha - p ^ 2 * pulse t)) with (t := t) as [A B].
  - exact X.
  - intro s; specialize (U s); replace (p ^ 2 * x s + (p ^ 2 * alpha - p ^ 2 * pulse s)) with
      (p ^ 2 * x s + p ^ 2 * alpha - p ^ 2 * pulse s) by ring; exact U.
  - intro s; unfold before, before_rate, N, D, E; auto_derive; [ trivial | field ].
  - intro s; unfold pulse, k, before, before_rate, N, D, E; replace (3 * p * s) with (3 * (p * s)) by ring;
    rewrite sin_plus.
    auto_derive; [ trivial | field; lra ].
  - rewrite X0, U0 in A, B; unfold before, before_rate, N, D, E in A, B |- *.
    rewrite ?Rmult_0_r, ?Ropp_0, ?exp_0, ?sin_0, ?cos_0 in A, B; split; [ rewrite A; field; lra | rewrite B; field;
      lra ].
Qed.
Lemma impact_time : 9 / 10 < tau < 6 / 5 /\ before psi tau = 0.
Proof.
  destruct motion as [_ [[S [Z L]] _]]; destruct (first_impact psi range) as [r [I [Zr B]]]; assert (K := k_pos).
  assert (F : before psi tau = 0) by (destruct (to_the_left t_i) as [A _]; rewrite Z in A; unfold tau; nra).
  enough (Q : tau = r) by (rewrite Q; split; assumption).
  destruct (Rtotal_order tau r) as [H | [H | H]]; [ | exact H | ].
  - assert (before psi tau < 0) by (apply B; split; [ unfold tau; nra | exact H ]); lra.
  - assert (Q : 0 < r / p < t_i).
    { split; [ apply Rdiv_lt_0_compat; lra | apply (Rmult_lt_reg_r p); [ exact p_pos | ] ].
      unfold tau in H; replace (r / p * p) with r by (field; lra); lra. }
    specialize (L (r / p) Q); destruct (to_the_left (r / p)) as [A _]; replace (p * (r / p)) with r in A by (field;
      lra); nra.
Qed.
Lemma to_the_right t : y t = k * after psi tau (p * (t - t_i)) /\ v t / p = k * after_rate psi tau (p * (t - t_i)).
Proof.
  destruct motion as [_ [_ [[[Y V] [Y0 V0]] _]]]; assert (P := sin_pos psi range).
  destruct (all_solutions p t_i p_pos y v (fun t => k * after psi tau (p * (t - t_i)))
              (fun t => p * (k * after_rate psi tau (p * (t - t_i)))) (fun t => - p ^ 2 * alpha - p ^ 2 * pulse t))
                with (t := t) as [A B].
  - exact Y.
  - intro s; specialize (V s); replace (p ^ 2 * y s + (- p ^ 2 * alpha - p ^ 2 * pulse s)) with
      (p ^ 2 * y s - p ^ 2 * alpha - p ^ 2 * pulse s) by ring; exact V.
  - intro s; unfold after, after_rate; auto_derive; [ trivial | unfold Rminus; field ].
  - intro s; unfold pulse, k, after, after_rate; replace (3 * p * s) with (3 * (tau +
    p * (s - t_i))) by (unfold tau; ring).
    auto_derive; [ trivial | unfold Rminus; field; lra ].
  - destruct (to_the_left t_i) as [_ C]; change (p * t_i) with tau in C; rewrite Y0, V0 in A, B.
    assert (U : u t_i = p * (k * before_rate psi tau)) by (rewrite <- C; field; lra); rewrite U in A, B.
    replace (p * (t_i - t_i)) with 0 in A, B by ring.
    assert (S : after psi tau 0 = 0) by (unfold after, a_4; rewrite Rplus_0_r, Ropp_0, exp_0; field).
    assert (S' : after_rate psi tau 0 = e * before_rate psi tau) by (unfold after_rate, a_3;
      rewrite Rplus_0_r, Ropp_0, exp_0; field).
    rewrite S, S' in A, B; split; [ rewrite A; field; lra | rewrite B; field; lra ].
Qed.
Lemma at_the_end : z T_ex - alpha + w T_ex / p = k * (sin psi * margin tau).
Proof.
  destruct impact_time as [I F]; destruct motion as [_ [_ [_ [E [_ [Z W]]]]]]; assert (P := sin_pos psi range).
  destruct (to_the_right T_ex) as [A B]; rewrite Z, W, A, B, <- (margin_is psi tau range I F);
    unfold after, after_rate.
  assert (X : p * (T_ex - t_i) = end_of_pulse psi - tau) by (rewrite E; unfold end_of_pulse, tau; field; lra).
  rewrite X; replace (3 * (tau + (end_of_pulse psi - tau)) + psi) with (2 * PI) by (unfold end_of_pulse; field).
  rewrite sin_2PI, cos_2PI; unfold k; rewrite (exp_Ropp (end_of_pulse psi - tau));
    assert (G := exp_pos (end_of_pulse psi - tau)).
  field; lra.
Qed.
Lemma in_the_end t : z t = (z T_ex - alpha + w T_ex / p) / 2 * exp (p * (t - T_ex)) +
                           (z T_ex - alpha - w T_ex / p) / 2 * exp (- (p * (t - T_ex))) + alpha.
Proof.
  destruct motion as [_ [_ [_ [_ [[Z W] _]]]]].
  destruct (all_solutions p T_ex p_pos z w (fun _ => alpha) (fun _ => 0) (fun _ => - p ^ 2 * alpha)) with (t := t) as
    [A _].
  - exact Z.
  - intro s; specialize (W s); replace (p ^ 2 * z s + - p ^ 2 * alpha) with (p ^ 2 * z s - p ^ 2 * alpha) by ring;
    exact W.
  - intro; auto_derive; trivial.
  - intro; auto_derive; [ trivial | ring ].
  - rewrite A; unfold sinh, cosh; field; lra.
Qed.
(* Above the threshold it does not come back to 0; below it, it does. *)
Lemma overturns_to_the_right : psi <= 7956 / 10000 -> 111 / 100 <= tau -> 0 < margin tau ->
  (forall t, t_i < t <= T_ex -> 0 < y t) /\ (forall t, T_ex <= t -> 0 < z t) /\
    forall m, exists S, forall t, S < t -> m < z t.
Proof.
  intros A B M; destruct impact_time as [I F]; assert (K := k_pos); assert (P := sin_pos psi range).
  assert (E : T_ex = (2 * PI - psi) / (3 * p)) by (destruct motion as [_ [_ [_ [E _]]]]; exact E).
  assert (X : p * (T_ex - t_i) <= 3 / 4).
  { replace (p * (T_ex - t_i)) with ((2 * PI - psi) / 3 - tau) by (rewrite E; unfold tau; field; lra).
    apply Rle_trans with ((2 * PI - 3 / 4) / 3 - 111 / 100); [ lra | bounds ]. }
  assert (Y : forall t, t_i < t <= T_ex -> 0 < y t).
  { intros t T; destruct (to_the_right t) as [-> _]; apply Rmult_lt_0_compat; [ exact K | ].
    replace 0 with (after psi tau 0) by (unfold after, a_4; rewrite Rplus_0_r, Ropp_0, exp_0; field).
    apply (grows (after psi tau) (after_rate psi tau)); [ nra | intros; apply after_derivative | ].
    intros s S; apply stays_right; [ lra | lra | nra ]. }
  assert (G : 0 < z T_ex - alpha + w T_ex / p) by (rewrite at_the_end; exact (Rmult_lt_0_compat _ _ K
    (Rmult_lt_0_compat _ _ P M))).
  assert (L : t_i < T_ex).
  { apply (Rmult_lt_reg_l p); [ exact p_pos | ]; replace (p * T_ex) with ((2 * PI - psi) / 3) by (rewrite E; field;
    lra).
    change (p * t_i) with tau; apply Rlt_trans with (6 / 5); [ lra | bounds ]. }
  assert (Z : 0 < z T_ex) by (destruct motion as [_ [_ [_ [_ [_ [-> _]]]]]]; apply Y; lra).
  split; [ exact Y | split ].
  - intros t T; rewrite (in_the_end t).
    set (E' := exp (p * (t - T_ex))); set (F' := exp (- (p * (t - T_ex)))).
    assert (Q : 1 <= E') by (assert (X' := exp_ineq1_le (p * (t - T_ex))); unfold E'; nra).
    assert (R : 0 < F') by apply exp_pos.
    assert (U : E' * F' = 1) by (unfold E', F'; rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    assert (C : alpha = 1 / 4) by reflexivity; assert (F' <= 1) by nra.
    assert (V : z T_ex - alpha + w T_ex / p <= (z T_ex - alpha + w T_ex / p) * E') by nra.
    destruct (Rle_dec 0 (z T_ex - alpha - w T_ex / p)) as [W | W]; [ assert (0 <=
      (z T_ex - alpha - w T_ex / p) * F') by nra; lra | ].
    assert (z T_ex - alpha - w T_ex / p <= (z T_ex - alpha - w T_ex / p) * F') by nra; lra.
  - intro m; destruct (exponential_beats p ((z T_ex - alpha + w T_ex / p) / 2) ((z T_ex - alpha - w T_ex / p) / 2) (m
    - alpha))
      as [S H]; [ lra | lra | ].
    exists (S + T_ex); intros t T; rewrite (in_the_end t); specialize (H (t - T_ex)); lra.
Qed.
Lemma comes_back_from_the_right : margin tau < 0 -> forall m, exists S, forall t, S < t -> z t < m.
Proof.
  intros M m; assert (K := k_pos); assert (P := sin_pos psi range).
  assert (G : z T_ex - alpha + w T_ex / p < 0).
  { rewrite at_the_end; assert (0 < k * sin psi) by (apply Rmult_lt_0_compat; assumption); nra. }
  destruct (exponential_beats p (- ((z T_ex - alpha + w T_ex / p) / 2)) (- ((z T_ex - alpha - w T_ex / p) / 2))
    (alpha - m))
    as [S H]; [ lra | lra | ].
  exists (S + T_ex); intros t T; rewrite (in_the_end t); specialize (H (t - T_ex)); lra.
Qed.
End Motion.

(* The threshold: psi_c, and the amplitude 1/sin psi_c in units of alpha g. A smaller psi is a larger amplitude. *)
Theorem one_impact_at_3 : exists psi_c, 3 / 4 < psi_c < 21 / 25 /\ 1400099818153277/10^15 < / sin psi_c <
  1400099818153278/10^15 /\
  forall p psi t_i T_ex x u y v z w, 0 < p -> 3 / 4 <= psi <= 21 / 25 -> rocks_with_one_impact p psi t_i T_ex x u y v
    z w ->
    (psi < psi_c -> (forall t, t_i < t <= T_ex -> 0 < y t) /\ (forall t, T_ex <= t -> 0 < z t) /\
                    forall m, exists S, forall t, S < t -> m < z t) /\
    (psi_c < psi -> forall m, exists S, forall t, S < t -> z t < m).
Proof.
  destruct critical_impact as [c [C Z]]; exists (PI / 2 - atan (cot_psi c)).
  assert (B : 3 / 4 < PI / 2 - atan (cot_psi c) < 7956 / 10000) by (unfold cot_psi, N, D; split;
    interval with (i_prec 60)).
  split; [ lra | split; [ unfold cot_psi, N, D; split; interval with (i_prec 100) | ] ].
  intros p psi t_i T_ex x u y v z w P R H.
  destruct (impact_time p psi t_i T_ex x u y v z w P R H) as [I F]; assert (E := psi_is psi (p * t_i) R I F).
  split; intro L.
  - assert (G : c < p * t_i).
    { apply Rnot_le_lt; intros [N | N]; [ assert (G := cot_grows (p * t_i) c);
      assert (A := atan_increasing (cot_psi (p * t_i)) (cot_psi c)); lra | ].
      rewrite <- N in L; lra. }
    apply (overturns_to_the_right p psi t_i T_ex x u y v z w P R H); [ lra | lra | ].
    rewrite <- Z; apply margin_grows; lra.
  - assert (G : p * t_i < c).
    { apply Rnot_le_lt; intros [N | N]; [ assert (G := cot_grows c (p * t_i));
      assert (A := atan_increasing (cot_psi c) (cot_psi (p * t_i))); lra | ].
      rewrite N in L; lra. }
    apply (comes_back_from_the_right p psi t_i T_ex x u y v z w P R H).
    rewrite <- Z; apply margin_grows; lra.
Qed.

(* There is such a motion, whatever p and psi are. *)
Theorem one_impact_motion_exists p psi : 0 < p -> 3 / 4 <= psi <= 21 / 25 ->
  exists t_i T_ex x u y v z w, rocks_with_one_impact p psi t_i T_ex x u y v z w.
Proof.
  intros P R; destruct (first_impact psi R) as [tau [I [Z L]]]; assert (S := sin_pos psi R).
  set (k := 1 / 4 / (10 * sin psi)); assert (K : 0 < k) by (unfold k; apply Rdiv_lt_0_compat; lra).
  set (T := (2 * PI - psi) / (3 * p)).
  set (y := fun t => k * after psi tau (p * t - tau)); set (v := fun t => p * (k * after_rate psi tau (p * t - tau))).
  exists (tau / p), T, (fun t => k * before psi (p * t)), (fun t => p * (k * before_rate psi (p * t))), y, v,
    (fun t => v T / p * sinh (p * (t - T)) + (y T - 1 / 4) * cosh (p * (t - T)) + 1 / 4),
    (fun t => p * (v T / p * cosh (p * (t - T)) + (y T - 1 / 4) * sinh (p * (t - T)))).
  assert (Q : p * (tau / p) = tau) by (field; lra).
  unfold rocks_with_one_impact, solves; repeat match goal with |- _ /\ _ => split end.
  - intro s; unfold before, before_rate, N, D, E; auto_derive; [ trivial | field ].
  - intro s; unfold k, before, before_rate, N, D, E; replace (3 * p * s) with (3 * (p * s)) by ring; rewrite sin_plus.
    auto_derive; [ trivial | field; lra ].
  - unfold before, N, D; at_zero.
  - unfold before_rate, D, E; at_zero.
  - apply Rdiv_lt_0_compat; lra.
  - rewrite Q, Z; ring.
  - intros t X; assert (before psi (p * t) < 0); [ apply L | nra ].
    split; [ nra | rewrite <- Q; apply Rmult_lt_compat_l; lra ].
  - intro s; unfold y, v, after, after_rate; auto_derive; [ trivial | unfold Rminus; field ].
  - intro s; unfold y, v, k, after, after_rate; replace (3 * p * s) with (3 * (tau + (p * s - tau))) by ring.
    auto_derive; [ trivial | unfold Rminus; field; lra ].
  - unfold y; rewrite Q, Rminus_diag_eq by reflexivity; unfold after, a_4; rewrite Rplus_0_r, Ropp_0, exp_0; field.
  - unfold v; rewrite Q, Rminus_diag_eq by reflexivity; unfold after_rate, a_3; rewrite Rplus_0_r, Ropp_0, exp_0;
    field.
  - reflexivity.
  - intro s; unfold sinh, cosh; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - intro s; unfold sinh, cosh; auto_derive; [ trivial | unfold Rminus; field; lra ].
  - replace (T - T) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; ring.
  - replace (T - T) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; field; lra.
Qed.
