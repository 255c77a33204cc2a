(* The responses of the linear model: what solves (56), (61) and (97), its rate, its constants, and its values at the
   end of the pulse and at the impact. sinh and cosh are Coq's; derivatives are Coquelicot's. *)
From Rederive Require Import Rederive Solutions.
From Coquelicot Require Import Coquelicot.

(* The linear block is turned by theta. (56), (61) and (97) are hypotheses of the theorems. *)
Section Linear.
Variables g alpha p omega_p psi a_p : R.
Hypotheses (g_pos : 0 < g) (alpha_pos : 0 < alpha) (p_pos : 0 < p) (omega_pos : 0 < omega_p).
Variables theta thetadot : R -> R.
Hypothesis moves : forall t, is_derive theta t (thetadot t).
Definition obeys force := forall t, is_derive thetadot t (p ^ 2 * theta t + force t).

(* From a solution y_1 with the rate v_1: the response, its rate, and the constants from the start at t_0. *)
Lemma response t_0 force y_1 v_1 :
  obeys force -> (forall t, is_derive y_1 t (v_1 t) /\ is_derive v_1 t (p ^ 2 * y_1 t + force t)) ->
  exists A B, forall t, theta t = A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t.
Proof.
  intros E F; exists ((thetadot t_0 - v_1 t_0) / p), (theta t_0 - y_1 t_0); intro t.
  exact (proj1 (all_solutions p t_0 p_pos _ _ y_1 v_1 force moves E (fun t => proj1 (F t)) (fun t => proj2 (F t)) t)).
Qed.
Lemma rate t_0 A B y_1 v_1 :
  (forall t, theta t = A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t) ->
    (forall t, is_derive y_1 t (v_1 t)) ->
  forall t, thetadot t / p = A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0)) + v_1 t / p.
Proof. intros E F; exact (rate_of p t_0 p_pos theta thetadot y_1 v_1 A B moves F E). Qed.
(* The other way round: whatever the constants are, that satisfies the equation. *)
Lemma satisfies t_0 force y_1 v_1 A B :
  (forall t, is_derive y_1 t (v_1 t) /\ is_derive v_1 t (p ^ 2 * y_1 t + force t)) ->
  (forall t, theta t = A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t) -> obeys force.
Proof.
  intros F E t; assert (G : forall s, thetadot s = p * (A * cosh (p * (s - t_0)) + B * sinh (p * (s - t_0))) + v_1 s).
  { intro s; replace (thetadot s) with (p * (thetadot s / p)) by (field; lra).
    rewrite (rate t_0 A B y_1 v_1 E (fun t => proj1 (F t))); field; lra. }
  apply (is_derive_ext (fun t => p * (A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0))) + v_1 t)).
  - intro s; now rewrite G.
  - destruct (F t) as [_ D]; rewrite (E t); unfold sinh, cosh; derivatives; field.
Qed.
Lemma at_start t_0 A B : A * sinh (p * (t_0 - t_0)) + B * cosh (p * (t_0 - t_0)) = B /\
                         A * cosh (p * (t_0 - t_0)) + B * sinh (p * (t_0 - t_0)) = A.
Proof. replace (t_0 - t_0) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; lra. Qed.

(* The pulse a_p sin(omega_p t + psi), or with cos. *)
Let s := omega_p / p.
Lemma squares : 0 < omega_p ^ 2 + p ^ 2. Proof. nra. Qed.
Lemma sine_solves k t :
  is_derive (fun t => 1 / (1 + s ^ 2) * (a_p / g) * sin (omega_p * t + psi) + k) t (p * (s / (1 +
    s ^ 2) * (a_p / g) * cos (omega_p * t + psi))) /\
  is_derive (fun t => p * (s / (1 + s ^ 2) * (a_p / g) * cos (omega_p * t + psi))) t
    (p ^ 2 * (1 / (1 + s ^ 2) * (a_p / g) * sin (omega_p * t + psi) + k) +
      (- p ^ 2 * k - p ^ 2 * (a_p / g) * sin (omega_p * t + psi))).
Proof. assert (Q := squares); unfold s; split; (auto_derive; [ trivial | field; nra ]). Qed.
Lemma cosine_solves k a t :
  is_derive (fun t => a / (1 + s ^ 2) * cos (omega_p * t + psi) + k) t (p * (- a * s / (1 +
    s ^ 2) * sin (omega_p * t + psi))) /\
  is_derive (fun t => p * (- a * s / (1 + s ^ 2) * sin (omega_p * t + psi))) t
    (p ^ 2 * (a / (1 + s ^ 2) * cos (omega_p * t + psi) + k) + (- p ^ 2 * k - p ^ 2 * a * cos (omega_p * t + psi))).
Proof. assert (Q := squares); unfold s; split; (auto_derive; [ trivial | field; nra ]). Qed.
Lemma constant_solves k t : is_derive (fun _ : R => k) t ((fun _ => 0) t) /\
  is_derive (fun _ : R => 0) t (p ^ 2 * k + - p ^ 2 * k).
Proof. split; (auto_derive; [ trivial | ring ]). Qed.

Ltac by_response t_0 solution :=
  let E := fresh in let F := fresh in let A := fresh in let B := fresh in let t := fresh in
  intro E; unshelve edestruct (fun O => response t_0 _ _ _ O solution) as [A [B F]];
  [ intro t; specialize (E t);
    match type of E with is_derive _ _ ?d => match goal with |- is_derive _ _ ?c => replace c with d by (unfold Rdiv;
      ring) end end; exact E
  | exists A, B; intro t; rewrite (F t), ?Rminus_0_r; try solve [ unfold Rdiv; ring ] ].
Ltac by_converse t_0 solution :=
  let E := fresh in let F := fresh in let A := fresh in let B := fresh in let t := fresh in
  intros [A [B E]] t; unshelve epose proof (satisfies t_0 _ _ _ A B solution _ t) as F;
  [ intro; rewrite E, ?Rminus_0_r; try solve [ unfold Rdiv; ring ]
  | match type of F with is_derive _ _ ?d => match goal with |- is_derive _ _ ?c => replace c with d by (unfold Rdiv;
      ring) end end; exact F ].
Ltac both_ways t_0 solution := split; [ by_response t_0 solution | by_converse t_0 solution ].
Ltac by_rate t_0 A B solution E :=
  let F := fresh in let t := fresh in
  intro t; pose proof (fun O => rate t_0 A B _ _ O (fun t => proj1 (solution t)) t) as F; lapply F; clear F; intro F;
  [ rewrite F, ?Rminus_0_r | rewrite (E F), ?Rminus_0_r; try solve [ unfold Rdiv; ring ] ].
Ltac no_ground E :=
  match type of E with is_derive _ _ ?d => match goal with |- is_derive _ _ ?c => replace c with d by (field;
    lra) end end; exact E.
(* u21 *)
Lemma amplitude x : a_p / (g * alpha) = 1 / x -> x <> 0 -> a_p = g * alpha / x.
Proof. intros U N; transitivity (a_p / (g * alpha) * (g * alpha)); [ field; lra | rewrite U; field; lra ]. Qed.
(* u20 *)
Lemma end_of_sine T_ex : row{u20} -> omega_p * T_ex + psi = 2 * PI.
Proof. intros ->; field; lra. Qed.
Ltac fractions := assert (Q := squares); unfold s; field; repeat split; try lra; try assumption.

(* theta < 0. *)
Theorem derivation_57a :
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{56a}))) <->
  exists A_1 A_2, forall t,
  row{57a at t, omega_p/p := s}.
Proof. both_ways 0 (sine_solves (- alpha)). Qed.
Section Response_a.
Variables A_1 A_2 : R.
Hypothesis equation_57a : forall t, row{57a at t, omega_p/p := s}.
Hypotheses (equation_u21 : row{u21}) (starts : sin psi <> 0).
Theorem derivation_59a t : row{59a at t, omega_p/p := s}.
Proof. revert t; by_rate 0 A_1 A_2 (sine_solves (- alpha)) equation_57a; rewrite (amplitude _ equation_u21 starts);
  fractions. Qed.
Theorem derivation_58a : row{58a, thetadot_0 := thetadot 0, omega_p/p := s}.
Proof. rewrite (derivation_59a 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l; unfold cot; fractions. Qed.
Theorem derivation_58b : row{58b, theta_0 := theta 0, omega_p/p := s}.
Proof. rewrite (equation_57a 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l, (amplitude _ equation_u21 starts);
  fractions. Qed.
Theorem derivation_70a : thetadot 0 = 0 -> row{70a, omega_p/p := s}.
Proof. intro rest; rewrite derivation_58a, rest; fractions. Qed.
Theorem derivation_70b : theta 0 = 0 -> row{70b, omega_p/p := s}.
Proof. intro rest; rewrite derivation_58b, rest; fractions. Qed.
Theorem derivation_69a T_ex : row{u20} -> row{69a, theta_ex := theta T_ex}.
Proof. intro; rewrite (equation_57a T_ex), (end_of_sine T_ex), sin_2PI by assumption; ring. Qed.
Theorem derivation_69b T_ex : row{u20} ->
  row{69b, thetadot_ex := thetadot T_ex, omega_p/p := s}.
Proof. intro; rewrite (derivation_59a T_ex), (end_of_sine T_ex), cos_2PI by assumption; fractions. Qed.
Theorem derivation_84 t_i : row{84, theta_i := theta t_i, omega_p/p := s}.
Proof. rewrite (equation_57a t_i), (amplitude _ equation_u21 starts); fractions. Qed.
Theorem derivation_85 t_i : row{85, thetadot_before := thetadot t_i, omega_p/p := s}.
Proof. apply derivation_59a. Qed.
End Response_a.

(* theta > 0. *)
Theorem derivation_57b :
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{56b}))) <->
  exists A_3 A_4, forall t,
  row{57b at t, omega_p/p := s}.
Proof. both_ways 0 (sine_solves (alpha)). Qed.
Section Response_b.
Variables A_3 A_4 : R.
Hypothesis equation_57b : forall t, row{57b at t, omega_p/p := s}.
Hypotheses (equation_u21 : row{u21}) (starts : sin psi <> 0).
Theorem derivation_59b t : row{59b at t, omega_p/p := s}.
Proof. revert t; by_rate 0 A_3 A_4 (sine_solves (alpha)) equation_57b; rewrite (amplitude _ equation_u21 starts);
  fractions. Qed.
Theorem derivation_58c : row{58c, thetadot_0 := thetadot 0, omega_p/p := s}.
Proof. rewrite (derivation_59b 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l; unfold cot; fractions. Qed.
Theorem derivation_58d : row{58d, theta_0 := theta 0, omega_p/p := s}.
Proof. rewrite (equation_57b 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l, (amplitude _ equation_u21 starts);
  fractions. Qed.
Theorem derivation_77a : thetadot 0 = 0 -> row{77a, omega_p/p := s}.
Proof. intro rest; rewrite derivation_58c, rest; fractions. Qed.
Theorem derivation_77b : theta 0 = 0 -> row{77b, omega_p/p := s}.
Proof. intro rest; rewrite derivation_58d, rest; fractions. Qed.
Theorem derivation_76a T_ex : row{u20} -> row{76a, theta_ex := theta T_ex}.
Proof. intro; rewrite (equation_57b T_ex), (end_of_sine T_ex), sin_2PI by assumption; ring. Qed.
Theorem derivation_76b T_ex : row{u20} ->
  row{76b, thetadot_ex := thetadot T_ex, omega_p/p := s}.
Proof. intro; rewrite (derivation_59b T_ex), (end_of_sine T_ex), cos_2PI by assumption; fractions. Qed.
End Response_b.

(* theta > 0 after an impact at t_i. *)
Section After.
Variables t_i : R.
Hypotheses (equation_u21 : row{u21}) (starts : sin psi <> 0).
Theorem derivation_79a :
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{56b}))) <->
  exists A_3 A_4, forall t,
  row{79a at t, omega_p/p := s}.
Proof.
  both_ways t_i (sine_solves alpha); rewrite (amplitude _ equation_u21 starts); fractions.
Qed.
Variables A_3 A_4 : R.
Hypothesis equation_79a : forall t, row{79a at t, omega_p/p := s}.
Theorem derivation_79b t : row{79b at t, omega_p/p := s}.
Proof.
  revert t; by_rate t_i A_3 A_4 (sine_solves alpha) equation_79a; rewrite (amplitude _ equation_u21 starts);
    fractions.
Qed.
Theorem derivation_80a T_ex : row{u20} -> row{80a, theta_ex := theta T_ex}.
Proof. intro; rewrite (equation_79a T_ex), (end_of_sine T_ex), sin_2PI by assumption; fractions. Qed.
Theorem derivation_80b T_ex : row{u20} ->
  row{80b, thetadot_ex := thetadot T_ex, omega_p/p := s}.
Proof. intro; rewrite (derivation_79b T_ex), (end_of_sine T_ex), cos_2PI by assumption; fractions. Qed.
Theorem derivation_81 : row{u22, theta_i := theta t_i} -> row{81, omega_p/p := s}.
Proof. intro Z; rewrite (equation_79a t_i), (proj1 (at_start t_i A_3 A_4)) in Z; lra. Qed.
Theorem derivation_82 e thetadot_before : row{u23, thetadot_after := thetadot t_i} ->
  row{82, omega_p/p := s}.
Proof. intro Z; rewrite <- Z, (derivation_79b t_i), (proj2 (at_start t_i A_3 A_4)); ring. Qed.
End After.

(* The free motion after t_o: (61) is (56) where the ground is at rest. *)
Theorem derivation_61a : a_p = 0 ->
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{56a}))) ->
  forall t, is_derive thetadot t (p ^ 2 * theta t + right{61a}).
Proof. intros Z E t; specialize (E t); rewrite Z in E; no_ground E. Qed.
Theorem derivation_61b : a_p = 0 ->
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{56b}))) ->
  forall t, is_derive thetadot t (p ^ 2 * theta t + right{61b}).
Proof. intros Z E t; specialize (E t); rewrite Z in E; no_ground E. Qed.
Section Free.
Variables t_o T_ex t_i : R.

Theorem derivation_62a : (forall t, is_derive thetadot t (p ^ 2 * theta t + right{61a})) <->
  exists Abar_1 Abar_2, forall t, row{62a at t}.
Proof. both_ways t_o (constant_solves (- alpha)). Qed.
Section Free_a.
Variables Abar_1 Abar_2 : R.
Hypothesis equation_62a : forall t, row{62a at t}.
Theorem derivation_63a t : row{63a at t}.
Proof. revert t; by_rate t_o Abar_1 Abar_2 (constant_solves (- alpha)) equation_62a; field; lra. Qed.
Theorem derivation_64a : row{64a, thetadot_to := thetadot t_o}.
Proof. rewrite (derivation_63a t_o), (proj2 (at_start t_o Abar_1 Abar_2)); reflexivity. Qed.
Theorem derivation_64b : row{64b, theta_to := theta t_o}.
Proof. rewrite (equation_62a t_o), (proj1 (at_start t_o Abar_1 Abar_2)); ring. Qed.
Theorem derivation_66a : t_o = T_ex -> row{66a, thetadot_ex := thetadot T_ex}.
Proof. intros <-; exact derivation_64a. Qed.
Theorem derivation_66b : t_o = T_ex -> row{66b, theta_ex := theta T_ex}.
Proof. intros <-; exact derivation_64b. Qed.
Theorem derivation_89a t : t_o = T_ex ->
  row{89a at t, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}.
Proof. intros <-; rewrite <- derivation_64a, <- derivation_64b; apply equation_62a. Qed.
Theorem derivation_89b t : t_o = T_ex ->
  row{89b at t, theta_ex := theta T_ex, thetadot_ex := thetadot T_ex}.
Proof. intros <-; rewrite <- derivation_64a, <- derivation_64b; apply derivation_63a. Qed.
(* With the end of the pulse, (91), and theta(t_i) = 0. *)
Hypothesis equation_91a : row{91a, theta_ex := theta T_ex, omega_p/p := s}.
Hypothesis equation_91b : row{91b, thetadot_ex := thetadot T_ex, omega_p/p := s}.
Hypotheses (starts : sin psi <> 0) (no_right_angle : cos psi <> 0).
Theorem derivation_92a : t_o = T_ex -> row{u22, theta_i := theta t_i} ->
  row{92a, omega_p/p := s}.
Proof.
  intros E Z; assert (F := derivation_89a t_i E); rewrite Z, equation_91a, equation_91b in F; revert F.
  unfold cot, tan; intro F; apply (Rmult_eq_reg_l alpha); [ | lra ].
  match type of F with 0 = ?e => transitivity (- alpha - e); [ fractions | rewrite <- F; ring ] end.
Qed.
Theorem derivation_92b : t_o = T_ex ->
  row{92b, thetadot_before := thetadot t_i, omega_p/p := s}.
Proof.
  intro E; assert (F := derivation_89b t_i E); rewrite equation_91a, equation_91b in F; revert F.
  unfold cot, tan; intro F; transitivity (thetadot t_i / p * p); [ | rewrite F ]; fractions.
Qed.
End Free_a.

Theorem derivation_62b : (forall t, is_derive thetadot t (p ^ 2 * theta t + right{61b})) <->
  exists Abar_3 Abar_4, forall t, row{62b at t}.
Proof. both_ways t_o (constant_solves (alpha)). Qed.
Section Free_b.
Variables Abar_3 Abar_4 : R.
Hypothesis equation_62b : forall t, row{62b at t}.
Theorem derivation_63b t : row{63b at t}.
Proof. revert t; by_rate t_o Abar_3 Abar_4 (constant_solves (alpha)) equation_62b; field; lra. Qed.
Theorem derivation_64c : row{64c, thetadot_to := thetadot t_o}.
Proof. rewrite (derivation_63b t_o), (proj2 (at_start t_o Abar_3 Abar_4)); reflexivity. Qed.
Theorem derivation_64d : row{64d, theta_to := theta t_o}.
Proof. rewrite (equation_62b t_o), (proj1 (at_start t_o Abar_3 Abar_4)); ring. Qed.
Theorem derivation_73a : t_o = T_ex -> row{73a, thetadot_ex := thetadot T_ex}.
Proof. intros <-; exact derivation_64c. Qed.
Theorem derivation_73b : t_o = T_ex -> row{73b, theta_ex := theta T_ex}.
Proof. intros <-; exact derivation_64d. Qed.
End Free_b.

(* After an impact at t_i when the ground is at rest. *)
Theorem derivation_93a : (forall t, is_derive thetadot t (p ^ 2 * theta t + right{61b})) <->
  exists c_1 c_2, forall t, row{93a at t}.
Proof. both_ways t_i (constant_solves alpha). Qed.
Variables c_1 c_2 : R.
Hypothesis equation_93a : forall t, row{93a at t}.
Theorem derivation_93b t : row{93b at t}.
Proof. revert t; by_rate t_i c_1 c_2 (constant_solves alpha) equation_93a; field; lra. Qed.
Theorem derivation_u24 : row{u22, theta_i := theta t_i} -> row{u24}.
Proof. rewrite (equation_93a t_i), (proj1 (at_start t_i c_1 c_2)); lra. Qed.
Theorem derivation_u25a : row{u25a, thetadot_after := thetadot t_i}.
Proof. rewrite derivation_93b, (proj2 (at_start t_i c_1 c_2)); reflexivity. Qed.
End Free.

(* The cosine pulse, theta > 0: u29 is in (97). *)
Lemma cos_pi_minus x : cos (PI - x) = - cos x.
Proof. rewrite cos_minus, cos_PI, sin_PI; ring. Qed.
Section Cosine.
Hypothesis starts : cos psi <> 0.
Theorem derivation_98 :
  (forall t, is_derive thetadot t (p ^ 2 * theta t + (right{97}))) <->
  exists A_3 A_4, forall t, row{98 at t, omega_p/p := s}.
Proof. both_ways 0 (cosine_solves alpha (alpha / cos psi)); fractions. Qed.
Variables A_3 A_4 : R.
Hypothesis equation_98 : forall t, row{98 at t, omega_p/p := s}.
Theorem derivation_99 t : row{99 at t, omega_p/p := s}.
Proof. revert t; by_rate 0 A_3 A_4 (cosine_solves alpha (alpha / cos psi)) equation_98; fractions. Qed.
Theorem derivation_100a : row{100a, thetadot_0 := thetadot 0, omega_p/p := s}.
Proof. rewrite (derivation_99 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l; unfold tan; fractions. Qed.
Theorem derivation_100b : row{100b, theta_0 := theta 0, omega_p/p := s}.
Proof. rewrite (equation_98 0), !Rmult_0_r, cosh_0, sinh_0, Rplus_0_l; fractions. Qed.
(* At rest it is pushed to the other side. *)
Theorem derivation_r13 : theta 0 = 0 ->
  is_derive thetadot 0 (p ^ 2 * theta 0 - p ^ 2 * alpha - p ^ 2 * alpha * cos (omega_p * 0 + psi) / cos psi) ->
  is_derive thetadot 0 (right{r13}).
Proof.
  intros Z E; match type of E with is_derive _ _ ?d => replace (-2 * p ^ 2 * alpha) with d; [ exact E | ] end.
  rewrite Z, !Rmult_0_r, Rplus_0_l; field; exact starts.
Qed.
(* At rest it is pushed to theta > 0 from the phase pi - psi on. *)
Theorem derivation_r14 phi : 0 <= psi < PI / 2 -> 0 <= phi <= PI ->
  (0 <= p ^ 2 * 0 - p ^ 2 * alpha - p ^ 2 * alpha * cos phi / cos psi <-> PI - psi <= phi).
Proof.
  intros I J; assert (C : 0 < cos psi) by (apply cos_gt_0; lra); assert (K : 0 < p ^ 2 * alpha / cos psi) by pos.
  replace (_ - _) with (p ^ 2 * alpha / cos psi * (- cos psi - cos phi)) by (field; lra).
  rewrite <- (cos_pi_minus psi); split; intro L.
  - apply cos_decr_0; try lra; nra.
  - assert (D := cos_decr_1 (PI - psi) phi); apply Rmult_le_pos; lra.
Qed.
Lemma end_of_cosine T_ex : row{u28} -> omega_p * T_ex + psi = 3 * (PI / 2).
Proof. intros ->; field; lra. Qed.
Theorem derivation_101a T_ex : row{u28} -> row{101a, theta_ex := theta T_ex}.
Proof. intro; rewrite (equation_98 T_ex), (end_of_cosine T_ex), cos_3PI2 by assumption; fractions. Qed.
Theorem derivation_101b T_ex : row{u28} ->
  row{101b, thetadot_ex := thetadot T_ex, omega_p/p := s}.
Proof. intro; rewrite (derivation_99 T_ex), (end_of_cosine T_ex), sin_3PI2 by assumption; fractions. Qed.
End Cosine.
End Linear.
