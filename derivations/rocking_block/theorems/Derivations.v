(* The equation of motion, from positions. Derivatives are Coquelicot's; the numbers are the paper's, and R' is its R.
   Before each derivation stands from what: the rows whose equations are its hypotheses, and what it assumes.
   newton, euler: the laws of motion. rotation: the block is rigid and turns about a corner. linearised: angles are
   small. rest: the block is at rest at theta = 0. criterion: the motion that just overturns tends to the
   equilibrium at theta = alpha (or - alpha), where it would stand on its corner. *)
From Rederive Require Import Rederive Solutions.
From Coquelicot Require Import Coquelicot.

(* Motion: the ground is at u_g, the block is turned by theta; side = 1 where theta < 0, -1 where theta > 0. *)
Section Motion.
Variables m g R' alpha side : R.
Hypotheses (m_pos : 0 < m) (g_pos : 0 < g) (R_pos : 0 < R') (sides : side ^ 2 = 1).
Variables u_g u_gdot u_gddot theta thetadot thetaddot : R -> R.
Hypothesis ground : forall t, is_derive u_g t (u_gdot t) /\ is_derive u_gdot t (u_gddot t).
Hypothesis angle : forall t, is_derive theta t (thetadot t) /\ is_derive thetadot t (thetaddot t).
Let b := R' * sin alpha.
Let J_c := m * R' ^ 2 / 3.
Let J_o := 4 / 3 * m * R' ^ 2.

(* (2), (12) and (3), (13): where the centre of mass is. *)
Definition x_c t := b - R' * sin (alpha + side * theta t).
Definition u_c t := u_g t - side * x_c t.
Definition y_c t := R' * (cos (alpha + side * theta t) - cos alpha).

Ltac differentiate :=
  match goal with |- is_derive _ ?t _ => destruct (ground t) as [? ?]; destruct (angle t) as [? ?] end; derivatives.

(* (4), (15) *)
(* from 2a, 2b, 12a, 12b *)
Theorem derivation_4a_15a t : is_derive u_c t (u_gdot t + R' * thetadot t * cos (alpha + side * theta t)).
Proof. unfold u_c, x_c; differentiate; ring [sides]. Qed.
(* from 3, 13 *)
Theorem derivation_4b_15b t : is_derive y_c t (- side * R' * thetadot t * sin (alpha + side * theta t)).
Proof. unfold y_c; differentiate; ring. Qed.

(* (5) and (6), (16): the kinetic energy as a function of the angle, its rate and the speed of the ground. *)
Definition K q v u := 1 / 2 * J_o * v ^ 2 + 1 / 2 * m * u ^ 2 + m * u * v * R' * cos (alpha + side * q).
Definition Omega q := m * g * R' * (cos (alpha + side * q) - cos alpha).
(* from 4a, 4b, 5, 15a, 15b, 16a, u2, u3b, u4 *)
Theorem derivation_6_16b q v u :
  1 / 2 * J_c * v ^ 2 + 1 / 2 * m * ((u + R' * v * cos (alpha + side * q)) ^ 2 + (- side * R' * v * sin (alpha +
    side * q)) ^ 2) =
  K q v u.
Proof. assert (P := pyth (alpha + side * q)); unfold K, J_c, J_o; field [P sides]. Qed.
(* (9), (14): the potential of the weight. *)
(* from 3, 13 *)
Theorem derivation_9_14 t : m * g * y_c t = Omega (theta t).
Proof. unfold y_c, Omega; ring. Qed.
(* (7), (8), (10): its partial derivatives, and the rate of the first along the motion. *)
(* from 6, 16b *)
Theorem derivation_7a_17a q v u : is_derive (fun v => K q v u) v (J_o * v + m * u * R' * cos (alpha + side * q)).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
(* from 7a, 17a *)
Theorem derivation_7b_17b t :
  is_derive (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)) t
    (J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
     side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
Proof. differentiate; ring. Qed.
(* from 6, 16b *)
Theorem derivation_8_18 q v u : is_derive (fun q => K q v u) q (- side * (m * u * v * R' * sin (alpha + side * q))).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
(* from 9, 14 *)
Theorem derivation_10_19 q : is_derive Omega q (- side * (m * g * R' * sin (alpha + side * q))).
Proof. unfold Omega; auto_derive; [ trivial | field ]. Qed.

(* Lagrange's equation (1) is (11), (20), and with p^2 = 3 g/(4 R') it is (21). *)
Definition lagrange t :=
  Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t -
  Derive (fun q => K q (thetadot t) (u_gdot t)) (theta t) + Derive Omega (theta t) = 0.
(* from 1, 7b, 8, 10, 17b, 18, 19 *)
Theorem derivation_11_20 t :
  lagrange t <-> J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
                 side * (m * g * R' * sin (alpha + side * theta t)) = 0.
Proof.
  assert (E : Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t =
              J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
              side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
  { rewrite (Derive_ext _ (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)))
      by (intro; apply is_derive_unique, derivation_7a_17a).
    apply is_derive_unique, derivation_7b_17b. }
  assert (F := is_derive_unique _ _ _ (derivation_8_18 (theta t) (thetadot t) (u_gdot t))).
  assert (G := is_derive_unique _ _ _ (derivation_10_19 (theta t))).
  unfold lagrange; rewrite E, G.
  setoid_rewrite F.
  apply (eq_by 1); [ lra | ring ].
Qed.
(* from 11, 20, u3b, u4, 28b *)
Theorem derivation_21a_21b p t :
  p ^ 2 = 3 * g / (4 * R') ->
  (lagrange t <-> thetaddot t + p ^ 2 * (u_gddot t / g * cos (alpha + side * theta t) - side * sin (alpha +
    side * theta t)) = 0).
Proof.
  intro P; rewrite derivation_11_20; apply (eq_by J_o); [ unfold J_o; apply Rgt_not_eq; pos | rewrite P; unfold J_o;
    field; lra ].
Qed.

(* Newton: the reactions H and V move the centre of mass. Its accelerations, (47) to (49), (25), (26). *)
Definition x_cdot t := - side * (R' * thetadot t * cos (alpha + side * theta t)).
Definition y_cdot t := - side * R' * thetadot t * sin (alpha + side * theta t).
Definition x_cddot t := - side * (R' * thetaddot t * cos (alpha + side * theta t)) +
  thetadot t ^ 2 * R' * sin (alpha + side * theta t).
Definition y_cddot t := - side * R' * thetaddot t * sin (alpha + side * theta t) - R' * thetadot t ^ 2 * cos (alpha +
  side * theta t).
(* from 48a *)
Theorem derivation_48b t : is_derive x_c t (x_cdot t).
Proof. unfold x_c, x_cdot; differentiate; ring. Qed.
(* from 48b *)
Theorem derivation_48c t : is_derive x_cdot t (x_cddot t).
Proof. unfold x_cdot, x_cddot; differentiate; ring [sides]. Qed.
(* from 49a *)
Theorem derivation_49b t : is_derive y_c t (y_cdot t).
Proof. unfold y_c, y_cdot; differentiate; ring. Qed.
(* from 49b *)
Theorem derivation_49c t : is_derive y_cdot t (y_cddot t).
Proof. unfold y_cdot, y_cddot; differentiate; ring [sides]. Qed.
(* from newton, 2a, 48c *)
Theorem derivation_47a H t : H = m * Derive (fun t => Derive u_c t) t <-> H = m * (u_gddot t - side * x_cddot t).
Proof.
  assert (E : Derive (fun t => Derive u_c t) t = u_gddot t - side * x_cddot t).
  { rewrite (Derive_ext _ (fun t => u_gdot t + R' * thetadot t * cos (alpha + side * theta t)))
      by (intro; apply is_derive_unique, derivation_4a_15a).
    apply is_derive_unique; unfold x_cddot; differentiate; ring [sides]. }
  now rewrite E.
Qed.
(* from newton, 49c *)
Theorem derivation_47b V t : V - m * g = m * Derive (fun t => Derive y_c t) t <-> V = m * (g + y_cddot t).
Proof.
  assert (E : Derive (fun t => Derive y_c t) t = y_cddot t).
  { rewrite (Derive_ext _ y_cdot) by (intro; apply is_derive_unique, derivation_49b).
    apply is_derive_unique, derivation_49c. }
  rewrite E; apply (eq_by 1); [ lra | ring ].
Qed.
(* At the start. *)
(* from 47a, 48c, rest *)
Theorem derivation_25a H t : theta t = 0 -> thetadot t = 0 ->
  H = m * (u_gddot t - side * x_cddot t) -> H = m * (u_gddot t + R' * thetaddot t * cos alpha).
Proof. intros A B ->; unfold x_cddot; rewrite A, B, Rmult_0_r, Rplus_0_r; ring [sides]. Qed.
(* from 47b, 49c, rest *)
Theorem derivation_26a V t : theta t = 0 -> thetadot t = 0 ->
  V = m * (g + y_cddot t) -> V = m * (g - side * R' * thetaddot t * sin alpha).
Proof. intros A B ->; unfold y_cddot; rewrite A, B, Rmult_0_r, Rplus_0_r; ring. Qed.
(* While it rocks: (21) put into them. *)
(* from 21a, 21b, 47a, 48c *)
Theorem derivation_50a_r1_r3 p H t :
  thetaddot t + p ^ 2 * (u_gddot t / g * cos (alpha + side * theta t) - side * sin (alpha + side * theta t)) = 0 ->
  H = m * (u_gddot t - side * x_cddot t) ->
  H / m = u_gddot t - p ^ 2 * R' * (u_gddot t / g * cos (alpha + side * theta t) ^ 2 -
            side * (sin (alpha + side * theta t) * cos (alpha + side * theta t))) - side * (thetadot t ^ 2 * R' * sin
              (alpha + side * theta t)).
Proof.
  intros E ->; assert (F : thetaddot t = - (p ^ 2 * (u_gddot t / g * cos (alpha +
    side * theta t) - side * sin (alpha + side * theta t)))) by lra.
  unfold x_cddot; rewrite F; field [sides]; lra.
Qed.
(* from 21a, 21b, 47b, 49c *)
Theorem derivation_50b_r2_r4 p V t :
  thetaddot t + p ^ 2 * (u_gddot t / g * cos (alpha + side * theta t) - side * sin (alpha + side * theta t)) = 0 ->
  V = m * (g + y_cddot t) ->
  V / m = g - p ^ 2 * R' * (sin (alpha + side * theta t) ^ 2 -
            side * (u_gddot t / g * sin (alpha + side * theta t) * cos (alpha +
              side * theta t))) - R' * thetadot t ^ 2 * cos (alpha + side * theta t).
Proof.
  intros E ->; assert (F : thetaddot t = - (p ^ 2 * (u_gddot t / g * cos (alpha +
    side * theta t) - side * sin (alpha + side * theta t)))) by lra.
  unfold y_cddot; rewrite F; field [sides]; lra.
Qed.
(* In contact with the ground: V > 0. *)
(* from r2, r4 *)
Theorem derivation_r7_r8 p V t : 0 < p ->
  V / m = g - p ^ 2 * R' * (sin (alpha + side * theta t) ^ 2 -
            side * (u_gddot t / g * sin (alpha + side * theta t) * cos (alpha +
              side * theta t))) - R' * thetadot t ^ 2 * cos (alpha + side * theta t) ->
  (V > 0 <->
   g + side * (p ^ 2 * R' * (u_gddot t / g * sin (2 * (alpha + side * theta t)) / 2 -
         side * sin (alpha + side * theta t) ^ 2 - side * (thetadot t ^ 2 / p ^ 2 * cos (alpha + side * theta t)))) >
           0).
Proof.
  intros P E; rewrite sin_2a; apply (lt_by m); [ exact m_pos | ].
  replace V with (V / m * m) by (field; lra); rewrite E; field [sides]; lra.
Qed.
(* It turns to theta < 0 from rest where the moment of the inertia force is the larger one, (11), (20). *)
(* from 11, rest *)
Theorem derivation_23 t : side = 1 -> lagrange t -> theta t = 0 ->
  (thetaddot t <= 0 <-> m * u_gddot t * R' * cos alpha >= m * g * R' * sin alpha).
Proof.
  intros S L A; apply derivation_11_20 in L; rewrite S, A, Rmult_0_r, Rplus_0_r in L.
  assert (J : 0 < J_o) by (unfold J_o; pos); split; intro; [ nra | ].
  apply Rnot_lt_le; intro K; assert (N := Rmult_lt_0_compat _ _ J K); lra.
Qed.
(* The reactions do no work, so that Lagrange's equation says what Newton's and Euler's say: the moments of H and V
   about the centre of mass turn the block. *)
(* from newton, euler, 2a, 2b, 3, 6, 9, 12a, 12b, 13, 14, 16b *)
Theorem derivation_1 H V t :
  H = m * Derive (fun t => Derive u_c t) t -> V - m * g = m * Derive (fun t => Derive y_c t) t ->
  (lagrange t <-> J_c * thetaddot t = side * (V * (R' * sin (alpha + side * theta t))) - H * (R' * cos (alpha +
    side * theta t))).
Proof.
  rewrite derivation_47a, derivation_47b; intros -> ->; rewrite derivation_11_20.
  assert (P := pyth (alpha + side * theta t)).
  apply (eq_by 1); [ lra | unfold x_cddot, y_cddot, J_o, J_c; field [P sides] ].
Qed.
(* from 25b, 26b, 11, 42a, rest *)
Theorem derivation_27 H V t : side = 1 -> lagrange t -> theta t = 0 ->
  H = m * (u_gddot t + R' * cos alpha * thetaddot t) -> V = m * (g - R' * sin alpha * thetaddot t) ->
  H * (R' * cos alpha) - V * (R' * sin alpha) + J_c * thetaddot t = 0.
Proof.
  intros S L A -> ->; apply derivation_11_20 in L; rewrite S, A, Rmult_0_r, Rplus_0_r in L; assert (P := pyth alpha).
  rewrite <- L; unfold J_o, J_c; field [P].
Qed.
(* At rest on the ground H is the ground's own. *)
(* from 47a, 48c, rest *)
Theorem derivation_u9a H t : theta t = 0 -> thetadot t = 0 -> thetaddot t = 0 ->
  H = m * (u_gddot t - side * x_cddot t) -> H = m * u_gddot t.
Proof. intros A B C ->; unfold x_cddot; rewrite B, C; ring. Qed.
(* from 11, u3b *)
Theorem derivation_u5 : sqrt (m * g * R' / J_o) = sqrt (3 * g / (4 * R')).
Proof. f_equal; unfold J_o; field; lra. Qed.
End Motion.

(* The ground that would hold the block at theta = alpha. *)
(* from 21a *)
Theorem derivation_u6 p g alpha u : 0 < p -> 0 < g -> cos (2 * alpha) <> 0 ->
  (0 + p ^ 2 * (u / g * cos (alpha + alpha) - sin (alpha + alpha)) = 0 <-> u = g * sin (2 * alpha) / cos (2 * alpha)).
Proof.
  intros P G C; replace (alpha + alpha) with (2 * alpha) by ring.
  apply (eq_by (p ^ 2 * cos (2 * alpha) / g)); [ nz | field; split; lra ].
Qed.
(* from 21b *)
Theorem derivation_u7 p g alpha u : 0 < p -> 0 < g ->
  (0 + p ^ 2 * (u / g * cos (alpha - alpha) + sin (alpha - alpha)) = 0 <-> u = 0).
Proof.
  intros P G; replace (alpha - alpha) with 0 by ring; rewrite cos_0, sin_0.
  apply (eq_by (p ^ 2 / g)); [ nz | field; lra ].
Qed.
