(** Fractions that stay in lowest terms, and the real numbers that they are.

    The checker adds and multiplies fractions; motions are real. Short cuts for 0, 1 and whole numbers
    keep the checker fast: most of its numbers are one of these. *)

From Coq Require Import QArith Reals Qreals Lra.

Definition is_zero (a : Q) : bool := match Qnum a with Z0 => true | _ => false end.
Definition is_whole (a : Q) : bool := match Qden a with xH => true | _ => false end.

Definition add (a b : Q) : Q :=
  if is_zero a then b else if is_zero b then a
  else if (is_whole a && is_whole b)%bool then (Qnum a + Qnum b)%Z # 1
  else Qred (a + b).

Definition mul (a b : Q) : Q :=
  if (is_zero a || is_zero b)%bool then 0
  else if (is_whole a && is_whole b)%bool then (Qnum a * Qnum b)%Z # 1
  else Qred (a * b).

Open Scope R_scope.

Lemma is_zero_R a : is_zero a = true -> Q2R a = 0.
Proof.
  destruct a as [[|p|p] d]; simpl; try discriminate. intros _. unfold Q2R; simpl. lra.
Qed.

Lemma Q2R_red a : Q2R (Qred a) = Q2R a.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma Q2R_whole a : is_whole a = true -> Q2R a = IZR (Qnum a).
Proof.
  destruct a as [n [d|d|]]; simpl; try discriminate. intros _. unfold Q2R; simpl. field.
Qed.

Lemma add_R a b : Q2R (add a b) = Q2R a + Q2R b.
Proof.
  unfold add.
  destruct (is_zero a) eqn:Ha. { rewrite (is_zero_R a Ha). lra. }
  destruct (is_zero b) eqn:Hb. { rewrite (is_zero_R b Hb). lra. }
  destruct (is_whole a) eqn:Wa, (is_whole b) eqn:Wb; cbn [andb]; try (rewrite Q2R_red; apply Q2R_plus).
  rewrite (Q2R_whole a Wa), (Q2R_whole b Wb), Q2R_whole by reflexivity. apply plus_IZR.
Qed.

Lemma mul_R a b : Q2R (mul a b) = Q2R a * Q2R b.
Proof.
  unfold mul.
  destruct (is_zero a) eqn:Ha. { rewrite (is_zero_R a Ha). simpl. rewrite RMicromega.Q2R_0. lra. }
  destruct (is_zero b) eqn:Hb. { rewrite (is_zero_R b Hb). simpl. rewrite RMicromega.Q2R_0. lra. }
  destruct (is_whole a) eqn:Wa, (is_whole b) eqn:Wb; cbn [andb orb]; try (rewrite Q2R_red; apply Q2R_mult).
  rewrite (Q2R_whole a Wa), (Q2R_whole b Wb), Q2R_whole by reflexivity. apply mult_IZR.
Qed.

Lemma opp_R a : Q2R (- a) = - Q2R a.
Proof. apply Q2R_opp. Qed.

Lemma Q2R_0 : Q2R 0 = 0.
Proof. apply RMicromega.Q2R_0. Qed.

Lemma Q2R_1 : Q2R 1 = 1.
Proof. apply RMicromega.Q2R_1. Qed.

Lemma le_R a b : Qle_bool a b = true -> Q2R a <= Q2R b.
Proof. intro H. apply Qle_Rle, Qle_bool_iff, H. Qed.

Lemma lt_R a b : Qle_bool b a = false -> Q2R a < Q2R b.
Proof.
  intro H. apply Qlt_Rlt. apply Qnot_le_lt. intro K. apply Qle_bool_iff in K. congruence.
Qed.

Global Hint Rewrite add_R mul_R opp_R Q2R_0 Q2R_1 Q2R_red : real.
