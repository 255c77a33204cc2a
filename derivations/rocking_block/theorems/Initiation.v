(* Rows between the equations of motion: geometry, the start of motion, sliding, and the phase of the pulse. *)
From Rederive Require Import Rederive.

(* Geometry: (u1), (2), (12). The block is turned about a corner, the vector to its centre of mass with it. *)
Section Geometry.
Variables b h R' alpha : R.
Hypotheses (b_pos : 0 < b) (h_pos : 0 < h) (R_pos : 0 < R').
Theorem derivation_32b : row{u1} -> row{32b}.
Proof. intros ->; now rewrite tan_atan. Qed.
Theorem derivation_42a : row{u1} -> R' ^ 2 = b ^ 2 + h ^ 2 -> row{42a} /\ h = R' * cos alpha.
Proof.
  intros A Q; assert (T := derivation_32b A); assert (P := pyth alpha).
  assert (C : 0 < cos alpha) by (rewrite A; destruct (atan_bound (b / h)); apply cos_gt_0; lra).
  assert (S : b * cos alpha = h * sin alpha).
  { replace (b * cos alpha) with (b / h * (h * cos alpha)) by (field; lra); rewrite T; unfold tan; field; lra. }
  assert (X : (R' * cos alpha) ^ 2 = h ^ 2).
  { rewrite Rpow_mult_distr, Q; transitivity ((b * cos alpha) ^ 2 + h ^ 2 * cos alpha ^ 2); [ ring | rewrite S;
    ring [P] ]. }
  assert (Y : h = R' * cos alpha) by (assert (0 < R' * cos alpha) by pos; nra).
  split; [ | exact Y ]; apply (Rmult_eq_reg_r (cos alpha)); [ rewrite S, Y; ring | lra ].
Qed.
Hypotheses (side_b : row{42a}) (side_h : h = R' * cos alpha).
Theorem derivation_2b_12b x_c theta :
  (x_c = b - (b * cos theta + h * sin theta) -> row{2b}) /\ (x_c = b - (b * cos theta - h * sin theta) -> row{12b}).
Proof. split; intros ->; [ rewrite sin_plus | rewrite sin_minus ]; rewrite side_b, side_h; ring. Qed.
(* The same vector's height, over that at rest, h. *)
Theorem derivation_3_13 y_c theta :
  (y_c = h * cos theta - b * sin theta - h -> row{3}) /\ (y_c = h * cos theta + b * sin theta - h -> row{13}).
Proof. split; intros ->; [ rewrite cos_plus | rewrite cos_minus ]; rewrite side_b, side_h; ring. Qed.
Theorem derivation_42b : row{42b}.
Proof. rewrite side_b, side_h; assert (P := pyth alpha); field [P]. Qed.
End Geometry.

(* The start: H_0, V_0 are the reactions at the corner, lambda a_p is the acceleration of the ground. *)
Section Start.
Variables m g R' alpha p a_p lambda thetaddot_0 H_0 V_0 : R.
Hypotheses (m_pos : 0 < m) (g_pos : 0 < g) (R_pos : 0 < R') (angle : 0 < alpha < PI / 2).
Lemma cos_pos : 0 < cos alpha. Proof. assert (Q := PI_RGT_0); apply cos_gt_0; lra. Qed.
Lemma sin_pos : 0 < sin alpha. Proof. assert (Q := PI_RGT_0); apply sin_gt_0; lra. Qed.
Let b := R' * sin alpha.
Let h := R' * cos alpha.
Theorem derivation_24a : m * a_p * R' * cos alpha >= m * g * R' * sin alpha <-> row{24a}.
Proof.
  assert (C := cos_pos); unfold tan; assert (K : 0 < m * R' * cos alpha) by pos.
  assert (E : g * (sin alpha / cos alpha) - a_p = / (m * R' * cos alpha) * (m * g * R' * sin alpha - m * a_p * R' *
    cos alpha))
    by (field; lra).
  assert (L := Rinv_0_lt_compat _ K); split; intro; nra.
Qed.
Hypotheses (equation_25b : row{25b}) (equation_26b : row{26b}).
Hypothesis equation_27 : forall J_c, row{u2} -> row{27}.
Theorem derivation_28a : row{28b} -> row{28a}.
Proof.
  intro P; assert (C := cos_pos); assert (S := sin_pos); assert (E := equation_27 _ eq_refl).
  rewrite equation_25b, equation_26b in E; unfold h, b in E; rewrite P; unfold tan.
  apply (Rmult_eq_reg_l (4 / 3 * m * R' ^ 2)); [ | apply Rgt_not_eq; pos ].
  transitivity (m * g * R' * sin alpha - m * R' * cos alpha * (lambda * a_p)); [ assert (Q := pyth alpha) | field;
    lra ].
  replace (4 / 3 * m * R' ^ 2 * thetaddot_0) with
    (m * (lambda * a_p + R' * cos alpha * thetaddot_0) * (R' * cos alpha) - m * (g - R' * sin alpha * thetaddot_0) *
      (R' * sin alpha) +
     m * R' ^ 2 / 3 * thetaddot_0 + m * g * R' * sin alpha - m * R' * cos alpha * (lambda * a_p)) by (field [Q]).
  rewrite E; ring.
Qed.
Theorem derivation_u11_u17 : 0 < p -> row{28a} ->
  (thetaddot_0 = 0 <-> row{u17, u_gddot_0 := lambda * a_p}).
Proof.
  intros P ->; assert (C := cos_pos); assert (S := sin_pos); assert (T : 0 < tan alpha) by (unfold tan; pos).
  apply (eq_by (- (p ^ 2 * sin alpha / (g * tan alpha)))); [ nz | field; lra ].
Qed.
Theorem derivation_51a : row{u17, u_gddot_0 := lambda * a_p} -> row{51a, u_gddot_0 := lambda * a_p}.
Proof.
  intro L; assert (C := cos_pos); assert (P := pyth alpha); assert (E := equation_27 _ eq_refl).
  assert (T : lambda * a_p * cos alpha = g * sin alpha) by (rewrite L; unfold tan; field; lra).
  assert (Z : thetaddot_0 = 0).
  { rewrite equation_25b, equation_26b in E; unfold h, b in E; apply (Rmult_eq_reg_l (4 / 3 * m * R' ^ 2)); [ | nz ].
    transitivity (m * (lambda * a_p + R' * cos alpha * thetaddot_0) * (R' * cos alpha) -
      m * (g - R' * sin alpha * thetaddot_0) * (R' * sin alpha) + m * R' ^ 2 / 3 * thetaddot_0 -
      m * R' * (lambda * a_p * cos alpha - g * sin alpha)); [ field [P] | rewrite E, T; ring ]. }
  rewrite equation_25b, equation_26b, Z; field; lra.
Qed.
Theorem derivation_32a mu : row{u11} -> (row{30} <-> row{32a}).
Proof.
  intro L; assert (C := cos_pos); replace (b / h) with (H_0 / V_0); [ reflexivity | ].
  rewrite (derivation_51a L), L; unfold tan, b, h; field; lra.
Qed.
Theorem derivation_31 mu : thetaddot_0 = 3 / 4 * (g / R') * sin alpha * (1 - lambda * a_p / (g * tan alpha)) ->
  V_0 <> 0 ->
  (row{30} <->
   row{31}).
Proof.
  intros E N; set (q := lambda * a_p / (g * tan alpha)) in *.
  assert (A : H_0 = m * (lambda * a_p - 3 / 4 * g * cos alpha * sin alpha * (q - 1))) by (rewrite equation_25b, E;
    unfold h; field; lra).
  assert (B : V_0 = m * (g + 3 / 4 * g * sin alpha ^ 2 * (q - 1))) by (rewrite equation_26b, E; unfold b; field; lra).
  set (d := g + 3 / 4 * g * sin alpha ^ 2 * (q - 1)) in *.
  assert (D : d <> 0) by (intro Z; apply N; rewrite B, Z; ring).
  rewrite A, B; match goal with |- (mu >= ?x <-> mu >= ?y) => replace x with y by (field; lra) end; reflexivity.
Qed.
End Start.
Theorem derivation_24b m g R' alpha a_p_min : 0 < m -> 0 < g -> 0 < R' -> 0 < alpha < PI / 2 ->
  let turns a_p := m * a_p * R' * cos alpha >= m * g * R' * sin alpha in
  (turns a_p_min /\ (forall a_p, turns a_p -> a_p_min <= a_p) <-> row{24b}).
Proof.
  intros M G R A turns; assert (E : forall a_p, turns a_p <-> a_p >= g * tan alpha) by (intro;
    apply derivation_24a; assumption).
  split.
  - intros [T L]; apply E in T; assert (Q : turns (g * tan alpha)) by (apply E; lra); specialize (L _ Q); lra.
  - intros ->; split; [ apply E; lra | intros a_p Q; apply E in Q; lra ].
Qed.
Theorem derivation_u10b m g R' alpha a_p lambda : 0 < m -> 0 < g -> 0 < R' -> 0 < alpha < PI / 2 -> 0 < a_p ->
  (m * (lambda * a_p) * R' * cos alpha >= m * g * R' * sin alpha <-> row{u10b}).
Proof.
  intros M G R A P; rewrite derivation_24a by assumption.
  assert (E : g * tan alpha <= lambda * a_p <-> g * tan alpha / a_p <= lambda) by (apply (le_by a_p);
    [ exact P | field; lra ]).
  split; intro H; apply Rle_ge, E, Rge_le, H.
Qed.
Theorem derivation_u10a a_p lambda omega_p psi : 0 < a_p -> lambda * a_p = a_p * sin (omega_p * 0 + psi) -> row{u10a}.
Proof. intros A E; assert (B := SIN_bound (omega_p * 0 + psi)); nra. Qed.

(* Coulomb: the block slides unless |H| < mu V. H changes its sign while the block rocks; (33) is of H >= 0. *)
Section Friction.
Variables mu H V alpha b h g u_gddot_0 : R.
Hypotheses (presses : 0 < V) (pushes : 0 <= H).
Lemma quotient : Rabs H / V = H / V. Proof. now rewrite Rabs_pos_eq. Qed.
Theorem derivation_33 : Rabs H < mu * V <-> row{33}.
Proof. rewrite <- quotient; apply (lt_by V); [ exact presses | field; lra ]. Qed.
Theorem derivation_50c : Rabs H <= mu * V <-> row{50c}.
Proof. rewrite <- quotient; apply (le_by V); [ exact presses | field; lra ]. Qed.
Theorem derivation_51c : row{50c} -> row{51a, H_0 := H, V_0 := V} -> row{51b} -> row{51c}.
Proof. lra. Qed.
Theorem derivation_55b : row{33} -> row{51a, H_0 := H, V_0 := V} -> row{51b} -> row{55a} ->
  row{55b}.
Proof. lra. Qed.
End Friction.

(* The phase: the pulse lasts while omega_p t + psi goes from 0 to 2 pi. *)
Section Phase.
Variables omega_p psi a_p g alpha : R.
Hypothesis omega_pos : 0 < omega_p.
Theorem derivation_52b_52c t : 0 <= omega_p * t + psi <= 2 * PI <-> row{52b} /\ row{52c}.
Proof.
  assert (A : 0 <= omega_p * t + psi <-> - psi / omega_p <= t) by (apply (le_by omega_p); [ lra | field; lra ]).
  assert (B : omega_p * t + psi <= 2 * PI <-> t <= (2 * PI - psi) / omega_p) by (apply (le_by omega_p);
    [ lra | field; lra ]).
  tauto.
Qed.
Theorem derivation_u20 T_ex : omega_p * T_ex + psi = 2 * PI <-> row{u20}.
Proof. apply (eq_by omega_p); [ lra | field; lra ]. Qed.
Theorem derivation_u28 T_ex : omega_p * T_ex + PI / 2 + psi = 2 * PI <-> row{u28}.
Proof. apply (eq_by omega_p); [ lra | field; lra ]. Qed.
Theorem derivation_53a : row{53a, u_gddot_0 := a_p * sin (omega_p * 0 + psi)}.
Proof. now rewrite Rmult_0_r, Rplus_0_l. Qed.
Theorem derivation_53b u_gddot_0 lambda : row{53a} -> u_gddot_0 = lambda * a_p ->
  row{53b}.
Proof. congruence. Qed.
Theorem derivation_53c lambda : 0 < a_p -> - (PI / 2) <= psi <= PI / 2 -> row{53b} ->
  row{53c}.
Proof.
  intros A P E; assert (S : lambda = sin psi) by (apply (Rmult_eq_reg_l a_p); lra).
  rewrite S; symmetry; now apply asin_sin.
Qed.
Theorem derivation_54 lambda : 0 < a_p -> row{53c} -> row{u18} ->
  row{54}.
Proof. intros A -> E; f_equal; rewrite <- E; field; lra. Qed.
Theorem derivation_u27a : row{u27a, u_gddot_0 := a_p * cos (omega_p * 0 + psi)}.
Proof. now rewrite Rmult_0_r, Rplus_0_l. Qed.
Theorem derivation_u27b u_gddot_0 lambda : row{u27a} -> u_gddot_0 = lambda * a_p ->
  row{u27b}.
Proof. congruence. Qed.
Theorem derivation_u27c lambda : 0 < a_p -> 0 <= psi <= PI -> row{u27b} -> row{u27c}.
Proof.
  intros A P E; assert (S : lambda = cos psi) by (apply (Rmult_eq_reg_l a_p); lra).
  rewrite S; symmetry; now apply acos_cos.
Qed.
Theorem derivation_u27d lambda : cos psi <> 0 -> row{u27b} -> row{u11} ->
  row{u27d}.
Proof. intros C E L; rewrite <- L, <- E; field; exact C. Qed.
End Phase.
