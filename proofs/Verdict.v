(** What follows from the theorem on one contact: the verdict is right, and the least energy of a simplex. *)

From Coq Require Import QArith Qreals Reals ZArith Arith Lia Lra List Bool.
From Signorini Require Import Paper Classes Amplitudes OneContact.
Import ListNotations.
Open Scope R_scope.

Section OnePhase.
Variables cells contact free : nat.
Hypothesis cells_positive : (0 < cells)%nat.
Hypothesis contact_positive : (0 < contact)%nat.
Hypothesis free_positive : (0 < free)%nat.
Let steps := (contact + free)%nat.
Let G := classes cells contact free.
Let nu := turns cells contact free.
Let w := window cells contact free.
Let u := inverse cells contact free.
Let q := (contact / G)%nat.
Let r := (contact mod G)%nat.
Let kOf := blocksOf cells contact free.
Let k := blocks cells contact free.
Let walk := walk cells contact free.
Let sign := sign cells contact free.
Let isLive := live cells contact free.

(** What is known of the classes, of this schedule. *)
Local Notation here lemma := (lemma cells contact free cells_positive contact_positive free_positive).
Let G_positive : (0 < G)%nat. Proof. exact (here G_positive). Qed.
Let cells_w : (2 * cells = w * G)%nat. Proof. exact (here cells_w). Qed.
Let contact_q : contact = (q * G + r)%nat /\ (r < G)%nat. Proof. exact (here contact_q). Qed.
Let sign_unit : forall alpha, (sign alpha = 1 \/ sign alpha = -1)%Z. Proof. exact (here sign_unit). Qed.
Let admissible_spec : admissible cells contact free = true <->
  (forall alpha, (alpha < k)%nat -> sign alpha = 1%Z) /\
  (forall alpha, (alpha < turns cells contact free)%nat -> drift cells contact free (S alpha) <= 0)%Z /\
  (win cells contact free < 0)%Z. Proof. exact (here admissible_spec). Qed.
Let one_contact : forall a b, motion cells contact free a b <->
  exists z, consists cells contact free z a b /\ allowed cells contact free z. Proof. exact (here one_contact). Qed.

(** * What follows from it *)

(** The verdict: some class is live, and its signs are admissible or nobody asks. *)
Definition verdict : bool :=
  (isLive (G - 1) || isLive 0) && ((k =? 0)%nat || admissible cells contact free).

Lemma some_live : isLive (G - 1) || isLive 0 = true <-> exists j, (j < G)%nat /\ isLive j = true.
Proof.
  pose proof G_positive. rewrite orb_true_iff. split.
  - intros [L|L]; [exists (G - 1)%nat|exists 0%nat]; split; auto; lia.
  - intros [j [J L]]. destruct contact_q as [_ R0].
    assert (E : forall i, isLive i = Nat.even (nu - if (i <? r)%nat then S q else q)) by reflexivity.
    rewrite !E. rewrite E in L. destruct (Nat.ltb_spec j r).
    + right. destruct (Nat.ltb_spec 0 r); [exact L|lia].
    + left. destruct (Nat.ltb_spec (G - 1) r); [lia|exact L].
Qed.

(** A state with given amplitudes. *)
Definition stateA (z : nat -> R) (i : Z) : R :=
  let m := (cells - Z.to_nat i)%nat in IZR (sign (m / G)) * z (m mod G)%nat.
Definition stateB (z : nat -> R) (i : Z) : R :=
  let m := (cells + Z.to_nat i - 1)%nat in - (IZR (sign (m / G)) * z (m mod G)%nat).

Lemma state_consists z : (forall j, (j < G)%nat -> isLive j = false -> z j = 0) ->
  consists cells contact free z (stateA z) (stateB z).
Proof.
  intro D. split; [exact D|]. intros m M. unfold arrival, stateA, stateB. fold G sign.
  destruct (Z.ltb_spec (Z.of_nat m) (Z.of_nat cells)).
  - replace (cells - Z.to_nat (Z.of_nat cells - Z.of_nat m))%nat with m by lia. reflexivity.
  - replace (cells + Z.to_nat (Z.of_nat m - Z.of_nat cells + 1) - 1)%nat with m by lia. ring.
Qed.

(** All of the sum in one class. *)
Definition only (j0 : nat) (value : R) (j : nat) : R := if (j =? j0)%nat then value else 0.

Lemma sum_only j0 value n : sum (only j0 value) n = if (j0 <? n)%nat then value else 0.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [sum]. rewrite IH. unfold only.
  destruct (Nat.ltb_spec j0 n), (Nat.ltb_spec j0 (S n)), (Nat.eqb_spec n j0); try lia; lra.
Qed.

(** Where the verdict is true, all of a rational sum in one class is a motion. *)
Lemma verdict_amplitude : verdict = true -> exists j0 value,
  (forall j, (j < G)%nat -> isLive j = false -> only j0 (Q2R value) j = 0) /\
  allowed cells contact free (only j0 (Q2R value)).
Proof.
  assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive).
  unfold verdict. rewrite andb_true_iff, some_live. intros [[j0 [J L]] V]. exists j0.
  exists (if (k =? 0)%nat then (- Z.of_nat cells # 1)%Q else (Z.of_nat cells # Z.to_pos (- win cells contact free))%Q).
  set (value := Q2R _). split.
  { intros j _ H. unfold only. destruct (Nat.eqb_spec j j0) as [->|]; [congruence|reflexivity]. }
  unfold allowed. fold k. unfold value. destruct (Nat.eqb_spec k 0) as [K|K]; cbn [orb] in V.
  - assert (E : Q2R (- Z.of_nat cells # 1) = - INR cells).
    { unfold Q2R. cbn [Qnum Qden]. rewrite opp_IZR, <- INR_IZR_INZ. field. }
    rewrite E. split; fold G; [intros j _|]; rewrite sum_only; [destruct (j0 <? S j)%nat; lra|].
    destruct (Nat.ltb_spec j0 G); [reflexivity|lia].
  - apply admissible_spec in V as A. destruct A as [_ [_ W0]].
    assert (E : Q2R (Z.of_nat cells # Z.to_pos (- win cells contact free)) = INR cells * / - IZR (win cells contact free)).
    { unfold Q2R. cbn [Qnum Qden]. rewrite Z2Pos.id, opp_IZR, <- INR_IZR_INZ by lia. reflexivity. }
    rewrite E. apply IZR_lt in W0 as W. split; [exact V|]. split; fold G.
    + assert (P : 0 <= INR cells * / - IZR (win cells contact free)).
      { apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra. }
      intros j _. unfold only. destruct (j =? j0)%nat; lra.
    + rewrite sum_only. destruct (Nat.ltb_spec j0 G); [field; lra|lia].
Qed.

Theorem verdict_correct : verdict = true <-> exists a b, motion cells contact free a b.
Proof.
  assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive). split.
  - intro V. destruct (verdict_amplitude V) as [j0 [value [D A]]]. set (z := only j0 (Q2R value)) in *.
    exists (stateA z), (stateB z). apply one_contact. exists z. split; [apply state_consists, D|exact A].
  - unfold verdict. rewrite andb_true_iff, some_live.
    intros [a [b M]]. apply one_contact in M. destruct M as [z [[D _] B]]. fold G isLive in D. split.
    + destruct (isLive (G - 1) || isLive 0) eqn:E; [apply some_live, E|]. exfalso.
      assert (Z : sum z G = 0).
      { apply sum_zero. intros j J. apply D; [exact J|]. destruct (isLive j) eqn:L; auto.
        rewrite (proj2 some_live) in E; [discriminate|exists j; auto]. }
      unfold allowed in B. fold k in B. destruct (k =? 0)%nat; [|destruct B as [_ B]]; destruct B as [_ B];
        fold G in B; rewrite Z in B; lra.
    + unfold allowed in B. fold k in B. destruct (k =? 0)%nat; [reflexivity|]. destruct B as [-> _]. reflexivity.
Qed.
(** * Least energy *)

Lemma sum_squares_windows z a b : consists cells contact free z a b ->
  sum (fun i => a (Z.of_nat i + 1)%Z * a (Z.of_nat i + 1)%Z + b (Z.of_nat i + 1)%Z * b (Z.of_nat i + 1)%Z) cells =
  INR w * sum (fun j => z j * z j) G.
Proof.
  intros [_ A]. set (f := fun m => let x := arrival (Z.of_nat cells) a b (Z.of_nat m) in x * x).
  assert (E : sum f (2 * cells) = INR w * sum (fun j => z j * z j) G).
  { replace (2 * cells)%nat with (w * G + 0)%nat by (rewrite cells_w; lia).
    rewrite (sum_ext f (fun m => 1 * (z (m mod G)%nat * z (m mod G)%nat))).
    2: { intros m M. unfold f. rewrite A by (rewrite cells_w; lia). fold G sign.
         destruct (sign_unit (m / G)) as [-> | ->]; simpl; ring. }
    rewrite (block_sum G (fun _ => 1) (fun j => z j * z j) G_positive) by lia.
    assert (One : forall i, sum (fun _ => 1) i = INR i).
    { intro i. induction i as [|i IH]; [reflexivity|]. rewrite S_INR. simpl. rewrite IH. reflexivity. }
    rewrite One. simpl. ring. }
  rewrite <- E. replace (2 * cells)%nat with (cells + cells)%nat by lia. rewrite sum_add.
  rewrite <- (sum_reverse f cells).
  assert (X : forall g h n, sum (fun i => g i + h i) n = sum g n + sum h n).
  { intros g h i. induction i as [|i IH]; simpl; lra. }
  rewrite X. f_equal; apply sum_ext; intros i I; unfold f, arrival.
  - destruct (Z.ltb_spec (Z.of_nat (cells - 1 - i)) (Z.of_nat cells)); [|lia].
    replace (Z.of_nat cells - Z.of_nat (cells - 1 - i))%Z with (Z.of_nat i + 1)%Z by lia. reflexivity.
  - destruct (Z.ltb_spec (Z.of_nat (cells + i)) (Z.of_nat cells)); [lia|].
    replace (Z.of_nat (cells + i) - Z.of_nat cells + 1)%Z with (Z.of_nat i + 1)%Z by lia. ring.
Qed.

(** d: live classes. *)
Definition amplitudesCount : R := sum (fun j => if isLive j then 1 else 0) G.

(** Energies, E/E_1 = (2/N) (sum of a^2 + b^2), of a simplex: E/E_1 >= 2 w N/(win^2 d). *)
Theorem least_energy a b : (k > 0)%nat -> motion cells contact free a b ->
  2 * INR w * INR cells <= IZR (win cells contact free) * IZR (win cells contact free) * amplitudesCount *
  (2 / INR cells * sum (fun i => a (Z.of_nat i + 1)%Z * a (Z.of_nat i + 1)%Z +
                                 b (Z.of_nat i + 1)%Z * b (Z.of_nat i + 1)%Z) cells).
Proof.
  intros K M. apply one_contact in M. destruct M as [z [C B]]. rewrite (sum_squares_windows z a b C).
  unfold allowed in B. fold k in B. destruct (Nat.eqb_spec k 0); [lia|]. destruct B as [_ [_ W]]. fold G in W.
  destruct C as [D _]. fold G isLive in D.
  set (S := sum z G) in *. set (Q := sum (fun j => z j * z j) G) in *.
  set (v := IZR (win cells contact free)) in *.
  assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive).
  (* sum over live j of (d z_j - S)^2 >= 0 gives S^2 <= d Q. *)
  assert (P : forall t n, (n <= G)%nat ->
    0 <= t * t * sum (fun j => if isLive j then 1 else 0) n - 2 * t * sum z n + sum (fun j => z j * z j) n).
  { intros t i I. induction i as [|i IH]; simpl; [lra|]. specialize (IH ltac:(lia)).
    destruct (isLive i) eqn:L.
    - pose proof (Rle_0_sqr (t - z i)) as R0. unfold Rsqr in R0. lra.
    - rewrite (D i) by (lia || exact L). lra. }
  set (d := amplitudesCount) in *.
  assert (H : forall t, 0 <= t * t * d - 2 * t * S + Q) by (intro t; apply (P t G); lia).
  assert (D0 : 0 <= d).
  { apply sum_nonneg. intros j _. destruct (isLive j); lra. }
  assert (SQ : S * S <= d * Q).
  { destruct (Rle_lt_or_eq_dec 0 d D0) as [D1|D1].
    - specialize (H (S / d)).
      replace (S / d * (S / d) * d - 2 * (S / d) * S + Q) with ((d * Q - S * S) / d) in H by (field; lra).
      apply (Rmult_le_compat_r d) in H; [|lra]. unfold Rdiv in H. rewrite Rmult_assoc, Rinv_l, Rmult_0_l in H by lra. lra.
    - rewrite <- D1 in *. destruct (Req_dec S 0) as [->|S0]; [lra|]. specialize (H ((Q + 1) / (2 * S))).
      replace (2 * ((Q + 1) / (2 * S)) * S) with (Q + 1) in H by (field; exact S0). lra. }
  assert (NN : INR cells * INR cells = v * v * (S * S)).
  { replace (v * v * (S * S)) with ((v * S) * (v * S)) by ring. rewrite W. ring. }
  replace (v * v * d * (2 / INR cells * (INR w * Q))) with (2 * INR w / INR cells * (v * v * (d * Q))) by (field; lra).
  replace (2 * INR w * INR cells) with (2 * INR w / INR cells * (INR cells * INR cells)) by (field; lra).
  apply Rmult_le_compat_l.
  - apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, N0]. pose proof (pos_INR w). lra.
  - rewrite NN. apply Rmult_le_compat_l; [apply Rle_0_sqr|exact SQ].
Qed.
Lemma sum_live c i : sum (fun j => if isLive j then c else 0) i = c * sum (fun j => if isLive j then 1 else 0) i.
Proof. rewrite <- sum_scale. apply sum_ext. intros j _. destruct (isLive j); ring. Qed.

(** Equal amplitudes reach it. *)
Theorem least_energy_attained : (k > 0)%nat -> verdict = true -> exists a b, motion cells contact free a b /\
  2 * INR w * INR cells = IZR (win cells contact free) * IZR (win cells contact free) * amplitudesCount *
  (2 / INR cells * sum (fun i => a (Z.of_nat i + 1)%Z * a (Z.of_nat i + 1)%Z +
                                 b (Z.of_nat i + 1)%Z * b (Z.of_nat i + 1)%Z) cells).
Proof.
  intros K V. assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive).
  unfold verdict in V. apply andb_true_iff in V. destruct V as [L V]. apply some_live in L.
  destruct (Nat.eqb_spec k 0) as [|_]; [lia|]. cbn [orb] in V.
  pose proof (proj1 admissible_spec V) as A. destruct A as [_ [_ W]]. apply IZR_lt in W.
  set (v := IZR (win cells contact free)) in *.
  assert (D : 0 < amplitudesCount).
  { destruct L as [j0 [J L]]. unfold amplitudesCount.
    assert (M : sum (only j0 1) G <= sum (fun j => if isLive j then 1 else 0) G).
    { clear - L. induction G as [|i IH]; simpl; [lra|]. unfold only at 2. destruct (Nat.eqb_spec i j0) as [->|].
      - rewrite L. lra.
      - destruct (isLive i); lra. }
    rewrite sum_only in M. destruct (Nat.ltb_spec j0 G); [lra|lia]. }
  set (d := amplitudesCount) in *. set (c := INR cells / (- v * d)).
  assert (C : 0 <= c).
  { apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. apply Rmult_lt_0_compat; lra. }
  set (z := fun j => if isLive j then c else 0).
  assert (Dead : forall j, (j < G)%nat -> isLive j = false -> z j = 0) by (intros j _ H; unfold z; rewrite H; reflexivity).
  exists (stateA z), (stateB z). split.
  - apply one_contact. exists z. split; [apply state_consists, Dead|]. unfold allowed. fold k.
    destruct (Nat.eqb_spec k 0) as [|_]; [lia|]. split; [exact V|]. split; fold G.
    + intros j _. unfold z. destruct (isLive j); lra.
    + unfold z. rewrite sum_live. fold amplitudesCount d v. unfold c. field. split; lra.
  - rewrite (sum_squares_windows z _ _ (state_consists z Dead)).
    rewrite (sum_ext (fun j => z j * z j) (fun j => if isLive j then c * c else 0))
      by (intros j _; unfold z; destruct (isLive j); ring).
    rewrite sum_live. fold amplitudesCount d. unfold c. field. repeat split; lra.
Qed.
End OnePhase.
