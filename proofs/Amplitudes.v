(** From the paper's rows to amplitudes, and back: p_{alpha G + j} = sign(alpha) z_j, and the rows of the z. *)

From Coq Require Import Reals ZArith Arith Lia Lra List Permutation Bool.
From Signorini Require Import Paper Classes.
Import ListNotations.
Open Scope R_scope.

(** * The schedule in classes *)

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

Lemma G_positive : (0 < G)%nat.
Proof.
  unfold G, classes. destruct (Nat.gcd (2 * cells) (contact + free)) eqn:E; [|lia].
  apply Nat.gcd_eq_0 in E. lia.
Qed.

Lemma steps_nu : steps = (nu * G)%nat.
Proof.
  pose proof G_positive. destruct (Nat.gcd_divide_r (2 * cells) (contact + free)) as [c C].
  unfold nu, turns. fold G in C |- *. change (Nat.gcd (2 * cells) (contact + free)) with G in C.
  fold steps in C |- *. rewrite C, Nat.div_mul by lia. reflexivity.
Qed.

Lemma cells_w : (2 * cells = w * G)%nat.
Proof.
  pose proof G_positive. destruct (Nat.gcd_divide_l (2 * cells) (contact + free)) as [c C].
  unfold w, window. fold G. change (Nat.gcd (2 * cells) (contact + free)) with G in C.
  rewrite C, Nat.div_mul by lia. reflexivity.
Qed.

Lemma nu_positive : (0 < nu)%nat.
Proof. pose proof steps_nu as E. unfold steps in E. destruct nu; lia. Qed.

Lemma w_positive : (0 < w)%nat.
Proof. pose proof cells_w as E. destruct w; lia. Qed.

Lemma is_inverse : ((u * w) mod nu = 1 mod nu)%nat.
Proof.
  pose proof nu_positive as N0. pose proof G_positive as G0.
  assert (D : Nat.gcd w nu = 1%nat) by (apply Nat.gcd_div_gcd; [apply Nat.neq_0_lt_0, G0|reflexivity]).
  destruct (Nat.gcd_bezout_pos w nu w_positive) as [x [y E]]. rewrite D in E.
  unfold u, inverse. fold w nu.
  destruct (find _ (seq 0 nu)) as [v|] eqn:F.
  - apply find_some in F. destruct F as [_ F]. apply Nat.eqb_eq, F.
  - exfalso. pose proof (find_none _ _ F (x mod nu)%nat) as H. cbv beta in H. rewrite Nat.eqb_neq in H.
    apply H; [apply in_seq; pose proof (Nat.mod_upper_bound x nu); lia|].
    rewrite Nat.mul_mod_idemp_l, E by lia. apply Nat.mod_add. lia.
Qed.

Lemma contact_q : contact = (q * G + r)%nat /\ (r < G)%nat.
Proof.
  pose proof G_positive. split; [|apply Nat.mod_upper_bound; lia].
  unfold q, r. rewrite (Nat.div_mod_eq contact G) at 1. lia.
Qed.

Lemma q_small : (q < nu)%nat.
Proof.
  destruct contact_q as [C R]. pose proof steps_nu as S. unfold steps in S. pose proof G_positive.
  apply (Nat.mul_lt_mono_pos_r G); lia.
Qed.

(** Step beta G + j is contact if beta is one of the first blocks. *)
Lemma is_contact beta j : (j < G)%nat -> (beta * G + j <? contact)%nat = (beta <? kOf j)%nat.
Proof.
  intro J. destruct contact_q as [C R]. unfold kOf, blocksOf. fold G q r.
  destruct (Nat.ltb_spec j r), (Nat.ltb_spec (beta * G + j) contact) as [A|A]; symmetry;
    rewrite ?Nat.ltb_lt, ?Nat.ltb_ge.
  - apply Nat.nle_gt. intro B. pose proof (Nat.mul_le_mono_r _ _ G B). lia.
  - apply Nat.nlt_ge. intro B. apply Nat.lt_succ_r in B. pose proof (Nat.mul_le_mono_r _ _ G B). lia.
  - apply Nat.nle_gt. intro B. pose proof (Nat.mul_le_mono_r _ _ G B). lia.
  - apply Nat.nlt_ge. intro B. pose proof (Nat.mul_le_mono_r (S beta) q G B). lia.
Qed.

Lemma split_step alpha j : (j < G)%nat -> ((alpha * G + j) / G = alpha /\ (alpha * G + j) mod G = j)%nat.
Proof.
  intro J. split.
  - rewrite Nat.div_add_l, Nat.div_small; lia.
  - rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small; lia.
Qed.

Lemma step_class m : (m = m / G * G + m mod G)%nat /\ (m mod G < G)%nat.
Proof. pose proof G_positive. split; [rewrite (Nat.div_mod_eq m G) at 1; lia|apply Nat.mod_upper_bound; lia]. Qed.

Lemma mod_steps alpha j : (j < G)%nat -> ((alpha * G + j) mod steps = alpha mod nu * G + j)%nat.
Proof.
  intro J. symmetry. pose proof nu_positive. pose proof (Nat.mod_upper_bound alpha nu ltac:(lia)) as B.
  apply Nat.mod_unique with (alpha / nu)%nat.
  - rewrite steps_nu. pose proof (Nat.mul_le_mono_r (S (alpha mod nu)) nu G B). lia.
  - rewrite steps_nu. rewrite (Nat.div_mod_eq alpha nu) at 1. lia.
Qed.

Lemma reflected_block alpha j : (j < G)%nat ->
  reflected contact free (alpha * G + j) = IZR (if (alpha mod nu <? kOf j)%nat then 1 else -1).
Proof.
  intro J. unfold reflected. fold steps. rewrite mod_steps, is_contact by exact J.
  destruct (alpha mod nu <? kOf j)%nat; reflexivity.
Qed.

(** Live classes have k blocks of contact, and k is such that they are. *)
Lemma live_blocks j : isLive j = true -> kOf j = k.
Proof.
  unfold isLive, live, k, blocks. fold nu G. fold q. fold kOf. unfold kOf, blocksOf. fold G q r.
  pose proof q_small. intro L. destruct (j <? r)%nat.
  - replace (nu - q)%nat with (S (nu - S q)) by lia. rewrite Nat.even_succ, <- Nat.negb_even, L. reflexivity.
  - rewrite L. reflexivity.
Qed.

Lemma k_even : Nat.even (nu - k) = true.
Proof.
  unfold k, blocks. fold nu G. fold q. pose proof q_small. destruct (Nat.even (nu - q)) eqn:E; auto.
  replace (nu - q)%nat with (S (nu - S q)) in E by lia. rewrite Nat.even_succ, <- Nat.negb_even in E.
  destruct (Nat.even (nu - S q)); auto.
Qed.

Lemma walk_k : walk k nu = 1%Z.
Proof. unfold walk, nu. rewrite walk_around; [fold nu; rewrite k_even; reflexivity|apply nu_positive|apply is_inverse]. Qed.

Lemma sign_unit alpha : (sign alpha = 1 \/ sign alpha = -1)%Z.
Proof. apply walk_unit; first [apply nu_positive|apply is_inverse]. Qed.

(** * From the rows to amplitudes *)

Section State.
Variables a b : Z -> R.
Let p := p cells contact free a b.

Lemma p_next alpha j : (j < G)%nat ->
  p ((alpha + w) * G + j) = IZR (if (alpha mod nu <? kOf j)%nat then 1 else -1) * p (alpha * G + j).
Proof.
  intro J. replace ((alpha + w) * G + j)%nat with (alpha * G + j + 2 * cells)%nat by (rewrite cells_w; lia).
  unfold p. rewrite p_delay by assumption. rewrite reflected_block by exact J. reflexivity.
Qed.

Lemma p_walk j t : (j < G)%nat -> p ((t * w) * G + j) = IZR (walk (kOf j) t) * p j.
Proof.
  intro J. induction t as [|t IH]; [simpl; ring|].
  replace (S t * w)%nat with (t * w + w)%nat by lia. rewrite p_next, IH by exact J.
  unfold walk. rewrite walk_next, mult_IZR. fold nu w. ring.
Qed.

Lemma periodic_for_ever : (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> forall i m, p (m + i * steps) = p m.
Proof.
  intros H. assert (O : forall m, p (m + steps) = p m).
  { intro m. induction m as [m H0|m IH] using (fun P => by_turns cells P cells_positive); auto.
    replace (m + 2 * cells + steps)%nat with (m + steps + 2 * cells)%nat by lia.
    unfold p in *. rewrite !p_delay, IH by assumption. f_equal. unfold reflected. fold steps.
    replace (m + steps)%nat with (m + 1 * steps)%nat by lia.
    rewrite Nat.mod_add by (unfold steps; lia). reflexivity. }
  induction i as [|i IH]; intro m; [f_equal; lia|].
  replace (m + S i * steps)%nat with (m + i * steps + steps)%nat by lia. rewrite O. apply IH.
Qed.

Lemma p_mod : (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> forall alpha j,
  p (alpha * G + j) = p ((alpha mod nu) * G + j).
Proof.
  intros H alpha j. rewrite <- (periodic_for_ever H (alpha / nu) (alpha mod nu * G + j)). f_equal.
  rewrite steps_nu. rewrite (Nat.div_mod_eq alpha nu) at 1. lia.
Qed.

Lemma dead_zero : (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> forall j,
  (j < G)%nat -> isLive j = false -> p j = 0.
Proof.
  intros H j J L. pose proof (p_walk j nu J) as E. rewrite (p_mod H) in E.
  replace ((nu * w) mod nu)%nat with 0%nat in E
    by (rewrite Nat.mul_comm, Nat.mod_mul; [reflexivity|pose proof nu_positive; lia]).
  unfold walk, nu in E. rewrite walk_around in E; [|apply nu_positive|apply is_inverse].
  unfold isLive, live in L. fold kOf in L. rewrite L in E. simpl in E. lra.
Qed.

Lemma amplitudes : (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> forall m,
  p m = IZR (sign (m / G)) * p (m mod G)%nat.
Proof.
  intros H m. destruct (step_class m) as [E J]. set (alpha := (m / G)%nat) in *. set (j := (m mod G)%nat) in *.
  rewrite E. pose proof (p_walk j ((alpha * u) mod nu) J) as W. rewrite (p_mod H) in W.
  assert (B : (((alpha * u) mod nu * w) mod nu = alpha mod nu)%nat)
    by (apply forth; first [apply nu_positive|apply is_inverse]).
  rewrite B, <- (p_mod H) in W. rewrite W. destruct (isLive j) eqn:L.
  - rewrite (live_blocks j L). reflexivity.
  - rewrite (dead_zero H j J L). ring.
Qed.

(** * And back *)

Lemma amplitudes_back z : consists cells contact free z a b -> forall m,
  p m = IZR (sign (m / G)) * z (m mod G)%nat.
Proof.
  intros [D A] m. fold G isLive in D.
  induction m as [m H|m IH] using (fun P => by_turns cells P cells_positive).
  - unfold p. rewrite p_start by assumption. apply A, H.
  - destruct (step_class m) as [E J]. set (alpha := (m / G)%nat) in *. set (j := (m mod G)%nat) in *.
    replace (m + 2 * cells)%nat with ((alpha + w) * G + j)%nat by (rewrite cells_w; lia).
    rewrite p_next by exact J. destruct (split_step (alpha + w) j J) as [-> ->].
    rewrite <- E, IH. destruct (isLive j) eqn:L; [|rewrite (D j J L); ring].
    rewrite (live_blocks j L). unfold sign, Classes.sign. fold nu u w k walk.
    assert (X : walk k (((alpha + w) * u) mod nu) =
                ((if (alpha mod nu <? k)%nat then 1 else -1) * walk k ((alpha * u) mod nu))%Z)
      by (apply sign_next; first [apply nu_positive|apply is_inverse|apply walk_k]).
    rewrite X, mult_IZR. ring.
Qed.

(** * Rows of amplitudes *)

Section Amplitudes.
Variable z : nat -> R.
Hypothesis dead : forall j, (j < G)%nat -> isLive j = false -> z j = 0.
Hypothesis p_is : forall m, p m = IZR (sign (m / G)) * z (m mod G)%nat.
Let S := sum z G.

Lemma gap_row : sum p (2 * cells) = IZR (win cells contact free) * S.
Proof.
  rewrite (sum_ext _ _ _ (fun m _ => p_is m)). replace (2 * cells)%nat with (w * G + 0)%nat by (rewrite cells_w; lia).
  rewrite (block_sum G (fun alpha => IZR (sign alpha)) z G_positive) by lia. rewrite sum_IZR. simpl. unfold S, win.
  fold w sign. ring.
Qed.

(** What flight adds in block beta, times z. *)
Let flown (beta : nat) : Z := (if (beta <? k)%nat then 0 else sign beta)%Z.

Lemma flight_row alpha j : (j < G)%nat -> (contact <= alpha * G + j)%nat ->
  sum (fun i => p (contact + i)) (Datatypes.S (alpha * G + j - contact)) =
  IZR (drift cells contact free alpha) * S + IZR (flown alpha) * sum z (Datatypes.S j).
Proof.
  intros J C. set (f := fun m => IZR (flown (m / G)) * z (m mod G)%nat).
  assert (F : forall m, f m = if (m <? contact)%nat then 0 else p m).
  { intro m. unfold f, flown. destruct (step_class m) as [E I].
    assert (M : (m <? contact)%nat = (m / G <? kOf (m mod G))%nat) by (rewrite E at 1; apply is_contact, I).
    rewrite M, p_is. destruct (isLive (m mod G)) eqn:L.
    - rewrite (live_blocks _ L). fold k. destruct (m / G <? k)%nat; simpl; ring.
    - rewrite (dead _ I L). destruct (m / G <? kOf (m mod G))%nat; ring. }
  assert (T : sum f (contact + Datatypes.S (alpha * G + j - contact)) =
              sum (fun i => p (contact + i)) (Datatypes.S (alpha * G + j - contact))).
  { rewrite sum_add, (sum_zero f contact).
    - rewrite Rplus_0_l. apply sum_ext. intros i _. rewrite F.
      destruct (Nat.ltb_spec (contact + i) contact); [lia|reflexivity].
    - intros m M. rewrite F. destruct (Nat.ltb_spec m contact); [reflexivity|lia]. }
  rewrite <- T. replace (contact + Datatypes.S (alpha * G + j - contact))%nat with (alpha * G + Datatypes.S j)%nat by lia.
  unfold f. rewrite (block_sum G (fun beta => IZR (flown beta)) z G_positive) by lia. rewrite sum_IZR. reflexivity.
Qed.
End Amplitudes.
End State.
End OnePhase.
