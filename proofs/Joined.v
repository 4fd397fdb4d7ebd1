(** The paper's rows are those of a chain: the uniform bar, clamped, with one stop at its tip.

    A state a, b of the paper is a state of the chain ([stateOf]); it obeys (30)-(32) if and only if it is a
    motion of the chain. *)

From Coq Require Import QArith Reals Qreals ZArith List Lia Lra.
From Signorini Require Import Numbers Chain Bars Paper.
Import ListNotations.
Open Scope R_scope.

(** * The chain, and its states *)

Definition paperBar (cells : nat) : list node := bar None [(cells, None)] None (Some (Z.of_nat cells # 1)%Q).
Definition paperSteps (cells contact free : nat) : list (list status) := stepsOf cells [(OnHigh, contact, free)].

(** Cell i lies between the nodes i - 1 and i: a_i is about to arrive at the right one, b_i at the left one. *)
Definition nodeOf (cells : nat) (a b : Z -> R) (i : nat) : local :=
  let u := sum (fun k => b (Z.of_nat k + 1)%Z - a (Z.of_nat k + 1)%Z) i in
  At (if (i =? 0)%nat then 0 else a (Z.of_nat i)) (if (i =? cells)%nat then 0 else b (Z.of_nat i + 1)%Z) u u.
Definition stateOf (cells : nat) (a b : Z -> R) : state := map (nodeOf cells a b) (seq 0 (S cells)).

(** * The chain marches as the paper does *)

Section Joined.
Variables cells contact free : nat.
Hypothesis cells_positive : (0 < cells)%nat.
Hypothesis contact_positive : (0 < contact)%nat.
Hypothesis free_positive : (0 < free)%nat.
Let steps := (contact + free)%nat.
Let tip : node := Joint 1 0 1 None (Some (Z.of_nat cells # 1)%Q).

Lemma paperBar_is : paperBar cells = Clamp None :: repeat Through (cells - 1) ++ [tip].
Proof. reflexivity. Qed.

Lemma place_is : Q2R (Z.of_nat cells # 1) = INR cells.
Proof. unfold Q2R. simpl. rewrite <- INR_IZR_INZ. field. Qed.

Lemma tip_open x : leftVelocity tip Open x = 2 * fromLeft x /\ rightVelocity tip Open x = 2 * fromLeft x.
Proof. unfold leftVelocity, rightVelocity, along, Q2R; simpl. split; field. Qed.

Lemma tip_held x : leftVelocity tip OnHigh x = 0 /\ rightVelocity tip OnHigh x = 0.
Proof. unfold leftVelocity, rightVelocity, along, Q2R; simpl. split; field. Qed.

Lemma through_is s x : leftVelocity Through s x = fromLeft x + fromRight x /\
  rightVelocity Through s x = fromLeft x + fromRight x.
Proof. unfold leftVelocity, rightVelocity, along, Q2R; simpl. split; field. Qed.

Lemma clamp_is s x : leftVelocity (Clamp None) s x = 0 /\ rightVelocity (Clamp None) s x = 0.
Proof. unfold leftVelocity, rightVelocity, along, Q2R; simpl. split; field. Qed.

Section State.
Variables a b : Z -> R.
Let p := p cells contact free a b.

(** Node i in step t: waves are what arrives at the tip before and after. *)
Definition nodeAt (t i : nat) : local :=
  let u := sum p (t + cells - i) - sum p (t + cells + i) in
  At (if (i =? 0)%nat then 0 else p (t + cells - i)) (if (i =? cells)%nat then 0 else - p (t + cells + i)) u u.
Definition stateAt (t : nat) : state := map (nodeAt t) (seq 0 (S cells)).

Lemma stateAt_0 : stateAt 0 = stateOf cells a b.
Proof.
  apply map_ext_in. intros i I. apply in_seq in I. unfold nodeAt, nodeOf.
  assert (A : forall j, (j < cells)%nat -> p (cells - 1 - j) = a (Z.of_nat j + 1)%Z).
  { intros j J. unfold p. rewrite p_start by lia. unfold arrival.
    destruct (Z.ltb_spec (Z.of_nat (cells - 1 - j)) (Z.of_nat cells)); [|lia]. f_equal. lia. }
  assert (B : forall j, (j < cells)%nat -> p (cells + j) = - b (Z.of_nat j + 1)%Z).
  { intros j J. unfold p. rewrite p_start by lia. unfold arrival.
    destruct (Z.ltb_spec (Z.of_nat (cells + j)) (Z.of_nat cells)); [lia|]. f_equal. f_equal. lia. }
  assert (U : forall j, (j <= cells)%nat -> sum p (0 + cells - j) - sum p (0 + cells + j) =
                sum (fun k => b (Z.of_nat k + 1)%Z - a (Z.of_nat k + 1)%Z) j).
  { induction j as [|j IH]; intro J; [simpl; rewrite Nat.sub_0_r, Nat.add_0_r; lra|]. cbn [sum].
    rewrite <- IH by lia. replace (0 + cells - j)%nat with (S (cells - 1 - j)) by lia.
    replace (0 + cells - S j)%nat with (cells - 1 - j)%nat by lia.
    replace (0 + cells + S j)%nat with (S (cells + j)) by lia. replace (0 + cells + j)%nat with (cells + j)%nat by lia.
    cbn [sum]. rewrite A, B by lia. lra. }
  rewrite U by lia. f_equal.
  - destruct (Nat.eqb_spec i 0); [reflexivity|]. replace (0 + cells - i)%nat with (cells - 1 - (i - 1))%nat by lia.
    rewrite A by lia. f_equal. lia.
  - destruct (Nat.eqb_spec i cells); [reflexivity|]. rewrite B by lia. lra.
Qed.

(** What a status of the tip means in step t. *)
Definition fits (t : nat) (s : status) : Prop :=
  (s = OnHigh /\ reflected contact free t = 1) \/ (s = Open /\ reflected contact free t = -1).

Lemma march_tail t m : forall i ss, (1 <= i)%nat -> (i + m = cells)%nat -> fits t (nth m ss Open) ->
  march (p (t + 1 + cells - i)) (repeat Through m ++ [tip]) ss (map (nodeAt t) (seq i (S m))) =
  (- p (t + cells + i), map (nodeAt (S t)) (seq i (S m))).
Proof.
  induction m as [|m IH]; intros i ss I E F.
  - assert (i = cells) as -> by lia. assert (D : p (t + cells + cells) = reflected contact free t * p t).
    { replace (t + cells + cells)%nat with (t + 2 * cells)%nat by lia. apply p_delay; assumption. }
    cbn [repeat app seq map march]. replace (hd Open ss) with (nth 0 ss Open) by (destruct ss; reflexivity).
    unfold nodeAt. rewrite Nat.eqb_refl. destruct (Nat.eqb_spec cells 0); [lia|].
    replace (t + cells - cells)%nat with t by lia. replace (S t + cells - cells)%nat with (S t) by lia.
    replace (t + 1 + cells - cells)%nat with (S t) by lia.
    replace (S t + cells + cells)%nat with (S (t + cells + cells)) by lia.
    cbn [sum]. rewrite D.
    destruct F as [[-> R]|[-> R]]; rewrite R.
    + rewrite !(proj1 (tip_held _)), !(proj2 (tip_held _)). cbn [fromLeft leftFace rightFace]. f_equal; [lra|].
      f_equal. f_equal; lra.
    + rewrite !(proj1 (tip_open _)), !(proj2 (tip_open _)). cbn [fromLeft leftFace rightFace]. f_equal; [lra|].
      f_equal. f_equal; lra.
  - cbn [repeat app]. change (seq i (S (S m))) with (i :: seq (S i) (S m)). cbn [map march].
    rewrite !(proj1 (through_is _ _)), !(proj2 (through_is _ _)).
    assert (L : fromLeft (nodeAt t i) = p (t + cells - i)).
    { unfold nodeAt. cbn [fromLeft]. destruct (Nat.eqb_spec i 0); [lia|reflexivity]. }
    assert (R : fromRight (nodeAt t i) = - p (t + cells + i)).
    { unfold nodeAt. cbn [fromRight]. destruct (Nat.eqb_spec i cells); [lia|reflexivity]. }
    replace (fromLeft (nodeAt t i) + fromRight (nodeAt t i) - fromRight (nodeAt t i))
      with (p (t + 1 + cells - S i)) by (rewrite L; replace (t + 1 + cells - S i)%nat with (t + cells - i)%nat by lia; lra).
    rewrite (IH (S i) (tl ss)) by (lia || (destruct ss; [destruct m|]; exact F)).
    f_equal; [rewrite R; lra|]. f_equal. rewrite L, R. unfold nodeAt. cbn [leftFace rightFace].
    destruct (Nat.eqb_spec i 0); [lia|]. destruct (Nat.eqb_spec i cells); [lia|].
    replace (t + cells + S i)%nat with (S t + cells + i)%nat by lia.
    replace (t + 1 + cells - i)%nat with (S t + cells - i)%nat by lia.
    replace (S t + cells - i)%nat with (S (t + cells - i)) by lia.
    replace (S t + cells + i)%nat with (S (t + cells + i)) by lia. cbn [sum]. f_equal; lra.
Qed.

Lemma step_at t ss : fits t (nth cells ss Open) -> step (paperBar cells) ss (stateAt t) = stateAt (S t).
Proof.
  intro F. unfold step, stateAt. rewrite paperBar_is. change (seq 0 (S cells)) with (0%nat :: seq 1 cells).
  cbn [map march]. rewrite !(proj1 (clamp_is _ _)), !(proj2 (clamp_is _ _)).
  assert (R : fromRight (nodeAt t 0) = - p (t + cells)).
  { unfold nodeAt. cbn [fromRight]. destruct (Nat.eqb_spec 0 cells); [lia|]. rewrite Nat.add_0_r. reflexivity. }
  replace (0 - fromRight (nodeAt t 0)) with (p (t + 1 + cells - 1))
    by (rewrite R; replace (t + 1 + cells - 1)%nat with (t + cells)%nat by lia; lra).
  replace (seq 1 cells) with (seq 1 (S (cells - 1))) by (f_equal; lia).
  rewrite (march_tail t (cells - 1) 1 (tl ss)).
  - cbn [snd]. f_equal. unfold nodeAt. cbn [leftFace rightFace]. change (0 =? 0)%nat with true.
    destruct (Nat.eqb_spec 0 cells); [lia|].
    rewrite !Nat.sub_0_r, !Nat.add_0_r. replace (S t + cells)%nat with (t + cells + 1)%nat by lia. f_equal; lra.
  - lia.
  - lia.
  - replace cells with (S (cells - 1)) in F by lia. destruct ss; [destruct (cells - 1)%nat|]; exact F.
Qed.

Lemma fits_contact t : (t < contact)%nat -> fits t (nth cells (atTip cells OnHigh) Open).
Proof.
  intro T. left. unfold atTip. rewrite app_nth2; rewrite repeat_length; [|lia]. rewrite Nat.sub_diag.
  split; [reflexivity|]. unfold reflected. rewrite Nat.mod_small by lia.
  destruct (Nat.ltb_spec t contact); [reflexivity|lia].
Qed.

Lemma fits_flight t : (t < free)%nat -> fits (contact + t) (nth cells [] Open).
Proof.
  intro T. right. split; [destruct cells; reflexivity|]. unfold reflected. rewrite Nat.mod_small by lia.
  destruct (Nat.ltb_spec (contact + t) contact); [lia|reflexivity].
Qed.

(** The place of the tip when step t begins, and what it obeys. *)
Definition place (t : nat) : R := sum p t - sum p (t + 2 * cells).

Lemma obeys_tip t ss : allObey (paperBar cells) ss (stateAt t) <->
  obeys tip (nth cells ss Open) (At (p t) 0 (place t) (place t)).
Proof.
  unfold stateAt. rewrite paperBar_is. change (seq 0 (S cells)) with (0%nat :: seq 1 cells). cbn [map allObey].
  assert (T : nodeAt t cells = At (p t) 0 (place t) (place t)).
  { unfold nodeAt, place. rewrite Nat.eqb_refl. destruct (Nat.eqb_spec cells 0); [lia|].
    replace (t + cells - cells)%nat with t by lia. replace (t + cells + cells)%nat with (t + 2 * cells)%nat by lia.
    reflexivity. }
  rewrite <- T.
  assert (I : forall m i ss, (i + m = cells)%nat ->
    allObey (repeat Through m ++ [tip]) ss (map (nodeAt t) (seq i (S m))) <-> obeys tip (nth m ss Open) (nodeAt t cells)).
  { induction m as [|m IH]; intros i s E.
    - replace i with cells by lia. cbn [repeat app seq map allObey]. destruct s; cbn [hd nth]; tauto.
    - cbn [repeat app]. change (seq i (S (S m))) with (i :: seq (S i) (S m)). cbn [map allObey].
      rewrite (IH (S i) (tl s)) by lia. destruct s; [destruct m|]; cbn [tl nth obeys]; tauto. }
  replace (seq 1 cells) with (seq 1 (S (cells - 1))) by (f_equal; lia). rewrite (I (cells - 1)%nat) by lia.
  replace (nth (cells - 1) (tl ss) Open) with (nth cells ss Open)
    by (replace cells with (S (cells - 1)) at 1 by lia; destruct ss; [destruct (cells - 1)%nat|]; reflexivity).
  cbn [obeys option_map above]. tauto.
Qed.

Lemma obeys_contact t : allObey (paperBar cells) (atTip cells OnHigh) (stateAt t) <-> place t = INR cells /\ 0 <= p t.
Proof.
  rewrite obeys_tip. unfold atTip. rewrite app_nth2; rewrite repeat_length; [|lia]. rewrite Nat.sub_diag.
  cbn [nth obeys rests leftFace tip]. unfold stopPush. cbn [fromLeft fromRight]. rewrite place_is, Q2R_1, Q2R_0.
  split; intros [A B]; split; lra.
Qed.

Lemma obeys_flight t : allObey (paperBar cells) [] (stateAt t) <-> place t + 2 * p t <= INR cells.
Proof.
  rewrite obeys_tip. replace (nth cells [] Open) with Open by (destruct cells; reflexivity).
  set (x := At (p t) 0 (place t) (place t)).
  change (obeys tip Open x) with (True /\ leftFace x + leftVelocity tip Open x <= Q2R (Z.of_nat cells # 1)).
  rewrite (proj1 (tip_open x)), place_is. cbn [x leftFace fromLeft]. tauto.
Qed.

Lemma place_next t s : fits t s -> place (S t) = place t + (if (t mod steps <? contact)%nat then 0 else 2 * p t).
Proof.
  intro F. unfold place. replace (S t + 2 * cells)%nat with (S (t + 2 * cells)) by lia. cbn [sum].
  unfold p. rewrite p_delay by assumption. unfold reflected. fold steps. destruct (t mod steps <? contact)%nat; lra.
Qed.

Lemma rows_contact c : forall t rest, (t + c <= contact)%nat ->
  rowsHold (paperBar cells) (repeat (atTip cells OnHigh) c ++ rest) (stateAt t) <->
  (forall i, (i < c)%nat -> place (t + i) = INR cells /\ 0 <= p (t + i)) /\ rowsHold (paperBar cells) rest (stateAt (t + c)).
Proof.
  induction c as [|c IH]; intros t rest C.
  - rewrite Nat.add_0_r. simpl. split; [|tauto]. intro H. split; [lia|exact H].
  - cbn [repeat app rowsHold]. rewrite obeys_contact, step_at, IH by (lia || (apply fits_contact; lia)).
    replace (S t + c)%nat with (t + S c)%nat by lia. split.
    + intros [A [B D]]. split; [|exact D]. intros [|i] I; [rewrite Nat.add_0_r; exact A|].
      replace (t + S i)%nat with (S t + i)%nat by lia. apply B. lia.
    + intros [A D]. repeat split; try exact D.
      * specialize (A 0%nat ltac:(lia)). rewrite Nat.add_0_r in A. apply A.
      * specialize (A 0%nat ltac:(lia)). rewrite Nat.add_0_r in A. apply A.
      * replace (S t + i)%nat with (t + S i)%nat by lia. apply A. lia.
      * replace (S t + i)%nat with (t + S i)%nat by lia. apply A. lia.
Qed.

Lemma rows_flight c : forall t, (t + c <= free)%nat ->
  rowsHold (paperBar cells) (repeat [] c ++ []) (stateAt (contact + t)) <->
  (forall i, (i < c)%nat -> place (contact + t + i) + 2 * p (contact + t + i) <= INR cells).
Proof.
  induction c as [|c IH]; intros t C; [simpl; split; [lia|auto]|].
  cbn [repeat app rowsHold]. rewrite obeys_flight, step_at by (apply fits_flight; lia).
  rewrite <- Nat.add_succ_r, IH by lia. split.
  - intros [A B] [|i] I; [rewrite Nat.add_0_r; exact A|].
    replace (contact + t + S i)%nat with (contact + S t + i)%nat by lia. apply B. lia.
  - intro A. split; [specialize (A 0%nat ltac:(lia)); rewrite Nat.add_0_r in A; exact A|]. intros i I.
    replace (contact + S t + i)%nat with (contact + t + S i)%nat by lia. apply A. lia.
Qed.

Lemma carried_contact c : forall t rest, (t + c <= contact)%nat ->
  carried (paperBar cells) (repeat (atTip cells OnHigh) c ++ rest) (stateAt t) = carried (paperBar cells) rest (stateAt (t + c)).
Proof.
  induction c as [|c IH]; intros t rest C; [rewrite Nat.add_0_r; reflexivity|].
  cbn [repeat app carried]. rewrite step_at, IH by (lia || (apply fits_contact; lia)). do 2 f_equal. lia.
Qed.

Lemma carried_flight c : forall t, (t + c <= free)%nat ->
  carried (paperBar cells) (repeat [] c ++ []) (stateAt (contact + t)) = stateAt (contact + t + c).
Proof.
  induction c as [|c IH]; intros t C; [rewrite Nat.add_0_r; reflexivity|].
  cbn [repeat app carried]. rewrite step_at by (apply fits_flight; lia).
  rewrite <- Nat.add_succ_r, IH by lia. f_equal. lia.
Qed.

Lemma joined_at : joined (paperBar cells) (stateAt 0).
Proof.
  assert (U : forall i, (i < cells)%nat -> leftFace (nodeAt 0 (S i)) - rightFace (nodeAt 0 i) =
    fromRight (nodeAt 0 i) - fromLeft (nodeAt 0 (S i))).
  { intros i I. unfold nodeAt. cbn [leftFace rightFace fromLeft fromRight Nat.eqb].
    destruct (Nat.eqb_spec i cells); [lia|]. replace (0 + cells - i)%nat with (S (cells - S i)) by lia.
    replace (0 + cells - S i)%nat with (cells - S i)%nat by lia. replace (0 + cells + S i)%nat with (S (cells + i)) by lia.
    replace (0 + cells + i)%nat with (cells + i)%nat by lia. cbn [sum]. lra. }
  unfold stateAt. rewrite paperBar_is. change (seq 0 (S cells)) with (0%nat :: seq 1 cells).
  replace (seq 1 cells) with (seq 1 (S (cells - 1))) by (f_equal; lia). cbn [map joined together]. split.
  { unfold nodeAt. cbn [leftFace rightFace]. rewrite Nat.sub_0_r, Nat.add_0_r. lra. }
  assert (J : forall m i, (i + m = cells)%nat -> joined (repeat Through m ++ [tip]) (map (nodeAt 0) (seq i (S m)))).
  { induction m as [|m IH]; intros i E; [simpl; auto|]. cbn [repeat app].
    change (seq i (S (S m))) with (i :: seq (S i) (S m)). cbn [map joined together]. split; [reflexivity|].
    split; [apply (IH (S i)); lia|]. destruct m; cbn [repeat app seq map]; apply U; lia. }
  split; [apply J; lia|]. destruct (cells - 1)%nat; cbn [repeat app seq map]; apply U; lia.
Qed.

Lemma motion_at : Chain.motion (paperBar cells) (paperSteps cells contact free) (stateAt 0) <->
  delayed cells contact free a b.
Proof.
  assert (Same : stateAt steps = stateAt 0 <-> forall m, (m < 2 * cells)%nat -> p (m + steps) = p m).
  { split.
    - intros E m M. assert (N : forall i, (i <= cells)%nat -> nodeAt steps i = nodeAt 0 i).
      { intros i I. unfold stateAt in E. apply (f_equal (fun xs => nth i xs (nodeAt 0 i))) in E.
        rewrite (nth_indep _ _ (nodeAt steps i)) in E at 1 by (rewrite map_length, seq_length; lia).
        rewrite !map_nth in E. rewrite !seq_nth in E by lia. exact E. }
      destruct (Nat.lt_ge_cases m cells) as [L|L].
      + specialize (N (cells - m)%nat ltac:(lia)). apply (f_equal fromLeft) in N. unfold nodeAt in N. cbn [fromLeft] in N.
        destruct (Nat.eqb_spec (cells - m) 0); [lia|].
        replace (steps + cells - (cells - m))%nat with (m + steps)%nat in N by lia.
        replace (0 + cells - (cells - m))%nat with m in N by lia. exact N.
      + specialize (N (m - cells)%nat ltac:(lia)). apply (f_equal fromRight) in N. unfold nodeAt in N. cbn [fromRight] in N.
        destruct (Nat.eqb_spec (m - cells) cells); [lia|].
        replace (steps + cells + (m - cells))%nat with (m + steps)%nat in N by lia.
        replace (0 + cells + (m - cells))%nat with m in N by lia. lra.
    - intro H. apply map_ext_in. intros i I. apply in_seq in I. unfold nodeAt.
      assert (D : sum p (steps + cells - i) - sum p (steps + cells + i) = sum p (0 + cells - i) - sum p (0 + cells + i)).
      { replace (steps + cells + i)%nat with (steps + cells - i + 2 * i)%nat by lia.
        replace (0 + cells + i)%nat with (0 + cells - i + 2 * i)%nat by lia. rewrite !sum_add.
        rewrite (sum_ext _ (fun k => p (0 + cells - i + k)%nat) (2 * i)); [lra|].
        intros k K. rewrite <- (H (0 + cells - i + k)%nat) by lia. f_equal. lia. }
      rewrite D. f_equal.
      + destruct (Nat.eqb_spec i 0); [reflexivity|]. rewrite <- (H (0 + cells - i)%nat) by lia. f_equal. lia.
      + destruct (Nat.eqb_spec i cells); [reflexivity|]. rewrite <- (H (0 + cells + i)%nat) by lia. do 2 f_equal. lia. }
  assert (Contact : forall i, (i <= contact)%nat -> place i = place 0).
  { induction i as [|i IH]; intro I; [reflexivity|]. rewrite (place_next i _ (fits_contact i ltac:(lia))).
    rewrite Nat.mod_small by (unfold steps; lia). destruct (Nat.ltb_spec i contact); [rewrite IH by lia; lra|lia]. }
  assert (Flight : forall i, (i <= free)%nat -> place (contact + i) = place 0 + 2 * sum (fun k => p (contact + k)) i).
  { induction i as [|i IH]; intro I; [rewrite Nat.add_0_r, Contact by lia; simpl; lra|].
    rewrite Nat.add_succ_r, (place_next (contact + i) _ (fits_flight i ltac:(lia))).
    rewrite Nat.mod_small by (unfold steps; lia). destruct (Nat.ltb_spec (contact + i) contact); [lia|].
    rewrite IH by lia. cbn [sum]. lra. }
  assert (Zero : place 0 = - sum p (2 * cells))
    by (unfold place; change (0 + 2 * cells)%nat with (2 * cells)%nat; change (sum p 0) with 0; lra).
  assert (Rows : rowsHold (paperBar cells) (paperSteps cells contact free) (stateAt 0) <->
    (forall i, (i < contact)%nat -> place i = INR cells /\ 0 <= p i) /\
    (forall i, (i < free)%nat -> place (contact + i) + 2 * p (contact + i) <= INR cells)).
  { unfold paperSteps. cbn [stepsOf]. rewrite rows_contact by lia. rewrite Nat.add_0_l.
    pose proof (rows_flight free 0 ltac:(lia)) as F. rewrite Nat.add_0_r in F. rewrite F. tauto. }
  assert (Carried : carried (paperBar cells) (paperSteps cells contact free) (stateAt 0) = stateAt steps).
  { unfold paperSteps. cbn [stepsOf]. rewrite carried_contact by lia. rewrite Nat.add_0_l.
    pose proof (carried_flight free 0 ltac:(lia)) as F. rewrite Nat.add_0_r in F. exact F. }
  split.
  - intros [_ _ H P]. rewrite Carried in P. pose proof (proj1 Same P) as P1. destruct (proj1 Rows H) as [C F].
    pose proof (proj1 (C 0%nat contact_positive)) as W. fold p. split; [exact P1| | |].
    + fold p. lra.
    + intros m M. apply C, M.
    + intros m M. specialize (F m M). rewrite Flight in F by lia. fold p. cbn [sum]. lra.
  - intros [P W C F]. fold p steps in P, W, C, F. split.
    + unfold stateAt. rewrite map_length, seq_length, paperBar_is. cbn [length].
      rewrite app_length, repeat_length. simpl. lia.
    + apply joined_at.
    + apply Rows. split.
      * intros i I. rewrite Contact by lia. split; [lra|apply C, I].
      * intros i I. rewrite Flight by lia. specialize (F i I). cbn [sum] in F. lra.
    + rewrite Carried. apply Same, P.
Qed.

(** * The theorem *)

(** The paper's rows hold of a, b if and only if it is a motion of the chain. *)
Theorem same_rows : Paper.motion cells contact free a b <->
  Chain.motion (paperBar cells) (paperSteps cells contact free) (stateOf cells a b).
Proof. rewrite <- stateAt_0, motion_at. apply delay_form; assumption. Qed.
End State.
End Joined.
