(** Sums of rows of anything linear, and what they prove.

    A state is a list of numbers. In each step there are further unknowns, say velocities and pushes; rows are
    equations and inequalities of state and unknowns, and the next state is linear in them. A certificate is a
    number for each row. From the last step to the first their sum becomes a form of the state at t = 0 alone. *)

From Coq Require Import QArith Reals Qreals List Lra Lia.
From Signorini Require Import Numbers Checker Sound.
Import ListNotations.

(** * Definitions *)

(** A sparse form: factors of numbered unknowns; one may be listed twice. *)
Definition sparse := list (nat * Q).

Fixpoint addAt (i : nat) (c : Q) (l : list Q) : list Q :=
  match i, l with
  | O, [] => [c]
  | O, x :: l' => add x c :: l'
  | S i', [] => 0%Q :: addAt i' c []
  | S i', x :: l' => x :: addAt i' c l'
  end.
Definition dense (f : sparse) : list Q := fold_right (fun ic l => addAt (fst ic) (snd ic) l) [] f.
Definition scaled (m : Q) (f : sparse) : sparse := map (fun ic => (fst ic, mul m (snd ic))) f.
Fixpoint combined (ms : list Q) (fs : list sparse) : sparse :=
  match ms, fs with m :: ms', f :: fs' => scaled m f ++ combined ms' fs' | _, _ => [] end.

(** A row says form + constant = 0, or >= 0. *)
Definition linearRow : Type := sparse * Q.

Record linearStep := {
  next : list sparse;              (** the state afterwards *)
  equations : list linearRow;
  inequalities : list linearRow
}.

Definition constants (ms : list Q) (rows : list linearRow) : Q :=
  fold_right add 0%Q (map (fun mr => mul (fst mr) (snd (snd mr))) (combine ms rows)).

(** Multipliers of a step, and of all; those of what holds at t = 0; those of "the state returns". *)
Record sumCertificate := {
  ofSteps : list (list Q * list Q);
  ofStart : list Q;
  ofReturn : list Q
}.

(** [n]: length of a state; what comes after that are unknowns of the step, of which nothing may be left. *)
Fixpoint pulledBack (n : nat) (steps : list linearStep) (listed : list (list Q * list Q)) (last : list Q)
    : option (list Q * Q) :=
  match steps with
  | [] => Some (last, 0%Q)
  | s :: rest =>
      match pulledBack n rest (tl listed) last with
      | Some (after, c) =>
          let (es, cs) := hd ([], []) listed in
          let all := dense (combined after (next s) ++ combined es (map fst (equations s)) ++
                            combined cs (map fst (inequalities s))) in
          if (forallb (Qle_bool 0) cs && forallb is_zero (skipn n all))%bool
          then Some (firstn n all, add c (add (constants es (equations s)) (constants cs (inequalities s))))
          else None
      | None => None
      end
  end.

(** Form and constant of the state at t = 0 that every motion makes >= 0. *)
Definition sumOf (n : nat) (start : list linearRow) (steps : list linearStep) (c : sumCertificate)
    : option (list Q * Q) :=
  match pulledBack n steps (ofSteps c) (ofReturn c) with
  | Some (l, d) =>
      let back := combine (seq 0 (length (ofReturn c))) (map (mul (-1)) (ofReturn c)) in
      Some (dense (combine (seq 0 (length l)) l ++ back ++ combined (ofStart c) (map fst start)),
            add d (constants (ofStart c) start))
  | None => None
  end.

Definition checkSum n start steps c : bool :=
  match sumOf n start steps c with
  | Some (l, d) => (forallb is_zero l && negb (Qle_bool 0 d))%bool
  | None => false
  end.

(** sum of factor^2/weight. *)
Fixpoint squaresOf (ws l : list Q) : option Q :=
  match l, ws with
  | [], _ => Some 0%Q
  | f :: l', w :: ws' =>
      match square f w, squaresOf ws' l' with Some a, Some b => Some (add a b) | _, _ => None end
  | f :: l', [] => if is_zero f then squaresOf [] l' else None
  end.

Definition checkSumLeast (ws : list Q) n start steps c (bound : Q) : bool :=
  (forallb (Qle_bool 0) ws &&
   match sumOf n start steps c with
   | Some (l, d) =>
       match squaresOf ws l with
       | Some s =>
           let t := Qred (- d / s) in
           Qle_bool 0 t && Qle_bool bound (add (mul (mul 2 t) (- d)) (- (mul (mul t t) s)))
       | None => false
       end
   | None => false
   end)%bool.

(** ** What a motion is *)

Open Scope R_scope.

Fixpoint eval (f : sparse) (z : list R) : R :=
  match f with [] => 0 | (i, c) :: f' => Q2R c * nth i z 0 + eval f' z end.

Definition isZero (z : list R) (r : linearRow) : Prop := eval (fst r) z + Q2R (snd r) = 0.
Definition isNonnegative (z : list R) (r : linearRow) : Prop := 0 <= eval (fst r) z + Q2R (snd r).

Record stepHolds (s : linearStep) (z : list R) : Prop := {
  allZero : Forall (isZero z) (equations s);
  allNonnegative : Forall (isNonnegative z) (inequalities s)
}.

(** From state [x] through all steps to [final], with unknowns [ys] in each. *)
Fixpoint leads (steps : list linearStep) (x : list R) (ys : list (list R)) (final : list R) : Prop :=
  match steps, ys with
  | [], [] => final = x
  | s :: rest, y :: ys' => stepHolds s (x ++ y) /\ leads rest (map (fun f => eval f (x ++ y)) (next s)) ys' final
  | _, _ => False
  end.

Definition cycle (n : nat) (start : list linearRow) (steps : list linearStep) (x : list R) : Prop :=
  Forall (fun s => length (next s) = n) steps /\ length x = n /\ Forall (isZero x) start /\ exists ys, leads steps x ys x.

Fixpoint weighted (ws : list Q) (x : list R) : R :=
  match ws, x with w :: ws', y :: x' => Q2R w * (y * y) + weighted ws' x' | _, _ => 0 end.

(** * Proofs *)

Fixpoint dot (l : list Q) (z : list R) : R :=
  match l, z with c :: l', y :: z' => Q2R c * y + dot l' z' | _, _ => 0 end.

Lemma eval_app f g z : eval (f ++ g) z = eval f z + eval g z.
Proof. induction f as [|[i c] f IH]; simpl; [lra|]. rewrite IH. lra. Qed.

Lemma eval_scaled m f z : eval (scaled m f) z = Q2R m * eval f z.
Proof. induction f as [|[i c] f IH]; simpl; [lra|]. rewrite IH, mul_R. lra. Qed.

Lemma dot_nil l : dot l [] = 0.
Proof. destruct l; reflexivity. Qed.

Lemma dot_addAt i c : forall l z, dot (addAt i c l) z = Q2R c * nth i z 0 + dot l z.
Proof.
  induction i as [|i IH]; intros [|x l] [|y z]; simpl; rewrite ?Q2R_0, ?add_R; try lra; rewrite IH; simpl; lra.
Qed.

Lemma dot_dense f z : dot (dense f) z = eval f z.
Proof. induction f as [|[i c] f IH]; [reflexivity|]. 
  change (dense ((i, c) :: f)) with (addAt i c (dense f)). rewrite dot_addAt, IH. reflexivity.
Qed.

Lemma eval_combined ms : forall fs z, eval (combined ms fs) z = dot ms (map (fun f => eval f z) fs).
Proof.
  induction ms as [|m ms IH]; intros [|f fs] z; try reflexivity. simpl. rewrite eval_app, eval_scaled, IH. reflexivity.
Qed.

Lemma eval_listed l : forall k (z : list R), eval (combine (seq k (length l)) l) z = dot l (skipn k z).
Proof.
  induction l as [|c l IH]; intros k z; [reflexivity|]. cbn [length seq combine eval]. rewrite IH.
  revert k. induction z as [|y z IZ]; intros [|k]; simpl; rewrite ?dot_nil; try lra. apply IZ.
Qed.

Lemma dot_zero l : forall z, forallb is_zero l = true -> dot l z = 0.
Proof.
  induction l as [|c l IH]; intros [|y z] H; try reflexivity. simpl in H. apply andb_prop in H. destruct H as [C H].
  simpl. rewrite (is_zero_R c C), IH by exact H. lra.
Qed.

Lemma dot_split l : forall x y, dot l (x ++ y) = dot (firstn (length x) l) x + dot (skipn (length x) l) y.
Proof.
  induction l as [|c l IH]; intros [|u x] y; simpl; try lra. rewrite IH. lra.
Qed.

Lemma dot_times m l : forall z, dot (map (mul m) l) z = Q2R m * dot l z.
Proof. induction l as [|c l IH]; intros [|y z]; simpl; try lra. rewrite IH, mul_R. lra. Qed.

Lemma equations_hold rows z : Forall (isZero z) rows -> forall ms,
  eval (combined ms (map fst rows)) z + Q2R (constants ms rows) = 0.
Proof.
  induction 1 as [|r rows H _ IH]; intros [|m ms]; unfold constants; simpl; rewrite ?Q2R_0; try lra.
  rewrite eval_app, eval_scaled, add_R, mul_R. specialize (IH ms). unfold constants, isZero in *.
  replace (eval (fst r) z) with (- Q2R (snd r)) by lra. lra.
Qed.

Lemma conditions_hold rows z : Forall (isNonnegative z) rows -> forall ms, forallb (Qle_bool 0) ms = true ->
  0 <= eval (combined ms (map fst rows)) z + Q2R (constants ms rows).
Proof.
  induction 1 as [|r rows H _ IH]; intros [|m ms] M; unfold constants; simpl; rewrite ?Q2R_0; try lra.
  simpl in M. apply andb_prop in M. destruct M as [M0 M]. apply le_R in M0. rewrite Q2R_0 in M0.
  rewrite eval_app, eval_scaled, add_R, mul_R. specialize (IH ms M). unfold constants, isNonnegative in *.
  assert (0 <= Q2R m * (eval (fst r) z + Q2R (snd r))) by (apply Rmult_le_pos; assumption). lra.
Qed.

Lemma pulledBack_holds n steps : forall listed last l c x ys final,
  Forall (fun s => length (next s) = n) steps -> length x = n -> leads steps x ys final ->
  pulledBack n steps listed last = Some (l, c) -> dot last final <= dot l x + Q2R c.
Proof.
  induction steps as [|s steps IH]; intros listed last l c x [|y ys] final N L M E; simpl in M, E; try contradiction.
  - injection E as <- <-. subst final. rewrite Q2R_0. lra.
  - destruct (pulledBack n steps (tl listed) last) as [[after d]|] eqn:P; [|discriminate].
    destruct (hd ([], []) listed) as [es cs]. destruct (forallb (Qle_bool 0) cs && _)%bool eqn:B; [|discriminate].
    injection E as <- <-. apply andb_prop in B. destruct B as [C0 Z0]. destruct M as [[Eq Co] M].
    inversion_clear N as [|? ? Ns Nr]. set (z := x ++ y) in *.
    specialize (IH (tl listed) last after d _ ys final Nr ltac:(rewrite map_length; exact Ns) M P).
    pose proof (equations_hold _ _ Eq es) as A. pose proof (conditions_hold _ _ Co cs C0) as B.
    set (all := dense _) in *.
    assert (D : dot all z = dot (firstn n all) x).
    { unfold z. rewrite dot_split, L. rewrite (dot_zero _ y Z0). lra. }
    rewrite <- D. unfold all. rewrite dot_dense, !eval_app, eval_combined, !add_R. lra.
Qed.

Lemma sumOf_holds n start steps c l d x : cycle n start steps x -> sumOf n start steps c = Some (l, d) ->
  0 <= dot l x + Q2R d.
Proof.
  intros [N [L [S [ys M]]]] E. unfold sumOf in E.
  destruct (pulledBack n steps (ofSteps c) (ofReturn c)) as [[k e]|] eqn:P; [|discriminate]. injection E as <- <-.
  pose proof (pulledBack_holds n steps _ _ _ _ _ _ _ N L M P) as H. pose proof (equations_hold _ _ S (ofStart c)) as A.
  rewrite dot_dense, !eval_app, eval_listed, add_R.
  replace (length (ofReturn c)) with (length (map (mul (-1)) (ofReturn c))) by apply map_length.
  rewrite eval_listed, dot_times, Q2R_m1. simpl skipn. lra.
Qed.

(** ** Theorem: what is checked is so. *)

Theorem checkSum_correct n start steps c : checkSum n start steps c = true -> forall x, ~ cycle n start steps x.
Proof.
  unfold checkSum. intros H x M. destruct (sumOf n start steps c) as [[l d]|] eqn:E; [|discriminate].
  apply andb_prop in H. destruct H as [Z D]. apply Bool.negb_true_iff, lt_R in D. rewrite Q2R_0 in D.
  pose proof (sumOf_holds n start steps c l d x M E). rewrite (dot_zero l x Z) in *. lra.
Qed.

Lemma weighted_nonnegative ws : forall x, forallb (Qle_bool 0) ws = true -> 0 <= weighted ws x.
Proof.
  induction ws as [|w ws IH]; intros [|y x] H; simpl; try lra. simpl in H. apply andb_prop in H. destruct H as [W H].
  apply le_R in W. rewrite Q2R_0 in W. pose proof (Rle_0_sqr y) as Y. unfold Rsqr in Y. specialize (IH x H). nra.
Qed.

Lemma squaresOf_bound l : forall ws s, forallb (Qle_bool 0) ws = true -> squaresOf ws l = Some s -> 0 <= Q2R s /\
  forall t x, 2 * t * dot l x - t * t * Q2R s <= weighted ws x.
Proof.
  induction l as [|f l IH]; intros ws s W H; simpl in H.
  - injection H as <-. rewrite Q2R_0. split; [lra|]. intros t x. pose proof (weighted_nonnegative ws x W). simpl. lra.
  - destruct ws as [|w ws].
    + destruct (is_zero f) eqn:F; [|discriminate]. apply (IH [] s W) in H. destruct H as [H0 H]. split; [exact H0|].
      intros t [|y x]; simpl; [specialize (H t []); rewrite dot_nil in H; simpl in H; lra|].
      rewrite (is_zero_R f F). specialize (H t x). simpl in H. lra.
    + destruct (square f w) as [a|] eqn:A; [|discriminate]. destruct (squaresOf ws l) as [b|] eqn:B; [|discriminate].
      injection H as <-. simpl in W. apply andb_prop in W. destruct W as [_ W]. apply square_bound in A.
      apply (IH ws b W) in B. destruct A as [A0 A], B as [B0 B]. rewrite add_R. split; [lra|].
      intros t [|y x]; simpl.
      * specialize (B t []). rewrite dot_nil in B. specialize (A t 0). simpl in B. nra.
      * specialize (A t y). specialize (B t x). lra.
Qed.

Theorem checkSumLeast_correct ws n start steps c bound : checkSumLeast ws n start steps c bound = true ->
  forall x, cycle n start steps x -> Q2R bound <= weighted ws x.
Proof.
  unfold checkSumLeast. intros H x M. apply andb_prop in H. destruct H as [W H].
  destruct (sumOf n start steps c) as [[l d]|] eqn:E; [|discriminate].
  pose proof (sumOf_holds n start steps c l d x M E) as P.
  destruct (squaresOf ws l) as [s|] eqn:S; [|discriminate]. apply (squaresOf_bound l ws s W) in S. destruct S as [_ S].
  set (t := Qred (- d / s)) in *. apply andb_prop in H. destruct H as [T B]. apply le_R in T, B. rewrite Q2R_0 in T.
  specialize (S (Q2R t) x). autorewrite with real in B. rewrite Q2R_2 in B. clearbody t. nra.
Qed.
