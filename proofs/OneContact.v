(** The theorem on one contact, docs/theory.md sections 4 to 6, for all N, n_c, n_f >= 1 and all real states. *)

From Coq Require Import Reals ZArith Arith Lia Lra List Bool.
From Signorini Require Import Paper Classes Amplitudes.
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
Let steps_nu : steps = (nu * G)%nat. Proof. exact (here steps_nu). Qed.
Let nu_positive : (0 < nu)%nat. Proof. exact (here nu_positive). Qed.
Let is_inverse : ((u * w) mod nu = 1 mod nu)%nat. Proof. exact (here is_inverse). Qed.
Let contact_q : contact = (q * G + r)%nat /\ (r < G)%nat. Proof. exact (here contact_q). Qed.
Let q_small : (q < nu)%nat. Proof. exact (here q_small). Qed.
Let is_contact : forall beta j, (j < G)%nat -> (beta * G + j <? contact)%nat = (beta <? kOf j)%nat.
Proof. exact (here is_contact). Qed.
Let split_step : forall alpha j, (j < G)%nat -> ((alpha * G + j) / G = alpha /\ (alpha * G + j) mod G = j)%nat.
Proof. exact (here split_step). Qed.
Let step_class : forall m, (m = m / G * G + m mod G)%nat /\ (m mod G < G)%nat. Proof. exact (here step_class). Qed.
Let live_blocks : forall j, isLive j = true -> kOf j = k. Proof. exact (here live_blocks). Qed.
Let k_even : Nat.even (nu - k) = true. Proof. exact (here k_even). Qed.
Let sign_unit : forall alpha, (sign alpha = 1 \/ sign alpha = -1)%Z. Proof. exact (here sign_unit). Qed.
Let dead_zero : forall a b,
  (forall m, (m < 2 * cells)%nat -> p cells contact free a b (m + steps) = p cells contact free a b m) ->
  forall j, (j < G)%nat -> isLive j = false -> p cells contact free a b j = 0. Proof. exact (here dead_zero). Qed.
Let amplitudes : forall a b,
  (forall m, (m < 2 * cells)%nat -> p cells contact free a b (m + steps) = p cells contact free a b m) ->
  forall m, p cells contact free a b m = IZR (sign (m / G)) * p cells contact free a b (m mod G)%nat.
Proof. exact (here amplitudes). Qed.
Let amplitudes_back : forall a b z, consists cells contact free z a b ->
  forall m, p cells contact free a b m = IZR (sign (m / G)) * z (m mod G)%nat.
Proof. exact (here amplitudes_back). Qed.
Let gap_row : forall a b z, (forall m, p cells contact free a b m = IZR (sign (m / G)) * z (m mod G)%nat) ->
  sum (p cells contact free a b) (2 * cells) = IZR (win cells contact free) * sum z G.
Proof. exact (here gap_row). Qed.
Let flight_row : forall a b z, (forall j, (j < G)%nat -> isLive j = false -> z j = 0) ->
  (forall m, p cells contact free a b m = IZR (sign (m / G)) * z (m mod G)%nat) ->
  forall alpha j, (j < G)%nat -> (contact <= alpha * G + j)%nat ->
  sum (fun i => p cells contact free a b (contact + i)) (S (alpha * G + j - contact)) =
  IZR (drift cells contact free alpha) * sum z G + IZR (if (alpha <? k)%nat then 0 else sign alpha) * sum z (S j).
Proof. exact (here flight_row). Qed.

(** * The theorem *)

Lemma live_contact alpha j : (j < G)%nat -> isLive j = true -> (alpha * G + j < contact)%nat <-> (alpha < k)%nat.
Proof.
  intros J L. rewrite <- (live_blocks j L), <- Nat.ltb_lt, <- Nat.ltb_lt, is_contact by exact J. reflexivity.
Qed.

Lemma below_steps m : (m < steps)%nat -> (m / G < nu)%nat.
Proof. intro H. pose proof G_positive. apply Nat.div_lt_upper_bound; [lia|]. rewrite steps_nu in H. lia. Qed.

Lemma sign_0 : sign 0 = 1%Z.
Proof.
  unfold sign, Classes.sign. rewrite Nat.mul_0_l, Nat.mod_0_l by (fold nu; pose proof nu_positive; lia). reflexivity.
Qed.

Lemma drift_next alpha : drift cells contact free (Datatypes.S alpha) =
  (drift cells contact free alpha + (if (alpha <? k)%nat then 0 else sign alpha))%Z.
Proof. reflexivity. Qed.

Lemma drift_contact alpha : (alpha <= k)%nat -> drift cells contact free alpha = 0%Z.
Proof.
  induction alpha as [|alpha IH]; intro H; [reflexivity|]. rewrite drift_next, IH by lia.
  destruct (Nat.ltb_spec alpha k); [reflexivity|lia].
Qed.

Lemma admissible_spec : admissible cells contact free = true <->
  (forall alpha, (alpha < k)%nat -> sign alpha = 1%Z) /\
  (forall alpha, (alpha < nu)%nat -> drift cells contact free (Datatypes.S alpha) <= 0)%Z /\
  (win cells contact free < 0)%Z.
Proof.
  unfold admissible. rewrite !andb_true_iff, !forallb_forall, Z.ltb_lt. fold k nu sign. split.
  - intros [[A B] C]. repeat split; auto; intros alpha H; [apply Z.eqb_eq, A|apply Z.leb_le, B]; apply in_seq; lia.
  - intros [A [B C]]. repeat split; auto; intros alpha H; apply in_seq in H;
      [apply Z.eqb_eq, A|apply Z.leb_le, B]; lia.
Qed.

Section State2.
Variables a b : Z -> R.
Let p := p cells contact free a b.
Variable z : nat -> R.
Hypothesis dead : forall j, (j < G)%nat -> isLive j = false -> z j = 0.
Hypothesis p_is : forall m, p m = IZR (sign (m / G)) * z (m mod G)%nat.
Hypothesis some_block : (0 < k)%nat.
Let S := sum z G.

(** Pressing: rows give the simplex. *)
Lemma simplex_of_rows : delayed cells contact free a b -> admissible cells contact free = true /\ inSimplex cells contact free z.
Proof.
  intros [_ W C F]. rewrite (gap_row a b z p_is) in W. fold S in W.
  assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive).
  assert (Z0 : forall j, (j < G)%nat -> 0 <= z j).
  { intros j J. destruct (isLive j) eqn:L; [|rewrite (dead j J L); lra].
    specialize (C j). fold p in C. rewrite p_is in C. destruct (split_step 0 j J) as [E1 E2].
    rewrite Nat.mul_0_l, Nat.add_0_l in E1, E2. rewrite E1, E2, sign_0 in C.
    assert (0 <= 1 * z j); [|lra]. apply C. apply (live_contact 0 j J L) in some_block. exact some_block. }
  assert (S0 : 0 <= S) by (apply sum_nonneg, Z0).
  assert (SN : S <> 0) by (intro E; rewrite E in W; lra).
  split; [apply admissible_spec; repeat split|split; auto].
  - intros alpha A. destruct (sign_unit alpha) as [U|U]; auto. exfalso. apply SN, sum_zero. intros j J.
    destruct (isLive j) eqn:L; [|apply (dead j J L)].
    pose proof (proj2 (live_contact alpha j J L) A) as H. specialize (C _ H). fold p in C. rewrite p_is in C.
    destruct (split_step alpha j J) as [E1 E2]. rewrite E1, E2, U in C. specialize (Z0 j J). lra.
  - intros alpha A. destruct (Nat.lt_ge_cases alpha k) as [B|B].
    { rewrite drift_contact by lia. lia. }
    pose proof G_positive as G0. destruct contact_q as [Q R0].
    assert (H : (contact <= alpha * G + (G - 1))%nat).
    { assert (q <= alpha)%nat by (unfold k, blocks in B; fold nu G in B; fold q in B; destruct (Nat.even (nu - q)); lia).
      pose proof (Nat.mul_le_mono_r q alpha G ltac:(assumption)). lia. }
    assert (T : (alpha * G + (G - 1) < steps)%nat).
    { rewrite steps_nu. pose proof (Nat.mul_le_mono_r (Datatypes.S alpha) nu G A). lia. }
    specialize (F (alpha * G + (G - 1) - contact)%nat ltac:(unfold steps in T; lia)).
    rewrite (flight_row a b z dead p_is alpha (G - 1)) in F by (exact H || lia).
    replace (Datatypes.S (G - 1)) with G in F by lia. fold S in F.
    rewrite drift_next. apply le_IZR. rewrite plus_IZR. apply Rmult_le_reg_r with S; [lra|].
    rewrite Rmult_0_l, Rmult_plus_distr_r. exact F.
  - apply lt_IZR. apply Rnot_le_lt. intro H.
    assert (0 <= IZR (win cells contact free) * S) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma rows_of_simplex : admissible cells contact free = true -> inSimplex cells contact free z ->
  (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> delayed cells contact free a b.
Proof.
  intros A [Z0 W] P. fold G in Z0, W. apply admissible_spec in A. destruct A as [U [D _]]. split; [exact P| | |].
  - rewrite (gap_row a b z p_is). exact W.
  - intros m M. fold p. rewrite p_is. destruct (step_class m) as [E J].
    destruct (isLive (m mod G)) eqn:L; [|rewrite (dead _ J L); lra].
    rewrite U; [rewrite Rmult_1_l; apply Z0, J|]. apply (live_contact _ _ J L). rewrite <- E. exact M.
  - intros m M. destruct (step_class (contact + m)) as [E J].
    set (alpha := ((contact + m) / G)%nat) in *. set (j := ((contact + m) mod G)%nat) in *.
    replace m with (alpha * G + j - contact)%nat by lia.
    rewrite (flight_row a b z dead p_is alpha j J) by lia. fold S.
    assert (S0 : 0 <= S) by (apply sum_nonneg, Z0).
    assert (B0 : 0 <= sum z (Datatypes.S j)) by (apply sum_nonneg; intros i I; apply Z0; lia).
    assert (B1 : sum z (Datatypes.S j) <= S) by (apply sum_monotone; [lia|exact Z0]).
    assert (T : (alpha < nu)%nat) by (apply below_steps; unfold steps; lia).
    pose proof (D alpha T) as D1. rewrite drift_next in D1.
    assert (D0 : (drift cells contact free alpha <= 0)%Z).
    { destruct alpha as [|alpha']; [reflexivity|]. apply D. lia. }
    destruct (Nat.ltb_spec alpha k) as [K|K]; [rewrite drift_contact by lia; lra|].
    apply IZR_le in D0, D1. rewrite plus_IZR in D1. simpl in D0, D1.
    destruct (sign_unit alpha) as [V|V]; rewrite V in *; simpl in *; nra.
Qed.
End State2.
(** * Grazing: no live class meets contact *)

Section Grazing.
Hypothesis no_block : k = 0%nat.

Lemma nu_even : Nat.even nu = true.
Proof. pose proof k_even as E. rewrite no_block, Nat.sub_0_r in E. exact E. Qed.

Lemma even_mod x : Nat.even (x mod nu) = Nat.even x.
Proof.
  rewrite (Nat.div_mod_eq x nu) at 2. rewrite Nat.even_add, Nat.even_mul, nu_even. simpl.
  destruct (Nat.even (x mod nu)); reflexivity.
Qed.

Lemma odd_uw : Nat.even u = false /\ Nat.even w = false.
Proof.
  assert (E : Nat.even (u * w) = false) by (rewrite <- even_mod, is_inverse, even_mod; reflexivity).
  rewrite Nat.even_mul in E. apply orb_false_iff in E. exact E.
Qed.

Lemma walk_0 t : walk 0 t = if Nat.even t then 1%Z else (-1)%Z.
Proof.
  induction t as [|t IH]; [reflexivity|]. unfold walk in *. rewrite walk_next, IH. simpl (if (_ <? 0)%nat then _ else _).
  rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even t); reflexivity.
Qed.

Lemma sign_alternates alpha : sign alpha = if Nat.even alpha then 1%Z else (-1)%Z.
Proof.
  unfold sign, Classes.sign. fold nu u k walk. rewrite no_block, walk_0, even_mod, Nat.even_mul.
  destruct odd_uw as [-> _]. rewrite orb_false_r. reflexivity.
Qed.

Lemma sum_alternates n : sumZ sign n = if Nat.even n then 0%Z else 1%Z.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [sumZ]. rewrite IH, sign_alternates, Nat.even_succ, <- Nat.negb_even.
  destruct (Nat.even n); reflexivity.
Qed.

Lemma drift_alternates alpha : drift cells contact free alpha = if Nat.even alpha then 0%Z else 1%Z.
Proof.
  rewrite <- sum_alternates. unfold drift. fold k sign. rewrite no_block.
  induction alpha as [|alpha IH]; [reflexivity|]. cbn [sumZ]. rewrite IH. reflexivity.
Qed.

Lemma win_one : win cells contact free = 1%Z.
Proof. unfold win. fold w sign. rewrite sum_alternates. destruct odd_uw as [_ ->]. reflexivity. Qed.

Lemma contact_dead : contact = r /\ forall j, (j < r)%nat -> isLive j = false.
Proof.
  pose proof q_small. destruct contact_q as [C R]. assert (Q : q = 0%nat).
  { unfold k, blocks in no_block. fold nu G in no_block. fold q in no_block. destruct (Nat.even (nu - q)); lia. }
  split; [rewrite Q in C; lia|]. intros j J. destruct (isLive j) eqn:L; auto. exfalso.
  apply live_blocks in L. rewrite no_block in L. unfold kOf, blocksOf in L. fold G r in L.
  destruct (Nat.ltb_spec j r); lia.
Qed.

Section State3.
Variables a b : Z -> R.
Let p := p cells contact free a b.
Variable z : nat -> R.
Hypothesis dead : forall j, (j < G)%nat -> isLive j = false -> z j = 0.
Hypothesis p_is : forall m, p m = IZR (sign (m / G)) * z (m mod G)%nat.
Let S := sum z G.

Lemma grazing_row alpha j : (j < G)%nat -> (contact <= alpha * G + j)%nat ->
  sum (fun i => p (contact + i)) (Datatypes.S (alpha * G + j - contact)) =
  if Nat.even alpha then sum z (Datatypes.S j) else S - sum z (Datatypes.S j).
Proof.
  intros J H. unfold p. rewrite (flight_row a b z dead p_is alpha j J H). fold S. fold k. rewrite no_block.
  rewrite drift_alternates. simpl (if (_ <? 0)%nat then _ else _). rewrite sign_alternates.
  destruct (Nat.even alpha); simpl; ring.
Qed.

Lemma nu_two : (2 <= nu)%nat.
Proof. pose proof nu_positive. pose proof nu_even as E. destruct nu as [|[|n]]; simpl in *; lia || discriminate. Qed.

Lemma box_of_rows : delayed cells contact free a b -> inBox cells contact free z.
Proof.
  intros [_ W C F]. rewrite (gap_row a b z p_is), win_one in W. fold S in W.
  assert (N0 : 0 < INR cells) by (apply lt_0_INR, cells_positive). pose proof nu_two as N2.
  assert (SN : S = - INR cells) by lra.
  split; [|exact SN]. fold G. intros j J. destruct contact_dead as [CR D]. destruct contact_q as [_ R0].
  assert (Up : forall alpha, (alpha < 2)%nat -> (contact <= alpha * G + j)%nat ->
    (if Nat.even alpha then sum z (Datatypes.S j) else S - sum z (Datatypes.S j)) <= 0).
  { intros alpha A H. rewrite <- (grazing_row alpha j J H). apply F.
    pose proof (Nat.mul_le_mono_r (Datatypes.S alpha) nu G ltac:(lia)). pose proof steps_nu as E. unfold steps in E. lia. }
  pose proof (Up 1%nat ltac:(lia) ltac:(lia)) as U1. simpl in U1.
  destruct (Nat.lt_ge_cases j r) as [L|L].
  - rewrite (sum_zero z (Datatypes.S j)); [lra|]. intros i I. apply dead; [lia|]. apply D. lia.
  - pose proof (Up 0%nat ltac:(lia) ltac:(lia)) as U0. simpl in U0. simpl. lra.
Qed.

Lemma rows_of_box : inBox cells contact free z ->
  (forall m, (m < 2 * cells)%nat -> p (m + steps) = p m) -> delayed cells contact free a b.
Proof.
  intros [B W] P. fold G in B, W. fold S in W. destruct contact_dead as [CR D]. split; [exact P| | |].
  - rewrite (gap_row a b z p_is), win_one. fold S. lra.
  - intros m M. fold p. rewrite p_is. destruct contact_q as [_ R0]. rewrite (Nat.mod_small m G) by lia.
    rewrite (dead m); [lra|lia|]. apply D. lia.
  - intros m M. destruct (step_class (contact + m)) as [E J].
    set (alpha := ((contact + m) / G)%nat) in *. set (j := ((contact + m) mod G)%nat) in *.
    replace m with (alpha * G + j - contact)%nat by lia. fold p. rewrite (grazing_row alpha j J) by lia.
    specialize (B j J). destruct (Nat.even alpha); lra.
Qed.
End State3.
End Grazing.

(** * Both ways *)

Theorem one_contact a b : motion cells contact free a b <->
  exists z, consists cells contact free z a b /\ allowed cells contact free z.
Proof.
  rewrite delay_form by assumption. set (p := p cells contact free a b). split.
  - intro H. exists p. pose proof (comesBack _ _ _ _ _ H) as P. fold p steps in P.
    assert (A : forall m, p m = IZR (sign (m / G)) * p (m mod G)%nat) by (apply amplitudes, P).
    assert (D : forall j, (j < G)%nat -> isLive j = false -> p j = 0) by (intros; apply dead_zero; assumption).
    split.
    + split; [exact D|]. intros m M. rewrite <- (p_start cells contact free) by assumption. apply A.
    + unfold allowed. fold k. destruct (Nat.eqb_spec k 0) as [K|K].
      * apply (box_of_rows K a b p D A H).
      * apply (simplex_of_rows a b p D A ltac:(lia) H).
  - intros [z [C B]]. pose proof (amplitudes_back a b z C) as A. destruct C as [D _].
    assert (P : forall m, (m < 2 * cells)%nat -> p (m + steps)%nat = p m).
    { intros m _. unfold p. rewrite !A. pose proof G_positive. f_equal.
      - f_equal. rewrite steps_nu, Nat.div_add by lia. unfold sign, Classes.sign. fold nu u. f_equal.
        rewrite Nat.mul_add_distr_r, (Nat.mul_comm nu u), Nat.mod_add by (pose proof nu_positive; lia). reflexivity.
      - f_equal. rewrite steps_nu, Nat.mod_add by lia. reflexivity. }
    unfold allowed in B. fold k in B. destruct (Nat.eqb_spec k 0) as [K|K].
    + apply (rows_of_box K a b z D A B P).
    + destruct B as [B1 B2]. apply (rows_of_simplex a b z D A ltac:(lia) B1 B2 P).
Qed.
End OnePhase.
