(* Scenes and certificates as the checker takes them. *)

open Answer
open Rows

(* ---- numbers of the checker *)

let rec positive n : Proved.positive =
  if Z.equal n Z.one then Proved.XH
  else
    let rest = positive (Z.shift_right n 1) in
    if Z.testbit n 0 then Proved.XI rest else Proved.XO rest

let z n : Proved.z =
  if Z.sign n = 0 then Proved.Z0 else if Z.sign n > 0 then Proved.Zpos (positive n)
  else Proved.Zneg (positive (Z.neg n))

let q (x : Q.t) : Proved.q = { Proved.qnum = z x.Q.num; qden = positive x.Q.den }

let nat =
  let known = ref [| Proved.O |] in
  fun n ->
    if n >= Array.length !known then begin
      let table = Array.make (n + 1) Proved.O in
      for i = 1 to n do table.(i) <- Proved.S table.(i - 1) done;
      known := table
    end;
    !known.(n)

let rec number = function
  | Proved.XH -> Z.one
  | Proved.XO rest -> Z.shift_left (number rest) 1
  | Proved.XI rest -> Z.succ (Z.shift_left (number rest) 1)

let fraction_of (x : Proved.q) =
  let above = match x.Proved.qnum with
    | Proved.Z0 -> Z.zero | Proved.Zpos n -> number n | Proved.Zneg n -> Z.neg (number n) in
  Q.make above (number x.Proved.qden)

(* ---- the scene and the certificate, for the checker *)

type question = { nodes : Proved.node list; steps : Proved.status list list; weights : (Proved.q * Proved.q) list }

let weight scene =
  let table = Array.concat (List.map (fun (cells, _, z) ->
      Array.make cells (Q.div (Q.mul (Q.of_int 2) z) (Q.of_int scene.cells))) scene.segments) in
  fun i -> table.(i mod scene.cells)

let question scene limits =
  let segments = List.map (fun (cells, joint, _) ->
      (nat cells, Option.map (fun (z1, z2, z) -> ((q z1, q z2), q z)) joint)) scene.segments in
  let phases = List.map (fun (stop, contact, free) ->
      (((match stop with Right -> Proved.OnHigh | Left -> Proved.OnLow), nat contact), nat free)) scene.phases in
  let weight = weight scene in
  let end_ = q Q.zero in
  { nodes = Proved.bar (Option.map q limits.strain_limit) segments (Option.map q limits.lowest) (Some (q limits.highest));
    steps = Proved.stepsOf (nat scene.cells) phases;
    weights = List.init (scene.cells + 1) (fun i ->
        ((if i = 0 then end_ else q (weight (i - 1))), (if i = scene.cells then end_ else q (weight i)))) }

let certificate scene rows taken y : Proved.certificate =
  let n = scene.cells in
  let tip = nat n and clamp = nat 0 in
  let zero = q Q.zero in
  let with_contact = Array.make (Array.length rows.starts) Q.zero in
  Array.blit taken.place 0 with_contact 0 (Array.length with_contact);
  let in_steps = List.init (Array.length rows.held) (fun m ->
      let k = phase rows m in
      let here = if rows.starts.(k) = m then with_contact.(k) else Q.zero in
      let push = found taken.push m and low = found taken.low m and high = found taken.high m in
      let strain = found taken.strain m in
      let at_tip =
        if rows.held.(m) then
          if Q.sign here = 0 && Q.sign push = 0 then [] else [(tip, [q here; q push])]
        else if Q.sign low = 0 && Q.sign high = 0 then [] else [(tip, [q low; q high])] in
      if Q.sign strain = 0 then at_tip else (clamp, [q strain]) :: at_tip) in
  (* The place of the tip at t = 0 is the sum of what all cells are longer. *)
  let sum table = Hashtbl.fold (fun _ value sum -> Q.add sum value) table Q.zero in
  let on_place = Q.sub (Q.add (Array.fold_left Q.add Q.zero taken.place) (sum taken.low)) (sum taken.high) in
  let factor = q (Q.neg on_place) in
  let at_start = List.init (n + 1) (fun i ->
      ((factor, if i = n then zero else factor), if i = 0 then factor else zero)) in
  let at_end = List.init (n + 1) (fun i ->
      { Proved.ofLeft = (if i = 0 then zero else q y.(i - 1));
        ofRight = (if i = n then zero else q y.(n + i)); ofLeftFace = zero; ofRightFace = zero }) in
  { Proved.inSteps = in_steps; atStart = at_start; atEnd = at_end }
