(** The paper's bar as a network: where (30)-(32) hold there is a motion of the network, so what the checker of
    networks refutes of it has no a, b. *)

From Coq Require Import QArith Reals Qreals ZArith List Lia Lra.
From Signorini Require Import Numbers Sound Sums Network Paper Verdict Joined.
Import ListNotations.
Open Scope R_scope.

Definition paperNetwork (N : nat) : network := {|
  cells := map (fun k => Cell k (S k) 1) (seq 0 N);
  meetings := Meeting true 0 :: repeat (Meeting false 0) N;
  contacts := [StopRight N (Z.of_nat N # 1)%Q] |}.
Definition paperClosed (contact free : nat) : list (list bool) := repeat [true] contact ++ repeat [false] free.

Lemma nth_range (f : nat -> R) n i : (i < n)%nat -> nth i (map f (seq 0 n)) 0 = f i.
Proof.
  intro I. rewrite (nth_indep _ 0 (f 0%nat)) by (rewrite map_length, seq_length; exact I).
  rewrite map_nth, seq_nth by exact I. reflexivity.
Qed.

Lemma over_one n j f : over n (fun k => if (k =? j)%nat then f k else 0) = if (j <? n)%nat then f j else 0.
Proof.
  unfold over. induction n as [|n IH]; [reflexivity|]. rewrite seq_S, map_app, fold_right_app. cbn [map fold_right plus].
  assert (A : forall l c, fold_right Rplus c l = fold_right Rplus 0 l + c) by (induction l as [|x l IL]; intro c; simpl; [lra|rewrite IL; lra]).
  rewrite A, IH. destruct (Nat.ltb_spec j n), (Nat.ltb_spec j (S n)), (Nat.eqb_spec n j); subst; try lia; lra.
Qed.

Lemma over_plus n f g : over n (fun k => f k + g k) = over n f + over n g.
Proof. unfold over. induction (seq 0 n) as [|k l IH]; simpl; [lra|]. rewrite IH. lra. Qed.

Section PaperNetwork.
Variables N contact free : nat.
Hypothesis N_positive : (0 < N)%nat.
Hypothesis contact_positive : (0 < contact)%nat.
Hypothesis free_positive : (0 < free)%nat.
Let net := paperNetwork N.
Variables a b : Z -> R.
Let p := p N contact free a b.

Definition placeAt (t i : nat) : R := sum p (t + N - i) - sum p (t + N + i).
Definition xAt (t : nat) : list R :=
  map (fun k => p (t + N - S k)) (seq 0 N) ++ map (fun k => - p (t + N + k)) (seq 0 N) ++
  map (placeAt t) (seq 0 (S N)).
Definition yAt (t : nat) : list R :=
  map (fun i => placeAt (S t) i - placeAt t i) (seq 0 (S N)) ++ [(1 + reflected contact free t) * p t].

Lemma lengths : length (cells net) = N /\ length (meetings net) = S N.
Proof. unfold net, paperNetwork. cbn. rewrite map_length, seq_length, repeat_length. auto. Qed.

Lemma reads t (z := xAt t ++ yAt t) :
  (forall k, (k < N)%nat -> nth (rightGoing k) z 0 = p (t + N - S k)) /\
  (forall k, (k < N)%nat -> nth (leftGoing net k) z 0 = - p (t + N + k)) /\
  (forall i, (i <= N)%nat -> nth (placeOf net i) z 0 = placeAt t i) /\
  (forall i, (i <= N)%nat -> nth (velocityOf net i) z 0 = placeAt (S t) i - placeAt t i) /\
  nth (pushOf net 0) z 0 = (1 + reflected contact free t) * p t.
Proof.
  unfold z, xAt, yAt, rightGoing, leftGoing, placeOf, velocityOf, pushOf. destruct lengths as [-> ->].
  rewrite <- !app_assoc.
  set (A := map (fun k => p (t + N - S k)) (seq 0 N)). set (B := map (fun k => - p (t + N + k)) (seq 0 N)).
  set (C := map (placeAt t) (seq 0 (S N))). set (V := map (fun i => placeAt (S t) i - placeAt t i) (seq 0 (S N))).
  assert (LA : length A = N) by (unfold A; rewrite map_length, seq_length; reflexivity).
  assert (LB : length B = N) by (unfold B; rewrite map_length, seq_length; reflexivity).
  assert (LC : length C = S N) by (unfold C; rewrite map_length, seq_length; reflexivity).
  assert (LV : length V = S N) by (unfold V; rewrite map_length, seq_length; reflexivity).
  repeat split.
  - intros k K. rewrite app_nth1 by lia. apply (nth_range (fun k => p (t + N - S k))), K.
  - intros k K. rewrite app_nth2 by lia. replace (N + k - length A)%nat with k by lia. rewrite app_nth1 by lia.
    apply (nth_range (fun k => - p (t + N + k))), K.
  - intros i I. do 2 rewrite app_nth2 by lia. replace (2 * N + i - length A - length B)%nat with i by lia.
    rewrite app_nth1 by lia. apply (nth_range (placeAt t)). lia.
  - intros i I. do 3 rewrite app_nth2 by lia. replace (2 * N + S N + i - length A - length B - length C)%nat with i by lia.
    rewrite app_nth1 by lia. apply (nth_range (fun i => placeAt (S t) i - placeAt t i)). lia.
  - do 4 rewrite app_nth2 by lia. replace (2 * N + 2 * S N + 0 - length A - length B - length C - length V)%nat with 0%nat by lia.
    reflexivity.
Qed.

Lemma cell_is k : (k < N)%nat -> nth k (cells net) noCell = Cell k (S k) 1.
Proof.
  intro K. unfold net, paperNetwork. cbn [cells].
  rewrite (nth_indep _ noCell (Cell 0 1 1)) by (rewrite map_length, seq_length; exact K).
  rewrite (map_nth (fun k => Cell k (S k) 1)), seq_nth by exact K. reflexivity.
Qed.

Lemma moves t i : (i <= N)%nat -> placeAt (S t) i - placeAt t i = p (t + N - i) - p (t + N + i).
Proof.
  intro I. unfold placeAt. replace (S t + N - i)%nat with (S (t + N - i)) by lia.
  replace (S t + N + i)%nat with (S (t + N + i)) by lia. cbn [sum]. lra.
Qed.

Lemma echo t : p (t + N + N) = reflected contact free t * p t.
Proof. replace (t + N + N)%nat with (t + 2 * N)%nat by lia. apply p_delay; assumption. Qed.

Lemma law_at t i : (i <= N)%nat -> lawAt net (xAt t ++ yAt t) i.
Proof.
  intro I. destruct (reads t) as [Rr [Rl [_ [Rv Rq]]]]. set (z := xAt t ++ yAt t) in *. unfold lawAt.
  rewrite Rv, moves by exact I. destruct i as [|i].
  - cbn. rewrite Nat.sub_0_r, Nat.add_0_r. lra.
  - assert (F : clamped (nth (S i) (meetings net) noMeeting) = false /\ dashpot (nth (S i) (meetings net) noMeeting) = 0%Q).
    { unfold net, paperNetwork. cbn [meetings nth]. rewrite (nth_indep _ noMeeting (Meeting false 0)) by (rewrite repeat_length; lia).
      rewrite nth_repeat. split; reflexivity. }
    destruct F as [-> ->]. rewrite Q2R_0.
    assert (S1 : stiffness net (S i) = 1 + if (S i <? N)%nat then 1 else 0).
    { unfold stiffness. destruct lengths as [-> _].
      transitivity (over N (fun k => if (k =? i)%nat then 1 else 0) + over N (fun k => if (k =? S i)%nat then 1 else 0)).
      - rewrite <- over_plus. unfold over. f_equal. apply map_ext_in. intros k K. apply in_seq in K. cbv zeta.
        rewrite cell_is by lia. cbn [leftEnd rightEnd impedance]. rewrite Q2R_1. reflexivity.
      - rewrite !(over_one _ _ (fun _ => 1)). destruct (Nat.ltb_spec i N); [reflexivity|lia]. }
    assert (A1 : arriving net z (S i) = p (t + N - S i) + if (S i <? N)%nat then - p (t + N + S i) else 0).
    { unfold arriving. destruct lengths as [-> _].
      transitivity (over N (fun k => if (k =? i)%nat then p (t + N - S k) else 0) +
                    over N (fun k => if (k =? S i)%nat then - p (t + N + k) else 0)).
      - rewrite <- over_plus. unfold over. f_equal. apply map_ext_in. intros k K. apply in_seq in K. cbv zeta.
        rewrite cell_is by lia. cbn [leftEnd rightEnd impedance]. rewrite Q2R_1, Rr, Rl by lia.
        cbn [Nat.eqb]. rewrite !Rmult_1_l. reflexivity.
      - rewrite (over_one _ _ (fun k => p (t + N - S k))), (over_one _ _ (fun k => - p (t + N + k))).
        destruct (Nat.ltb_spec i N); [reflexivity|lia]. }
    assert (P1 : Network.pushes net z (S i) = if (N =? S i)%nat then - ((1 + reflected contact free t) * p t) else 0).
    { unfold Network.pushes, over. cbn [net paperNetwork contacts length seq map fold_right nth]. fold net. rewrite Rq.
      destruct (N =? S i)%nat; lra. }
    rewrite S1, A1, P1. destruct (Nat.ltb_spec (S i) N), (Nat.eqb_spec N (S i)) as [E|E]; try lia; [lra|].
    rewrite <- E. replace (t + N - N)%nat with t by lia. rewrite echo. lra.
Qed.

Lemma stepped_at t : stepped net (xAt t ++ yAt t) = xAt (S t).
Proof.
  destruct (reads t) as [Rr [Rl [Ru [Rv _]]]]. set (z := xAt t ++ yAt t) in *.
  unfold stepped, xAt. destruct lengths as [-> ->].
  f_equal; [|f_equal]; apply map_ext_in; intros k K; apply in_seq in K.
  - rewrite cell_is by lia. cbn [leftEnd]. rewrite Rv, Rl, moves by lia.
    replace (S t + N - S k)%nat with (t + N - k)%nat by lia. lra.
  - rewrite cell_is by lia. cbn [rightEnd]. rewrite Rv, Rr, moves by lia.
    replace (S t + N + k)%nat with (t + N + S k)%nat by lia. lra.
  - rewrite Ru, Rv by lia. lra.
Qed.

Lemma together_at : together net (xAt 0).
Proof.
  destruct (reads 0) as [Rr [Rl [Ru _]]]. destruct lengths as [LK LM].
  assert (LX : length (xAt 0) = (2 * N + S N)%nat) by (unfold xAt; rewrite !app_length, !map_length, !seq_length; lia).
  assert (In : forall k, (k < 2 * N + S N)%nat -> nth k (xAt 0) 0 = nth k (xAt 0 ++ yAt 0) 0)
    by (intros k K; rewrite app_nth1 by lia; reflexivity).
  unfold together. rewrite LK, LM. split.
  - intros k K. rewrite cell_is by exact K. cbn [leftEnd rightEnd].
    rewrite !In by (unfold placeOf, leftGoing, rightGoing; rewrite ?LK; lia). rewrite !Ru, Rr, Rl by lia. unfold placeAt.
    replace (0 + N - k)%nat with (S (0 + N - S k)) by lia. replace (0 + N + S k)%nat with (S (0 + N + k)) by lia.
    cbn [sum]. lra.
  - intros [|i] I C.
    + rewrite In by (unfold placeOf; rewrite LK; lia). rewrite Ru by lia. unfold placeAt. rewrite Nat.sub_0_r, Nat.add_0_r. lra.
    + exfalso. revert C. unfold net, paperNetwork. cbn [meetings nth].
      rewrite (nth_indep _ noMeeting (Meeting false 0)) by (rewrite repeat_length; lia). rewrite nth_repeat. discriminate.
Qed.

Lemma obeys_at t (closed : bool) :
  (if closed then reflected contact free t = 1 /\ placeAt t N = INR N /\ 0 <= p t
   else reflected contact free t = -1 /\ placeAt t N + 2 * p t <= INR N) -> obeysAll net (xAt t ++ yAt t) [closed].
Proof.
  intro H. destruct (reads t) as [_ [_ [Ru [Rv Rq]]]]. split.
  - intros i I. apply law_at. destruct lengths as [_ E]. rewrite E in I. lia.
  - intros j J. cbn in J. assert (j = 0%nat) as -> by lia. unfold contactObeys.
    change (nth 0 (contacts net) noContact) with (StopRight N (Z.of_nat N # 1)). change (nth 0 [closed] false) with closed.
    assert (Q : Q2R (Z.of_nat N # 1) = INR N) by (unfold Q2R; simpl; rewrite <- INR_IZR_INZ; field).
    destruct closed; rewrite Ru, Rv, Rq, Q, moves by lia; replace (t + N - N)%nat with t by lia; rewrite echo;
      destruct H as [-> H]; repeat split; lra.
Qed.

Lemma marches_at steps : forall t, (forall i, (i < length steps)%nat -> obeysAll net (xAt (t + i) ++ yAt (t + i)) (nth i steps [])) ->
  marches net steps (xAt t) (map yAt (seq t (length steps))) (xAt (t + length steps)).
Proof.
  induction steps as [|s steps IH]; intros t H; cbn [length seq map marches]; [rewrite Nat.add_0_r; reflexivity|].
  split; [specialize (H 0%nat ltac:(cbn; lia)); rewrite Nat.add_0_r in H; exact H|]. rewrite stepped_at.
  replace (t + S (length steps))%nat with (S t + length steps)%nat by lia. apply IH. intros i I.
  specialize (H (S i) ltac:(cbn; lia)). replace (t + S i)%nat with (S t + i)%nat in H by lia. exact H.
Qed.

(** (30)-(32) give a motion of the network. *)
Theorem network_of_paper : Paper.motion N contact free a b -> networkMotion net (paperClosed contact free) (xAt 0).
Proof.
  intro M. destruct (proj1 (delay_form N contact free N_positive free_positive a b) M) as [P _ _ _].
  fold p in P. pose proof (proj1 (same_rows N contact free N_positive contact_positive free_positive a b) M) as X.
  rewrite <- (stateAt_0 N contact free N_positive contact_positive free_positive) in X. destruct X as [_ _ X _]. unfold paperSteps in X. cbn [Bars.stepsOf] in X.
  apply rows_contact in X; [|assumption || lia..]. destruct X as [C F]. rewrite Nat.add_0_l in F.
  rewrite <- (Nat.add_0_r contact) in F at 2.
  pose proof (proj1 (rows_flight N contact free N_positive contact_positive free_positive a b free 0 ltac:(lia)) F) as Apart.
  assert (Place : forall t, Joined.place N contact free a b t = placeAt t N).
  { intro t. unfold Joined.place, placeAt. replace (t + N - N)%nat with t by lia.
    replace (t + N + N)%nat with (t + 2 * N)%nat by lia. reflexivity. }
  split; [|split; [apply together_at|exists (map yAt (seq 0 (contact + free)))]].
  { destruct lengths as [-> ->]. unfold xAt. rewrite !app_length, !map_length, !seq_length. lia. }
  assert (Len : length (paperClosed contact free) = (contact + free)%nat)
    by (unfold paperClosed; rewrite app_length, !repeat_length; reflexivity).
  assert (Back : xAt (0 + length (paperClosed contact free)) = xAt 0).
  { rewrite Len, Nat.add_0_l. unfold xAt. f_equal; [|f_equal]; apply map_ext_in; intros k K; apply in_seq in K.
    - replace (contact + free + N - S k)%nat with (0 + N - S k + (contact + free))%nat by lia. apply P. lia.
    - replace (contact + free + N + k)%nat with (0 + N + k + (contact + free))%nat by lia. f_equal. apply P. lia.
    - unfold placeAt. replace (contact + free + N + k)%nat with (contact + free + N - k + 2 * k)%nat by lia.
      replace (0 + N + k)%nat with (0 + N - k + 2 * k)%nat by lia. rewrite !sum_add.
      rewrite (sum_ext _ (fun i => p (0 + N - k + i)%nat) (2 * k)); [lra|]. intros i I.
      rewrite <- (P (0 + N - k + i)%nat) by lia. f_equal. lia. }
  rewrite <- Back at 2. rewrite <- Len. apply marches_at. intros i I. rewrite Len in I. rewrite Nat.add_0_l.
  unfold paperClosed. destruct (Nat.lt_ge_cases i contact) as [L|L].
  - rewrite app_nth1 by (rewrite repeat_length; exact L).
    rewrite (nth_indep _ [] [true]), nth_repeat by (rewrite repeat_length; exact L). apply obeys_at.
    destruct (C i L) as [A B]. rewrite Place in A. split; [|split; assumption].
    unfold reflected. rewrite Nat.mod_small by lia. destruct (Nat.ltb_spec i contact); [reflexivity|lia].
  - rewrite app_nth2; rewrite repeat_length; [|lia].
    rewrite (nth_indep _ [] [false]), nth_repeat by (rewrite repeat_length; lia). apply obeys_at.
    specialize (Apart (i - contact)%nat ltac:(lia)).
    replace (contact + 0 + (i - contact))%nat with i in Apart by lia. rewrite Place in Apart. split; [|exact Apart].
    unfold reflected. rewrite Nat.mod_small by lia. destruct (Nat.ltb_spec i contact); [lia|reflexivity].
Qed.
End PaperNetwork.

Corollary checkNetwork_of_paper N contact free c : (0 < N)%nat -> (0 < contact)%nat -> (0 < free)%nat ->
  checkNetwork (paperNetwork N) (paperClosed contact free) c = true ->
  (forall a b, ~ Paper.motion N contact free a b) /\ verdict N contact free = false.
Proof.
  intros HN HC HF H. assert (No : forall a b, ~ Paper.motion N contact free a b).
  { intros a b M. exact (checkNetwork_correct _ _ _ H _ (network_of_paper N contact free HN HC HF a b M)). }
  split; [exact No|]. apply Bool.not_true_iff_false. intro V. apply verdict_correct in V; [|assumption..].
  destruct V as [a [b M]]. exact (No a b M).
Qed.
