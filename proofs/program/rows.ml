(* Rows of a bar as sparse forms of the waves at t = 0, made by carrying symbols through the steps.

   Only a guess comes of them, which the proved checker then judges. *)

module Ints = Map.Make (Int)

type form = { of_wave : Q.t Ints.t; constant : Q.t }  (* a_1 .. a_N, then b_1 .. b_N, from 0 *)

let zero = { of_wave = Ints.empty; constant = Q.zero }
let wave i = { zero with of_wave = Ints.singleton i Q.one }

let plus f g =
  { of_wave = Ints.union (fun _ a b -> let c = Q.add a b in if Q.sign c = 0 then None else Some c) f.of_wave g.of_wave;
    constant = Q.add f.constant g.constant }

let times m f =
  if Q.sign m = 0 then zero
  else { of_wave = Ints.map (Q.mul m) f.of_wave; constant = Q.mul m f.constant }

let minus f g = plus f (times Q.minus_one g)

type t = {
  arrivals : form array;   (* at the tip, in each step *)
  at_clamp : form array;   (* at the clamp *)
  held : bool array;       (* contact or flight *)
  starts : int array;      (* first step of each phase *)
  displacement : form;     (* of the tip, at t = 0 *)
  period : form array;     (* W *)
}

let make (scene : Answer.scene) =
  let n = scene.cells in
  let steps = List.concat_map (fun (_, contact, free) ->
      List.init contact (fun _ -> true) @ List.init free (fun _ -> false)) scene.phases |> Array.of_list in
  let joints = Array.make (n + 1) None in
  ignore (List.fold_left (fun first (cells, joint, _) ->
      joints.(first + cells) <- joint; first + cells) 0 scene.segments);
  let r = ref (Array.init n wave) and l = ref (Array.init n (fun i -> wave (n + i))) in
  let arrivals = Array.make (Array.length steps) zero and at_clamp = Array.make (Array.length steps) zero in
  Array.iteri (fun m held ->
      let r0 = !r and l0 = !l in
      arrivals.(m) <- r0.(n - 1);
      at_clamp.(m) <- l0.(0);
      let r1 = Array.make n zero and l1 = Array.make n zero in
      r1.(0) <- times Q.minus_one l0.(0);
      l1.(n - 1) <- if held then times Q.minus_one r0.(n - 1) else r0.(n - 1);
      for i = 1 to n - 1 do
        match joints.(i) with
        | None -> l1.(i - 1) <- l0.(i); r1.(i) <- r0.(i - 1)
        | Some (z1, z2, z) ->
          let two = Q.of_int 2 in
          let v = plus (times (Q.div (Q.mul two z1) z) r0.(i - 1)) (times (Q.div (Q.mul two z2) z) l0.(i)) in
          l1.(i - 1) <- minus v r0.(i - 1);
          r1.(i) <- minus v l0.(i)
      done;
      r := r1; l := l1) steps;
  let starts = List.rev (fst (List.fold_left (fun (found, step) (_, c, f) -> (step :: found, step + c + f))
                                ([], 0) scene.phases)) in
  let displacement = ref Ints.empty in
  for i = 0 to n - 1 do
    displacement := Ints.add i Q.minus_one (Ints.add (n + i) Q.one !displacement)
  done;
  { arrivals; at_clamp; held = steps; starts = Array.of_list starts;
    displacement = { zero with of_wave = !displacement }; period = Array.append !r !l }

(* ---- multipliers of rows, all with the sign of "something >= 0" *)

type taken = {
  place : Q.t array;                       (* of each phase: place - stop = 0 in its first step *)
  push : (int, Q.t) Hashtbl.t;             (* by step of contact *)
  low : (int, Q.t) Hashtbl.t;              (* by step of flight: place after it - lower limit *)
  high : (int, Q.t) Hashtbl.t;             (* upper limit - place after it *)
  strain : (int, Q.t) Hashtbl.t;           (* by step: 2 x what arrives at the clamp + limit *)
}

let nothing phases =
  let table () = Hashtbl.create 64 in
  { place = Array.make phases Q.zero; push = table (); low = table (); high = table (); strain = table () }

let found table key = try Hashtbl.find table key with Not_found -> Q.zero
let take table key value = Hashtbl.replace table key (Q.add value (found table key))
let place taken k value = taken.place.(k) <- Q.add taken.place.(k) value

(* Which phase a step belongs to. *)
let phase rows m =
  let k = ref (Array.length rows.starts - 1) in
  while rows.starts.(!k) > m do decr k done;
  !k

(* The tip's way from the start of its contact to the end of step m, at least or at most a limit:
   value x (limit - way/2) >= 0 with both counted from that place. *)
let way_at_most rows taken m value =
  take taken.high m (Q.div value (Q.of_int 2)); place taken (phase rows m) (Q.div value (Q.of_int 2))
let way_at_least rows taken m value =
  take taken.low m (Q.div value (Q.of_int 2)); place taken (phase rows m) (Q.neg (Q.div value (Q.of_int 2)))
(* - value x (way of flight k / 2 - half of what it has to be). *)
let landing taken k value =
  place taken (k + 1) (Q.neg (Q.div value (Q.of_int 2))); place taken k (Q.div value (Q.of_int 2))

(* Limits, in cells: of the tip, and of strain. *)
type limits = { lowest : Q.t option; highest : Q.t; strain_limit : Q.t option; stops : Q.t array }

let push_sign (scene : Answer.scene) k =
  match List.nth scene.phases k with (Answer.Right, _, _) -> Q.of_int 2 | _ -> Q.of_int (-2)

(* The sum of rows x multipliers, as a form of the waves at t = 0. *)
let total scene rows limits taken =
  let sum = ref zero and u = ref rows.displacement in
  let add value form = if Q.sign value <> 0 then sum := plus !sum (times value form) in
  let number value = { zero with constant = value } in
  Array.iteri (fun m held ->
      let k = phase rows m in
      if rows.starts.(k) = m then add taken.place.(k) (minus !u (number limits.stops.(k)));
      (match limits.strain_limit with
       | Some limit -> add (found taken.strain m) (plus (times (Q.of_int 2) rows.at_clamp.(m)) (number limit))
       | None -> ());
      if held then add (found taken.push m) (times (push_sign scene k) rows.arrivals.(m))
      else begin
        u := plus !u (times (Q.of_int 2) rows.arrivals.(m));
        (match limits.lowest with
         | Some low -> add (found taken.low m) (minus !u (number low)) | None -> ());
        add (found taken.high m) (minus (number limits.highest) !u)
      end) rows.held;
  !sum

(* All multipliers times one number that makes them whole: the checker then has few fractions to reduce. *)
let made_whole taken y =
  let common = ref Z.one in
  let see (x : Q.t) = common := Z.lcm !common x.Q.den in
  let tables = [taken.push; taken.low; taken.high; taken.strain] in
  Array.iter see taken.place; Array.iter see y;
  List.iter (Hashtbl.iter (fun _ value -> see value)) tables;
  let scale = Q.mul (Q.of_bigint !common) in
  List.iter (Hashtbl.filter_map_inplace (fun _ value -> Some (scale value))) tables;
  ({ taken with place = Array.map scale taken.place }, Array.map scale y)
