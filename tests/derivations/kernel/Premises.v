(* That the premises of a theorem hold at some values of its variables: the values that are in the context under the
   names of the variables, those that an equation among the premises gives, and 1 for the rest. *)
From Rederive Require Import Rederive Solutions Limits.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.

(* Leaves a goal for each premise of the theorem I. *)
Ltac premises I :=
  cbv zeta in I;
  lazymatch type of I with
  | ?P -> ?Q =>
      lazymatch type of P with
      | Prop => let H := fresh in assert (H : P); [ clear I | specialize (I H); clear H; premises I ]
      | _ => let unknown := open_constr:(_ : P) in specialize (I unknown); premises I
      end
  | forall x : ?T, _ =>
      first [ specialize (I x) | let unknown := open_constr:(_ : T) in specialize (I unknown) ]; premises I
  | _ => clear I; exact Logic.I
  end.
Ltac separate :=
  repeat match goal with
         | |- _ /\ _ => split
         | |- forall t, _ /\ _ => let t := fresh "t" in intro t; split
         end.

(* What an equation says an unknown number or function is. *)
Lemma quotient_is x p e : p <> 0 -> x = p * e -> x / p = e.
Proof. intros P ->; field; exact P. Qed.
Ltac define_function t :=
  lazymatch goal with
  | |- ?f t = _ => is_evar f; reflexivity
  | |- ?f t / _ = _ => is_evar f; refine (quotient_is _ _ _ _ _); [ | reflexivity ]
  end.
Ltac define :=
  lazymatch goal with
  | |- forall t, _ = _ => let t := fresh "t" in intro t; define_function t
  | |- ?x / _ = _ => is_evar x; refine (quotient_is _ _ _ _ _); [ | reflexivity ]
  | |- ?l = ?r => first [ is_evar l; reflexivity | is_evar r; reflexivity ]
  end.
Ltac functions := repeat match goal with f := _ : _ -> _ |- _ => subst f end.
Ltac values := repeat match goal with x := _ |- _ => subst x end.
Ltac derive :=
  intros; lazymatch goal with
  | |- is_derive ?f ?t (?g ?t) =>
      is_evar g; is_var t; values; unfold sinh, cosh; auto_derive; [ | symmetry; reflexivity ]
  end.
Ltac guess :=
  repeat match goal with
         | |- context [ ?unknown ] =>
             is_evar unknown; first [ unify unknown (1 : R) | unify unknown (fun _ : R => 1 : R) ]
         end.

(* Proofs of premises without unknowns. *)
Ltac size :=
  first [ lra | interval | apply Rgt_not_eq; unfold Rgt; interval | apply Rlt_not_eq; interval
        | rewrite asin_atan by lra; unfold Rsqr; interval | solve [ nz ] ].
Ltac sizes := repeat match goal with |- _ /\ _ => split end; values; size.
Ltac equal :=
  first [ reflexivity | ring | field; sizes
        | let S := fresh in assert (S : sqrt 3 ^ 2 = 3) by (apply square_of_root; lra); field [S]; sizes ].
Ltac derivative := auto_derive; [ first [ trivial | sizes ] | unfold Rminus; equal ].
Definition tried (u : R) := True.  (* each angle is tried once, no matter how often it occurs *)
Ltac angles_of_zero :=
  repeat match goal with
         | |- context [ ?f ?u ] =>
             lazymatch f with sin => idtac | cos => idtac | exp => idtac end;
             lazymatch goal with _ : tried u |- _ => fail | _ => idtac end;
             lazymatch u with 0 => fail | _ => first [ replace u with 0 by (field; fail) | assert (tried u) by exact I ] end
         end;
  repeat match goal with H : tried _ |- _ => clear H end.
Lemma over_1 x : x / 1 = x. Proof. field. Qed.
Ltac simple :=
  cbv beta; unfold sinh, cosh, cot, tan in *; angles_of_zero;
  repeat first [ rewrite Rmult_0_r | rewrite Rmult_1_l | rewrite over_1 | rewrite Rplus_0_l | rewrite Rplus_0_r
               | rewrite Rminus_0_r ];
  rewrite ?sin_0, ?cos_0, ?exp_0, ?Rtrigo_facts.cos_pi_minus, ?Rtrigo_facts.sin_pi_minus, ?sin_PI3, ?cos_PI3;
  rewrite ?exp_Ropp;
  repeat rewrite exp_ln by lra; repeat rewrite sin_asin by lra.
Ltac finish :=
  first [ assumption | solve [ intros; functions; unfold sinh, cosh; derivative ]
        | intros; values; try match goal with H : ?x = _ |- _ => is_var x; subst x end; simple;
          first [ solve [ equal ] | solve [ size ] | solve [ derivative ] | solve [ split; derivative ]
                | apply is_lim_const ] ].
