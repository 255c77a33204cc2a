(* The equation of motion and the restitution, from positions. Derivatives and integrals are Coquelicot's; the
   numbers are the paper's, and R' is its R. *)
From Rederive Require Import Rederive.
From Coquelicot Require Import Coquelicot.

(* An integral by an antiderivative. *)
Ltac integral F :=
  lazymatch goal with |- is_RInt ?f ?u ?v ?I =>
    replace I with (minus (F v) (F u)) by (unfold minus, plus, opp; simpl; field);
    apply (is_RInt_derive F f); intros;
    [ auto_derive; [ trivial | field ] | apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; trivial ]
  end.

(* A rectangle 2 b by 2 h of density rho. Double integrals, the inner one first. *)
Section Block.
Variables b h rho R' alpha : R.
Hypotheses (corner : b = R' * sin alpha) (top : h = R' * cos alpha).
Let m := rho * (2 * h * (2 * b)).
Lemma diagonal : R' ^ 2 = b ^ 2 + h ^ 2.
Proof. rewrite corner, top; assert (P := pyth alpha); ring [P]. Qed.

(* The moment of inertia about the centre of mass. *)
Theorem derivation_u2 :
  exists inner, (forall x, is_RInt (fun y => rho * (x ^ 2 + y ^ 2)) (- h) h (inner x)) /\
                is_RInt inner (- b) b (m * R' ^ 2 / 3).
Proof.
  exists (fun x => rho * (2 * h * x ^ 2 + 2 / 3 * h ^ 3)); split.
  - intro x; integral (fun y => rho * (x ^ 2 * y + y ^ 3 / 3)).
  - rewrite diagonal; unfold m; integral (fun x => rho * (2 / 3 * h * x ^ 3 + 2 / 3 * h ^ 3 * x)).
Qed.
(* About a corner, by Steiner. *)
Theorem derivation_u3 J_c J_o : J_c = m * R' ^ 2 / 3 -> J_o = J_c + m * R' ^ 2 -> J_o = 4 / 3 * m * R' ^ 2.
Proof. intros; subst J_o J_c; field. Qed.

(* The moment of momentum about the new corner before the impact: r^2 - 2 b r sin phi = x^2 + y^2 - 2 b x. *)
Theorem derivation_41 :
  exists inner, (forall x, is_RInt (fun y => x ^ 2 + y ^ 2 - 2 * b * x) 0 (2 * h) (inner x)) /\
                is_RInt inner 0 (2 * b) (4 * h * b * (4 / 3 * h ^ 2 - 2 / 3 * b ^ 2)).
Proof.
  exists (fun x => 2 * h * (x ^ 2 - 2 * b * x) + 8 / 3 * h ^ 3); split.
  - intro x; integral (fun y => (x ^ 2 - 2 * b * x) * y + y ^ 3 / 3).
  - integral (fun x => 2 * h * (x ^ 3 / 3 - b * x ^ 2) + 8 / 3 * h ^ 3 * x).
Qed.
Theorem derivation_43b thetadot_minus :
  rho * (4 * h * b * (4 / 3 * h ^ 2 - 2 / 3 * b ^ 2)) * thetadot_minus =
  m * R' ^ 2 * (4 / 3 - 2 * sin alpha ^ 2) * thetadot_minus.
Proof. unfold m; rewrite corner, top; assert (P := pyth alpha); field [P]. Qed.
(* About that corner it is the same after the impact. *)
Theorem derivation_46 thetadot_minus thetadot_plus :
  0 < m -> 0 < R' ->
  (m * R' ^ 2 * (4 / 3 - 2 * sin alpha ^ 2) * thetadot_minus = 4 / 3 * m * R' ^ 2 * thetadot_plus <->
   thetadot_plus = (1 - 3 / 2 * sin alpha ^ 2) * thetadot_minus).
Proof.
  intros M L; apply (eq_by (- (4 / 3 * m * R' ^ 2))); [ | field ].
  apply Ropp_neq_0_compat; nz.
Qed.
End Block.

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
  match goal with |- is_derive _ ?t _ => destruct (ground t) as [D1 D2]; destruct (angle t) as [D3 D4] end;
  auto_derive;
  [ repeat split; eexists; eassumption
  | repeat match goal with H : is_derive ?f ?t ?d |- _ => 
      change (Derive (fun x => f x) t) with (Derive f t); rewrite ?(is_derive_unique f t d H); clear H end ].

(* (4), (15) *)
Theorem derivation_4a t : is_derive u_c t (u_gdot t + R' * thetadot t * cos (alpha + side * theta t)).
Proof. unfold u_c, x_c; differentiate; ring [sides]. Qed.
Theorem derivation_4b t : is_derive y_c t (- side * R' * thetadot t * sin (alpha + side * theta t)).
Proof. unfold y_c; differentiate; ring. Qed.

(* (5) and (6), (16): the kinetic energy as a function of the angle, its rate and the speed of the ground. *)
Definition K q v u := 1 / 2 * J_o * v ^ 2 + 1 / 2 * m * u ^ 2 + m * u * v * R' * cos (alpha + side * q).
Definition Omega q := m * g * R' * (cos (alpha + side * q) - cos alpha).
Theorem derivation_6 q v u :
  1 / 2 * J_c * v ^ 2 + 1 / 2 * m * ((u + R' * v * cos (alpha + side * q)) ^ 2 + (- side * R' * v * sin (alpha + side * q)) ^ 2) =
  K q v u.
Proof. assert (P := pyth (alpha + side * q)); unfold K, J_c, J_o; field [P sides]. Qed.
(* (7), (8), (10): its partial derivatives, and the rate of the first along the motion. *)
Theorem derivation_7a q v u : is_derive (fun v => K q v u) v (J_o * v + m * u * R' * cos (alpha + side * q)).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
Theorem derivation_7b t :
  is_derive (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)) t
    (J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
     side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
Proof. differentiate; ring. Qed.
Theorem derivation_8 q v u : is_derive (fun q => K q v u) q (- side * (m * u * v * R' * sin (alpha + side * q))).
Proof. unfold K; auto_derive; [ trivial | field ]. Qed.
Theorem derivation_10 q : is_derive Omega q (- side * (m * g * R' * sin (alpha + side * q))).
Proof. unfold Omega; auto_derive; [ trivial | field ]. Qed.

(* Lagrange's equation (1) is (11), (20), and with p^2 = 3 g/(4 R') it is (21). *)
Definition lagrange t :=
  Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t -
  Derive (fun q => K q (thetadot t) (u_gdot t)) (theta t) + Derive Omega (theta t) = 0.
Theorem derivation_11 t :
  lagrange t <-> J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
                 side * (m * g * R' * sin (alpha + side * theta t)) = 0.
Proof.
  assert (E : Derive (fun t => Derive (fun v => K (theta t) v (u_gdot t)) (thetadot t)) t =
              J_o * thetaddot t + m * u_gddot t * R' * cos (alpha + side * theta t) -
              side * (m * u_gdot t * thetadot t * R' * sin (alpha + side * theta t))).
  { rewrite (Derive_ext _ (fun t => J_o * thetadot t + m * u_gdot t * R' * cos (alpha + side * theta t)))
      by (intro; apply is_derive_unique, derivation_7a).
    apply is_derive_unique, derivation_7b. }
  assert (F := is_derive_unique _ _ _ (derivation_8 (theta t) (thetadot t) (u_gdot t))).
  assert (G := is_derive_unique _ _ _ (derivation_10 (theta t))).
  unfold lagrange; rewrite E, G.
  setoid_rewrite F.
  apply (eq_by 1); [ lra | ring ].
Qed.
Theorem derivation_21 p t :
  p ^ 2 = 3 * g / (4 * R') ->
  (lagrange t <-> thetaddot t + p ^ 2 * (u_gddot t / g * cos (alpha + side * theta t) - side * sin (alpha + side * theta t)) = 0).
Proof.
  intro P; rewrite derivation_11; apply (eq_by J_o); [ unfold J_o; apply Rgt_not_eq; pos | rewrite P; unfold J_o; field; lra ].
Qed.
End Motion.
