(* Functions by their derivatives (Coquelicot's): constants, growing functions, and the solutions of
   y'' = p^2 y + f, which are one and the hyperbolic functions. *)
From Rederive Require Import Rederive.
From Coquelicot Require Import Coquelicot.

(* The derivative of what is built from functions whose derivatives are hypotheses. *)
Ltac derivatives :=
  auto_derive;
  [ repeat split; try (eexists; eassumption)
  | repeat match goal with H : is_derive ?f ?t ?d |- _ =>
      change (Derive (fun x => f x) t) with (Derive f t); rewrite ?(is_derive_unique f t d H); clear H end;
        unfold Rminus ].

Lemma hyperbolic x : cosh x ^ 2 = 1 + sinh x ^ 2.
Proof. enough (cosh x ^ 2 - sinh x ^ 2 = 1) by lra; transitivity (exp x * exp (- x)).
  - unfold cosh, sinh; field.
  - rewrite <- exp_plus, Rplus_opp_r; apply exp_0.
Qed.
Lemma sum_is_exp x : cosh x + sinh x = exp x.
Proof. unfold cosh, sinh; field. Qed.
(* A function whose derivative is 0 is a constant. *)
Lemma constant f : (forall t : R, is_derive f t 0) -> forall s t : R, f s = f t.
Proof.
  intros D s t; destruct (Rtotal_order s t) as [L | [-> | L]]; [ | reflexivity | symmetry ];
    apply (eq_is_derive f); auto.
Qed.
(* A function whose derivative is not negative grows. *)
Lemma increases (f d : R -> R) a b : a <= b ->
  (forall x, a <= x <= b -> is_derive f x (d x)) -> (forall x, a <= x <= b -> 0 <= d x) -> f a <= f b.
Proof.
  intros L D S; destruct (MVT_gen f a b d) as [c [I E]].
  - intros x X; rewrite Rmin_left, Rmax_right in X by exact L; apply D; lra.
  - intros x X; rewrite Rmin_left, Rmax_right in X by exact L.
    apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D; exact X.
  - rewrite Rmin_left, Rmax_right in I by exact L; specialize (S c I); nra.
Qed.
(* The same, strictly. *)
Lemma grows (f d : R -> R) a b : a < b ->
  (forall x, a <= x <= b -> is_derive f x (d x)) -> (forall x, a < x < b -> 0 < d x) -> f a < f b.
Proof.
  intros L D S; destruct (MVT_cor2 f d a b L) as [c [E I]]; [ intros; apply is_derive_Reals; auto | ].
  specialize (S c I); nra.
Qed.
(* A growing exponential is larger than everything else. *)
Lemma exponential_beats p k c m :
  0 < p -> 0 < k -> exists T, forall s, T < s -> m < k * exp (p * s) + c * exp (- (p * s)).
Proof.
  intros P0 K; exists (Rmax 0 ((Rabs c + Rabs m) / (k * p))); intros s L.
  assert (P : 0 < s) by (eapply Rle_lt_trans; [ apply Rmax_l | exact L ]).
  assert (B : (Rabs c + Rabs m) / (k * p) < s) by (eapply Rle_lt_trans; [ apply Rmax_r | exact L ]).
  assert (D : Rabs c + Rabs m < k * (p * s)).
  { apply (Rmult_lt_compat_r (k * p)) in B; [ | nra ]; unfold Rdiv in B.
    rewrite Rmult_assoc, Rinv_l in B; nra. }
  assert (G := exp_ineq1 (p * s)); assert (U : exp (- (p * s)) <= 1).
  { rewrite <- exp_0; apply Rlt_le, exp_increasing; nra. }
  assert (V := exp_pos (- (p * s))); assert (X := Rle_abs m).
  assert (Y : - Rabs c <= c) by (unfold Rabs; destruct (Rcase_abs c); lra).
  assert (Z := Rabs_pos c); assert (p * s <> 0) by nra; nra.
Qed.

(* y'' = p^2 y + f: two solutions that agree at t_0 with their rates agree always. *)
Section Unique.
Variables p t_0 : R.
Hypothesis p_pos : 0 < p.
Lemma only_zero (y v : R -> R) :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive v t (p ^ 2 * y t)) -> y t_0 = 0 -> v t_0 = 0 ->
  forall t, y t = 0 /\ v t = 0.
Proof.
  intros Y V Y0 V0 t.
  assert (E : forall q, q ^ 2 = p ^ 2 -> v t + q * y t = 0).
  { intros q Q; assert (C : (v t + q * y t) * exp (- (q * t)) = (v t_0 + q * y t_0) * exp (- (q * t_0))).
    { apply (constant (fun t => (v t + q * y t) * exp (- (q * t)))); intro s.
      assert (Ys := Y s); assert (Vs := V s); derivatives; ring [Q]. }
    rewrite Y0, V0 in C; assert (P := exp_pos (- (q * t))); nra. }
  assert (A := E p eq_refl); assert (B := E (- p) ltac:(ring)); split; nra.
Qed.

(* The same of a motion that obeys the equation between t_0 and b alone, with a rate that is continuous at both. *)
Lemma constant_until (E : R -> R) b : t_0 <= b -> (forall t, t_0 < t < b -> is_derive E t 0) ->
  (forall t, t_0 <= t <= b -> continuous E t) -> E b = E t_0.
Proof.
  intros L D C; destruct (MVT_gen E t_0 b (fun _ => 0)) as [c [_ F]]; rewrite ?Rmin_left, ?Rmax_right in * by exact L.
  - exact D.
  - intros x X; now apply continuity_pt_filterlim, C.
  - lra.
Qed.
Lemma agrees_until b (y v y_1 v_1 f : R -> R) : (forall t, is_derive y t (v t)) -> (forall t, continuous v t) ->
  (forall t, t_0 < t < b -> is_derive v t (p ^ 2 * y t + f t)) ->
  (forall t, is_derive y_1 t (v_1 t)) -> (forall t, is_derive v_1 t (p ^ 2 * y_1 t + f t)) ->
  y t_0 = y_1 t_0 -> v t_0 = v_1 t_0 -> forall t, t_0 <= t <= b -> y t = y_1 t /\ v t = v_1 t.
Proof.
  intros Y C V Y1 V1 E F t I.
  assert (G : forall q, q ^ 2 = p ^ 2 -> v t - v_1 t + q * (y t - y_1 t) = 0).
  { intros q Q; set (r := fun s => (- v_1 s + q * (y s - y_1 s)) * exp (- (q * s))).
    assert (H : v t * exp (- (q * t)) + r t = v t_0 * exp (- (q * t_0)) + r t_0).
    { apply (constant_until (fun s => v s * exp (- (q * s)) + r s)); [ lra | |].
      - intros s S; unfold r; assert (Ys := Y s); assert (Vs := V s ltac:(lra)); assert (Y1s := Y1 s);
          assert (V1s := V1 s); derivatives; ring [Q].
      - intros s _; apply (continuous_plus (V := R_NormedModule)); [ apply (continuous_mult (K := R_AbsRing)) | ].
        + apply C.
        + apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; trivial.
        + apply (ex_derive_continuous (V := R_NormedModule)); unfold r; auto_derive;
            repeat split; trivial; eexists; [ apply V1 | apply Y | apply Y1 ]. }
    unfold r in H; rewrite E, F in H; assert (P := exp_pos (- (q * t))).
    replace (v t - v_1 t + q * (y t - y_1 t)) with
      ((v t * exp (- (q * t)) + (- v_1 t + q * (y t - y_1 t)) * exp (- (q * t))) / exp (- (q * t))) by (field; lra).
    rewrite H; field; lra. }
  assert (A := G p eq_refl); assert (B := G (- p) ltac:(ring)); split; nra.
Qed.

(* All solutions, from one. *)
Lemma all_solutions (y v y_1 v_1 f : R -> R) :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive v t (p ^ 2 * y t + f t)) ->
  (forall t, is_derive y_1 t (v_1 t)) -> (forall t, is_derive v_1 t (p ^ 2 * y_1 t + f t)) ->
  forall t, y t = (v t_0 - v_1 t_0) / p * sinh (p * (t - t_0)) + (y t_0 - y_1 t_0) * cosh (p * (t - t_0)) + y_1 t /\
            v t / p = (v t_0 - v_1 t_0) / p * cosh (p * (t - t_0)) + (y t_0 - y_1 t_0) * sinh (p * (t - t_0)) +
              v_1 t / p.
Proof.
  intros Y V Y1 V1 t; set (A := (v t_0 - v_1 t_0) / p); set (B := y t_0 - y_1 t_0).
  destruct (only_zero (fun t => y t - y_1 t - (A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0))))
              (fun t => v t - v_1 t - p * (A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0))))) with (t := t) as [P
                Q].
  - intro s; unfold sinh, cosh; assert (D := Y s); assert (D1 := Y1 s).
    derivatives; field.
  - intro s; unfold sinh, cosh; assert (D := V s); assert (D1 := V1 s).
    derivatives; field.
  - replace (t_0 - t_0) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; unfold B; ring.
  - replace (t_0 - t_0) with 0 by ring; rewrite Rmult_0_r, sinh_0, cosh_0; unfold A; field; lra.
  - split; [ lra | apply (Rmult_eq_reg_l p); [ | lra ]; unfold Rdiv; rewrite Rmult_plus_distr_l ].
    replace (p * (v t * / p)) with (v t) by (field; lra); replace (p * (v_1 t * / p)) with (v_1 t) by (field; lra);
      lra.
Qed.
(* From the form of the response follows that of its rate. *)
Lemma rate_of (y v y_1 v_1 : R -> R) A B :
  (forall t, is_derive y t (v t)) -> (forall t, is_derive y_1 t (v_1 t)) ->
  (forall t, y t = A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t) ->
  forall t, v t / p = A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0)) + v_1 t / p.
Proof.
  intros Y Y1 E t; assert (D : is_derive y t (p * (A * cosh (p * (t - t_0)) + B * sinh (p * (t - t_0))) + v_1 t)).
  { apply (is_derive_ext (fun t => A * sinh (p * (t - t_0)) + B * cosh (p * (t - t_0)) + y_1 t)); [ intro;
    now rewrite E | ].
    unfold sinh, cosh; assert (D1 := Y1 t); derivatives; field. }
  rewrite <- (is_derive_unique y t _ (Y t)), (is_derive_unique y t _ D); field; lra.
Qed.
End Unique.

(* Two functions that agree at T with their derivatives, as one. *)
Lemma glued (f f' g g' : R -> R) T : (forall t, is_derive f t (f' t)) -> (forall t, is_derive g t (g' t)) ->
  f T = g T -> f' T = g' T ->
  forall t, is_derive (fun t => if Rle_dec t T then f t else g t) t (if Rle_dec t T then f' t else g' t).
Proof.
  intros F G E E' t; destruct (Rtotal_order t T) as [L | [-> | L]].
  - destruct (Rle_dec t T) as [_ | N]; [ | lra ]; apply (is_derive_ext_loc f); [ | apply F ].
    apply (filter_imp (fun s => s < T)); [ intros s S; destruct (Rle_dec s T); [ reflexivity | lra ] | now apply
      open_lt ].
  - destruct (Rle_dec T T) as [_ | N]; [ | lra ]; apply is_derive_Reals; intros eps P.
    destruct (proj1 (is_derive_Reals _ _ _) (F T) eps P) as [d A].
    destruct (proj1 (is_derive_Reals _ _ _) (G T) eps P) as [d' B].
    exists (mkposreal _ (Rmin_pos d d' (cond_pos d) (cond_pos d'))); intros h N H; simpl in H.
    assert (M := Rmin_l d d'); assert (M' := Rmin_r d d'); destruct (Rle_dec T T) as [_ | X]; [ | lra ].
    destruct (Rle_dec (T + h) T); [ apply A | rewrite E, E'; apply B ]; lra.
  - destruct (Rle_dec t T) as [N | _]; [ lra | ]; apply (is_derive_ext_loc g); [ | apply G ].
    apply (filter_imp (fun s => T < s)); [ intros s S; destruct (Rle_dec s T); [ lra | reflexivity ] | now apply
      open_gt ].
Qed.
