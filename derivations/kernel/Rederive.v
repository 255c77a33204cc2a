(* What the lemmas are proved with. A lemma says: where the symbols lie in their ranges, each divisor is not 0
   and each root exists, and there the two statements say the same. Division and roots are total in Coq, so
   that the first half is part of what is proved. *)
Require Export Reals Lra Psatz.
Open Scope R_scope.
(* The paper calls a length R: it is R' here. *)
Notation real := R.

Definition cot x := cos x / sin x. Definition coth x := cosh x / sinh x.
Definition sec x := 1 / cos x. Definition sech x := 1 / cosh x.
Definition csc x := 1 / sin x. Definition csch x := 1 / sinh x.

(* Two relations whose differences are the same but for a factor. *)
Lemma product_zero k x : k <> 0 -> (k * x = 0 <-> x = 0).
Proof. intro K; split; intro H; [ destruct (Rmult_integral _ _ H); tauto | rewrite H; ring ]. Qed.
Lemma eq_by k a b c d : k <> 0 -> a - b = k * (c - d) -> (a = b <-> c = d).
Proof.
  intros K E; destruct (product_zero k (c - d) K) as [P Q]; rewrite <- E in P, Q.
  split; intro H; [ enough (c - d = 0) by lra; apply P | enough (a - b = 0) by lra; apply Q ]; lra.
Qed.
Lemma lt_by k a b c d : 0 < k -> a - b = k * (c - d) -> (a < b <-> c < d).
Proof. intros K E; split; intro H; nra. Qed.
Lemma le_by k a b c d : 0 < k -> a - b = k * (c - d) -> (a <= b <-> c <= d).
Proof. intros K E; split; intro H; nra. Qed.
(* A divisor of which a multiple is known not to be 0. *)
Lemma exp_minus_one_nonzero x : x <> 0 -> exp x - 1 <> 0.
Proof. intros N E; apply N, exp_inv; rewrite exp_0; lra. Qed.
Lemma nonzero_by k a b : a <> 0 -> a = k * b -> b <> 0.
Proof. intros A E B; apply A; rewrite E, B; ring. Qed.

Lemma pyth x : cos x ^ 2 = 1 - sin x ^ 2. Proof. generalize (sin2_cos2 x); unfold Rsqr; intro; lra. Qed.
Lemma exp_nonzero x : exp x <> 0. Proof. generalize (exp_pos x); lra. Qed.
Lemma cosh_by_exp x : cosh x = (exp x + / exp x) / 2. Proof. unfold cosh; now rewrite exp_Ropp. Qed.
Lemma sinh_by_exp x : sinh x = (exp x - / exp x) / 2. Proof. unfold sinh; now rewrite exp_Ropp. Qed.
Lemma square_of_root x : 0 <= x -> sqrt x ^ 2 = x.
Proof. intro; rewrite <- Rsqr_pow2; now apply Rsqr_sqrt. Qed.
Lemma root_is x y : 0 <= y -> y ^ 2 = x -> sqrt x = y.
Proof. intros; subst; rewrite <- Rsqr_pow2; now apply sqrt_Rsqr. Qed.

(* Signs of what is built from positive things: products, sums, powers, roots, functions. *)
Ltac known := first [ assumption | lra ].
Ltac by_squares := nra.
Ltac pos :=
  lazymatch goal with
  | |- _ > _ => unfold Rgt; pos
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < _ * _ => first [ apply Rmult_lt_0_compat; pos | by_squares ]
  | |- 0 < _ / _ => first [ apply Rdiv_lt_0_compat; pos | by_squares ]
  | |- 0 < / _ => apply Rinv_0_lt_compat; pos
  | |- 0 < _ ^ _ => first [ apply pow_lt; pos | by_squares ]
  | |- 0 < sqrt _ => apply sqrt_lt_R0; pos
  | |- 0 < sin _ => first [ known | apply sin_gt_0; known ]
  | |- 0 < cos _ => first [ known | apply cos_gt_0; known ]
  | |- 0 < _ + _ =>
      first [ known | apply Rplus_lt_0_compat; pos | apply Rplus_lt_le_0_compat; [ pos | nonneg ]
            | apply Rplus_le_lt_0_compat; [ nonneg | pos ] | by_squares ]
  | |- 0 < _ => first [ known | by_squares ]
  end
with nonneg :=
  lazymatch goal with
  | |- _ >= _ => apply Rle_ge; nonneg
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= _ ^ 2 => apply pow2_ge_0
  | |- 0 <= _ * _ => first [ apply Rmult_le_pos; nonneg | by_squares ]
  | |- 0 <= _ / _ => first [ known | apply Rle_mult_inv_pos; [ nonneg | pos ] | by_squares ]
  | |- 0 <= _ + _ => first [ known | apply Rplus_le_le_0_compat; nonneg | by_squares ]
  | |- 0 <= 1 - sin ?x => generalize (SIN_bound x); lra
  | |- 0 <= 1 - cos ?x => generalize (COS_bound x); lra
  | |- 0 <= _ => first [ known | apply Rlt_le; pos | by_squares ]
  end.
Ltac nz :=
  lazymatch goal with
  | |- _ /\ _ => split; nz
  | |- exp _ <> 0 => apply exp_nonzero
  | |- _ => first [ assumption | nz_by_parts ]
  end
with nz_by_parts :=
  lazymatch goal with
  | |- _ * _ <> 0 => first [ apply Rmult_integral_contrapositive_currified; nz | nz_by_sign ]
  | |- _ / _ <> 0 => apply Rmult_integral_contrapositive_currified; [ nz | apply Rinv_neq_0_compat; nz ]
  | |- / _ <> 0 => apply Rinv_neq_0_compat; nz
  | |- _ ^ _ <> 0 => apply pow_nonzero; nz
  | |- - _ <> 0 => apply Ropp_neq_0_compat; nz
  | |- exp ?x - 1 <> 0 => apply exp_minus_one_nonzero; subst x; nz
  | |- _ => nz_by_sign
  end
with nz_by_sign :=
  first
    [ match goal with H : ?a <> 0 |- ?b <> 0 => let Z := fresh in intro Z; apply H; clear - Z; lra end
    | match goal with H : ?a <> ?z |- ?b <> 0 => let Z := fresh in intro Z; apply H; lra end
    | match goal with
      | H : ?a <> 0 |- ?b <> 0 => let Z := fresh in intro Z; apply H; field_simplify_eq; [ lra | nz ]
      end
    | apply Rgt_not_eq; unfold Rgt; pos
    | apply Rlt_not_eq; by_squares
    | lra ].
Ltac defined := first [ nz | pos | nonneg ].

(* Bars around what has a sign. *)
Ltac bars :=
  repeat match goal with
         | |- context [ Rabs ?u ] =>
             first [ rewrite (Rabs_pos_eq u) by nonneg | rewrite (Rabs_left1 u) by lra ]
         end.
(* The hypotheses with what the names stand for put in, and functions by others. *)
Ltac start :=
  intros; assert (pi_is_large : 3 < PI) by (generalize PI2_3_2; lra); subst; bars;
  unfold tan, cot, sec, csc, tanh, coth, sech, csch in *;
  repeat first [ rewrite cosh_by_exp in * | rewrite sinh_by_exp in * ].
(* A phase gets a name; an argument is a sum of phases. *)
Tactic Notation "phase" ident(f) constr(u) :=
  destruct (ex_intro (fun x => x = u) u eq_refl) as [f ?].
Tactic Notation "angle" constr(u) constr(s) :=
  let E := fresh in
  assert (E : u = s) by (subst; field; nz); rewrite ?(f_equal sin E), ?(f_equal cos E) in *; clear E.
Tactic Notation "exponent" constr(u) constr(s) :=
  let E := fresh in assert (E : exp u = exp s) by (f_equal; subst; field; nz); rewrite ?E in *; clear E.
Tactic Notation "square_root" ident(y) ident(square) constr(u) :=
  assert (square : 0 <= u) by nonneg; apply square_of_root in square;
  let E := fresh in
  destruct (ex_intro (fun x => x = sqrt u) (sqrt u) eq_refl) as [y E]; rewrite <- ?E in *;
  assert (0 <= y) by (rewrite E; apply sqrt_pos); clear E;
  try (assert (y <> 0) by (intro Z; rewrite Z in square; assert (0 < u) by pos; lra)).
Tactic Notation "root" constr(u) constr(v) "by" tactic3(squares) :=
  let E := fresh in
  assert (E : sqrt u = v) by (apply root_is; [ nonneg | squares ]); rewrite ?E in *; clear E.
(* The square of a number times the root of one. *)
Ltac square_of_numbers :=
  first [ field | rewrite square_of_root by lra; field | rewrite Rpow_mult_distr, square_of_root by lra; field ].
Ltac by_theorem u rewriting :=
  lazymatch u with
  | sin (_ + _) => rewriting sin_plus | cos (_ + _) => rewriting cos_plus | exp (_ + _) => rewriting exp_plus
  | sin (- _) => rewriting sin_neg | cos (- _) => rewriting cos_neg | exp (- _) => rewriting exp_Ropp
  | sin (PI / 2) => rewriting sin_PI2 | sin PI => rewriting sin_PI | sin 0 => rewriting sin_0
  | cos (PI / 2) => rewriting cos_PI2 | cos PI => rewriting cos_PI | cos 0 => rewriting cos_0
  | exp 0 => rewriting exp_0
  end.
Ltac addition_theorems :=
  repeat match goal with
         | H : context [ ?f ?x ] |- _ => by_theorem (f x) ltac:(fun E => rewrite E in H)
         | |- context [ ?f ?x ] => by_theorem (f x) ltac:(fun E => rewrite E)
         end.

(* The first conjunct, kept for the others. *)
Tactic Notation "first_of" tactic3(t) :=
  let D := fresh "D" in match goal with |- ?d /\ _ => assert (D : d) by t; split; [ exact D | ] end.
(* What is assumed is a multiple of it, or the same. *)
Tactic Notation "multiple" constr(k) tactic3(t) :=
  match goal with H : ?a <> 0 |- ?b <> 0 => apply (nonzero_by k a b H); solve [ t ] end.
Tactic Notation "as_known" tactic3(t) :=
  match goal with
  | H : 0 <= ?a |- 0 <= ?b => replace b with a by solve [ t ]; exact H
  | H : 0 < ?a |- 0 < ?b => replace b with a by solve [ t ]; exact H
  end.
(* An equation of fractions; `polynomial` and `fraction` know what squares are. *)
Tactic Notation "identity" tactic3(polynomial) "or" tactic3(fraction) :=
  first [ reflexivity | ring | solve [ field; nz ] | solve [ polynomial ] | solve [ fraction; nz ] ].
(* What the sides imply of each other, link by link. *)
Ltac links :=
  split; intros; repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split;
  first [ lra | by_squares | pos ].
