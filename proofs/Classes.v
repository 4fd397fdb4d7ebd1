(** Classes of steps: what docs/theory.md, sections 4 to 6, says of one contact in whole numbers, and walks
    around a class.

    Steps fall into G = gcd(2N, n) classes, and going around a class of nu = n/G steps turns the sign of a wave
    once for each free step. Where it comes back as it was the class is live and has one amplitude z_j; so
    p_{alpha G + j} = sign(alpha) z_j, and (30)-(32) are conditions on the z: a simplex, a box, or nothing. *)

From Coq Require Import Reals ZArith Arith Lia Lra List Permutation Bool.
From Signorini Require Import Paper.
Import ListNotations.
Open Scope R_scope.

(** * The set *)

Fixpoint sumZ (f : nat -> Z) (n : nat) : Z := match n with O => 0 | S m => sumZ f m + f m end%Z.

Section Definitions.
Variables cells contact free : nat.

Definition classes := Nat.gcd (2 * cells) (contact + free).      (** G *)
Definition turns := ((contact + free) / classes)%nat.            (** nu *)
Definition window := (2 * cells / classes)%nat.                  (** w *)

(** Contact steps of class j: q + 1 of the first r classes, q of the others. *)
Definition blocksOf (j : nat) : nat :=
  if (j <? contact mod classes)%nat then S (contact / classes) else (contact / classes)%nat.
Definition live (j : nat) : bool := Nat.even (turns - blocksOf j).

(** k: those of the live classes. *)
Definition blocks : nat :=
  if Nat.even (turns - contact / classes) then (contact / classes)%nat else S (contact / classes).

(** From block 0 to block t w mod nu: a factor -1 for each block of flight. *)
Fixpoint walk (k t : nat) : Z :=
  match t with
  | O => 1
  | S t' => walk k t' * (if ((t' * window) mod turns <? k)%nat then 1 else -1)
  end%Z.

(** u w = 1 mod nu. *)
Definition inverse : nat :=
  match find (fun u => (u * window) mod turns =? 1 mod turns)%nat (seq 0 turns) with Some u => u | None => O end.

(** epsilon of block alpha. *)
Definition sign (alpha : nat) : Z := walk blocks ((alpha * inverse) mod turns).

Definition win : Z := sumZ sign window.
(** Lambda: what flight has added up before block alpha. *)
Definition drift (alpha : nat) : Z := sumZ (fun beta => if (beta <? blocks)%nat then 0 else sign beta)%Z alpha.

(** Contact asks for one sign, no prefix sum is positive, and the gap can be met. *)
Definition admissible : bool :=
  forallb (fun alpha => sign alpha =? 1)%Z (seq 0 blocks) &&
  forallb (fun alpha => drift (S alpha) <=? 0)%Z (seq 0 turns) && (win <? 0)%Z.

(** A state of amplitudes z. *)
Definition consists (z : nat -> R) (a b : Z -> R) : Prop :=
  (forall j, (j < classes)%nat -> live j = false -> z j = 0) /\
  forall m, (m < 2 * cells)%nat ->
    arrival (Z.of_nat cells) a b (Z.of_nat m) = IZR (sign (m / classes)) * z (m mod classes)%nat.

Definition inSimplex (z : nat -> R) : Prop :=
  (forall j, (j < classes)%nat -> 0 <= z j) /\ IZR win * sum z classes = - INR cells.

Definition inBox (z : nat -> R) : Prop :=
  (forall j, (j < classes)%nat -> - INR cells <= sum z (S j) <= 0) /\ sum z classes = - INR cells.

Definition allowed (z : nat -> R) : Prop :=
  if (blocks =? 0)%nat then inBox z else admissible = true /\ inSimplex z.
End Definitions.

(** * Walks around a class *)

Definition product (f : nat -> Z) (l : list nat) : Z := fold_right (fun x y => (f x * y)%Z) 1%Z l.

Lemma product_cons f x l : product f (x :: l) = (f x * product f l)%Z.
Proof. reflexivity. Qed.

Lemma product_app f l l' : product f (l ++ l') = (product f l * product f l')%Z.
Proof.
  induction l as [|x l IH]; [symmetry; apply Z.mul_1_l|].
  rewrite <- app_comm_cons, !product_cons, IH. ring.
Qed.

Lemma product_permutation f l l' : Permutation l l' -> product f l = product f l'.
Proof. induction 1; rewrite ?product_cons; try ring; congruence. Qed.

Section Walks.
Variables cells contact free : nat.
Let nu := turns cells contact free.
Let w := window cells contact free.
Let u := inverse cells contact free.
Hypothesis nu_positive : (0 < nu)%nat.
Hypothesis is_inverse : ((u * w) mod nu = 1 mod nu)%nat.
Let walk := walk cells contact free.
Let turn k alpha : Z := if (alpha <? k)%nat then 1%Z else (-1)%Z.

Lemma walk_next k t : walk k (S t) = (walk k t * turn k ((t * w) mod nu)%nat)%Z.
Proof. reflexivity. Qed.

Lemma walk_unit k t : (walk k t = 1 \/ walk k t = -1)%Z.
Proof.
  induction t as [|t IH]; [left; reflexivity|]. rewrite walk_next. unfold turn.
  destruct ((t * w) mod nu <? k)%nat, IH as [-> | ->]; lia.
Qed.

Lemma back t : (((t * w) mod nu * u) mod nu = t mod nu)%nat.
Proof.
  rewrite Nat.mul_mod_idemp_l by lia. rewrite <- Nat.mul_assoc, (Nat.mul_comm w u).
  rewrite <- Nat.mul_mod_idemp_r, is_inverse, Nat.mul_mod_idemp_r by lia. f_equal. lia.
Qed.

Lemma forth t : (((t * u) mod nu * w) mod nu = t mod nu)%nat.
Proof.
  rewrite Nat.mul_mod_idemp_l by lia. rewrite <- Nat.mul_assoc.
  rewrite <- Nat.mul_mod_idemp_r, is_inverse, Nat.mul_mod_idemp_r by lia. f_equal. lia.
Qed.

Lemma walk_product k t : walk k t = product (turn k) (map (fun i => (i * w) mod nu)%nat (seq 0 t)).
Proof.
  induction t as [|t IH]; [reflexivity|].
  rewrite walk_next, IH, seq_S, map_app, product_app. simpl. ring.
Qed.

Lemma all_blocks : Permutation (map (fun i => (i * w) mod nu)%nat (seq 0 nu)) (seq 0 nu).
Proof.
  apply NoDup_Permutation_bis.
  - apply (NoDup_map_inv (fun alpha => (alpha * u) mod nu)%nat). rewrite map_map.
    rewrite (map_ext_in _ (fun t => t)); [rewrite map_id; apply seq_NoDup|].
    intros t T. apply in_seq in T. rewrite back. apply Nat.mod_small. lia.
  - rewrite map_length. reflexivity.
  - intros x X. apply in_map_iff in X. destruct X as [t [<- _]]. apply in_seq.
    pose proof (Nat.mod_upper_bound (t * w) nu). lia.
Qed.

Lemma turns_product k m : product (turn k) (seq 0 m) = if Nat.even (m - k) then 1%Z else (-1)%Z.
Proof.
  induction m as [|m IH]; [reflexivity|]. rewrite seq_S, product_app, IH. simpl product. unfold turn.
  change (0 + m)%nat with m. destruct (Nat.ltb_spec m k).
  - replace (m - k)%nat with 0%nat by lia. replace (S m - k)%nat with 0%nat by lia. reflexivity.
  - replace (S m - k)%nat with (S (m - k)) by lia. rewrite Nat.even_succ, <- Nat.negb_even.
    destruct (Nat.even (m - k)); reflexivity.
Qed.

Lemma walk_around k : walk k nu = if Nat.even (nu - k) then 1%Z else (-1)%Z.
Proof. rewrite walk_product, (product_permutation _ _ _ all_blocks). apply turns_product. Qed.

Lemma sign_next k alpha : walk k nu = 1%Z ->
  walk k (((alpha + w) * u) mod nu) = (turn k (alpha mod nu)%nat * walk k ((alpha * u) mod nu))%Z.
Proof.
  intro A. set (t := ((alpha * u) mod nu)%nat).
  assert (T : (t < nu)%nat) by (apply Nat.mod_upper_bound; lia).
  assert (E : (((alpha + w) * u) mod nu = (t + 1) mod nu)%nat).
  { rewrite Nat.mul_add_distr_r. rewrite <- Nat.add_mod_idemp_l by lia. fold t.
    rewrite <- Nat.add_mod_idemp_r, (Nat.mul_comm w u), is_inverse, Nat.add_mod_idemp_r by lia. reflexivity. }
  rewrite E. replace (alpha mod nu)%nat with ((t * w) mod nu)%nat by (unfold t; apply forth).
  assert (W : walk k (t + 1) = (turn k ((t * w) mod nu)%nat * walk k t)%Z).
  { rewrite Nat.add_1_r, walk_next. ring. }
  destruct (Nat.eq_dec (t + 1) nu) as [L|L].
  - rewrite <- W, L, A, Nat.mod_same by lia. reflexivity.
  - rewrite Nat.mod_small by lia. exact W.
Qed.
End Walks.

(** * Sums by blocks *)

Lemma block_sum G c z : (0 < G)%nat -> forall alpha j, (j <= G)%nat ->
  sum (fun m => c (m / G)%nat * z (m mod G)%nat) (alpha * G + j) = sum c alpha * sum z G + c alpha * sum z j.
Proof.
  intro G0. assert (I : forall alpha j, (j <= G)%nat ->
    sum (fun m => c (m / G)%nat * z (m mod G)%nat) (alpha * G + j) =
    sum (fun m => c (m / G)%nat * z (m mod G)%nat) (alpha * G) + c alpha * sum z j).
  { intros alpha j J. rewrite sum_add. f_equal. rewrite <- sum_scale. apply sum_ext. intros i H.
    replace ((alpha * G + i) / G)%nat with alpha by (rewrite Nat.div_add_l, Nat.div_small; lia).
    replace ((alpha * G + i) mod G)%nat with i
      by (rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small; lia). reflexivity. }
  intros alpha j J. rewrite I by lia. f_equal. clear j J. induction alpha as [|alpha IH]; [simpl; lra|].
  replace (S alpha * G)%nat with (alpha * G + G)%nat by lia. rewrite I, IH by lia. simpl. lra.
Qed.

Lemma sum_IZR f n : sum (fun i => IZR (f i)) n = IZR (sumZ f n).
Proof. induction n as [|n IH]; simpl; [reflexivity|]. rewrite IH, plus_IZR. reflexivity. Qed.

Lemma sum_nonneg z n : (forall j, (j < n)%nat -> 0 <= z j) -> 0 <= sum z n.
Proof. induction n as [|n IH]; intro H; simpl; [lra|]. assert (0 <= z n) by auto. assert (0 <= sum z n) by auto. lra. Qed.

Lemma sum_monotone z n j : (j <= n)%nat -> (forall i, (i < n)%nat -> 0 <= z i) -> sum z j <= sum z n.
Proof.
  intros J H. replace n with (j + (n - j))%nat by lia. rewrite sum_add.
  assert (0 <= sum (fun i => z (j + i)%nat) (n - j)); [|lra].
  apply sum_nonneg. intros i I. apply H. lia.
Qed.

Lemma sum_zero z n : (forall j, (j < n)%nat -> z j = 0) -> sum z n = 0.
Proof. induction n as [|n IH]; intro H; simpl; [reflexivity|]. rewrite IH, H; auto. lra. Qed.
