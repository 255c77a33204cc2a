(* The block as a body: its moments of inertia, and what an impact leaves of its rate, from double integrals. The
   numbers are the paper's, and R' is its R. *)
From Rederive Require Import Rederive Solutions.
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
Hypotheses (corner : row{42a}) (top : h = R' * cos alpha).
Let m := rho * (2 * h * (2 * b)).
Lemma diagonal : R' ^ 2 = b ^ 2 + h ^ 2.
Proof. rewrite corner, top; assert (P := pyth alpha); ring [P]. Qed.

(* The moment of inertia about the centre of mass. *)
Theorem derivation_u2 :
  exists inner, (forall x, is_RInt (fun y => rho * (x ^ 2 + y ^ 2)) (- h) h (inner x)) /\
                is_RInt inner (- b) b (right{u2}).
Proof.
  exists (fun x => rho * (2 * h * x ^ 2 + 2 / 3 * h ^ 3)); split.
  - intro x; integral (fun y => rho * (x ^ 2 * y + y ^ 3 / 3)).
  - rewrite diagonal; unfold m; integral (fun x => rho * (2 / 3 * h * x ^ 3 + 2 / 3 * h ^ 3 * x)).
Qed.
(* About a corner. *)
Theorem derivation_u3b :
  exists inner, (forall x, is_RInt (fun y => rho * (x ^ 2 + y ^ 2)) 0 (2 * h) (inner x)) /\
                is_RInt inner 0 (2 * b) (right{u3b}).
Proof.
  exists (fun x => rho * (2 * h * x ^ 2 + 8 / 3 * h ^ 3)); split.
  - intro x; integral (fun y => rho * (x ^ 2 * y + y ^ 3 / 3)).
  - rewrite diagonal; unfold m; integral (fun x => rho * (2 / 3 * h * x ^ 3 + 8 / 3 * h ^ 3 * x)).
Qed.
(* About the other one, to whose left the block lies. *)
Theorem derivation_u4 :
  exists inner, (forall x, is_RInt (fun y => rho * (x ^ 2 + y ^ 2)) 0 (2 * h) (inner x)) /\
                is_RInt inner (- (2 * b)) 0 (right{u4}).
Proof.
  exists (fun x => rho * (2 * h * x ^ 2 + 8 / 3 * h ^ 3)); split.
  - intro x; integral (fun y => rho * (x ^ 2 * y + y ^ 3 / 3)).
  - rewrite diagonal; unfold m; integral (fun x => rho * (2 / 3 * h * x ^ 3 + 8 / 3 * h ^ 3 * x)).
Qed.
(* That is Steiner's theorem. *)
Theorem derivation_u3a J_c J_o : row{u2} -> row{u3b} -> row{u3a}.
Proof. intros; subst J_o J_c; field. Qed.

(* The moment of momentum about the new corner before the impact: r^2 - 2 b r sin phi = x^2 + y^2 - 2 b x. *)
Theorem derivation_41 :
  exists inner, (forall x, is_RInt (fun y => x ^ 2 + y ^ 2 - 2 * b * x) 0 (2 * h) (inner x)) /\
                is_RInt inner 0 (2 * b) (right{41}).
Proof.
  exists (fun x => 2 * h * (x ^ 2 - 2 * b * x) + 8 / 3 * h ^ 3); split.
  - intro x; integral (fun y => (x ^ 2 - 2 * b * x) * y + y ^ 3 / 3).
  - integral (fun x => 2 * h * (x ^ 3 / 3 - b * x ^ 2) + 8 / 3 * h ^ 3 * x).
Qed.
Theorem derivation_43b thetadot_minus :
  rho * (right{41}) * thetadot_minus = right{43b}.
Proof. unfold m; rewrite corner, top; assert (P := pyth alpha); field [P]. Qed.
(* About that corner it is the same after the impact. *)
(* After the impact every point has r^2 = x^2 + y^2. *)
Theorem derivation_45b thetadot_plus :
  exists inner, (forall x, is_RInt (fun y => rho * ((x ^ 2 + y ^ 2) * thetadot_plus)) 0 (2 * h) (inner x)) /\
                is_RInt inner 0 (2 * b) (right{45b}).
Proof.
  exists (fun x => rho * ((2 * h * x ^ 2 + 8 / 3 * h ^ 3) * thetadot_plus)); split.
  - intro x; integral (fun y => rho * ((x ^ 2 * y + y ^ 3 / 3) * thetadot_plus)).
  - rewrite Rmult_assoc, Rmult_assoc, <- (Rmult_assoc m), diagonal; unfold m.
    integral (fun x => rho * ((2 / 3 * h * x ^ 3 + 8 / 3 * h ^ 3 * x) * thetadot_plus)).
Qed.
(* The inner integral of (43) goes as far as that of (39): what is printed is right of a square. *)
Theorem derivation_43a y_end : row{39c} -> (y_end = 2 * b <-> h = b).
Proof. intros ->; apply (eq_by 2); [ lra | ring ]. Qed.
Theorem derivation_46a thetadot_minus thetadot_plus :
  0 < m -> 0 < R' ->
  (right{43b} = right{45b} <->
   row{46a}).
Proof. intros M L; apply (eq_by (4 / 3 * m * R' ^ 2)); [ nz | field ]. Qed.
End Block.
(* The impact elsewhere: an impulse P at a distance d from the new corner lifts the centre of mass, whose
   speed is (4b) before and (15b) after, and adds to the moment of momentum about that corner. *)
Theorem derivation_r16 m R' alpha d thetadot_minus thetadot_plus y_cdot_minus y_cdot_plus P :
  0 < m -> 0 < R' -> thetadot_minus <> 0 -> 4 / 3 * R' ^ 2 - R' * d * sin alpha <> 0 ->
  y_cdot_minus = - R' * thetadot_minus * sin (alpha + 0) -> y_cdot_plus = R' * thetadot_plus * sin (alpha - 0) ->
  P = m * y_cdot_plus - m * y_cdot_minus ->
  right{45b} - right{43b} = P * d ->
  row{r16, e := thetadot_plus / thetadot_minus}.
Proof.
  intros M R T N -> -> ->; rewrite Rplus_0_r, Rminus_0_r; apply (eq_by (/ (m * thetadot_minus *
    (4 / 3 * R' ^ 2 - R' * d * sin alpha)))); [ | field; repeat split; lra ].
  apply Rinv_neq_0_compat; repeat apply Rmult_integral_contrapositive_currified; lra.
Qed.

(* Points of the block, at r and phi from the corner about which it turns, when it is upright. The new corner is at
   (- 2 b, 0) from the old one; before the impact the block turns about the old one, after it about the new one. *)
Section Points.
Variables b r phi t thetadot_minus thetadot_plus : R.
Variable theta : R -> R.
Hypothesis upright : theta t = 0.
Let x' s := - r * sin (phi + theta s).
Let y' s := r * cos (phi + theta s).
Lemma speeds thetadot : is_derive theta t thetadot ->
  Derive x' t = - r * cos phi * thetadot /\ Derive y' t = - r * sin phi * thetadot.
Proof.
  intro D; split; apply is_derive_unique; unfold x', y'; derivatives; rewrite upright, Rplus_0_r; ring.
Qed.
Theorem derivation_38 : is_derive theta t thetadot_minus ->
  (x' t + 2 * b) * Derive y' t - y' t * Derive x' t = right{38}.
Proof.
  intro D; destruct (speeds _ D) as [-> ->]; unfold x', y'; rewrite upright, Rplus_0_r; assert (P := pyth phi); ring
    [P].
Qed.
Theorem derivation_45a : is_derive theta t thetadot_plus ->
  x' t * Derive y' t - y' t * Derive x' t = right{45a}.
Proof.
  intro D; destruct (speeds _ D) as [-> ->]; unfold x', y'; rewrite upright, Rplus_0_r; assert (P := pyth phi); ring
    [P].
Qed.
Theorem derivation_39 x hO_minus : row{u15} ->
  row{38} ->
  row{39}.
Proof. intros E ->; rewrite <- E; ring. Qed.
Theorem derivation_40a x y : row{u15} -> r * cos phi = y -> row{40a}.
Proof. intros <- <-; assert (P := pyth phi); ring [P]. Qed.
End Points.
(* The energy that the impact takes, where the ground does not move. *)
Theorem derivation_u12a m R' alpha J_o thetadot_minus thetadot_plus K : 
  (forall v u, K v u = 1 / 2 * J_o * v ^ 2 + 1 / 2 * m * u ^ 2 + m * u * v * R' * cos alpha) ->
  K thetadot_minus 0 - K thetadot_plus 0 = right{u12a}.
Proof. intro E; rewrite !E; ring. Qed.
