(* An answer of `signorini find NC NF ... --format json`: which bar, which schedule, what is claimed.

   Strict: a key that this program does not know, or that is there twice, is refused. Numbers are read as
   docs/certificates.md says; nothing here is proved, so nothing here is clever. *)

exception Refused of string

let refuse format = Printf.ksprintf (fun text -> raise (Refused text)) format

type json = Yojson.Safe.t

(* ---- JSON *)

let members what keys (value : json) =
  match value with
  | `Assoc pairs ->
    List.iteri (fun i (key, _) ->
        if not (List.mem key keys) then refuse "%s: the key %S is not known to this checker" what key;
        if List.exists (fun (other, _) -> other = key) (List.filteri (fun j _ -> j < i) pairs) then
          refuse "%s: the key %S is there twice" what key) pairs;
    fun key -> (try List.assoc key pairs with Not_found -> `Null)
  | _ -> refuse "%s: no object" what

let items what : json -> json list = function `List values -> values | _ -> refuse "%s: no list" what

let whole what : json -> Z.t = function
  | `Int value -> Z.of_int value
  | `Intlit text when String.length text < 100_000 -> Z.of_string text
  | _ -> refuse "%s: no integer" what

let count what value =
  let value = whole what value in
  if Z.lt value Z.zero || Z.gt value (Z.of_int 1_000_000) then refuse "%s: allowed 0 .. 1000000" what;
  Z.to_int value

let double what : json -> float = function
  | `Float value when Float.is_finite value -> value
  | `Int value -> float_of_int value
  | _ -> refuse "%s: no finite number" what

let is_null (value : json) = value = `Null

let all_of allowed text = text <> "" && String.for_all allowed text

(* "-7/12", or an integer. *)
let fraction what (value : json) =
  let digits = all_of (fun c -> c >= '0' && c <= '9') in
  let text = match value with
    | `Int value -> string_of_int value | `Intlit text | `String text -> text
    | _ -> refuse "%s: no fraction" what in
  let unsigned = if text <> "" && text.[0] = '-' then String.sub text 1 (String.length text - 1) else text in
  (match String.split_on_char '/' unsigned with
   | [a] when digits a -> ()
   | [a; b] when digits a && digits b && Z.sign (Z.of_string b) > 0 -> ()
   | _ -> refuse "%s: no fraction" what);
  Q.of_string text

(* Pairs [row, multiplier] of distinct rows. *)
let multipliers what value =
  let seen = Hashtbl.create 64 in
  List.map (fun pair ->
      match pair with
      | `List [row; factor] ->
        let row = count what row in
        if Hashtbl.mem seen row then refuse "%s: row %d is there twice" what row;
        Hashtbl.add seen row ();
        (row, fraction what factor)
      | _ -> refuse "%s: not pairs [row, multiplier]" what) (items what value)

(* ---- doubles as fractions *)

(* The simplest fraction that rounds to this double > 0: the first of its continued fraction, and of the
   fractions between, that lies where doubles round to it. *)
let simplest value =
  let exact = Q.of_float value in
  let half other = Q.div (Q.add exact (Q.of_float other)) (Q.of_int 2) in
  let low = half (Float.pred value) and high = half (Float.succ value) in
  let even = Int64.logand (Int64.bits_of_float value) 1L = 0L in
  let rounds x = if even then Q.leq low x && Q.leq x high else Q.lt low x && Q.lt x high in
  let rec go (p0, q0) (p1, q1) above below =
    let at k = (Z.add p0 (Z.mul k p1), Z.add q0 (Z.mul k q1)) in
    let fits k = let p, q = at k in Z.sign q > 0 && rounds (Q.make p q) in
    let whole = Z.fdiv above below in
    if not (fits whole) then go (p1, q1) (at whole) below (Z.sub above (Z.mul whole below))
    else begin
      let low = ref Z.zero and high = ref whole in
      while Z.lt (Z.succ !low) !high do
        let middle = Z.shift_right (Z.add !low !high) 1 in
        if fits middle then high := middle else low := middle
      done;
      let p, q = at !high in Q.make p q
    end in
  if value = 0. then Q.zero else go (Z.zero, Z.one) (Z.one, Z.zero) exact.Q.num exact.Q.den

(* z1 : z2 : z of a joint, whole numbers below 2^50, docs/certificates.md "Numbers". *)
let joint left right dashpot =
  let exact = List.map simplest [left; right; dashpot] in
  let common = List.fold_left (fun common (x : Q.t) -> Z.lcm common x.Q.den) Z.one exact in
  let most = Z.shift_left Z.one 50 in
  let sum = left +. right +. dashpot in
  let z = if Z.leq common most && sum *. Z.to_float common < Z.to_float most then
      List.map (fun (x : Q.t) -> (Q.mul x (Q.of_bigint common)).Q.num) exact
    else begin
      let unit_ = Z.to_float most /. sum in
      List.map (fun x ->
          let y = Q.add (Q.of_float (x *. unit_)) (Q.of_ints 1 2) in
          Z.fdiv y.Q.num y.Q.den) [left; right; dashpot]
    end in
  match List.map Q.of_bigint z with
  | [a; b; d] -> (a, b, Q.add (Q.add a b) d)
  | _ -> assert false

(* ---- the bar and its schedule *)

type side = Right | Left

type scene = {
  cells : int;
  segments : (int * (Q.t * Q.t * Q.t) option * Q.t) list;  (* cells, joint at the end, Z/Z_1 *)
  places : side -> Q.t option;  (* of the stops, in |g| *)
  phases : (side * int * int) list;
  uniform : bool;
}

type answer = {
  scene : scene;
  status : string;
  objective : string option;
  reason : string option;
  ratio : json;
  range : json list option;
  certificate : json;
}

(* What an answer says besides; read by nobody here. *)
let unread = [
  "schema"; "version"; "static_force"; "period"; "period_ratio"; "frequency_ratio"; "kernel_dimension";
  "solution_set"; "family"; "contact"; "canonical_schedule"; "energy"; "energy_section"; "physical";
  "admissible"; "residuals"; "near_schedule"; "route"; "route_reason"; "left_out"; "solver"; "repetitions";
  "pressing_phases"; "symmetric"; "peak_strain"; "detail" ]

let most_steps = 200_000
let most_moves = 400_000_000

let side what : json -> side = function
  | `String "right" -> Right | `String "left" -> Left | _ -> refuse "%s: no side" what

let read_stops bar stops =
  let gap = double "bar: gap" (bar "gap") in
  let stops = List.map (fun stop ->
      let stop = members "stops" ["side"; "place"] stop in
      (side "stops" (stop "side"), double "stops: place" (stop "place"))) (items "stops" stops) in
  match stops with
  | (Right, right) :: rest when right = gap && gap <> 0. ->
    let sign = Q.of_int (if gap > 0. then 1 else -1) in
    let left = match rest with
      | [] -> None
      | [(Left, place)] when place < 0. && place < right ->
        let place = Q.neg (simplest (-. place /. abs_float gap)) in
        if Q.geq place sign then refuse "stops: the second one is not below the first";
        Some place
      | _ -> refuse "stops: allowed the wall, then one on the left, below 0" in
    (function Right -> Some sign | Left -> left)
  | _ -> refuse "stops: allowed the wall at bar.gap, which is not 0: without a gap this checker knows nothing"

let read_segments cells value =
  let segments = List.map (fun segment ->
      let segment = members "segments" ["cells"; "impedance"; "speed"; "dashpot"] segment in
      let impedance = double "impedance" (segment "impedance") in
      let dashpot = double "dashpot" (segment "dashpot") in
      let speed = double "speed" (segment "speed") in
      if not (impedance > 0. && dashpot >= 0. && speed > 0.) then
        refuse "segments: allowed impedances and speeds > 0, dashpots >= 0";
      (count "segments: cells" (segment "cells"), impedance, dashpot)) (items "segments" value) in
  let total = List.fold_left (fun sum (n, _, _) -> if n < 1 then refuse "segments: no cells"; sum + n) 0 segments in
  if segments <> [] && total <> cells then refuse "segments: not %d cells" cells;
  let first = match segments with (_, z, _) :: _ -> z | [] -> 1. in
  let rec chain = function
    | [] -> [(cells, None, Q.one)]
    | [(n, z, d)] ->
      if d <> 0. then refuse "segments: the last one has a dashpot";
      [(n, None, Q.of_float (z /. first))]
    | (n, z, d) :: ((_, z', _) :: _ as rest) ->
      (n, Some (joint (z /. first) (z' /. first) (d /. first)), Q.of_float (z /. first)) :: chain rest in
  let uniform = List.for_all (fun (_, z, d) -> z = first && d = 0.) segments in
  (chain segments, uniform)

let read_phases places value =
  let phases = List.map (fun phase ->
      let contact, free, stop = match items "schedule" phase with
        | [c; f] -> (c, f, Right) | [c; f; s] -> (c, f, side "schedule" s) | _ -> refuse "schedule" in
      let contact = count "schedule" contact and free = count "schedule" free in
      if contact < 1 || free < 1 then refuse "schedule: allowed n_c >= 1, n_f >= 1";
      if places stop = None then refuse "schedule: a contact on a stop that is not there";
      (stop, contact, free)) (items "schedule" value) in
  if phases = [] then refuse "schedule: empty";
  phases

let read (value : json) =
  let top = members "answer" (unread @ [ "bar"; "stops"; "segments"; "status"; "cells"; "schedule"; "objective"; "reason";
                                         "energy_ratio"; "energy_ratio_range"; "certificate" ]) value in
  let bar = members "bar" ["length"; "wave_speed"; "axial_stiffness"; "gap"; "young"] (top "bar") in
  let cells = count "cells" (top "cells") in
  if cells < 1 then refuse "cells: allowed 1 or more";
  let places = read_stops bar (top "stops") in
  let segments, uniform = read_segments cells (top "segments") in
  let phases = read_phases places (top "schedule") in
  let steps = List.fold_left (fun sum (_, c, f) -> sum + c + f) 0 phases in
  if steps > most_steps || steps * cells > most_moves then
    refuse "schedule: this checker takes up to %d steps, and steps x cells up to %d" most_steps most_moves;
  { scene = { cells; segments; places; phases; uniform };
    status = (match top "status" with `String s -> s | _ -> refuse "status: no text");
    objective = (match top "objective" with `String s -> Some s | `Null -> None | _ -> refuse "objective");
    reason = (match top "reason" with `String s -> Some s | `Null -> None | _ -> refuse "reason");
    ratio = top "energy_ratio";
    range = (match top "energy_ratio_range" with
        | `Null -> None | value -> Some (items "energy_ratio_range" value));
    certificate = top "certificate" }
