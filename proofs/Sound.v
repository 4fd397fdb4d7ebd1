(** What the checker accepts is so: sums of rows hold of every motion. *)

From Coq Require Import QArith Reals Qreals List Lra Lia.
From Signorini Require Import Numbers Chain Checker.
Import ListNotations.
Open Scope R_scope.

Definition value (f : form) (x : local) : R :=
  Q2R (ofLeft f) * fromLeft x + Q2R (ofRight f) * fromRight x +
  Q2R (ofLeftFace f) * leftFace x + Q2R (ofRightFace f) * rightFace x.

Fixpoint total (fs : list form) (xs : state) : R :=
  match xs with [] => 0 | x :: xs' => value (first fs) x + total (tl fs) xs' end.

Ltac reals := autorewrite with real; try lra; try ring.

Lemma value_plus f g x : value (plus f g) x = value f x + value g x.
Proof. unfold value; simpl; reals. Qed.

Lemma value_times m f x : value (times m f) x = Q2R m * value f x.
Proof. unfold value; simpl; reals. Qed.

Lemma value_zero x : value zero x = 0.
Proof. unfold value; simpl; reals. Qed.

Lemma total_nil xs : total [] xs = 0.
Proof. induction xs as [|x xs IH]; simpl; auto. rewrite IH. unfold first; simpl. rewrite value_zero. lra. Qed.

Lemma total_plusAll fs : forall gs xs, total (plusAll fs gs) xs = total fs xs + total gs xs.
Proof.
  induction fs as [|f fs IH]; intros [|g gs] xs; simpl; rewrite ?total_nil; try lra.
  destruct xs as [|x xs]; simpl; [lra|]. unfold first; simpl. rewrite IH, value_plus. lra.
Qed.

Lemma total_plusAt k : forall g fs xs x, nth_error xs k = Some x ->
  total (plusAt k g fs) xs = total fs xs + value g x.
Proof.
  induction k as [|k IH]; intros g fs [|y xs] x H; simpl in *; try discriminate.
  - injection H as ->. rewrite value_plus. lra.
  - rewrite (IH g (tl fs) xs x H). lra.
Qed.

Lemma total_times m fs : forall xs, total (map (times m) fs) xs = Q2R m * total fs xs.
Proof.
  induction fs as [|f fs IH]; intros [|x xs]; simpl; rewrite ?total_nil; try lra.
  - unfold first; simpl. rewrite value_zero. lra.
  - unfold first; simpl. rewrite value_times, IH. lra.
Qed.

Lemma march_pull ns : forall xs ss fs left arriving, length xs = length ns ->
  total fs (snd (march arriving ns ss xs)) + Q2R left * fst (march arriving ns ss xs) =
  total (pull left ns ss fs) xs + match ns with [] => 0 | _ => Q2R (ofLeft (first fs)) end * arriving.
Proof.
  induction ns as [|n ns IH]; intros [|x xs] ss fs left arriving H; simpl in H; try discriminate.
  - simpl. lra.
  - injection H as H. simpl.
    specialize (IH xs (tl ss) (tl fs) (ofRight (first fs))
                  (rightVelocity n (hd Open ss) x - fromRight x) H).
    destruct (march _ ns (tl ss) xs) as [back rest]. simpl in *.
    unfold leftVelocity, rightVelocity, along in *.
    destruct (velocities n (hd Open ss)) as [vl vr]. simpl in *.
    unfold first in *; simpl. unfold value at 1 2; simpl. autorewrite with real.
    set (w := match ns with [] => 0%Q | _ => ofLeft (hd zero (tl fs)) end).
    assert (W : match ns with [] => 0 | _ => Q2R (ofLeft (hd zero (tl fs))) end = Q2R w)
      by (subst w; destruct ns; auto using Q2R_0).
    rewrite W in IH. clear W. clearbody w. lra.
Qed.

Lemma step_pull ns ss xs fs : length xs = length ns ->
  total fs (step ns ss xs) = total (pull 0 ns ss fs) xs.
Proof. intro H. pose proof (march_pull ns xs ss fs 0 0 H) as K. unfold step. rewrite Q2R_0 in K. lra. Qed.

Lemma length_march ns : forall xs ss arriving, length xs = length ns ->
  length (snd (march arriving ns ss xs)) = length ns.
Proof.
  induction ns as [|n ns IH]; intros [|x xs] ss arriving H; simpl in *; try discriminate; auto.
  injection H as H. specialize (IH xs (tl ss) (rightVelocity n (hd Open ss) x - fromRight x) H).
  destruct (march _ ns (tl ss) xs). simpl in *. congruence.
Qed.

Definition holds (x : local) (r : row) : Prop :=
  let e := value (theForm r) x + Q2R (constant r) in if equality r then e = 0 else 0 <= e.

Lemma Q2R_2 : Q2R 2 = 2.
Proof. unfold Q2R; simpl; lra. Qed.

Lemma Q2R_m1 : Q2R (-1) = -1.
Proof. unfold Q2R; simpl; lra. Qed.

Lemma rowsOf_hold n s x : obeys n s x -> Forall (holds x) (rowsOf n s).
Proof.
  destruct n as [[limit|]| |z1 z2 z low high|z1 d1 z2 d2 g], s; simpl; intro H;
    unfold leftVelocity, rightVelocity, along, stopPush, gapPush in *; simpl in H; unfold bounded, resting;
    repeat match goal with
    | low : option Q |- _ => destruct low; simpl in H
    end; repeat (apply Forall_cons || apply Forall_nil); unfold holds, value; simpl;
    rewrite ?Q2R_opp, ?Q2R_mult, ?Q2R_opp, ?Q2R_mult, ?Q2R_0, ?Q2R_1, ?Q2R_2, ?Q2R_m1 in *; try lra.
Qed.

Lemma weighed_holds x : forall rs ms f c, Forall (holds x) rs -> weighed ms rs = Some (f, c) ->
  0 <= value f x + Q2R c.
Proof.
  induction rs as [|r rs IH]; intros [|m ms] f c H E; simpl in E; try discriminate.
  1, 2: injection E as <- <-; rewrite value_zero, Q2R_0; lra.
  destruct (equality r || Qle_bool 0 m)%bool eqn:B; [|discriminate].
  destruct (weighed ms rs) as [[g d]|] eqn:E'; [|discriminate]. injection E as <- <-.
  inversion H as [|? ? Hr Hrs]; subst. specialize (IH ms g d Hrs E').
  rewrite value_plus, value_times. autorewrite with real. unfold holds in Hr.
  destruct (equality r); simpl in B.
  - nra.
  - apply le_R in B. rewrite Q2R_0 in B. nra.
Qed.

Lemma allObey_nth ns : forall ss xs k n, length xs = length ns -> allObey ns ss xs ->
  nth_error ns k = Some n -> exists x, nth_error xs k = Some x /\ obeys n (nth k ss Open) x.
Proof.
  induction ns as [|m ns IH]; intros ss [|x xs] [|k] n L H E; simpl in *; try discriminate.
  - injection E as ->. exists x. split; auto. destruct ss; apply H.
  - injection L as L. destruct (IH (tl ss) xs k n L (proj2 H) E) as [y [Y O]]. exists y. split; auto.
    destruct ss; simpl in *; auto. destruct k; auto.
Qed.

Lemma withRows_holds ns ss xs : length xs = length ns -> allObey ns ss xs ->
  forall listed fs c fs' c', withRows ns ss listed fs c = Some (fs', c') ->
  total fs xs + Q2R c <= total fs' xs + Q2R c'.
Proof.
  intros L H listed. induction listed as [|[k ms] rest IH]; intros fs c fs' c' E; simpl in E.
  - injection E as <- <-. lra.
  - destruct (nth_error ns k) as [n|] eqn:N; [|discriminate].
    destruct (weighed ms (rowsOf n (nth k ss Open))) as [[f d]|] eqn:W; [|discriminate].
    apply IH in E. destruct (allObey_nth ns ss xs k n L H N) as [x [X O]].
    pose proof (weighed_holds x _ _ _ _ (rowsOf_hold _ _ _ O) W).
    rewrite (total_plusAt k f fs xs x X), add_R in E. lra.
Qed.

Lemma pulled_holds ns : forall steps listed fs xs gs c, length xs = length ns -> rowsHold ns steps xs ->
  pulled ns steps listed fs = Some (gs, c) -> total fs (carried ns steps xs) <= total gs xs + Q2R c.
Proof.
  induction steps as [|ss steps IH]; intros listed fs xs gs c L H E; simpl in *.
  - injection E as <- <-. rewrite Q2R_0. lra.
  - destruct (pulled ns steps (tl listed) fs) as [[hs d]|] eqn:P; [|discriminate].
    destruct H as [H Hs]. apply (withRows_holds ns ss xs L H) in E.
    assert (L' : length (step ns ss xs) = length ns) by (apply length_march, L).
    specialize (IH (tl listed) fs (step ns ss xs) hs d L' Hs P).
    rewrite (step_pull ns ss xs hs L) in IH. lra.
Qed.

Lemma joining_holds ns : forall xs left listed, length xs = length ns -> joined ns xs ->
  total (joining left ns listed) xs =
  match xs with [] => 0 | x :: _ => Q2R left * (fromLeft x + leftFace x) end.
Proof.
  induction ns as [|n ns IH]; intros [|x xs] left listed L H; try discriminate; [reflexivity|].
  injection L as L. cbn [joining joined] in *. destruct H as [T [J C]].
  destruct (hd (0, 0, 0)%Q listed) as [[a b] c].
  set (cell := match ns with [] => 0%Q | _ => a end).
  set (one := match n with Gap _ _ _ _ _ => 0%Q | _ => b end).
  set (held := match n with Clamp _ => c | _ => 0%Q end).
  cbn [total first hd tl]. rewrite (IH xs cell (tl listed) L J).
  unfold value; cbn [ofLeft ofRight ofLeftFace ofRightFace]. autorewrite with real.
  assert (O : Q2R one * (rightFace x - leftFace x) = 0).
  { subst one. destruct n; simpl in T; rewrite ?Q2R_0; try ring; [destruct T as [T ->]| |]; rewrite T; ring. }
  assert (K : Q2R held * leftFace x = 0).
  { subst held. destruct n; simpl in T; rewrite ?Q2R_0; try ring. destruct T as [-> _]. ring. }
  destruct xs as [|y xs], ns as [|n' ns]; simpl in L; try discriminate.
  - subst cell. rewrite Q2R_0. lra.
  - clearbody cell. assert (Q2R cell * (leftFace y + fromLeft y - rightFace x - fromRight x) = 0)
      by (replace (leftFace y + fromLeft y - rightFace x - fromRight x) with 0 by lra; ring).
    lra.
Qed.

Lemma summed_holds ns steps c fs d xs : motion ns steps xs -> summed ns steps c = Some (fs, d) ->
  0 <= total fs xs + Q2R d.
Proof.
  intros [L J H P] E. unfold summed in E.
  destruct (pulled ns steps (inSteps c) (atEnd c)) as [[gs e]|] eqn:G; [|discriminate].
  injection E as <- <-. apply (pulled_holds ns steps _ _ xs gs e L H) in G. rewrite P in G.
  rewrite !total_plusAll, total_times, Q2R_m1, (joining_holds ns xs 0 _ L J), Q2R_0.
  destruct xs; lra.
Qed.

Lemma value_is_zero f x : is_zero_form f = true -> value f x = 0.
Proof.
  unfold is_zero_form. intro H. repeat (apply andb_prop in H; destruct H as [H ?H]).
  unfold value. repeat rewrite is_zero_R by assumption. ring.
Qed.

Lemma total_is_zero fs : forall xs, forallb is_zero_form fs = true -> total fs xs = 0.
Proof.
  induction fs as [|f fs IH]; intros [|x xs] H; rewrite ?total_nil; auto. simpl in H.
  apply andb_prop in H. destruct H as [F H]. simpl. unfold first; simpl.
  rewrite (IH xs H), (value_is_zero f x F). ring.
Qed.

(** ** Theorem: what is checked is so. *)

Theorem check_correct ns steps c : check ns steps c = true -> forall xs, ~ motion ns steps xs.
Proof.
  unfold check. intros H xs M. destruct (summed ns steps c) as [[fs d]|] eqn:E; [|discriminate].
  apply andb_prop in H. destruct H as [Z D]. apply Bool.negb_true_iff, lt_R in D. rewrite Q2R_0 in D.
  pose proof (summed_holds ns steps c fs d xs M E). rewrite (total_is_zero fs xs Z) in *. lra.
Qed.

Lemma square_bound f w s : square f w = Some s -> 0 <= Q2R s /\
  forall t x, 2 * t * (Q2R f * x) - t * t * Q2R s <= Q2R w * (x * x).
Proof.
  unfold square. destruct (is_zero f) eqn:Z.
  - destruct (Qle_bool 0 w) eqn:W; [|discriminate]. intro H. injection H as <-.
    apply le_R in W. rewrite Q2R_0 in *. rewrite (is_zero_R f Z). split; [lra|]. intros. nra.
  - destruct (Qle_bool w 0) eqn:W; [discriminate|]. intro H. injection H as <-.
    apply lt_R in W. rewrite Q2R_0 in W. rewrite !mul_R, Q2R_red.
    assert (N : ~ (w == 0)%Q). { intro E. apply Qeq_eqR in E. rewrite Q2R_0 in E. lra. }
    rewrite Q2R_inv by exact N. set (v := Q2R w) in *. set (g := Q2R f).
    assert (I : 0 < / v) by (apply Rinv_0_lt_compat; lra). split; [nra|]. intros t x.
    assert (0 <= v * ((x - t * g * / v) * (x - t * g * / v))) by (apply Rmult_le_pos; [lra|apply Rle_0_sqr]).
    replace (v * ((x - t * g * / v) * (x - t * g * / v)))
      with (v * (x * x) - 2 * t * (g * x) + t * t * (g * g * / v)) in * by (field; lra).
    lra.
Qed.

Lemma squares_bound ws : forall fs s, squares ws fs = Some s -> 0 <= Q2R s /\
  forall t xs, 2 * t * total fs xs - t * t * Q2R s <= energy ws xs.
Proof.
  induction ws as [|w ws IH]; intros fs s H; simpl in H.
  - destruct (forallb is_zero_form fs) eqn:Z; [|discriminate]. injection H as <-. rewrite Q2R_0.
    split; [lra|]. intros t xs. rewrite (total_is_zero fs xs Z). destruct xs; simpl; lra.
  - destruct (square (ofLeft (first fs)) (fst w)) as [a|] eqn:A; [|discriminate].
    destruct (square (ofRight (first fs)) (snd w)) as [b|] eqn:B; [|discriminate].
    destruct (squares ws (tl fs)) as [c|] eqn:C; [|discriminate].
    destruct (is_zero (ofLeftFace (first fs)) && is_zero (ofRightFace (first fs)))%bool eqn:Z; [|discriminate].
    injection H as <-. apply andb_prop in Z. destruct Z as [Z1 Z2].
    apply square_bound in A, B. apply IH in C. destruct A as [A0 A], B as [B0 B], C as [C0 C].
    autorewrite with real. split; [lra|]. intros t [|x xs].
    + simpl. nra.
    + specialize (A t (fromLeft x)). specialize (B t (fromRight x)). specialize (C t xs).
      simpl. unfold value. rewrite (is_zero_R _ Z1), (is_zero_R _ Z2). lra.
Qed.

Theorem leastEnergy_correct ws ns steps c bound : leastEnergy ws ns steps c = Some bound ->
  forall xs, motion ns steps xs -> Q2R bound <= energy ws xs.
Proof.
  unfold leastEnergy. intros H xs M.
  destruct (summed ns steps c) as [[fs d]|] eqn:E; [|discriminate].
  pose proof (summed_holds ns steps c fs d xs M E).
  destruct (squares ws fs) as [s|] eqn:S; [|discriminate]. apply squares_bound in S. destruct S as [_ S].
  set (t := Qred (- d / s)) in *. destruct (Qle_bool 0 t) eqn:T; [|discriminate].
  injection H as <-. apply le_R in T. rewrite Q2R_0 in T. specialize (S (Q2R t) xs).
  autorewrite with real. rewrite Q2R_2. clearbody t. nra.
Qed.

Corollary checkLeast_correct ws ns steps c bound : checkLeast ws ns steps c bound = true ->
  forall xs, motion ns steps xs -> Q2R bound <= energy ws xs.
Proof.
  unfold checkLeast. intros H xs M. destruct (leastEnergy ws ns steps c) as [e|] eqn:E; [|discriminate].
  apply le_R in H. pose proof (leastEnergy_correct ws ns steps c e E xs M). lra.
Qed.

