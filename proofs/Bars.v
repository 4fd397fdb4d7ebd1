(** Bars as chains: what the files of the program are about.

    A bar of segments is clamped at its left end; its tip is stopped at [high] and perhaps at [low]. Each
    contact of a schedule, a stop and two numbers of steps, holds the tip and lets it go. *)

From Coq Require Import QArith List.
From Signorini Require Import Chain.
Import ListNotations.

(** A segment: its cells, and the joint at its right end as (z1, z2, z) of [Joint]; the last one ends at
    the tip. *)
Definition segment := (nat * option (Q * Q * Q))%type.

Fixpoint nodesOf (segments : list segment) (low high : option Q) : list node :=
  match segments with
  | [] => []
  | (cells, end_) :: rest =>
      repeat Through (cells - 1) ++
      match end_ with
      | Some (z1, z2, z) => Joint z1 z2 z None None :: nodesOf rest low high
      | None => [Joint 1 0 1 low high]
      end
  end.

Definition bar (strain : option Q) (segments : list segment) (low high : option Q) : list node :=
  Clamp strain :: nodesOf segments low high.

(** Statuses of all nodes in one step: only the tip, node number [cells], has contacts. *)
Definition atTip (cells : nat) (s : status) : list status := repeat Open cells ++ [s].

Fixpoint stepsOf (cells : nat) (phases : list (status * nat * nat)) : list (list status) :=
  match phases with
  | [] => []
  | (stop, contact, free) :: rest =>
      repeat (atTip cells stop) contact ++ repeat [] free ++ stepsOf cells rest
  end.
