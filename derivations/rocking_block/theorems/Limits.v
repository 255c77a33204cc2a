(* What motions tend to as time goes on: the criterion of overturning is a limit, which no motion reaches. *)
From Rederive Require Import Rederive Solutions.
From Coquelicot Require Import Coquelicot.

(* What a function tends to as time goes on. *)
Definition tends_to (f : R -> R) (l : R) := is_lim f p_infty l.
Lemma tends_to_is f l : tends_to f l <-> forall eps, 0 < eps -> exists T, forall t, T < t -> Rabs (f t - l) < eps.
Proof.
  unfold tends_to; rewrite <- is_lim_spec; split.
  - intros H eps E; exact (H (mkposreal eps E)).
  - intros H [eps E]; exact (H eps E).
Qed.
Lemma tends_to_ext f g l : (forall t, f t = g t) -> (tends_to f l <-> tends_to g l).
Proof.
  intro E; split; apply is_lim_ext; auto.
Qed.
Lemma tends_to_from T f g l : (forall t, T < t -> f t = g t) -> (tends_to f l <-> tends_to g l).
Proof.
  intro E; split; apply is_lim_ext_loc; exists T; intros t L; [ | symmetry ]; auto.
Qed.
(* A sinh + B cosh dies away just if its growing part, (A + B) exp/2, is 0. *)
Lemma dies_away p t_o A B l : 0 < p ->
  (tends_to (fun t => A * sinh (p * (t - t_o)) + B * cosh (p * (t - t_o)) + l) l <-> A = - B).
Proof.
  intro P; rewrite tends_to_is.
  assert (S : forall t, A * sinh (p * (t - t_o)) + B * cosh (p * (t - t_o)) + l - l =
    (A + B) / 2 * exp (p * (t - t_o)) + (B - A) / 2 * exp (- (p * (t - t_o)))) by (intro; unfold sinh, cosh; field).
  assert (grows_not : forall k c, 0 < k -> exists T, forall t, T < t ->
    1 < k * exp (p * (t - t_o)) + c * exp (- (p * (t - t_o)))).
  { intros k c K; destruct (exponential_beats p k c 1 P K) as [T H]; exists (T + t_o); intros t L; apply H; lra. }
  split.
  - intro H; destruct (H 1 Rlt_0_1) as [T H1]; destruct (Rtotal_order (A + B) 0) as [N | [N | N]]; [ exfalso | lra |
    exfalso ].
    + destruct (grows_not (- ((A + B) / 2)) (- ((B - A) / 2))) as [U H2]; [ lra | ].
      assert (L := Rmax_l T U); assert (M := Rmax_r T U).
      specialize (H1 (Rmax T U + 1)); specialize (H2 (Rmax T U + 1)); rewrite S in H1; apply Rabs_def2 in H1; lra.
    + destruct (grows_not ((A + B) / 2) ((B - A) / 2)) as [U H2]; [ lra | ].
      assert (L := Rmax_l T U); assert (M := Rmax_r T U).
      specialize (H1 (Rmax T U + 1)); specialize (H2 (Rmax T U + 1)); rewrite S in H1; apply Rabs_def2 in H1; lra.
  - intros -> eps E; destruct (exponential_beats p eps 0 (Rabs B) P E) as [T H]; exists (T + t_o); intros t L.
    specialize (H (t - t_o)); rewrite S; replace (_ + _) with (B * exp (- (p * (t - t_o)))) by field.
    assert (X := exp_pos (- (p * (t - t_o)))); rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by lra.
    assert (Y : exp (p * (t - t_o)) * exp (- (p * (t - t_o))) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    assert (Rabs B < eps * exp (p * (t - t_o))) by lra; nra.
Qed.
(* What tends to a limit, with an acceleration that tends to one, comes to rest. *)
Lemma comes_to_rest t_o (y v a : R -> R) l L :
  (forall t, t_o < t -> is_derive y t (v t) /\ is_derive v t (a t)) -> tends_to y l -> tends_to a L ->
  L = 0 /\ tends_to v 0.
Proof.
  intros D Y A; rewrite tends_to_is in *.
  assert (between : forall f d, (forall t, t_o < t -> is_derive f t (d t)) -> forall s t, t_o < s < t ->
    exists c, s <= c <= t /\ f t - f s = d c * (t - s)).
  { intros f d E s t I; destruct (MVT_gen f s t d) as [c [J F]]; rewrite ?Rmin_left, ?Rmax_right in * by lra.
    - intros x X; apply E; lra.
    - intros x X; apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply E; lra.
    - exists c; split; assumption. }
  assert (slow : forall eps, 0 < eps -> exists T, t_o < T /\ forall t, T < t -> exists c, t <= c <= t + 1 /\ Rabs (v
    c) < eps).
  { intros eps E; destruct (Y (eps / 2)) as [T H]; [ lra | ]; exists (Rmax T t_o + 1).
    assert (M := Rmax_l T t_o); assert (N := Rmax_r T t_o); split; [ lra | intros t G ].
    destruct (between y v (fun s S => proj1 (D s S)) t (t + 1)) as [c [I F]]; [ lra | ].
    exists c; split; [ exact I | ]; assert (H1 := H t); assert (H2 := H (t + 1)).
    replace (v c) with ((y (t + 1) - l) - (y t - l)) by lra.
    assert (Q := Rabs_triang (y (t + 1) - l) (- (y t - l))); rewrite Rabs_Ropp in Q; unfold Rminus in *; lra. }
  assert (Z : L = 0).
  { destruct (Req_dec L 0) as [Z | N]; [ exact Z | exfalso ]; assert (K := Rabs_pos_lt L N).
    destruct (A (Rabs L / 4)) as [T H]; [ lra | ]; destruct (slow (Rabs L / 4)) as [U [O S]]; [ lra | ].
    assert (M := Rmax_l T U); assert (M' := Rmax_r T U); set (t := Rmax T U + 1) in *.
    destruct (S t) as [c [I F]]; [ unfold t; lra | ]; destruct (S (t + 2)) as [c' [I' F']]; [ unfold t; lra | ].
    destruct (between v a (fun s S => proj2 (D s S)) c c') as [d [J G]]; [ unfold t in *; lra | ].
    assert (W : Rabs (a d) * (c' - c) < Rabs L / 2).
    { rewrite <- (Rabs_pos_eq (c' - c)), <- Rabs_mult, <- G by lra.
      assert (Q := Rabs_triang (v c') (- v c)); rewrite Rabs_Ropp in Q; unfold Rminus in *; lra. }
    assert (X : Rabs L < Rabs (a d) + Rabs L / 4).
    { specialize (H d); assert (Q := Rabs_triang (a d) (- (a d - L))); rewrite Rabs_Ropp in Q.
      replace (a d + - (a d - L)) with L in Q by ring; assert (T < d) by (unfold t in *; lra); lra. }
    assert (P := Rabs_pos (a d)); nra. }
  split; [ exact Z | rewrite Z in *; intros eps E ].
  destruct (A (eps / 2)) as [T H]; [ lra | ]; destruct (slow (eps / 2)) as [U [O S]]; [ lra | ].
  assert (M := Rmax_l T U); assert (M' := Rmax_r T U); exists (Rmax T U); intros t I.
  destruct (S t) as [c [J F]]; [ lra | ]; rewrite Rminus_0_r.
  destruct (Req_dec c t) as [-> | N]; [ lra | ].
  destruct (between v a (fun s S => proj2 (D s S)) t c) as [d [I' G]]; [ lra | ].
  specialize (H d); assert (X : Rabs (a d) < eps / 2) by (rewrite Rminus_0_r in H; apply H; lra).
  assert (W : Rabs (a d * (c - t)) <= Rabs (a d)).
  { rewrite Rabs_mult, (Rabs_pos_eq (c - t)) by lra; assert (P := Rabs_pos (a d)); nra. }
  replace (v t) with (v c + - (a d * (c - t))) by lra.
  assert (Q := Rabs_triang (v c) (- (a d * (c - t)))); rewrite Rabs_Ropp in Q; lra.
Qed.
Lemma tends_to_scaled c f : c <> 0 -> (tends_to f 0 <-> tends_to (fun t => f t / c) 0).
Proof.
  intro C; rewrite !tends_to_is; assert (K := Rabs_pos_lt c C); split; intros H eps E.
  - destruct (H (eps * Rabs c)) as [T B]; [ nra | exists T; intros t L; specialize (B t L) ].
    rewrite Rminus_0_r in *; unfold Rdiv; rewrite Rabs_mult, Rabs_inv; apply (Rmult_lt_reg_r (Rabs c)); [ exact K | ].
    rewrite Rmult_assoc, Rinv_l; lra.
  - destruct (H (eps / Rabs c)) as [T B]; [ now apply Rdiv_lt_0_compat | exists T; intros t L; specialize (B t L) ].
    rewrite Rminus_0_r in *; unfold Rdiv in B; rewrite Rabs_mult, Rabs_inv in B.
    apply (Rmult_lt_reg_r (/ Rabs c)); [ now apply Rinv_0_lt_compat | exact B ].
Qed.
