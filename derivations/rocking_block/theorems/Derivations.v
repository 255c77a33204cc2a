(* The equation of motion, from positions. Derivatives are Coquelicot's; the numbers are the paper's, and R' is its R.
   row{4a at t} is the row (4a) of the paper, which is written here before Coq reads the file. From which rows and
   assumptions each theorem follows is in theorems.toml. *)
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
Lemma sides_4a_15a t : is_derive u_c t (u_gdot t + R' * thetadot t * cos (alpha + side * theta t)).
Proof. unfold u_c, x_c; differentiate; ring [sides]. Qed.
Lemma sides_4b_15b t : is_derive y_c t (- side * R' * thetadot t * sin (alpha + side * theta t)).
Proof. unfold y_c; differentiate; ring. Qed.

(* (5) and (6), (16): the kinetic energy as a function of the angle, its rate and the speed of the ground. *)
Definition K q v u := 1 / 2 * J_o * v ^ 2 + 1 / 2 * m * u ^ 2 + m * u * v * R' * cos (alpha + side * q).
Definition Omega q := m * g * R' * (cos (alpha + side * q) - cos alpha).
Lemma sides_6_16b q v u :
  1 / 2 * J_c * v ^ 2 + 1 / 2 * m * ((u + R' * v * cos (alpha + side * q)) ^ 2 + (- side * R' * v * sin (alpha +
    side * q)) ^ 2) =
  K q v u.
Proof. assert (P := pyth (alpha + side * q)); unfold K, J_c, J_o; field [P sides]. Qed.
(* (9), (14): the potential of the weight. *)
Lemma sides_9_14 t : m * g * y_c t = Omega (theta t).
Proof. unfold y_c, Omega; ring. Qed.
(* (7), (8), (10): its partial derivatives, and the rate of the first along the motion. *)
Lemma sides_7a_17a q v u : is_derive (fun v => K q v u) v (J_o * v + m * u * R' * cos (alpha + side * q)).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
Lemma sides_7b_17b t :
  is_derive (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)) t
    (J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
     side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
Proof. differentiate; ring. Qed.
Lemma sides_8_18 q v u : is_derive (fun q => K q v u) q (- side * (m * u * v * R' * sin (alpha + side * q))).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
Lemma sides_10_19 q : is_derive Omega q (- side * (m * g * R' * sin (alpha + side * q))).
Proof. unfold Omega; auto_derive; [ trivial | field ]. Qed.

(* Lagrange's equation (1) is (11), (20), and with p^2 = 3 g/(4 R') it is (21). *)
Definition lagrange t := row{1, ddt_dK_dthetadot := Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t, dK_dtheta := Derive (fun q => K q (thetadot t) (u_gdot t)) (theta t), dOmega_dtheta := Derive Omega (theta t)}.
Lemma sides_11_20 t :
  lagrange t <-> J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
                 side * (m * g * R' * sin (alpha + side * theta t)) = 0.
Proof.
  assert (E : Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t =
              J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
              side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
  { rewrite (Derive_ext _ (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)))
      by (intro; apply is_derive_unique, sides_7a_17a).
    apply is_derive_unique, sides_7b_17b. }
  assert (F := is_derive_unique _ _ _ (sides_8_18 (theta t) (thetadot t) (u_gdot t))).
  assert (G := is_derive_unique _ _ _ (sides_10_19 (theta t))).
  unfold lagrange; rewrite E, G.
  setoid_rewrite F.
  apply (eq_by 1); [ lra | ring ].
Qed.
Lemma sides_21a_21b p t :
  row{28b} ->
  (lagrange t <-> thetaddot t + p ^ 2 * (u_gddot t / g * cos (alpha + side * theta t) - side * sin (alpha +
    side * theta t)) = 0).
Proof.
  intro P; rewrite sides_11_20; apply (eq_by J_o); [ unfold J_o; apply Rgt_not_eq; pos | rewrite P; unfold J_o;
    field; lra ].
Qed.

(* Newton: the reactions H and V move the centre of mass. Its accelerations, (47) to (49), (25), (26). *)
Definition x_cdot t := - side * (R' * thetadot t * cos (alpha + side * theta t)).
Definition y_cdot t := - side * R' * thetadot t * sin (alpha + side * theta t).
Definition x_cddot t := - side * (R' * thetaddot t * cos (alpha + side * theta t)) +
  thetadot t ^ 2 * R' * sin (alpha + side * theta t).
Definition y_cddot t := - side * R' * thetaddot t * sin (alpha + side * theta t) - R' * thetadot t ^ 2 * cos (alpha +
  side * theta t).
Lemma sides_48b t : is_derive x_c t (x_cdot t).
Proof. unfold x_c, x_cdot; differentiate; ring. Qed.
Lemma sides_48c t : is_derive x_cdot t (x_cddot t).
Proof. unfold x_cdot, x_cddot; differentiate; ring [sides]. Qed.
Lemma sides_49b t : is_derive y_c t (y_cdot t).
Proof. unfold y_c, y_cdot; differentiate; ring. Qed.
Lemma sides_49c t : is_derive y_cdot t (y_cddot t).
Proof. unfold y_cdot, y_cddot; differentiate; ring [sides]. Qed.
Lemma sides_47a H t : H = m * Derive (fun t => Derive u_c t) t <-> H = m * (u_gddot t - side * x_cddot t).
Proof.
  assert (E : Derive (fun t => Derive u_c t) t = u_gddot t - side * x_cddot t).
  { rewrite (Derive_ext _ (fun t => u_gdot t + R' * thetadot t * cos (alpha + side * theta t)))
      by (intro; apply is_derive_unique, sides_4a_15a).
    apply is_derive_unique; unfold x_cddot; differentiate; ring [sides]. }
  now rewrite E.
Qed.
Theorem derivation_47b V t : V - m * g = m * Derive (fun t => Derive y_c t) t <-> row{47b at t}.
Proof.
  assert (E : Derive (fun t => Derive y_c t) t = y_cddot t).
  { rewrite (Derive_ext _ y_cdot) by (intro; apply is_derive_unique, sides_49b).
    apply is_derive_unique, sides_49c. }
  rewrite E; apply (eq_by 1); [ lra | ring ].
Qed.
(* At the start. *)
Theorem derivation_25a H t : theta t = 0 -> thetadot t = 0 ->
  H = m * (u_gddot t - side * x_cddot t) ->
  row{25a, H_0 := H, u_gddot_0 := u_gddot t, thetaddot_0 := thetaddot t}.
Proof. intros A B ->; unfold x_cddot; rewrite A, B, Rmult_0_r, Rplus_0_r; ring [sides]. Qed.
Lemma sides_26a V t : theta t = 0 -> thetadot t = 0 ->
  V = m * (g + y_cddot t) -> V = m * (g - side * R' * thetaddot t * sin alpha).
Proof. intros A B ->; unfold y_cddot; rewrite A, B, Rmult_0_r, Rplus_0_r; ring. Qed.
(* While it rocks: (21) put into them. *)
Lemma sides_50a_r1_r3 p H t :
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
Lemma sides_50b_r2_r4 p V t :
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
Theorem derivation_r7_r8 p V t :
  (row{r2 at t} -> (V > 0 <-> row{r7 at t})) /\ (row{r4 at t} -> (V > 0 <-> row{r8 at t})).
Proof.
  split; intro E; apply (lt_by m); try exact m_pos; replace V with (V / m * m) by (field; lra); rewrite E; ring.
Qed.
(* The rows, on the side that each is about. *)
Lemma is_derive_value (f : R -> R) (x d e : R) : is_derive f x d -> d = e -> is_derive f x e.
Proof. now intros D <-. Qed.
Lemma other_side x y : x + -1 * y = x - y. Proof. ring. Qed.
Ltac on_side L := rewrite L, ?Rmult_1_l, ?other_side.
Ltac derivative D := let L := fresh in intro L; apply (is_derive_value _ _ _ _ D); on_side L; ring.
Ltac derivatives_on_both D := split; derivative D.
Theorem derivation_4a_15a t :
  (side = 1 -> is_derive u_c t (right{4a at t})) /\ (side = -1 -> is_derive u_c t (right{15a at t})).
Proof. derivatives_on_both (sides_4a_15a t). Qed.
Theorem derivation_4b_15b t :
  (side = 1 -> is_derive y_c t (right{4b at t})) /\ (side = -1 -> is_derive y_c t (right{15b at t})).
Proof. derivatives_on_both (sides_4b_15b t). Qed.
Theorem derivation_6_16b q v u :
  let u_cdot := u + R' * v * cos (alpha + side * q) in
  let y_cdot := - side * R' * v * sin (alpha + side * q) in
  (side = 1 -> right{5, thetadot := v} = right{6, theta := q, thetadot := v, u_gdot := u}) /\
  (side = -1 -> right{16a, thetadot := v} = right{16b, theta := q, thetadot := v, u_gdot := u}).
Proof.
  intros u_cdot y_cdot; unfold u_cdot, y_cdot, J_c, J_o.
  split; intro L; on_side L; [ assert (P := pyth (alpha + q)) | assert (P := pyth (alpha - q)) ]; field [P].
Qed.
Theorem derivation_9_14 t :
  (side = 1 -> m * g * y_c t = right{9 at t}) /\ (side = -1 -> m * g * y_c t = right{14 at t}).
Proof. split; intro L; rewrite sides_9_14; unfold Omega; on_side L; ring. Qed.
Theorem derivation_7a_17a q v u :
  (side = 1 -> is_derive (fun v => K q v u) v (right{7a, theta := q, thetadot := v, u_gdot := u})) /\
  (side = -1 -> is_derive (fun v => K q v u) v (right{17a, theta := q, thetadot := v, u_gdot := u})).
Proof. derivatives_on_both (sides_7a_17a q v u). Qed.
Theorem derivation_7b_17b t :
  let rate t := J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t) in
  (side = 1 -> is_derive rate t (right{7b at t})) /\ (side = -1 -> is_derive rate t (right{17b at t})).
Proof. intro rate; derivatives_on_both (sides_7b_17b t). Qed.
Theorem derivation_8_18 q v u :
  (side = 1 -> is_derive (fun q => K q v u) q (right{8, theta := q, thetadot := v, u_gdot := u})) /\
  (side = -1 -> is_derive (fun q => K q v u) q (right{18, theta := q, thetadot := v, u_gdot := u})).
Proof. derivatives_on_both (sides_8_18 q v u). Qed.
Theorem derivation_10_19 q :
  (side = 1 -> is_derive Omega q (right{10, theta := q})) /\ (side = -1 -> is_derive Omega q (right{19, theta := q})).
Proof. derivatives_on_both (sides_10_19 q). Qed.
Ltac relation E := let L := fresh in intro L; rewrite E; apply (eq_by 1); [ lra | on_side L; ring ].
Theorem derivation_11_20 t :
  (side = 1 -> (lagrange t <-> row{11 at t})) /\ (side = -1 -> (lagrange t <-> row{20 at t})).
Proof. split; relation (sides_11_20 t). Qed.
Theorem derivation_21a_21b p t : row{28b} ->
  (side = 1 -> (lagrange t <-> row{21a at t})) /\ (side = -1 -> (lagrange t <-> row{21b at t})).
Proof. intro P; split; relation (sides_21a_21b p t P). Qed.
Theorem derivation_48b t : side = 1 -> is_derive x_c t (right{48b at t}).
Proof. derivative (sides_48b t : is_derive x_c t (- side * (R' * thetadot t * cos (alpha + side * theta t)))). Qed.
Theorem derivation_48c t : side = 1 -> is_derive x_cdot t (right{48c at t}).
Proof. intro L; apply (is_derive_value _ _ _ _ (sides_48c t)); unfold x_cddot; on_side L; ring. Qed.
Theorem derivation_49b t : side = 1 -> is_derive y_c t (right{49b at t}).
Proof. intro L; apply (is_derive_value _ _ _ _ (sides_49b t)); unfold y_cdot; on_side L; ring. Qed.
Theorem derivation_49c t : side = 1 -> is_derive y_cdot t (right{49c at t}).
Proof. intro L; apply (is_derive_value _ _ _ _ (sides_49c t)); unfold y_cddot; on_side L; ring. Qed.
Theorem derivation_47a H t : side = 1 -> (H = m * Derive (fun t => Derive u_c t) t <-> row{47a at t}).
Proof. intro L; rewrite sides_47a, L, Rmult_1_l; reflexivity. Qed.
Theorem derivation_26a V t : side = 1 -> theta t = 0 -> thetadot t = 0 -> row{47b at t} ->
  row{26a, V_0 := V, thetaddot_0 := thetaddot t}.
Proof. intros L A B E; rewrite (sides_26a V t A B E); on_side L; ring. Qed.
Theorem derivation_50a_r1_r3 p H t : 0 < p ->
  (side = 1 -> row{21a at t} -> row{47a at t} -> row{50a at t} /\ row{r1 at t}) /\
  (side = -1 -> row{21b at t} -> H = m * (u_gddot t + x_cddot t) -> row{r3 at t}).
Proof.
  intro P; split; intros L E F; [ split | ]; (rewrite (sides_50a_r1_r3 p H t);
    [ on_side L; rewrite ?sin_2a; field; repeat split; lra | on_side L; lra | on_side L; rewrite F; ring ]).
Qed.
Theorem derivation_50b_r2_r4 p V t : 0 < p ->
  (side = 1 -> row{21a at t} -> row{47b at t} -> row{50b at t} /\ row{r2 at t}) /\
  (side = -1 -> row{21b at t} -> row{47b at t} -> row{r4 at t}).
Proof.
  intro P; split; intros L E F; [ split | ]; (rewrite (sides_50b_r2_r4 p V t);
    [ on_side L; rewrite ?sin_2a; field; repeat split; lra | on_side L; lra | exact F ]).
Qed.
(* It turns to theta < 0 from rest where the moment of the inertia force is the larger one, (11), (20). *)
Theorem derivation_23 t : side = 1 -> lagrange t -> theta t = 0 ->
  (thetaddot t <= 0 <-> row{23, H := m * u_gddot t}).
Proof.
  intros S L A; apply sides_11_20 in L; rewrite S, A, Rmult_0_r, Rplus_0_r in L.
  assert (J : 0 < J_o) by (unfold J_o; pos); split; intro; [ nra | ].
  apply Rnot_lt_le; intro K; assert (N := Rmult_lt_0_compat _ _ J K); lra.
Qed.
(* The reactions do no work, so that Lagrange's equation says what Newton's and Euler's say: the moments of H and V
   about the centre of mass turn the block. *)
Theorem derivation_1 H V t :
  H = m * Derive (fun t => Derive u_c t) t -> V - m * g = m * Derive (fun t => Derive y_c t) t ->
  (lagrange t <-> J_c * thetaddot t = side * (V * (R' * sin (alpha + side * theta t))) - H * (R' * cos (alpha +
    side * theta t))).
Proof.
  rewrite sides_47a, derivation_47b; intros -> ->; rewrite sides_11_20.
  assert (P := pyth (alpha + side * theta t)).
  apply (eq_by 1); [ lra | unfold x_cddot, y_cddot, J_o, J_c; field [P sides] ].
Qed.
Theorem derivation_27 H V t : side = 1 -> lagrange t -> theta t = 0 ->
  H = m * (u_gddot t + R' * cos alpha * thetaddot t) -> V = m * (g - R' * sin alpha * thetaddot t) ->
  row{27, H_0 := H, V_0 := V, h := R' * cos alpha, b := R' * sin alpha, thetaddot_0 := thetaddot t}.
Proof.
  intros S L A -> ->; apply sides_11_20 in L; rewrite S, A, Rmult_0_r, Rplus_0_r in L; assert (P := pyth alpha).
  rewrite <- L; unfold J_o, J_c; field [P].
Qed.
(* At rest on the ground H is the ground's own. *)
Theorem derivation_u9a H t : theta t = 0 -> thetadot t = 0 -> thetaddot t = 0 ->
  H = m * (u_gddot t - side * x_cddot t) -> row{u9a at t}.
Proof. intros A B C ->; unfold x_cddot; rewrite B, C; ring. Qed.
Theorem derivation_u5 : sqrt (m * g * R' / J_o) = right{u5}.
Proof. f_equal; unfold J_o; field; lra. Qed.
End Motion.

(* The ground that would hold the block at theta = alpha. *)
Theorem derivation_u6 p g alpha u : 0 < p -> 0 < g -> cos (2 * alpha) <> 0 ->
  (0 + p ^ 2 * (u / g * cos (alpha + alpha) - sin (alpha + alpha)) = 0 <-> row{u6, u_gddot_alpha := u}).
Proof.
  intros P G C; replace (alpha + alpha) with (2 * alpha) by ring.
  apply (eq_by (p ^ 2 * cos (2 * alpha) / g)); [ nz | field; split; lra ].
Qed.
Theorem derivation_u7 p g alpha u : 0 < p -> 0 < g ->
  (0 + p ^ 2 * (u / g * cos (alpha - alpha) + sin (alpha - alpha)) = 0 <-> row{u7, u_gddot_alpha := u}).
Proof.
  intros P G; replace (alpha - alpha) with 0 by ring; rewrite cos_0, sin_0.
  apply (eq_by (p ^ 2 / g)); [ nz | field; lra ].
Qed.
