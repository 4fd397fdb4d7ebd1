(** The paper's operators and rows, (21)-(32), and their delay form.

    Definitions are written from the paper's extensions of waves: [a] and [b] are what runs to the right and
    to the left in cells 1 .. N at t = 0, L = c = g = 1, and (31) is multiplied by N. The delay form says the
    same of one sequence p, of what arrives at the tip: p (m + 2N) = p m after contact, - p m after flight. *)

From Coq Require Import Reals ZArith Lia Lra.
Open Scope R_scope.

Fixpoint sum (f : nat -> R) (n : nat) : R := match n with O => 0 | S m => sum f m + f m end.

(** * Definitions *)

Section Operators.
Open Scope Z_scope.
Variable N : Z.
Variables a b : Z -> R.

(** (21), (22): the extended waves in contact, by cells: [s] is the cell that ends at x_s. *)
Definition r1DD (s : Z) : R :=
  if 1 <=? s then a s else if 1 - N <=? s then - b (1 - s) else a (s + 2 * N).
Definition r2DD (s : Z) : R :=
  if s <=? N then b s else if s <=? 2 * N then - a (2 * N + 1 - s) else b (s - 2 * N).

(** (24), (25): in flight. *)
Definition r1DN (s : Z) : R :=
  if 1 <=? s then a s else if 1 - N <=? s then - b (1 - s) else if 1 - 2 * N <=? s then - a (s + 2 * N)
  else if 1 - 3 * N <=? s then b (1 - 2 * N - s) else a (s + 4 * N).
Definition r2DN (s : Z) : R :=
  if s <=? N then b s else if s <=? 2 * N then a (2 * N + 1 - s) else if s <=? 3 * N then - b (s - 2 * N)
  else if s <=? 4 * N then - a (4 * N + 1 - s) else b (s - 4 * N).

(** (29): the waves after n steps; (21)-(22) repeat after 2N steps, (24)-(25) after 4N. *)
Definition aDD (n i : Z) : R := r1DD (i - n mod (2 * N)).
Definition bDD (n i : Z) : R := r2DD (i + n mod (2 * N)).
Definition aDN (n i : Z) : R := r1DN (i - n mod (4 * N)).
Definition bDN (n i : Z) : R := r2DN (i + n mod (4 * N)).

(** Strain and velocity at the tip in step m: s = r2 - r1 and v = r1 + r2 at x = L. *)
Definition strainDD (m : Z) : R := bDD (m + 1) N - aDD m N.
Definition velocityDN (m : Z) : R := aDN m N + bDN (m + 1) N.

(** What arrives at the tip in step m < 2N. *)
Definition arrival (m : Z) : R := if m <? N then a (N - m) else - b (m - N + 1).
End Operators.

Section Rows.
Open Scope Z_scope.
Variables cells contact free : nat.
Let N := Z.of_nat cells.
Variables a b : Z -> R.
Let a1 := aDD N a b (Z.of_nat contact).
Let b1 := bDD N a b (Z.of_nat contact).

(** (30)-(32). *)
Record motion : Prop := {
  periodic : forall i, 1 <= i <= N ->
    aDN N a1 b1 (Z.of_nat free) i = a i /\ bDN N a1 b1 (Z.of_nat free) i = b i;                      (** (30) *)
  atWall : (sum (fun i => b (Z.of_nat i + 1) - a (Z.of_nat i + 1)) cells = INR cells)%R;             (** (31) *)
  pressed : forall m, (m < contact)%nat -> (strainDD N a b (Z.of_nat m) <= 0)%R;                     (** (10) *)
  released : (0 <= strainDD N a b (Z.of_nat contact))%R;                                             (** (11) *)
  apart : forall m, (m < free)%nat -> (sum (fun k => velocityDN N a1 b1 (Z.of_nat k)) (S m) <= 0)%R  (** (12) *)
}.
End Rows.

(** * Proofs: the delay form *)

Lemma sum_ext f g n : (forall i, (i < n)%nat -> f i = g i) -> sum f n = sum g n.
Proof. induction n as [|n IH]; intro H; simpl; auto. rewrite IH, H; auto. Qed.

Lemma sum_add f n m : sum f (n + m) = sum f n + sum (fun i => f (n + i)%nat) m.
Proof. induction m as [|m IH]; [rewrite Nat.add_0_r; simpl; lra|]. rewrite Nat.add_succ_r. simpl. lra. Qed.

Lemma sum_scale c f n : sum (fun i => c * f i) n = c * sum f n.
Proof. induction n as [|n IH]; simpl; lra. Qed.

Lemma sum_minus f g n : sum (fun i => f i - g i) n = sum f n - sum g n.
Proof. induction n as [|n IH]; simpl; lra. Qed.

Lemma sum_reverse f n : sum (fun i => f (n - 1 - i)%nat) n = sum f n.
Proof.
  induction n as [|n IH]; auto. change (sum (fun i => f (S n - 1 - i)%nat) (1 + n) = sum f n + f n).
  rewrite sum_add, <- IH. simpl. replace (n - 0 - 0)%nat with n by lia.
  rewrite (sum_ext _ (fun i => f (n - 1 - i)%nat) n) by (intros; f_equal; lia). lra.
Qed.

Ltac same := first [reflexivity | lia | f_equal; lia | f_equal; f_equal; lia].

Ltac cells := repeat match goal with
  | |- context [Z.leb ?x ?y] => destruct (Z.leb_spec x y)
  | |- context [Z.ltb ?x ?y] => destruct (Z.ltb_spec x y)
  end; try lia; rewrite ?Rmult_1_l, <- ?Ropp_mult_distr_l, ?Rmult_1_l, ?Ropp_involutive; same.

Section Windows.
Open Scope Z_scope.
Variable N : Z.
Hypothesis N_positive : 0 < N.
Variables a b : Z -> R.

Lemma mod_small_or m n : 0 <= m < 2 * N -> let t := m + n mod (2 * N) in
  (m + n) mod (2 * N) = if t <? 2 * N then t else t - 2 * N.
Proof.
  intros H t. subst t. pose proof (Z.mod_pos_bound n (2 * N) ltac:(lia)).
  rewrite <- (Z.add_mod_idemp_r m n) by lia. destruct (Z.ltb_spec (m + n mod (2 * N)) (2 * N)).
  - apply Z.mod_small. lia.
  - symmetry. apply Z.mod_unique with 1; lia.
Qed.

Lemma strain_arrival m : 0 <= m < 2 * N -> strainDD N a b m = (-2 * arrival N a b m)%R.
Proof.
  intro H. unfold strainDD, aDD, bDD. rewrite (Z.mod_small m) by lia.
  assert (R2 : r2DD N a b (N + (m + 1) mod (2 * N)) = (- arrival N a b m)%R).
  { destruct (Z.eq_dec m (2 * N - 1)) as [->|].
    - replace (2 * N - 1 + 1) with (2 * N) by lia. rewrite Z.mod_same by lia.
      unfold r2DD, arrival. cells.
    - rewrite Z.mod_small by lia. unfold r2DD, arrival. cells. }
  rewrite R2. replace (r1DD N a b (N - m)) with (arrival N a b m) by (unfold r1DD, arrival; cells). lra.
Qed.

Lemma arrival_DD n m : 0 <= m < 2 * N ->
  arrival N (aDD N a b n) (bDD N a b n) m = arrival N a b ((m + n) mod (2 * N)).
Proof.
  intro H. rewrite mod_small_or by lia. pose proof (Z.mod_pos_bound n (2 * N) ltac:(lia)).
  unfold arrival, aDD, bDD, r1DD, r2DD. generalize dependent (n mod (2 * N)). intros t Ht. cells.
Qed.

(** In flight the sign changes with each turn of 2N steps; the state repeats after two. *)
Definition turned (t : Z) : R := if Z.even (t / (2 * N)) then 1%R else (-1)%R.

Lemma turned_4N n m : turned (m + n mod (4 * N)) = turned (m + n).
Proof.
  unfold turned. rewrite (Z.div_mod n (4 * N)) at 2 by lia.
  replace (m + (4 * N * (n / (4 * N)) + n mod (4 * N)))
    with (m + n mod (4 * N) + (2 * (n / (4 * N))) * (2 * N)) by ring.
  rewrite Z.div_add by lia. rewrite Z.even_add_mul_2. reflexivity.
Qed.

Lemma mod_4N n m : (m + n mod (4 * N)) mod (2 * N) = (m + n) mod (2 * N).
Proof.
  rewrite (Z.div_mod n (4 * N)) at 2 by lia.
  replace (m + (4 * N * (n / (4 * N)) + n mod (4 * N)))
    with (m + n mod (4 * N) + (2 * (n / (4 * N))) * (2 * N)) by ring.
  rewrite Z.mod_add by lia. reflexivity.
Qed.

(** t = 2N q + r, q < 3. *)
Lemma turn_cases t : 0 <= t < 6 * N ->
  (t < 2 * N /\ t mod (2 * N) = t /\ turned t = 1%R) \/
  (2 * N <= t < 4 * N /\ t mod (2 * N) = t - 2 * N /\ turned t = (-1)%R) \/
  (4 * N <= t /\ t mod (2 * N) = t - 4 * N /\ turned t = 1%R).
Proof.
  intro H. assert (E : forall q r, t = 2 * N * q + r -> 0 <= r < 2 * N -> t mod (2 * N) = r /\ t / (2 * N) = q).
  { intros q r -> B. split; [symmetry; apply Z.mod_unique with q|symmetry; apply Z.div_unique with r]; lia. }
  unfold turned. destruct (Z.lt_ge_cases t (2 * N)); [left|destruct (Z.lt_ge_cases t (4 * N)); right; [left|right]].
  - destruct (E 0 t) as [-> ->]; try lia. auto.
  - destruct (E 1 (t - 2 * N)) as [-> ->]; try lia. auto.
  - destruct (E 2 (t - 4 * N)) as [-> ->]; try lia. auto.
Qed.

Lemma arrival_DN n m : 0 <= m < 2 * N ->
  arrival N (aDN N a b n) (bDN N a b n) m = (turned (m + n) * arrival N a b ((m + n) mod (2 * N)))%R.
Proof.
  intro H. rewrite <- turned_4N, <- mod_4N. pose proof (Z.mod_pos_bound n (4 * N) ltac:(lia)).
  unfold arrival, aDN, bDN, r1DN, r2DN. generalize dependent (n mod (4 * N)). intros t Ht.
  destruct (turn_cases (m + t) ltac:(lia)) as [[C [-> ->]]|[[C [-> ->]]|[C [-> ->]]]];
    replace (-1)%R with (- (1))%R by lra; cells.
Qed.

Lemma velocity_arrival m : 0 <= m -> velocityDN N a b m = (2 * (turned m * arrival N a b (m mod (2 * N))))%R.
Proof.
  intro H. assert (A : aDN N a b m N = (turned m * arrival N a b (m mod (2 * N)))%R).
  { rewrite <- (Z.add_0_l m) at 2 3. rewrite <- turned_4N, <- mod_4N. unfold aDN.
    pose proof (Z.mod_pos_bound m (4 * N) ltac:(lia)). generalize dependent (m mod (4 * N)). intros t Ht.
    rewrite Z.add_0_l. unfold r1DN, arrival.
    destruct (turn_cases t ltac:(lia)) as [[C [-> ->]]|[[C [-> ->]]|[C [-> ->]]]];
      replace (-1)%R with (- (1))%R by lra; cells. }
  assert (B : bDN N a b (m + 1) N = aDN N a b m N).
  { unfold aDN, bDN. assert (E : (m + 1) mod (4 * N) = if m mod (4 * N) + 1 =? 4 * N then 0 else m mod (4 * N) + 1).
    { pose proof (Z.mod_pos_bound m (4 * N) ltac:(lia)). rewrite <- Z.add_mod_idemp_l by lia.
      destruct (Z.eqb_spec (m mod (4 * N) + 1) (4 * N)) as [->|]; [apply Z.mod_same|apply Z.mod_small]; lia. }
    rewrite E. pose proof (Z.mod_pos_bound m (4 * N) ltac:(lia)). generalize dependent (m mod (4 * N)).
    intros t E Ht. destruct (Z.eqb_spec (t + 1) (4 * N)); unfold r1DN, r2DN; cells. }
  unfold velocityDN. rewrite B, A. lra.
Qed.

(** A state is its window of arrivals. *)
Lemma same_window a' b' : (forall m, 0 <= m < 2 * N -> arrival N a b m = arrival N a' b' m) <->
  (forall i, 1 <= i <= N -> a i = a' i /\ b i = b' i).
Proof.
  split; intro H.
  - intros i I. split.
    + specialize (H (N - i) ltac:(lia)). unfold arrival in H. destruct (Z.ltb_spec (N - i) N); [|lia].
      replace (N - (N - i)) with i in H by lia. exact H.
    + specialize (H (N + i - 1) ltac:(lia)). unfold arrival in H. destruct (Z.ltb_spec (N + i - 1) N); [lia|].
      replace (N + i - 1 - N + 1) with i in H by lia. lra.
  - intros m M. unfold arrival. destruct (Z.ltb_spec m N); [apply H; lia|]. f_equal. apply H. lia.
Qed.
End Windows.

Lemma by_turns cells (P : nat -> Prop) : (0 < cells)%nat -> (forall m, (m < 2 * cells)%nat -> P m) ->
  (forall m, P m -> P (m + 2 * cells)%nat) -> forall m, P m.
Proof.
  intros C Z S m. induction m as [m IH] using (well_founded_induction lt_wf).
  destruct (Nat.lt_ge_cases m (2 * cells)) as [L|L]; auto.
  replace m with (m - 2 * cells + 2 * cells)%nat by lia. apply S, IH. lia.
Qed.

(** * The delay form of (30)-(32) *)

Section Delay.
Variables cells contact free : nat.
Hypothesis cells_positive : (0 < cells)%nat.
Hypothesis free_positive : (0 < free)%nat.
Let N := Z.of_nat cells.
Let steps := (contact + free)%nat.
Variables a b : Z -> R.

(** What happens to a wave that arrives in step m. *)
Definition reflected (m : nat) : R := if (m mod steps <? contact)%nat then 1 else -1.

Fixpoint reflections (r q : nat) : R :=
  match q with O => 1 | S q' => reflected (r + 2 * cells * q') * reflections r q' end.

(** What arrives at the tip in step m, of all steps to come. *)
Definition p (m : nat) : R :=
  reflections (m mod (2 * cells)) (m / (2 * cells)) * arrival N a b (Z.of_nat (m mod (2 * cells))).

Lemma p_delay m : p (m + 2 * cells) = reflected m * p m.
Proof.
  unfold p. replace (m + 2 * cells)%nat with (m + 1 * (2 * cells))%nat by lia.
  rewrite Nat.mod_add, Nat.div_add by lia. rewrite Nat.add_1_r. cbn [reflections].
  replace (m mod (2 * cells) + 2 * cells * (m / (2 * cells)))%nat with m
    by (rewrite Nat.add_comm; apply Nat.div_mod_eq).
  ring.
Qed.

Lemma p_start m : (m < 2 * cells)%nat -> p m = arrival N a b (Z.of_nat m).
Proof. intro H. unfold p. rewrite Nat.mod_small, Nat.div_small by lia. simpl. ring. Qed.

Lemma mod_turn m : ((m + 2 * cells) mod (2 * cells) = m mod (2 * cells))%nat.
Proof. replace (m + 2 * cells)%nat with (m + 1 * (2 * cells))%nat by lia. apply Nat.mod_add. lia. Qed.

Lemma p_contact m : (m < contact + 2 * cells)%nat -> p m = arrival N a b (Z.of_nat (m mod (2 * cells))).
Proof.
  induction m as [m H|m IH] using (fun P => by_turns cells P cells_positive); [intros _|intro H].
  - rewrite Nat.mod_small by lia. apply p_start, H.
  - rewrite p_delay, IH, mod_turn by lia. unfold reflected. rewrite Nat.mod_small by lia.
    destruct (Nat.ltb_spec m contact); [ring|lia].
Qed.

Lemma turned_next m : turned N (Z.of_nat (m + 2 * cells)) = - turned N (Z.of_nat m).
Proof.
  unfold turned. replace (Z.of_nat (m + 2 * cells)) with (Z.of_nat m + 1 * (2 * N))%Z by (unfold N; lia).
  rewrite Z.div_add by (unfold N; lia). rewrite Z.even_add. change (Z.even 1) with false.
  destruct (Z.even (Z.of_nat m / (2 * N))); simpl; lra.
Qed.

Lemma turned_first m : (m < 2 * cells)%nat -> turned N (Z.of_nat m) = 1.
Proof. intro H. unfold turned. rewrite Z.div_small by (unfold N; lia). reflexivity. Qed.

Lemma p_flight m : (m < free + 2 * cells)%nat ->
  p (contact + m) = turned N (Z.of_nat m) * p (contact + m mod (2 * cells)).
Proof.
  induction m as [m H|m IH] using (fun P => by_turns cells P cells_positive); [intros _|intro H].
  - rewrite Nat.mod_small, turned_first by lia. ring.
  - rewrite Nat.add_assoc, p_delay, IH, mod_turn, turned_next by lia.
    unfold reflected. rewrite Nat.mod_small by (unfold steps; lia).
    destruct (Nat.ltb_spec (contact + m) contact); [lia|ring].
Qed.

Lemma of_nat_mod m : Z.of_nat (m mod (2 * cells)) = (Z.of_nat m mod (2 * N))%Z.
Proof. rewrite Nat2Z.inj_mod. f_equal. unfold N. lia. Qed.

Lemma window_contact m : (0 <= m < 2 * N)%Z ->
  arrival N (aDD N a b (Z.of_nat contact)) (bDD N a b (Z.of_nat contact)) m = p (contact + Z.to_nat m).
Proof.
  intro H. rewrite arrival_DD by (unfold N in *; lia). rewrite p_contact by (unfold N in *; lia).
  rewrite of_nat_mod. f_equal. f_equal. lia.
Qed.

Lemma window_period m : (0 <= m < 2 * N)%Z ->
  let a1 := aDD N a b (Z.of_nat contact) in let b1 := bDD N a b (Z.of_nat contact) in
  arrival N (aDN N a1 b1 (Z.of_nat free)) (bDN N a1 b1 (Z.of_nat free)) m = p (Z.to_nat m + steps).
Proof.
  intros H a1 b1. rewrite arrival_DN by (unfold N in *; lia).
  pose proof (Z.mod_pos_bound (m + Z.of_nat free) (2 * N) ltac:(unfold N in *; lia)).
  unfold a1, b1. rewrite window_contact by lia.
  replace (Z.to_nat m + steps)%nat with (contact + (Z.to_nat m + free))%nat by (unfold steps; lia).
  rewrite (p_flight (Z.to_nat m + free)) by (unfold N in *; lia).
  replace (Z.of_nat (Z.to_nat m + free)) with (m + Z.of_nat free)%Z by lia. f_equal. f_equal. f_equal.
  apply Nat2Z.inj. rewrite of_nat_mod, Z2Nat.id by lia. f_equal. lia.
Qed.

Record delayed : Prop := {
  comesBack : forall m, (m < 2 * cells)%nat -> p (m + steps) = p m;
  fromWall : sum p (2 * cells) = - INR cells;
  pushes : forall m, (m < contact)%nat -> 0 <= p m;
  stays : forall m, (m < free)%nat -> sum (fun k => p (contact + k)) (S m) <= 0
}.

Lemma gap_sum : sum (fun i => b (Z.of_nat i + 1)%Z - a (Z.of_nat i + 1)%Z) cells = - sum p (2 * cells).
Proof.
  replace (2 * cells)%nat with (cells + cells)%nat by lia. rewrite sum_add, sum_minus.
  rewrite <- (sum_reverse (fun i => a (Z.of_nat i + 1)%Z)).
  rewrite (sum_ext (fun i => p (cells + i)) (fun i => -1 * b (Z.of_nat i + 1)%Z)).
  2: { intros i H. rewrite p_start by lia. unfold arrival.
       destruct (Z.ltb_spec (Z.of_nat (cells + i)) N); [unfold N in *; lia|].
       replace (Z.of_nat (cells + i) - N + 1)%Z with (Z.of_nat i + 1)%Z by (unfold N; lia). lra. }
  rewrite sum_scale, (sum_ext p (fun i => a (Z.of_nat (cells - 1 - i) + 1)%Z) cells); [lra|].
  intros i H. rewrite p_start by lia. unfold arrival.
  destruct (Z.ltb_spec (Z.of_nat i) N); [|unfold N in *; lia]. f_equal. unfold N. lia.
Qed.

Lemma pushes_strain m : (m <= contact)%nat -> strainDD N a b (Z.of_nat m) = -2 * p m.
Proof.
  intro H. assert (E : strainDD N a b (Z.of_nat m) = strainDD N a b (Z.of_nat (m mod (2 * cells)))).
  { unfold strainDD, aDD, bDD. rewrite of_nat_mod. rewrite Z.mod_mod, Z.add_mod_idemp_l by (unfold N; lia).
    reflexivity. }
  pose proof (Nat.mod_upper_bound m (2 * cells) ltac:(lia)).
  rewrite E, strain_arrival by (unfold N; lia). rewrite p_contact by lia. reflexivity.
Qed.

Lemma apart_sum m : (m <= free)%nat -> let a1 := aDD N a b (Z.of_nat contact) in
  let b1 := bDD N a b (Z.of_nat contact) in
  sum (fun k => velocityDN N a1 b1 (Z.of_nat k)) m = 2 * sum (fun k => p (contact + k)) m.
Proof.
  intros H a1 b1. rewrite <- sum_scale. apply sum_ext. intros k K.
  rewrite velocity_arrival by (unfold N; lia).
  pose proof (Z.mod_pos_bound (Z.of_nat k) (2 * N) ltac:(unfold N in *; lia)).
  unfold a1, b1. rewrite window_contact by lia. rewrite (p_flight k) by lia. repeat f_equal.
  rewrite <- of_nat_mod. apply Nat2Z.id.
Qed.

Theorem delay_form : motion cells contact free a b <-> delayed.
Proof.
  split; [intros [P W C _ F]|intros [P W C F]]; split.
  - intros m M.
    pose proof (proj2 (same_window N ltac:(unfold N; lia) _ _ a b) P (Z.of_nat m) ltac:(unfold N; lia)) as E.
    rewrite window_period in E by (unfold N; lia). rewrite Nat2Z.id in E. rewrite E, p_start by lia. reflexivity.
  - rewrite gap_sum in W. lra.
  - intros m M. specialize (C m M). fold N in C. rewrite pushes_strain in C by lia. lra.
  - intros m M. specialize (F m M). fold N in F. rewrite apart_sum in F by lia. lra.
  - fold N. apply same_window; [unfold N; lia|]. intros m M. rewrite window_period by lia.
    rewrite P by (unfold N in M; lia). rewrite p_start, Z2Nat.id by (unfold N in M; lia). reflexivity.
  - rewrite gap_sum. lra.
  - intros m M. specialize (C m M). fold N. rewrite pushes_strain by lia. lra.
  - fold N. rewrite pushes_strain by lia. specialize (F 0%nat free_positive). simpl in F.
    rewrite Nat.add_0_r in F. lra.
  - intros m M. specialize (F m M). fold N. rewrite apart_sum by lia. lra.
Qed.
End Delay.
