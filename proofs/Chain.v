(** A chain of bars: the law of waves and nodes, contacts, and what a periodic motion is.

    Cells stand side by side; a wave crosses each in one step. Between two cells, and at both ends, is a
    node. With w the waves that arrive at it, Z the impedances of the cells that they come from and D its
    dashpot, it moves with the velocity

        v = 2 (sum of Z w) / (sum of Z + D),   and v - w goes back along each branch.             (N)

    Places are counted in (velocity x step), so that a cell becomes longer by l - r in a step's time and
    a node moves by v. Waves and places are real numbers, what describes the bars are fractions. *)

From Coq Require Import QArith Reals Qreals List.
Import ListNotations.
Open Scope R_scope.

(** ** Nodes *)

Inductive node :=
| Clamp (strain : option Q)
    (** held for ever; with a limit, the strain 2 l of the cell at its right is to be >= -limit *)
| Through
    (** between two cells of one bar: equal impedances, no dashpot *)
| Joint (z1 z2 z : Q) (low high : option Q)
    (** impedances of the cells at its left and right (0: no cell), z = z1 + z2 + dashpot; between which
        places it stays: those of stops, or a limit *)
| Gap (z1 d1 z2 d2 g : Q).
    (** two faces, each with the impedance of its cell and a dashpot, at rest g apart *)

(** What a node does during one step: a joint may be on one of its stops, a gap may be shut. *)
Inductive status := Open | OnLow | OnHigh | Shut.

(** (N) as two rows of coefficients, of the waves from the left and from the right: how fast the left
    face moves, and the right one. *)
Definition velocities (n : node) (s : status) : (Q * Q) * (Q * Q) :=
  (match n, s with
   | Clamp _, _ => ((0, 0), (0, 0))
   | Through, _ => ((1, 1), (1, 1))
   | Joint z1 z2 z _ _, Open => let v := (2 * z1 / z, 2 * z2 / z) in (v, v)
   | Joint _ _ _ _ _, _ => ((0, 0), (0, 0))
   | Gap z1 d1 z2 d2 _, Shut =>
       let z := z1 + d1 + z2 + d2 in let v := (2 * z1 / z, 2 * z2 / z) in (v, v)
   | Gap z1 d1 z2 d2 _, _ => ((2 * z1 / (z1 + d1), 0), (0, 2 * z2 / (z2 + d2)))
   end)%Q.

(** ** States: of each node the waves about to arrive, and where its faces are *)

Record local := At { fromLeft : R; fromRight : R; leftFace : R; rightFace : R }.
Definition state := list local.

Definition along (c : Q * Q) (x : local) : R := Q2R (fst c) * fromLeft x + Q2R (snd c) * fromRight x.
Definition leftVelocity n s x := along (fst (velocities n s)) x.
Definition rightVelocity n s x := along (snd (velocities n s)) x.

(** One step. [arriving] is what the node before sends to the right; the result is what the first node
    sends to the left, and the state of all nodes a step later. Statuses that are not listed are [Open]. *)
Fixpoint march (arriving : R) (ns : list node) (ss : list status) (xs : state) : R * state :=
  match ns, xs with
  | n :: ns', x :: xs' =>
      let s := hd Open ss in
      let vl := leftVelocity n s x in
      let vr := rightVelocity n s x in
      let (back, rest) := march (vr - fromRight x) ns' (tl ss) xs' in
      (vl - fromLeft x, At arriving back (leftFace x + vl) (rightFace x + vr) :: rest)
  | _, _ => (0, [])
  end.

Definition step ns ss xs : state := snd (march 0 ns ss xs).

(** ** Rows: what one node has to obey during one step *)

(** The push of a stop, or of the two faces of a gap on each other. *)
Definition stopPush (z1 z2 : Q) (x : local) : R := 2 * (Q2R z1 * fromLeft x + Q2R z2 * fromRight x).

Definition gapPush (z1 d1 z2 d2 : Q) (x : local) : R :=
  let fa := 2 * (Q2R z1 * fromLeft x) in let fb := 2 * (Q2R z2 * fromRight x) in
  Q2R (/ (z1 + d1 + z2 + d2)) * (Q2R (z2 + d2) * fa - Q2R (z1 + d1) * fb).

Definition below (place : R) (limit : option Q) : Prop :=
  match limit with Some h => place <= Q2R h | None => True end.
Definition above (place : R) (limit : option Q) : Prop :=
  match limit with Some h => Q2R h <= place | None => True end.
Definition rests (place : R) (stop : option Q) (push : R) : Prop :=
  match stop with Some h => place = Q2R h /\ 0 <= push | None => True end.

Definition obeys (n : node) (s : status) (x : local) : Prop :=
  let after := leftFace x + leftVelocity n s x in
  match n, s with
  | Clamp limit, _ => above (2 * fromRight x) (option_map Qopp limit)
  | Through, _ => True
  | Joint z1 z2 z low high, Open => above after low /\ below after high
  | Joint z1 z2 z low high, OnLow => rests (leftFace x) low (- stopPush z1 z2 x)
  | Joint z1 z2 z low high, _ => rests (leftFace x) high (stopPush z1 z2 x)
  | Gap z1 d1 z2 d2 g, Shut => leftFace x - rightFace x = Q2R g /\ 0 <= gapPush z1 d1 z2 d2 x
  | Gap z1 d1 z2 d2 g, _ => after - (rightFace x + rightVelocity n s x) <= Q2R g
  end.

Fixpoint allObey (ns : list node) (ss : list status) (xs : state) : Prop :=
  match ns, xs with
  | n :: ns', x :: xs' => obeys n (hd Open ss) x /\ allObey ns' (tl ss) xs'
  | _, _ => True
  end.

(** At t = 0 places and waves belong together: between two nodes lies one cell, made longer by l - r. *)
Definition together (n : node) (x : local) : Prop :=
  match n with
  | Clamp _ => leftFace x = 0 /\ rightFace x = 0
  | Through | Joint _ _ _ _ _ => leftFace x = rightFace x
  | Gap _ _ _ _ _ => True
  end.

Fixpoint joined (ns : list node) (xs : state) : Prop :=
  match ns, xs with
  | n :: ns', x :: xs' =>
      together n x /\ joined ns' xs' /\
      match ns', xs' with
      | _ :: _, y :: _ => leftFace y - rightFace x = fromRight x - fromLeft y
      | _, _ => True
      end
  | _, _ => True
  end.

(** ** Motions: rows in every step, and the state returns *)

Fixpoint carried (ns : list node) (steps : list (list status)) (xs : state) : state :=
  match steps with [] => xs | ss :: rest => carried ns rest (step ns ss xs) end.

Fixpoint rowsHold (ns : list node) (steps : list (list status)) (xs : state) : Prop :=
  match steps with [] => True | ss :: rest => allObey ns ss xs /\ rowsHold ns rest (step ns ss xs) end.

Record motion (ns : list node) (steps : list (list status)) (xs : state) : Prop := {
  everyNode : length xs = length ns;
  together0 : joined ns xs;
  rows : rowsHold ns steps xs;
  returns : carried ns steps xs = xs
}.

(** Energy, with a weight for each wave: those from the left, those from the right. *)
Fixpoint energy (ws : list (Q * Q)) (xs : state) : R :=
  match ws, xs with
  | w :: ws', x :: xs' =>
      Q2R (fst w) * (fromLeft x * fromLeft x) + Q2R (snd w) * (fromRight x * fromRight x) + energy ws' xs'
  | _, _ => 0
  end.
