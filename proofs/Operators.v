(** The paper's operators as functions on lists, (26)-(32), and that they are the rows of Paper.v.

    A state is a pair of lists of N numbers, a and b. (27), (28) extend them by the pieces of (21), (22), (24),
    (25), one after the other; (29) cuts the state after n steps out of that. Over rational numbers all of it
    can be computed; over real ones it is what Paper.v says by cells. *)

From Coq Require Import QArith Reals Qreals ZArith List Lia Lra.
From Signorini Require Import Paper Classes OneContact Verdict.
Import ListNotations.

(** * Definitions *)

Section Operators.
Context {T : Type}.
Variables (zero : T) (opp : T -> T) (add : T -> T -> T).
Variable N : nat.

Definition waves : Type := list T * list T.
Definition cut (from : nat) (l : list T) : list T := firstn N (skipn from l).
Definition atTip (l : list T) : T := nth (N - 1) l zero.

(** (27), (28): a^DD in the cells -2N + 1 .. N, b^DD in 1 .. 3N; a^DN in -4N + 1 .. N, b^DN in 1 .. 5N. *)
Definition extendedDD '((a, b) : waves) : waves :=
  (a ++ map opp (rev b) ++ a, b ++ map opp (rev a) ++ b).
Definition extendedDN '((a, b) : waves) : waves :=
  (a ++ rev b ++ map opp a ++ map opp (rev b) ++ a, b ++ rev a ++ map opp b ++ map opp (rev a) ++ b).

(** (29): the state after n steps of contact, and of flight. *)
Definition afterContact (n : nat) (x : waves) : waves :=
  let (a, b) := extendedDD x in let k := (n mod (2 * N))%nat in (cut (2 * N - k) a, cut k b).
Definition afterFlight (n : nat) (x : waves) : waves :=
  let (a, b) := extendedDN x in let k := (n mod (4 * N))%nat in (cut (4 * N - k) a, cut k b).

(** W of (30). *)
Definition period (contact free : nat) (x : waves) : waves := afterFlight free (afterContact contact x).

(** The left side of (31), times N/g. *)
Definition opened '((a, b) : waves) : T := add (fold_right add zero b) (opp (fold_right add zero a)).

(** C of (32), a row for each step: strain at the tip in contact, (10), its negative at the end of contact,
    (11), and what velocity has added up to after each step of flight, (12). *)
Definition strain (x : waves) (m : nat) : T :=
  add (atTip (snd (afterContact (S m) x))) (opp (atTip (fst (afterContact m x)))).
Definition velocity (x : waves) (m : nat) : T :=
  add (atTip (fst (afterFlight m x))) (atTip (snd (afterFlight (S m) x))).
Fixpoint total (f : nat -> T) (n : nat) : T := match n with O => zero | S m => add (total f m) (f m) end.
Definition conditions (contact free : nat) (x : waves) : list T :=
  map (strain x) (seq 0 contact) ++ [opp (strain x contact)] ++
  map (fun m => total (velocity (afterContact contact x)) (S m)) (seq 0 free).
End Operators.

(** Of rational waves, to be computed. *)
Definition periodQ := period Qopp.
Definition openedQ := opened 0%Q Qopp Qplus.
Definition conditionsQ := conditions 0%Q Qopp Qplus.

(** (30)-(32) of rational waves. *)
Record rationalMotion (N contact free : nat) (a b : list Q) : Prop := {
  cellsA : length a = N;
  cellsB : length b = N;
  returnsA : Forall2 Qeq (fst (periodQ N contact free (a, b))) a;
  returnsB : Forall2 Qeq (snd (periodQ N contact free (a, b))) b;
  startsAtWall : openedQ (a, b) == inject_Z (Z.of_nat N);
  signs : Forall (fun row => row <= 0)%Q (conditionsQ N contact free (a, b))
}.

(** A list as a function of its cells, 1 .. N. *)
Definition cellsOf (l : list Q) (i : Z) : R := nth (Z.to_nat (i - 1)) (map Q2R l) 0%R.

(** * Proofs *)

Open Scope R_scope.

Section Real.
Variable N : nat.
Hypothesis N_positive : (0 < N)%nat.

Lemma nth_skip (l : list R) d k : forall i, nth i (skipn k l) d = nth (k + i) l d.
Proof.
  revert l. induction k as [|k IH]; intros l i; [reflexivity|].
  destruct l as [|x l]; [destruct i; destruct (S k + 0)%nat; reflexivity|]. apply IH.
Qed.

Lemma nth_first (l : list R) d n : forall i, (i < n)%nat -> nth i (firstn n l) d = nth i l d.
Proof.
  revert l. induction n as [|n IH]; intros l i I; [lia|]. destruct l as [|x l]; [destruct i; reflexivity|].
  destruct i as [|i]; [reflexivity|]. cbn [firstn nth]. apply IH. lia.
Qed.

Lemma nth_cut k (l : list R) i : (i < N)%nat -> nth i (cut N k l) 0 = nth (k + i) l 0.
Proof. intro I. unfold cut. rewrite nth_first, nth_skip by exact I. reflexivity. Qed.

(** Pieces of N cells, one after the other. *)
Lemma nth_piece (l rest : list R) i : length l = N ->
  nth i (l ++ rest) 0 = if (i <? N)%nat then nth i l 0 else nth (i - N) rest 0.
Proof.
  intro L. destruct (Nat.ltb_spec i N); [apply app_nth1; lia|]. rewrite app_nth2 by lia. rewrite L. reflexivity.
Qed.

Lemma nth_opposite (l : list R) i : nth i (map Ropp l) 0 = - nth i l 0.
Proof. rewrite <- Ropp_0 at 1. apply map_nth. Qed.

Definition inCells (l : list R) (i : Z) : R := nth (Z.to_nat (i - 1)) l 0.

Lemma nth_cells (l : list R) i : nth i l 0 = inCells l (Z.of_nat i + 1).
Proof. unfold inCells. f_equal. lia. Qed.

Lemma nth_back (l : list R) i : length l = N -> (i < N)%nat -> nth i (rev l) 0 = inCells l (Z.of_nat N - Z.of_nat i).
Proof. intros L I. rewrite rev_nth by lia. unfold inCells. f_equal. lia. Qed.

Ltac pieces := repeat (rewrite nth_piece by (rewrite ?map_length, ?rev_length; assumption));
  unfold r1DD, r2DD, r1DN, r2DN; rewrite ?nth_opposite;
  repeat match goal with
  | |- context [Nat.ltb ?x ?y] => destruct (Nat.ltb_spec x y); try lia
  | |- context [Z.leb ?x ?y] => destruct (Z.leb_spec x y); try lia
  end; rewrite ?nth_opposite; rewrite ?nth_back by (assumption || lia); rewrite ?nth_cells;
  first [f_equal; lia | f_equal; f_equal; lia].

Lemma of_mod n k : (0 < k)%nat -> (Z.of_nat n mod (Z.of_nat k * Z.of_nat N))%Z = Z.of_nat (n mod (k * N)).
Proof. intro K. rewrite Nat2Z.inj_mod, Nat2Z.inj_mul. reflexivity. Qed.

Section State.
Variables a b : list R.
Hypothesis lengthA : length a = N.
Hypothesis lengthB : length b = N.
Let fa := inCells a.
Let fb := inCells b.

Lemma contact_cells n i : (i < N)%nat -> let x := afterContact Ropp N n (a, b) in
  nth i (fst x) 0 = aDD (Z.of_nat N) fa fb (Z.of_nat n) (Z.of_nat i + 1) /\
  nth i (snd x) 0 = bDD (Z.of_nat N) fa fb (Z.of_nat n) (Z.of_nat i + 1).
Proof.
  intros I x. unfold x, afterContact, extendedDD, aDD, bDD, fa, fb. cbn [fst snd]. rewrite !nth_cut by exact I.
  pose proof (of_mod n 2 ltac:(lia)) as E. change (Z.of_nat 2) with 2%Z in E. rewrite E.
  pose proof (Nat.mod_upper_bound n (2 * N) ltac:(lia)) as B. set (k := (n mod (2 * N))%nat) in *. clearbody k.
  split; pieces.
Qed.

Lemma flight_cells n i : (i < N)%nat -> let x := afterFlight Ropp N n (a, b) in
  nth i (fst x) 0 = aDN (Z.of_nat N) fa fb (Z.of_nat n) (Z.of_nat i + 1) /\
  nth i (snd x) 0 = bDN (Z.of_nat N) fa fb (Z.of_nat n) (Z.of_nat i + 1).
Proof.
  intros I x. unfold x, afterFlight, extendedDN, aDN, bDN, fa, fb. cbn [fst snd]. rewrite !nth_cut by exact I.
  pose proof (of_mod n 4 ltac:(lia)) as E. change (Z.of_nat 4) with 4%Z in E. rewrite E.
  pose proof (Nat.mod_upper_bound n (4 * N) ltac:(lia)) as B. set (k := (n mod (4 * N))%nat) in *. clearbody k.
  split; pieces.
Qed.

Lemma cut_length k (l : list R) : (k + N <= length l)%nat -> length (cut N k l) = N.
Proof. intro K. unfold cut. rewrite firstn_length, skipn_length. lia. Qed.

Lemma contact_lengths n : let x := afterContact Ropp N n (a, b) in length (fst x) = N /\ length (snd x) = N.
Proof.
  intro x. unfold x, afterContact, extendedDD. cbn [fst snd]. pose proof (Nat.mod_upper_bound n (2 * N) ltac:(lia)).
  split; apply cut_length; rewrite !app_length, !map_length, !rev_length, lengthA, lengthB; lia.
Qed.

Lemma flight_lengths n : let x := afterFlight Ropp N n (a, b) in length (fst x) = N /\ length (snd x) = N.
Proof.
  intro x. unfold x, afterFlight, extendedDN. cbn [fst snd]. pose proof (Nat.mod_upper_bound n (4 * N) ltac:(lia)).
  split; apply cut_length; rewrite !app_length, !map_length, !rev_length, lengthA, lengthB; lia.
Qed.
End State.

(** Extended waves depend on the cells 1 .. N only. *)
Lemma same_flight f g f' g' n i : (forall j, (1 <= j <= Z.of_nat N)%Z -> f j = f' j /\ g j = g' j) ->
  (1 <= i <= Z.of_nat N)%Z -> aDN (Z.of_nat N) f g n i = aDN (Z.of_nat N) f' g' n i /\
  bDN (Z.of_nat N) f g n i = bDN (Z.of_nat N) f' g' n i.
Proof.
  intros H I. unfold aDN, bDN, r1DN, r2DN. pose proof (Z.mod_pos_bound n (4 * Z.of_nat N) ltac:(lia)).
  generalize dependent (n mod (4 * Z.of_nat N))%Z. intros k K.
  split; repeat match goal with |- context [Z.leb ?x ?y] => destruct (Z.leb_spec x y); try lia end;
    first [apply H | f_equal; apply H]; lia.
Qed.

Lemma sum_list (l : list R) : fold_right Rplus 0 l = sum (fun i => inCells l (Z.of_nat i + 1)) (length l).
Proof.
  rewrite (sum_ext _ (fun i => nth i l 0)) by (intros; symmetry; apply nth_cells).
  induction l as [|x l IH]; [reflexivity|]. cbn [fold_right length]. rewrite IH.
  change (S (length l)) with (1 + length l)%nat. rewrite sum_add. simpl. lra.
Qed.

Lemma total_sum f n : total 0 Rplus f n = sum f n.
Proof. induction n as [|n IH]; simpl; congruence. Qed.

Lemma same_lists (l l' : list R) : length l = N -> length l' = N ->
  l = l' <-> forall i, (i < N)%nat -> nth i l 0 = nth i l' 0.
Proof.
  intros L L'. split; [intros ->; auto|]. intro H. apply (nth_ext _ _ 0 0); [congruence|]. rewrite L. exact H.
Qed.

(** Lists of real numbers: the rows of the lists are those of Paper.v. *)
Theorem rows_of_lists contact free a b : length a = N -> length b = N ->
  (fst (period Ropp N contact free (a, b)) = a /\ snd (period Ropp N contact free (a, b)) = b /\
   opened 0 Ropp Rplus (a, b) = INR N /\
   Forall (fun row => row <= 0) (conditions 0 Ropp Rplus N contact free (a, b))) <->
  motion N contact free (inCells a) (inCells b).
Proof.
  intros LA LB. set (fa := inCells a). set (fb := inCells b).
  destruct (contact_lengths a b LA LB contact) as [LA1 LB1].
  destruct (afterContact Ropp N contact (a, b)) as [a1 b1] eqn:E1. cbn [fst snd] in LA1, LB1.
  assert (C1 : forall j, (1 <= j <= Z.of_nat N)%Z -> inCells a1 j = aDD (Z.of_nat N) fa fb (Z.of_nat contact) j /\
                 inCells b1 j = bDD (Z.of_nat N) fa fb (Z.of_nat contact) j).
  { intros j J. pose proof (contact_cells a b LA LB contact (Z.to_nat (j - 1)) ltac:(lia)) as H. cbv zeta in H.
    rewrite E1 in H. cbn [fst snd] in H. replace (Z.of_nat (Z.to_nat (j - 1)) + 1)%Z with j in H by lia. exact H. }
  set (pa := aDD (Z.of_nat N) fa fb (Z.of_nat contact)) in *. set (pb := bDD (Z.of_nat N) fa fb (Z.of_nat contact)) in *.
  assert (Flight : forall n i, (i < N)%nat -> let x := afterFlight Ropp N n (a1, b1) in
            nth i (fst x) 0 = aDN (Z.of_nat N) pa pb (Z.of_nat n) (Z.of_nat i + 1) /\
            nth i (snd x) 0 = bDN (Z.of_nat N) pa pb (Z.of_nat n) (Z.of_nat i + 1)).
  { intros n i I x. destruct (flight_cells a1 b1 LA1 LB1 n i I) as [A B].
    destruct (same_flight _ _ pa pb (Z.of_nat n) (Z.of_nat i + 1) C1 ltac:(lia)) as [<- <-]. split; assumption. }
  assert (P : period Ropp N contact free (a, b) = afterFlight Ropp N free (a1, b1)) by (unfold period; rewrite E1; reflexivity).
  destruct (flight_lengths a1 b1 LA1 LB1 free) as [LA2 LB2].
  assert (Last : (Z.of_nat (N - 1) + 1 = Z.of_nat N)%Z) by lia.
  assert (Strain : forall m, strain 0 Ropp Rplus N (a, b) m = strainDD (Z.of_nat N) fa fb (Z.of_nat m)).
  { intro m. unfold strain, atTip, strainDD. rewrite (proj2 (contact_cells a b LA LB (S m) (N - 1) ltac:(lia))).
    rewrite (proj1 (contact_cells a b LA LB m (N - 1) ltac:(lia))). rewrite Last.
    replace (Z.of_nat (S m)) with (Z.of_nat m + 1)%Z by lia. reflexivity. }
  assert (Velocity : forall m, velocity 0 Ropp Rplus N (a1, b1) m = velocityDN (Z.of_nat N) pa pb (Z.of_nat m)).
  { intro m. unfold velocity, atTip, velocityDN. rewrite (proj1 (Flight m (N - 1)%nat ltac:(lia))).
    rewrite (proj2 (Flight (S m) (N - 1)%nat ltac:(lia))). rewrite Last.
    replace (Z.of_nat (S m)) with (Z.of_nat m + 1)%Z by lia. reflexivity. }
  assert (Gap : opened 0 Ropp Rplus (a, b) = sum (fun i => fb (Z.of_nat i + 1)%Z - fa (Z.of_nat i + 1)%Z) N).
  { unfold opened. rewrite !sum_list, LA, LB, sum_minus. reflexivity. }
  assert (Rows : Forall (fun row => row <= 0) (conditions 0 Ropp Rplus N contact free (a, b)) <->
    (forall m, (m < contact)%nat -> strainDD (Z.of_nat N) fa fb (Z.of_nat m) <= 0) /\
    0 <= strainDD (Z.of_nat N) fa fb (Z.of_nat contact) /\
    (forall m, (m < free)%nat -> sum (fun k => velocityDN (Z.of_nat N) pa pb (Z.of_nat k)) (S m) <= 0)).
  { unfold conditions. rewrite E1, !Forall_app, !Forall_map, !Forall_forall. split.
    - intros [A [B C]]. repeat split.
      + intros m M. rewrite <- Strain. apply A, in_seq. lia.
      + specialize (B _ (or_introl eq_refl)). rewrite Strain in B. lra.
      + intros m M. specialize (C m ltac:(apply in_seq; lia)). rewrite total_sum in C.
        rewrite (sum_ext _ _ _ (fun k _ => Velocity k)) in C. exact C.
    - intros [A [B C]]. repeat split.
      + intros m M. apply in_seq in M. rewrite Strain. apply A. lia.
      + intros x [<-|[]]. rewrite Strain. lra.
      + intros m M. apply in_seq in M. rewrite total_sum, (sum_ext _ _ _ (fun k _ => Velocity k)). apply C. lia. }
  rewrite P, Gap, Rows, (same_lists _ a LA2 LA), (same_lists _ b LB2 LB). split.
  - intros [A [B [G [C [D F]]]]]. split; auto. intros i I.
    destruct (Flight free (Z.to_nat (i - 1)) ltac:(lia)) as [X Y].
    specialize (A (Z.to_nat (i - 1)) ltac:(lia)). specialize (B (Z.to_nat (i - 1)) ltac:(lia)).
    replace (Z.of_nat (Z.to_nat (i - 1)) + 1)%Z with i in * by lia.
    split; [exact (eq_trans (eq_sym X) A)|exact (eq_trans (eq_sym Y) B)].
  - intros [A G C D F]. repeat split; auto; intros i I; destruct (Flight free i I) as [X Y];
      destruct (A (Z.of_nat i + 1)%Z ltac:(lia)) as [U V]; [rewrite X|rewrite Y]; rewrite nth_cells; assumption.
Qed.
End Real.

(** ** Rational lists *)

Definition both (f : Q -> R) (x : list Q * list Q) : list R * list R := (map f (fst x), map f (snd x)).

Lemma map_opposite (l : list Q) : map Q2R (map Qopp l) = map Ropp (map Q2R l).
Proof. rewrite !map_map. apply map_ext. intro x. apply Q2R_opp. Qed.

Lemma map_cut N k (l : list Q) : map Q2R (cut N k l) = cut N k (map Q2R l).
Proof. unfold cut. rewrite skipn_map, firstn_map. reflexivity. Qed.

Lemma real_contact N n x : both Q2R (afterContact Qopp N n x) = afterContact Ropp N n (both Q2R x).
Proof.
  destruct x as [a b]. unfold afterContact, extendedDD, both. cbn [fst snd].
  rewrite !map_cut, !map_app, !map_opposite, !map_rev. reflexivity.
Qed.

Lemma real_flight N n x : both Q2R (afterFlight Qopp N n x) = afterFlight Ropp N n (both Q2R x).
Proof.
  destruct x as [a b]. unfold afterFlight, extendedDN, both. cbn [fst snd].
  rewrite !map_cut, !map_app, !map_opposite, !map_rev. reflexivity.
Qed.

Lemma real_tip N l : Q2R (atTip 0%Q N l) = atTip 0 N (map Q2R l).
Proof. unfold atTip. rewrite <- (map_nth Q2R). rewrite RMicromega.Q2R_0. reflexivity. Qed.

Lemma real_strain N x m : Q2R (strain 0%Q Qopp Qplus N x m) = strain 0 Ropp Rplus N (both Q2R x) m.
Proof. unfold strain. rewrite Q2R_plus, Q2R_opp, !real_tip, <- !real_contact. reflexivity. Qed.

Lemma real_velocity N x m : Q2R (velocity 0%Q Qopp Qplus N x m) = velocity 0 Ropp Rplus N (both Q2R x) m.
Proof. unfold velocity. rewrite Q2R_plus, !real_tip, <- !real_flight. reflexivity. Qed.

Lemma real_total f n : Q2R (total 0%Q Qplus f n) = total 0 Rplus (fun m => Q2R (f m)) n.
Proof. induction n as [|n IH]; simpl; [apply RMicromega.Q2R_0|]. rewrite Q2R_plus, IH. reflexivity. Qed.

Lemma real_fold l : Q2R (fold_right Qplus 0%Q l) = fold_right Rplus 0 (map Q2R l).
Proof. induction l as [|x l IH]; simpl; [apply RMicromega.Q2R_0|]. rewrite Q2R_plus, IH. reflexivity. Qed.

Lemma real_conditions N contact free x :
  map Q2R (conditions 0%Q Qopp Qplus N contact free x) = conditions 0 Ropp Rplus N contact free (both Q2R x).
Proof.
  unfold conditions. rewrite !map_app, !map_map. f_equal; [|f_equal].
  - apply map_ext. intro m. apply real_strain.
  - simpl. rewrite Q2R_opp, real_strain. reflexivity.
  - apply map_ext. intro m. rewrite real_total, real_contact || rewrite real_total, <- real_contact.
    induction (S m) as [|n IH]; [reflexivity|]. cbn [total]. rewrite IH, real_velocity. reflexivity.
Qed.

Lemma equal_lists (l l' : list Q) : Forall2 Qeq l l' <-> map Q2R l = map Q2R l'.
Proof.
  split.
  - induction 1 as [|x y l l' E _ IH]; [reflexivity|]. simpl. rewrite IH, (Qeq_eqR x y E). reflexivity.
  - revert l'. induction l as [|x l IH]; intros [|y l'] H; try discriminate; constructor; injection H as E H.
    + apply eqR_Qeq, E.
    + apply IH, H.
Qed.

Lemma real_signs l : Forall (fun row => row <= 0)%Q l <-> Forall (fun row => row <= 0) (map Q2R l).
Proof.
  rewrite Forall_map, !Forall_forall. pose proof RMicromega.Q2R_0 as Z. split; intros H x X; specialize (H x X).
  - apply Qle_Rle in H. rewrite Z in H. exact H.
  - apply Rle_Qle. rewrite Z. exact H.
Qed.

(** The rows of rational lists, computed as the paper does, are those of Paper.v. *)
Theorem rational_rows N contact free a b : (0 < N)%nat -> rationalMotion N contact free a b <->
  length a = N /\ length b = N /\ motion N contact free (cellsOf a) (cellsOf b).
Proof.
  intro N0. assert (L : forall l : list Q, length (map Q2R l) = length l) by (intro; apply map_length).
  assert (G : opened 0%Q Qopp Qplus (a, b) == inject_Z (Z.of_nat N) <-> opened 0 Ropp Rplus (both Q2R (a, b)) = INR N).
  { assert (E : Q2R (opened 0%Q Qopp Qplus (a, b)) = opened 0 Ropp Rplus (both Q2R (a, b))).
    { unfold opened, both. cbn [fst snd]. rewrite Q2R_plus, Q2R_opp, !real_fold. reflexivity. }
    assert (I : Q2R (inject_Z (Z.of_nat N)) = INR N) by (unfold Q2R; simpl; rewrite <- INR_IZR_INZ; field).
    rewrite <- E, <- I. split; [apply Qeq_eqR|apply eqR_Qeq]. }
  assert (P : both Q2R (period Qopp N contact free (a, b)) = period Ropp N contact free (map Q2R a, map Q2R b)).
  { unfold period. rewrite real_flight, real_contact. reflexivity. }
  assert (P1 := f_equal fst P). assert (P2 := f_equal snd P). cbn [both fst snd] in P1, P2.
  pose proof (real_conditions N contact free (a, b)) as C. change (both Q2R (a, b)) with (map Q2R a, map Q2R b) in C, G.
  split.
  - intros [LA LB RA RB W S]. split; [exact LA|]. split; [exact LB|].
    apply (rows_of_lists N N0 contact free); [rewrite L; assumption..|]. rewrite <- P1, <- P2, <- C.
    apply equal_lists in RA, RB. apply real_signs in S. apply G in W. auto.
  - intros [LA [LB M]].
    apply (rows_of_lists N N0 contact free (map Q2R a) (map Q2R b)) in M; [|rewrite L; assumption..].
    rewrite <- P1, <- P2, <- C in M. destruct M as [RA [RB [W S]]].
    split; try assumption; [apply equal_lists, RA|apply equal_lists, RB|apply G, W|apply real_signs, S].
Qed.

(** * The theorem on one contact, of rational lists *)

Section OneContact.
Variables N contact free : nat.
Hypothesis N_positive : (0 < N)%nat.
Hypothesis contact_positive : (0 < contact)%nat.
Hypothesis free_positive : (0 < free)%nat.

Theorem rational_one_contact a b : rationalMotion N contact free a b <-> length a = N /\ length b = N /\
  exists z, consists N contact free z (cellsOf a) (cellsOf b) /\ allowed N contact free z.
Proof. rewrite rational_rows, one_contact by assumption. reflexivity. Qed.

(** The verdict says whether there is a rational motion, too. *)
Theorem rational_verdict : verdict N contact free = true <-> exists a b, rationalMotion N contact free a b.
Proof.
  split.
  - intro V. destruct (verdict_amplitude N contact free N_positive contact_positive free_positive V) as [j0 [value [D A]]].
    set (G := classes N contact free) in *. set (z := only j0 (Q2R value)) in *.
    set (at_ := fun m => (inject_Z (sign N contact free (m / G)) * (if (m mod G =? j0)%nat then value else 0))%Q).
    assert (E : forall m, Q2R (at_ m) = IZR (sign N contact free (m / G)) * z (m mod G)%nat).
    { intro m. unfold at_, z, only. rewrite Q2R_mult. f_equal; [unfold Q2R; simpl; field|].
      destruct (m mod G =? j0)%nat; [reflexivity|apply RMicromega.Q2R_0]. }
    set (a := map (fun i => at_ (N - 1 - i)%nat) (seq 0 N)). set (b := map (fun i => (- at_ (N + i)%nat)%Q) (seq 0 N)).
    assert (Cell : forall f i, (1 <= i <= Z.of_nat N)%Z -> cellsOf (map f (seq 0 N)) i = Q2R (f (Z.to_nat (i - 1)))).
    { intros f i I. unfold cellsOf. rewrite map_map.
      rewrite (nth_indep _ 0 (Q2R (f 0%nat))) by (rewrite map_length, seq_length; lia).
      rewrite (map_nth (fun k => Q2R (f k))), seq_nth by lia. do 2 f_equal. }
    exists a, b. apply rational_one_contact. unfold a at 1, b at 1. rewrite !map_length, !seq_length.
    split; [reflexivity|]. split; [reflexivity|]. exists z. split; [|exact A].
    destruct (state_consists N contact free N_positive contact_positive free_positive z D) as [D' S].
    split; [exact D'|]. intros m M. rewrite <- S by exact M.
    apply (same_window (Z.of_nat N) ltac:(lia)); [|lia]. intros i I. unfold a, b. rewrite !Cell by exact I.
    unfold stateA, stateB. fold G. rewrite Q2R_opp, !E. split.
    + replace (N - 1 - Z.to_nat (i - 1))%nat with (N - Z.to_nat i)%nat by lia. reflexivity.
    + replace (N + Z.to_nat (i - 1))%nat with (N + Z.to_nat i - 1)%nat by lia. reflexivity.
  - intros [a [b M]]. apply rational_rows in M; [|assumption]. apply verdict_correct; try assumption.
    exists (cellsOf a), (cellsOf b). apply M.
Qed.
End OneContact.
