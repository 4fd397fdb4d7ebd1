(** The checker: sums of rows of a chain, and what they prove.

    A certificate is a number for each row that it uses. Their sum is pulled back through the steps, from
    the last one to the first, by the transpose of a step, until it is one linear form of the state at
    t = 0: every motion makes it >= 0. If nothing is left of it but a negative number there is no motion;
    if waves alone are left, Cauchy and Schwarz bound the energy from below. Definitions only; Sound.v has the proofs. *)

From Coq Require Import QArith List.
From Signorini Require Import Numbers Chain.
Import ListNotations.
Open Scope Q_scope.

(** ** Linear forms of one node, and of all *)

Record form := Form { ofLeft : Q; ofRight : Q; ofLeftFace : Q; ofRightFace : Q }.
Definition zero : form := Form 0 0 0 0.

Definition plus (f g : form) : form :=
  Form (add (ofLeft f) (ofLeft g)) (add (ofRight f) (ofRight g))
       (add (ofLeftFace f) (ofLeftFace g)) (add (ofRightFace f) (ofRightFace g)).
Definition times (m : Q) (f : form) : form :=
  Form (mul m (ofLeft f)) (mul m (ofRight f)) (mul m (ofLeftFace f)) (mul m (ofRightFace f)).
Definition first (fs : list form) : form := hd zero fs.

Fixpoint plusAll (fs gs : list form) : list form :=
  match fs, gs with
  | [], _ => gs
  | _, [] => fs
  | f :: fs', g :: gs' => plus f g :: plusAll fs' gs'
  end.

Fixpoint plusAt (k : nat) (g : form) (fs : list form) : list form :=
  match k with
  | O => plus (first fs) g :: tl fs
  | S k' => first fs :: plusAt k' g (tl fs)
  end.

(** ** The transpose of a step. [left] is the factor of what the first node sends to the left. *)

Fixpoint pull (left : Q) (ns : list node) (ss : list status) (fs : list form) : list form :=
  match ns with
  | [] => []
  | n :: ns' =>
      let f := first fs in
      let right := match ns' with [] => 0 | _ => ofLeft (first (tl fs)) end in
      let (vl, vr) := velocities n (hd Open ss) in
      let l := add left (ofLeftFace f) in
      let r := add right (ofRightFace f) in
      Form (add (add (mul l (fst vl)) (mul r (fst vr))) (- left))
           (add (add (mul l (snd vl)) (mul r (snd vr))) (- right))
           (ofLeftFace f) (ofRightFace f) :: pull (ofRight f) ns' (tl ss) (tl fs)
  end.

(** ** Rows of one node in one step: form + constant >= 0, or = 0 *)

Record row := Row { equality : bool; theForm : form; constant : Q }.

Definition bounded (sign : Q) (v : Q * Q) (limit : option Q) : row :=
  match limit with
  | Some h => Row false (Form (sign * fst v) (sign * snd v) sign 0) (- (sign * h))
  | None => Row false zero 0
  end.

Definition resting (sign : Q) (z1 z2 : Q) (stop : option Q) : list row :=
  match stop with
  | Some h => [Row true (Form 0 0 1 0) (- h); Row false (Form (sign * (2 * z1)) (sign * (2 * z2)) 0 0) 0]
  | None => []
  end.

Definition rowsOf (n : node) (s : status) : list row :=
  match n, s with
  | Clamp (Some limit), _ => [Row false (Form 0 2 0 0) limit]
  | Clamp None, _ | Through, _ => []
  | Joint z1 z2 z low high, Open =>
      let v := fst (velocities n s) in [bounded 1 v low; bounded (-1) v high]
  | Joint z1 z2 z low high, OnLow => resting (-1) z1 z2 low
  | Joint z1 z2 z low high, _ => resting 1 z1 z2 high
  | Gap z1 d1 z2 d2 g, Shut =>
      let scale := / (z1 + d1 + z2 + d2) in
      [Row true (Form 0 0 1 (-1)) (- g);
       Row false (Form (scale * ((z2 + d2) * (2 * z1))) (- (scale * ((z1 + d1) * (2 * z2)))) 0 0) 0]
  | Gap z1 d1 z2 d2 g, _ =>
      [Row false (Form (- (2 * z1 / (z1 + d1))) (2 * z2 / (z2 + d2)) (-1) 1) g]
  end.

Fixpoint weighed (ms : list Q) (rs : list row) : option (form * Q) :=
  match ms, rs with
  | [], _ => Some (zero, 0)
  | m :: ms', r :: rs' =>
      if (equality r || Qle_bool 0 m)%bool then
        match weighed ms' rs' with
        | Some (f, c) => Some (plus f (times m (theForm r)), add c (mul m (constant r)))
        | None => None
        end
      else None
  | _ :: _, [] => None
  end.

(** Multipliers of one step: of each node that has some, its number and those of its rows. *)
Fixpoint withRows (ns : list node) (ss : list status) (listed : list (nat * list Q)) (fs : list form)
    (c : Q) : option (list form * Q) :=
  match listed with
  | [] => Some (fs, c)
  | (k, ms) :: rest =>
      match nth_error ns k with
      | Some n =>
          match weighed ms (rowsOf n (nth k ss Open)) with
          | Some (f, d) => withRows ns ss rest (plusAt k f fs) (add c d)
          | None => None
          end
      | None => None
      end
  end.

(** All steps: [fs] is the form at the end. *)
Fixpoint pulled (ns : list node) (steps : list (list status)) (listed : list (list (nat * list Q)))
    (fs : list form) : option (list form * Q) :=
  match steps with
  | [] => Some (fs, 0)
  | ss :: rest =>
      match pulled ns rest (tl listed) fs with
      | Some (gs, c) => withRows ns ss (hd [] listed) (pull 0 ns ss gs) c
      | None => None
      end
  end.

(** What holds at t = 0. Of each node: multipliers of the cell at its right, of "both faces are one", and
    of "a clamp is at 0". [left] is that of the cell at the left of the first. *)
Fixpoint joining (left : Q) (ns : list node) (listed : list (Q * Q * Q)) : list form :=
  match ns with
  | [] => []
  | n :: ns' =>
      let '(a, b, c) := hd (0, 0, 0) listed in
      let cell := match ns' with [] => 0 | _ => a end in
      let one := match n with Gap _ _ _ _ _ => 0 | _ => b end in
      let held := match n with Clamp _ => c | _ => 0 end in
      Form left (- cell) (add (add left (- one)) held) (add one (- cell)) :: joining cell ns' (tl listed)
  end.

Record certificate := Certificate {
  inSteps : list (list (nat * list Q));   (** rows of each step *)
  atStart : list (Q * Q * Q);             (** rows at t = 0 *)
  atEnd : list form                       (** the state returns: a factor for each component *)
}.

(** Form and constant with form + constant >= 0 for every motion. *)
Definition summed (ns : list node) (steps : list (list status)) (c : certificate)
    : option (list form * Q) :=
  match pulled ns steps (inSteps c) (atEnd c) with
  | Some (fs, d) =>
      Some (plusAll (plusAll fs (map (times (-1)) (atEnd c))) (joining 0 ns (atStart c)), d)
  | None => None
  end.

(** ** What sums prove *)

Definition is_zero_form (f : form) : bool :=
  is_zero (ofLeft f) && is_zero (ofRight f) && is_zero (ofLeftFace f) && is_zero (ofRightFace f).

(** No motion. *)
Definition check (ns : list node) (steps : list (list status)) (c : certificate) : bool :=
  match summed ns steps c with
  | Some (fs, d) => forallb is_zero_form fs && negb (Qle_bool 0 d)
  | None => false
  end.

(** factor^2/weight. *)
Definition square (f w : Q) : option Q :=
  if is_zero f then (if Qle_bool 0 w then Some 0 else None)
  else if Qle_bool w 0 then None else Some (mul (mul f f) (Qred (/ w))).

Fixpoint squares (ws : list (Q * Q)) (fs : list form) : option Q :=
  match ws with
  | [] => if forallb is_zero_form fs then Some 0 else None
  | w :: ws' =>
      let f := first fs in
      match square (ofLeft f) (fst w), square (ofRight f) (snd w), squares ws' (tl fs) with
      | Some a, Some b, Some c =>
          if (is_zero (ofLeftFace f) && is_zero (ofRightFace f))%bool then Some (add (add a b) c) else None
      | _, _, _ => None
      end
  end.

(** An energy that no motion is below: from form >= -constant > 0, constant^2/(sum of factor^2/weight). *)
Definition leastEnergy (ws : list (Q * Q)) (ns : list node) (steps : list (list status))
    (c : certificate) : option Q :=
  match summed ns steps c with
  | Some (fs, d) =>
      match squares ws fs with
      | Some s =>
          let t := Qred (- d / s) in
          if Qle_bool 0 t then Some (add (mul (mul 2 t) (- d)) (- (mul (mul t t) s))) else None
      | None => None
      end
  | None => None
  end.

Definition checkLeast (ws : list (Q * Q)) (ns : list node) (steps : list (list status))
    (c : certificate) (bound : Q) : bool :=
  match leastEnergy ws ns steps c with Some e => Qle_bool bound e | None => false end.
