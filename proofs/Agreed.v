(** What the checker says of the uniform bar it says of the paper's rows, and it agrees with the theorem on
    one contact: the chain of Joined.v has no motions but those of the paper. *)

From Coq Require Import QArith Reals Qreals ZArith List Lia Lra.
From Signorini Require Import Numbers Chain Bars Checker Sound Paper Verdict Joined.
Import ListNotations.
Open Scope R_scope.

Definition nowhere : local := At 0 0 0 0.
Definition waveA (xs : state) (i : Z) : R := fromLeft (nth (Z.to_nat i) xs nowhere).
Definition waveB (xs : state) (i : Z) : R := fromRight (nth (Z.to_nat (i - 1)) xs nowhere).

Section Agreed.
Variables cells contact free : nat.
Hypothesis cells_positive : (0 < cells)%nat.
Hypothesis contact_positive : (0 < contact)%nat.
Hypothesis free_positive : (0 < free)%nat.

Lemma last_carried ns steps' : forall xs, length xs = length ns -> steps' <> [] ->
  exists ss ys, length ys = length ns /\ carried ns steps' xs = step ns ss ys.
Proof.
  induction steps' as [|ss rest IH]; intros xs L N; [congruence|]. destruct rest as [|ss' rest].
  - exists ss, xs. auto.
  - apply (IH (step ns ss xs)); [apply length_march, L|discriminate].
Qed.

Lemma nothing_enters ns : forall ss ys arriving, length ys = length ns -> ns <> [] ->
  fromLeft (nth 0 (snd (march arriving ns ss ys)) nowhere) = arriving /\
  fromRight (nth (length ns - 1) (snd (march arriving ns ss ys)) nowhere) = 0.
Proof.
  induction ns as [|n ns IH]; intros ss [|y ys] arriving L N; try discriminate; [congruence|]. injection L as L.
  cbn [march]. specialize (IH (tl ss) ys (rightVelocity n (hd Open ss) y - fromRight y) L).
  destruct ns as [|n' ns].
  - destruct ys; [|discriminate]. cbn [march snd nth length Nat.sub fromLeft fromRight]. split; reflexivity.
  - destruct IH as [_ IH]; [discriminate|]. destruct (march _ (n' :: ns) (tl ss) ys) as [back rest].
    cbn [snd length] in *. replace (S (S (length ns)) - 1)%nat with (S (S (length ns) - 1)) by lia.
    split; [reflexivity|exact IH].
Qed.

Lemma joined_nth ns : forall xs i, length xs = length ns -> joined ns xs -> (i < length ns)%nat ->
  together (nth i ns Through) (nth i xs nowhere) /\ ((S i < length ns)%nat ->
  leftFace (nth (S i) xs nowhere) - rightFace (nth i xs nowhere) =
  fromRight (nth i xs nowhere) - fromLeft (nth (S i) xs nowhere)).
Proof.
  induction ns as [|n ns IH]; intros [|x xs] i L J I; try discriminate; [cbn in I; lia|]. injection L as L.
  cbn [joined] in J. destruct J as [T [J C]]. destruct i as [|i].
  - split; [exact T|]. intro S1. destruct ns as [|n' ns]; [cbn in S1; lia|]. destruct xs; [discriminate|]. exact C.
  - cbn [length] in *. destruct (IH xs i L J ltac:(lia)) as [A B]. split; [exact A|]. intro S1. apply B. lia.
Qed.

(** And the chain has no other motions. *)
Theorem no_others xs : Chain.motion (paperBar cells) (paperSteps cells contact free) xs ->
  xs = stateOf cells (waveA xs) (waveB xs).
Proof.
  intros [L J _ P]. set (x := fun i => nth i xs nowhere).
  assert (Len : length (paperBar cells) = S cells).
  { cbn [paperBar bar nodesOf length]. rewrite app_length, repeat_length. simpl. lia. }
  assert (Ends : fromLeft (x 0%nat) = 0 /\ fromRight (x cells) = 0).
  { destruct (last_carried (paperBar cells) (paperSteps cells contact free) xs L) as [ss [ys [Y E]]].
    - unfold paperSteps. cbn [stepsOf]. destruct contact; [lia|discriminate].
    - rewrite P in E. unfold x. rewrite E. pose proof (nothing_enters (paperBar cells) ss ys 0 Y ltac:(discriminate)) as H.
      rewrite Len in H. replace (S cells - 1)%nat with cells in H by lia. exact H. }
  assert (One : forall i, (i <= cells)%nat -> leftFace (x i) = rightFace (x i)).
  { intros i I. destruct (joined_nth _ xs i L J ltac:(lia)) as [T _]. fold (x i) in T.
    assert (A : Forall (fun n => together n (x i) -> leftFace (x i) = rightFace (x i)) (paperBar cells)).
    { constructor; [intros [-> ->]; reflexivity|]. apply Forall_app. split.
      - apply Forall_forall. intros n N. apply repeat_spec in N. subst n. auto.
      - constructor; [auto|constructor]. }
    rewrite Forall_nth in A. apply (A i Through); [lia|exact T]. }
  assert (U : forall i, (i <= cells)%nat -> leftFace (x i) =
    sum (fun k => waveB xs (Z.of_nat k + 1) - waveA xs (Z.of_nat k + 1)) i).
  { induction i as [|i IH]; intro I.
    - destruct (joined_nth _ xs 0 L J ltac:(lia)) as [T _]. apply T.
    - cbn [sum]. rewrite <- IH by lia. pose proof (One i ltac:(lia)). destruct (joined_nth _ xs i L J ltac:(lia)) as [_ C].
      specialize (C ltac:(lia)). fold (x i) (x (S i)) in C. unfold waveA, waveB.
      replace (Z.to_nat (Z.of_nat i + 1 - 1)) with i by lia. replace (Z.to_nat (Z.of_nat i + 1)) with (S i) by lia.
      fold (x i) (x (S i)). lra. }
  apply (nth_ext _ _ nowhere nowhere).
  { unfold stateOf. rewrite map_length, seq_length. lia. }
  intros i I. rewrite L, Len in I. fold (x i). unfold stateOf.
  rewrite (nth_indep _ nowhere (nodeOf cells (waveA xs) (waveB xs) 0)) by (rewrite map_length, seq_length; lia).
  rewrite map_nth, seq_nth by lia. unfold nodeOf. rewrite Nat.add_0_l, <- U by lia. unfold waveA, waveB.
  replace (Z.to_nat (Z.of_nat i + 1 - 1)) with i by lia. rewrite Nat2Z.id. fold (x i).
  destruct Ends as [E0 EN]. pose proof (One i ltac:(lia)) as O. destruct (x i) as [l r u v] eqn:X. cbn in *. subst v.
  assert (E1 : i = 0%nat -> l = 0) by (intros ->; rewrite X in E0; exact E0).
  assert (E2 : i = cells -> r = 0) by (intros ->; rewrite X in EN; exact EN).
  destruct (Nat.eqb_spec i 0), (Nat.eqb_spec i cells); rewrite ?E1, ?E2 by assumption; reflexivity.
Qed.

Corollary verdict_of_chain : verdict cells contact free = true <->
  exists xs, Chain.motion (paperBar cells) (paperSteps cells contact free) xs.
Proof.
  rewrite (verdict_correct cells contact free) by assumption. split.
  - intros [a [b M]]. exists (stateOf cells a b). apply same_rows; assumption.
  - intros [xs M]. exists (waveA xs), (waveB xs). apply same_rows; [assumption..|]. rewrite <- no_others; exact M.
Qed.

(** What the checker proves of this chain holds of (30)-(32), and the verdict agrees. *)
Corollary check_of_paper c : check (paperBar cells) (paperSteps cells contact free) c = true ->
  (forall a b, ~ Paper.motion cells contact free a b) /\ verdict cells contact free = false.
Proof.
  intro H. pose proof (check_correct _ _ _ H) as N. split.
  - intros a b M. apply (N (stateOf cells a b)), same_rows; assumption.
  - apply Bool.not_true_iff_false. intro V. apply verdict_of_chain in V. destruct V as [xs M]. exact (N xs M).
Qed.

(** The energy that the checker weighs, E/E_1. *)
Definition paperWeights : list (Q * Q) :=
  map (fun i => let w := (2 # Pos.of_nat cells)%Q in ((if (i =? 0)%nat then 0 else w), (if (i =? cells)%nat then 0 else w))%Q)
    (seq 0 (S cells)).

Lemma energy_sum (ws : nat -> Q * Q) (xs : nat -> local) m : forall i,
  energy (map ws (seq i m)) (map xs (seq i m)) = sum (fun k => let x := xs (i + k)%nat in
    Q2R (fst (ws (i + k)%nat)) * (fromLeft x * fromLeft x) + Q2R (snd (ws (i + k)%nat)) * (fromRight x * fromRight x)) m.
Proof.
  induction m as [|m IH]; intro i; [reflexivity|]. cbn [seq map energy]. rewrite IH.
  change (S m) with (1 + m)%nat. rewrite sum_add. cbn [sum]. rewrite Nat.add_0_r, Rplus_0_l. f_equal.
  apply sum_ext. intros k _. replace (i + (1 + k))%nat with (S i + k)%nat by lia. reflexivity.
Qed.

Lemma energy_is a b : energy paperWeights (stateOf cells a b) =
  2 / INR cells * sum (fun i => a (Z.of_nat i + 1)%Z * a (Z.of_nat i + 1)%Z + b (Z.of_nat i + 1)%Z * b (Z.of_nat i + 1)%Z) cells.
Proof.
  assert (W : Q2R (2 # Pos.of_nat cells) = 2 / INR cells).
  { unfold Q2R. cbn [Qnum Qden]. rewrite INR_IZR_INZ. unfold Rdiv. do 3 f_equal.
    rewrite <- positive_nat_Z, Nat2Pos.id by lia. reflexivity. }
  unfold paperWeights, stateOf. rewrite energy_sum. cbn [fst snd Nat.add]. rewrite <- W, <- sum_scale.
  set (v := Q2R (2 # Pos.of_nat cells)).
  set (ra := fun k => if (k =? 0)%nat then 0 else v * (a (Z.of_nat k) * a (Z.of_nat k))).
  set (rb := fun k => if (k =? cells)%nat then 0 else v * (b (Z.of_nat k + 1)%Z * b (Z.of_nat k + 1)%Z)).
  rewrite (sum_ext _ (fun k => ra k + rb k) (S cells)).
  2: { intros k _. unfold ra, rb, nodeOf. cbn [fromLeft fromRight].
       destruct (k =? 0)%nat, (k =? cells)%nat; rewrite ?Q2R_0; fold v; ring. }
  assert (P : forall f g n, sum (fun k => f k + g k) n = sum f n + sum g n).
  { intros f g n. induction n as [|n IH]; simpl; lra. }
  rewrite P. assert (A : sum ra (S cells) = sum (fun k => ra (1 + k)%nat) cells).
  { change (S cells) with (1 + cells)%nat. rewrite sum_add. unfold ra at 1. simpl. lra. }
  assert (B : sum rb (S cells) = sum rb cells).
  { cbn [sum]. unfold rb at 2. rewrite Nat.eqb_refl. lra. }
  rewrite A, B, <- P. apply sum_ext. intros k K. unfold ra, rb. cbn [Nat.add Nat.eqb].
  destruct (Nat.eqb_spec k cells); [lia|]. replace (Z.of_nat (S k)) with (Z.of_nat k + 1)%Z by lia. ring.
Qed.

Corollary least_of_paper c bound :
  checkLeast paperWeights (paperBar cells) (paperSteps cells contact free) c bound = true ->
  forall a b, Paper.motion cells contact free a b -> Q2R bound <=
  2 / INR cells * sum (fun i => a (Z.of_nat i + 1)%Z * a (Z.of_nat i + 1)%Z + b (Z.of_nat i + 1)%Z * b (Z.of_nat i + 1)%Z) cells.
Proof.
  intros H a b M. rewrite <- energy_is. apply (checkLeast_correct _ _ _ _ _ H), same_rows; assumption.
Qed.
End Agreed.
