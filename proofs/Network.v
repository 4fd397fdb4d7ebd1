(** Networks of bars: any number of cells, in any pattern, meet at nodes with dashpots; stops and gaps anywhere.

    A wave crosses every cell in one step. With w the waves that arrive at a node along its cells, Z their
    impedances, D its dashpot and q the pushes of the contacts on it, to the right,

        (sum of Z + D) v = 2 (sum of Z w) + sum of q,   and v - w goes back along each cell.         (N)

    Velocities and pushes are whatever obeys this and the contacts: no cluster of closed contacts is special.
    Places are counted in (velocity x step), as in Chain.v. *)

From Coq Require Import QArith Reals Qreals List Lra Lia Arith.
From Signorini Require Import Numbers Sound Sums.
Import ListNotations.

Record cell := Cell { leftEnd : nat; rightEnd : nat; impedance : Q }.
Record meeting := Meeting { clamped : bool; dashpot : Q }.
Inductive contact :=
| StopRight (at_ : nat) (place : Q)        (** u <= place, pushes to the left *)
| StopLeft (at_ : nat) (place : Q)         (** u >= place, pushes to the right *)
| GapBetween (left right : nat) (g : Q).   (** u left - u right <= g *)

Record network := { cells : list cell; meetings : list meeting; contacts : list contact }.

Definition noCell := Cell 0 0 0.
Definition noMeeting := Meeting true 0.
Definition noContact := StopRight 0 0.

Section Network.
Variable net : network.
Let K := length (cells net).
Let M := length (meetings net).
Let J := length (contacts net).
Let cellOf k := nth k (cells net) noCell.

(** Numbers of unknowns: of each cell what arrives at its right and at its left end, places of the nodes; then
    those of a step, velocities and pushes. *)
Definition rightGoing (k : nat) : nat := k.
Definition leftGoing (k : nat) : nat := (K + k)%nat.
Definition placeOf (i : nat) : nat := (2 * K + i)%nat.
Definition velocityOf (i : nat) : nat := (2 * K + M + i)%nat.
Definition pushOf (j : nat) : nat := (2 * K + 2 * M + j)%nat.

(** Indices are those of nodes that there are. *)
Definition wellFormed : bool :=
  forallb (fun c => (leftEnd c <? M) && (rightEnd c <? M))%nat%bool (cells net) &&
  forallb (fun c => match c with
                    | StopRight i _ | StopLeft i _ => i <? M
                    | GapBetween i j _ => (i <? M) && (j <? M)
                    end)%nat%bool (contacts net).

(** * The law *)

Section Law.
Open Scope R_scope.
Variable z : list R.
Let r k := nth (rightGoing k) z 0.
Let l k := nth (leftGoing k) z 0.
Let u i := nth (placeOf i) z 0.
Let v i := nth (velocityOf i) z 0.
Let q j := nth (pushOf j) z 0.

Definition over (n : nat) (f : nat -> R) : R := fold_right Rplus 0 (map f (seq 0 n)).

(** Sum of Z, sum of Z w and sum of q at node i. *)
Definition stiffness (i : nat) : R := over K (fun k => let c := cellOf k in
  (if (rightEnd c =? i)%nat then Q2R (impedance c) else 0) + (if (leftEnd c =? i)%nat then Q2R (impedance c) else 0)).
Definition arriving (i : nat) : R := over K (fun k => let c := cellOf k in
  (if (rightEnd c =? i)%nat then Q2R (impedance c) * r k else 0) +
  (if (leftEnd c =? i)%nat then Q2R (impedance c) * l k else 0)).
Definition pushes (i : nat) : R := over J (fun j =>
  match nth j (contacts net) noContact with
  | StopRight a _ => if (a =? i)%nat then - q j else 0
  | StopLeft a _ => if (a =? i)%nat then q j else 0
  | GapBetween a b _ => (if (a =? i)%nat then - q j else 0) + (if (b =? i)%nat then q j else 0)
  end).

Definition lawAt (i : nat) : Prop :=
  let n := nth i (meetings net) noMeeting in
  if clamped n then v i = 0 else (stiffness i + Q2R (dashpot n)) * v i = 2 * arriving i + pushes i.

Definition contactObeys (closed : bool) (j : nat) : Prop :=
  match nth j (contacts net) noContact, closed with
  | StopRight i h, true | StopLeft i h, true => u i = Q2R h /\ v i = 0 /\ 0 <= q j
  | StopRight i h, false => q j = 0 /\ u i + v i <= Q2R h
  | StopLeft i h, false => q j = 0 /\ Q2R h <= u i + v i
  | GapBetween a b g, true => u a - u b = Q2R g /\ v a = v b /\ 0 <= q j
  | GapBetween a b g, false => q j = 0 /\ u a + v a - (u b + v b) <= Q2R g
  end.

(** One step obeys (N) at each node and every contact, closed or open. *)
Definition obeysAll (closed : list bool) : Prop :=
  (forall i, (i < M)%nat -> lawAt i) /\ (forall j, (j < J)%nat -> contactObeys (nth j closed false) j).

(** The state afterwards. *)
Definition stepped : list R :=
  map (fun k => v (leftEnd (cellOf k)) - l k) (seq 0 K) ++
  map (fun k => v (rightEnd (cellOf k)) - r k) (seq 0 K) ++
  map (fun i => u i + v i) (seq 0 M).

(** A cell is made longer by l - r; clamps are at 0. *)
Definition together : Prop :=
  (forall k, (k < K)%nat -> u (rightEnd (cellOf k)) - u (leftEnd (cellOf k)) = l k - r k) /\
  (forall i, (i < M)%nat -> clamped (nth i (meetings net) noMeeting) = true -> u i = 0).
End Law.

Fixpoint marches (steps : list (list bool)) (x : list R) (ys : list (list R)) (final : list R) : Prop :=
  match steps, ys with
  | [], [] => final = x
  | closed :: rest, y :: ys' => obeysAll (x ++ y) closed /\ marches rest (stepped (x ++ y)) ys' final
  | _, _ => False
  end.

(** A periodic motion: in each step some velocities and pushes [ys] obey, and the state returns. *)
Definition networkMotion (steps : list (list bool)) (x : list R) : Prop :=
  length x = (2 * K + M)%nat /\ together x /\ exists ys, marches steps x ys x.

(** * Rows *)

Open Scope Q_scope.

Definition cellTerms (i k : nat) : sparse := let c := cellOf k in
  (if (rightEnd c =? i)%nat then [(velocityOf i, impedance c); (rightGoing k, -(2) * impedance c)] else []) ++
  (if (leftEnd c =? i)%nat then [(velocityOf i, impedance c); (leftGoing k, -(2) * impedance c)] else []).
Definition pushTerms (i j : nat) : sparse :=
  match nth j (contacts net) noContact with
  | StopRight a _ => if (a =? i)%nat then [(pushOf j, 1)] else []
  | StopLeft a _ => if (a =? i)%nat then [(pushOf j, -(1))] else []
  | GapBetween a b _ => (if (a =? i)%nat then [(pushOf j, 1)] else []) ++ (if (b =? i)%nat then [(pushOf j, -(1))] else [])
  end.
Definition lawRow (i : nat) : linearRow :=
  let n := nth i (meetings net) noMeeting in
  (if clamped n then [(velocityOf i, 1)]
   else (velocityOf i, dashpot n) :: flat_map (cellTerms i) (seq 0 K) ++ flat_map (pushTerms i) (seq 0 J), 0).

Definition contactEquations (closed : list bool) (j : nat) : list linearRow :=
  match nth j (contacts net) noContact, nth j closed false with
  | StopRight i h, true | StopLeft i h, true => [([(placeOf i, 1)], - h); ([(velocityOf i, 1)], 0)]
  | GapBetween a b g, true => [([(placeOf a, 1); (placeOf b, -(1))], - g); ([(velocityOf a, 1); (velocityOf b, -(1))], 0)]
  | _, false => [([(pushOf j, 1)], 0)]
  end.
Definition contactConditions (closed : list bool) (j : nat) : list linearRow :=
  match nth j (contacts net) noContact, nth j closed false with
  | _, true => [([(pushOf j, 1)], 0)]
  | StopRight i h, false => [([(placeOf i, -(1)); (velocityOf i, -(1))], h)]
  | StopLeft i h, false => [([(placeOf i, 1); (velocityOf i, 1)], - h)]
  | GapBetween a b g, false =>
      [([(placeOf a, -(1)); (velocityOf a, -(1)); (placeOf b, 1); (velocityOf b, 1)], g)]
  end.

Definition stepOf (closed : list bool) : linearStep := {|
  next := map (fun k => [(velocityOf (leftEnd (cellOf k)), 1); (leftGoing k, -(1))]) (seq 0 K) ++
          map (fun k => [(velocityOf (rightEnd (cellOf k)), 1); (rightGoing k, -(1))]) (seq 0 K) ++
          map (fun i => [(placeOf i, 1); (velocityOf i, 1)]) (seq 0 M);
  equations := map lawRow (seq 0 M) ++ flat_map (contactEquations closed) (seq 0 J);
  inequalities := flat_map (contactConditions closed) (seq 0 J) |}.

Definition startRows : list linearRow :=
  map (fun k => let c := cellOf k in
         ([(placeOf (rightEnd c), 1); (placeOf (leftEnd c), -(1)); (leftGoing k, -(1)); (rightGoing k, 1)], 0)) (seq 0 K) ++
  flat_map (fun i => if clamped (nth i (meetings net) noMeeting) then [([(placeOf i, 1)], 0)] else []) (seq 0 M).

Definition checkNetwork (steps : list (list bool)) (c : sumCertificate) : bool :=
  wellFormed && checkSum (2 * K + M) startRows (map stepOf steps) c.

Definition checkNetworkLeast (ws : list Q) (steps : list (list bool)) (c : sumCertificate) (bound : Q) : bool :=
  wellFormed && checkSumLeast ws (2 * K + M) startRows (map stepOf steps) c bound.

(** * Proofs *)

Open Scope R_scope.

Lemma eval_flat {A} (f : A -> sparse) l z : eval (flat_map f l) z = fold_right Rplus 0 (map (fun x => eval (f x) z) l).
Proof. induction l as [|x l IH]; [reflexivity|]. simpl. rewrite eval_app, IH. reflexivity. Qed.

Lemma over_ext n f g : (forall k, f k = g k) -> over n f = over n g.
Proof. intro H. unfold over. f_equal. apply map_ext, H. Qed.

Lemma over_linear n c d f g : over n (fun k => c * f k + d * g k) = c * over n f + d * over n g.
Proof. unfold over. induction (seq 0 n) as [|k l IH]; simpl; [lra|]. rewrite IH. lra. Qed.

Ltac numbers := cbn [eval fst snd]; rewrite ?Q2R_mult, ?Q2R_opp, ?Q2R_opp, ?Q2R_0, ?Q2R_1, ?Q2R_2.

Lemma lawRow_holds z i : lawAt z i -> isZero z (lawRow i).
Proof.
  unfold lawAt, isZero, lawRow. destruct (clamped (nth i (meetings net) noMeeting)); intro H; numbers; [lra|].
  rewrite eval_app, !eval_flat.
  assert (A : fold_right Rplus 0 (map (fun k => eval (cellTerms i k) z) (seq 0 K)) =
              nth (velocityOf i) z 0 * stiffness i + -2 * arriving z i).
  { unfold stiffness, arriving. rewrite <- over_linear. apply over_ext. intro k. unfold cellTerms.
    destruct (rightEnd (cellOf k) =? i)%nat, (leftEnd (cellOf k) =? i)%nat; cbn [app]; numbers; ring. }
  assert (B : fold_right Rplus 0 (map (fun j => eval (pushTerms i j) z) (seq 0 J)) = - pushes z i).
  { replace (- pushes z i) with (-1 * pushes z i + 0 * pushes z i) by ring. unfold pushes. rewrite <- over_linear.
    apply over_ext. intro j. unfold pushTerms. destruct (nth j (contacts net) noContact) as [a h|a h|a b g];
      repeat match goal with |- context [(?a =? i)%nat] => destruct (a =? i)%nat end; cbn [app]; numbers; ring. }
  rewrite A, B. lra.
Qed.

Lemma contact_holds z closed j : contactObeys z (nth j closed false) j ->
  Forall (isZero z) (contactEquations closed j) /\ Forall (isNonnegative z) (contactConditions closed j).
Proof.
  unfold contactObeys, contactEquations, contactConditions.
  destruct (nth j (contacts net) noContact) as [a h|a h|a b g], (nth j closed false); intro H;
    split; repeat (apply Forall_cons || apply Forall_nil); unfold isZero, isNonnegative; numbers; lra.
Qed.

Lemma step_holds z closed : obeysAll z closed -> stepHolds (stepOf closed) z.
Proof.
  intros [L C]. split; cbn [stepOf equations inequalities].
  - apply Forall_app. split.
    + apply Forall_map, Forall_forall. intros i I. apply in_seq in I. apply lawRow_holds, L. lia.
    + apply Forall_flat_map, Forall_forall. intros j I. apply in_seq in I. apply contact_holds, C. lia.
  - apply Forall_flat_map, Forall_forall. intros j I. apply in_seq in I. apply contact_holds, C. lia.
Qed.

Lemma next_is z closed : map (fun f => eval f z) (next (stepOf closed)) = stepped z.
Proof.
  unfold stepped. cbn [stepOf next]. rewrite !map_app, !map_map.
  f_equal; [|f_equal]; apply map_ext; intro k; numbers; lra.
Qed.

Lemma start_holds x : together x -> Forall (isZero x) startRows.
Proof.
  intros [C P]. apply Forall_app. split.
  - apply Forall_map, Forall_forall. intros k I. apply in_seq in I. specialize (C k ltac:(lia)). unfold isZero. numbers. lra.
  - apply Forall_flat_map, Forall_forall. intros i I. apply in_seq in I. specialize (P i ltac:(lia)).
    destruct (clamped _); [|constructor]. constructor; [|constructor]. unfold isZero. numbers. rewrite (P eq_refl). lra.
Qed.

Lemma motion_cycle steps x : networkMotion steps x -> cycle (2 * K + M) startRows (map stepOf steps) x.
Proof.
  intros [L [T [ys H]]]. split; [|split; [exact L|split; [apply start_holds, T|]]].
  - apply Forall_map, Forall_forall. intros closed _. cbn [stepOf next]. rewrite !app_length, !map_length, !seq_length. lia.
  - exists ys. clear L T. set (final := x) in H at 2 |- * at 2. clearbody final. revert x ys H.
    induction steps as [|closed steps IH]; intros x [|y ys] H; cbn [marches map leads] in H |- *; try contradiction; [exact H|].
    destruct H as [O H]. split; [apply step_holds, O|]. rewrite next_is. apply IH, H.
Qed.

(** ** Theorem: what is checked is so, of every network. *)

Theorem checkNetwork_correct steps c : checkNetwork steps c = true -> forall x, ~ networkMotion steps x.
Proof.
  intros H x X. apply andb_prop in H. destruct H as [_ H]. exact (checkSum_correct _ _ _ _ H x (motion_cycle _ _ X)).
Qed.

Theorem checkNetworkLeast_correct ws steps c bound : checkNetworkLeast ws steps c bound = true ->
  forall x, networkMotion steps x -> Q2R bound <= weighted ws x.
Proof.
  intros H x X. apply andb_prop in H. destruct H as [_ H].
  exact (checkSumLeast_correct _ _ _ _ _ _ H x (motion_cycle _ _ X)).
Qed.
End Network.
