(* The kinds of certificates that `signorini find` writes, as multipliers of rows of contact and
   flight: "paper", "lumped", "network", "joints" (docs/certificates.md). *)

open Answer
open Rows

let half = Q.of_ints 1 2
let place_of scene stop = Option.get (scene.places stop)
let stop_of scene k = let (stop, _, _) = List.nth scene.phases k in stop
let sides scene = Array.of_list (List.map (fun (stop, _, _) -> stop) scene.phases)

(* Half the tip's way, in cells, from one place to another. *)
let way scene from to_ = Q.mul (Q.div (Q.of_int scene.cells) (Q.of_int 2)) (Q.sub to_ from)

let non_negative what list =
  List.iter (fun (row, value) -> if Q.sign value < 0 then refuse "%s: row %d has a negative multiplier" what row) list;
  list

(* Steps of contact and of flight, through all phases. *)
let numbered rows wanted =
  let steps = ref [] in
  Array.iteri (fun m held -> if held = wanted then steps := m :: !steps) rows.held;
  Array.of_list (List.rev !steps)

let pick what table row =
  if row < Array.length table then table.(row) else refuse "%s: there is no row %d" what row

(* rows "paper": multipliers of (30)-(32) as they are; those of (30) come back. *)
let paper scene rows taken certificate =
  let multipliers_of name = multipliers name (certificate name) in
  if Q.sign (fraction "size" (certificate "size")) <> 0 then refuse "size: its row is there only without a gap";
  place taken 0 (Q.neg (fraction "gap" (certificate "gap")));
  let contacts = numbered rows true and flights = numbered rows false in
  List.iter (fun (row, value) -> take taken.push (pick "pressure" contacts row) (Q.mul half value))
    (non_negative "pressure" (multipliers_of "pressure"));
  List.iter (fun (row, value) -> way_at_most rows taken (pick "penetration" flights row) value)
    (non_negative "penetration" (multipliers_of "penetration"));
  (match certificate "landing" with
   | `Null -> ()
   | list -> List.iter (fun (k, value) ->
       if k >= List.length scene.phases - 1 then refuse "landing: there is no row %d" k;
       landing taken k value) (multipliers "landing" list));
  let y = Array.make (2 * scene.cells) Q.zero in
  List.iter (fun (row, value) ->
      if row >= Array.length y then refuse "periodicity: there is no row %d" row;
      y.(row) <- Q.neg value) (multipliers_of "periodicity");
  y

(* ---- rows "lumped" *)

let folded cells contact free =
  let fold steps length = if steps < length then steps else length + steps mod length in
  (fold contact (2 * cells), fold free (4 * cells))

let rec gcd a b = if b = 0 then a else gcd b (a mod b)

(* Of each step of the cut schedule: what it touches, and its number in the whole one. *)
let cut scene =
  let whole = ref 0 and steps = ref [] in
  List.iter (fun (stop, contact, free) ->
      let c, f = folded scene.cells contact free in
      for m = 0 to c - 1 do steps := (Some stop, !whole + m) :: !steps done;
      for m = 0 to f - 1 do steps := (None, !whole + contact + m) :: !steps done;
      whole := !whole + contact + free) scene.phases;
  Array.of_list (List.rev !steps)

(* Runs of residues: first residue, end, and p/z by step where z is not 0 for all. *)
let runs scene steps =
  let n = Array.length steps in
  let classes = gcd (2 * scene.cells) n in
  let starts = List.sort_uniq compare (0 :: List.concat (List.init n (fun m ->
      let kind m = Option.is_none (fst steps.(m)) in
      if m = 0 || kind m <> kind (m - 1) then [m mod classes] else []))) in
  let rec ends = function
    | [] -> [] | [first] -> [(first, classes)] | first :: (next :: _ as rest) -> (first, next) :: ends rest in
  let live (first, end_) =
    let signs = Hashtbl.create 16 in
    let rec go m sign =
      if Hashtbl.mem signs m then sign
      else begin
        Hashtbl.add signs m sign;
        go ((m + 2 * scene.cells) mod n) (if fst steps.(m) <> None then sign else - sign)
      end in
    if go first 1 <> 1 then None
    else begin
      let asks = Hashtbl.fold (fun m sign found -> match fst steps.(m) with
          | Some Right -> sign :: found | Some Left -> (- sign) :: found | None -> found) signs [] in
      let both = List.mem 1 asks && List.mem (-1) asks in
      if both then None
      else begin
        if List.mem (-1) asks then Hashtbl.filter_map_inplace (fun _ sign -> Some (- sign)) signs;
        Some (first, end_, signs)
      end
    end in
  (classes, List.filter_map live (ends starts))

(* The inequalities in their order: what each asks, and of which step. *)
let lumped_inequalities scene floor steps =
  let classes, live = runs scene steps in
  let live = Array.of_list live in
  let run_of = Array.make classes (-1) in
  Array.iteri (fun t (first, _, _) -> run_of.(first) <- t) live;
  let seen = Hashtbl.create 64 and found = ref [] in
  let n = Array.length steps in
  let prefix = ref [||] and source = ref Right in
  for m = 0 to n - 1 do
    match fst steps.(m) with
    | Some stop -> source := stop; prefix := Array.make (Array.length live) Z.zero
    | None ->
      let t = run_of.(m mod classes) in
      if t >= 0 then begin
        let (first, end_, signs) = live.(t) in
        let p = Array.copy !prefix in
        p.(t) <- Z.add p.(t) (Z.of_int (Hashtbl.find signs m));
        prefix := p;
        let last = snd steps.(m + end_ - first - 1) in
        let offer factor bound what =
          let row = (Array.to_list (Array.map (fun c -> Z.to_string (Z.mul factor c)) p), Q.to_string bound) in
          if Array.exists (fun c -> Z.sign c <> 0) p && not (Hashtbl.mem seen row) then begin
            Hashtbl.add seen row ();
            found := (what, last) :: !found
          end in
        let from = place_of scene !source in
        let bound stop = way scene from (place_of scene stop) in
        let high = bound Right in
        offer high.Q.den (Q.of_bigint high.Q.num) (`Below high.Q.den);
        if scene.places Left <> None then begin
          let low = bound Left in
          offer (Z.neg low.Q.den) (Q.of_bigint (Z.neg low.Q.num)) (`Above low.Q.den)
        end;
        (match floor with
         | Some floor -> offer Z.minus_one (way scene floor from) (`Above Z.one)
         | None -> ())
      end
  done;
  Array.of_list (List.rev !found)

let lumped scene rows floor taken certificate =
  let steps = cut scene in
  let sides = sides scene in
  List.iter (fun (row, value) ->
      let scaled bound = Q.mul value (Q.of_bigint bound.Q.den) in
      if row = 0 then
        place taken 0 (scaled (Q.mul (Q.of_int scene.cells) (place_of scene sides.(0))))
      else if row < Array.length sides then
        landing taken (row - 1)
          (scaled (way scene (place_of scene sides.(row - 1)) (place_of scene sides.(row))))
      else refuse "equalities: there is no row %d" row) (multipliers "equalities" (certificate "equalities"));
  let inequalities = lumped_inequalities scene floor steps in
  List.iter (fun (row, value) ->
      match pick "inequalities" inequalities row with
      | `Below factor, m -> way_at_most rows taken m (Q.mul value (Q.of_bigint factor))
      | `Above factor, m -> way_at_least rows taken m (Q.mul value (Q.of_bigint factor)))
    (non_negative "inequalities" (multipliers "inequalities" (certificate "inequalities")))

(* ---- rows "network" *)

(* Lists of [contact, step, multiplier]; contacts in the order of docs/certificates.md. Those of (30) are found
   anew. A distance is that of the rows of contact and flight, or is told by them; a guess, as all but the checker. *)
let network scene rows floor taken certificate =
  let steps = Array.length rows.held in
  let contacts = Array.of_list (
      [`Stop Right] @ (if scene.places Left = None then [] else [`Stop Left]) @ (if floor = None then [] else [`Floor])) in
  let listed name = List.map (function
      | `List [contact; step; value] ->
        let contact = count name contact and step = count name step in
        if contact < 1 || contact > Array.length contacts || step >= steps then
          refuse "%s: there is no contact %d with a step %d" name contact step;
        (contacts.(contact - 1), step, Q.of_float (double name value))
      | _ -> refuse "%s: not lists [contact, step, multiplier]" name) (items name (certificate name)) in
  let waves = items "periodicity" (certificate "periodicity") in
  List.iter (fun wave -> ignore (double "periodicity" wave)) waves;
  if List.length waves <> 2 * scene.cells then refuse "periodicity: not one for each wave";
  let (_, _, last) = List.nth scene.segments (List.length scene.segments - 1) in
  List.iter (fun (contact, m, value) ->
      if not rows.held.(m) || contact <> `Stop (stop_of scene (phase rows m)) || Q.sign value < 0 then
        refuse "pushes: allowed >= 0 in steps of contact";
      take taken.push m (Q.mul last value)) (listed "pushes");
  List.iter (fun (contact, m, value) ->
      let upper = contact = `Stop Right in
      let before = (m + steps - 1) mod steps in
      let k = phase rows m in
      let equal k = place taken k (if upper then Q.neg value else value) in
      if rows.starts.(k) = m && contact = `Stop (stop_of scene k) then equal k
      else if rows.held.(before) then begin
        let k = phase rows before in
        if contact = `Stop (stop_of scene k) then equal k
        else if Q.sign value <> 0 then refuse "places: a distance between two stops"
      end
      else take (if upper then taken.high else taken.low) before value) (listed "places")

(* ---- rows "joints" *)

(* Blocks in the order of time: kind, turn, phase, flight?, last of it?, first step, steps. *)
let blocks scene unit_ =
  let cuts, n = List.fold_left (fun (cuts, step) (_, c, f) ->
      ((step mod unit_) :: ((step + c) mod unit_) :: cuts, step + c + f)) ([0], 0) scene.phases in
  let kinds = Array.of_list (List.sort_uniq compare cuts) in
  let next residue =
    Array.fold_left (fun best k -> if k > residue && k < best then k else best) unit_ kinds in
  let index residue = let t = ref 0 in Array.iteri (fun i k -> if k = residue then t := i) kinds; !t in
  let found = ref [] and step = ref 0 in
  List.iteri (fun k (_, c, f) ->
      List.iter (fun (steps, flies) ->
          let end_ = !step + steps in
          while !step < end_ do
            let residue = !step mod unit_ in
            let width = next residue - residue in
            found := (index residue, !step / unit_, k, flies, !step + width = end_, !step, width) :: !found;
            step := !step + width
          done) [(c, false); (f, true)]) scene.phases;
  (kinds, n / unit_, List.rev !found)

let joints scene rows limits taken certificate =
  let n = Array.length rows.held in
  let unit_ = List.fold_left (fun unit_ (cells, _, _) -> gcd unit_ (2 * cells)) n scene.segments in
  let kinds, turns, blocks = blocks scene unit_ in
  let per_step = max 1 (2 * (List.length scene.segments - 1)) in
  let waves = Array.length kinds * turns * per_step in
  let flights = List.length (List.filter (fun (_, _, _, flies, _, _, _) -> flies) blocks) in
  let equalities = multipliers "equalities" (certificate "equalities") in
  let table = Hashtbl.create 256 in
  List.iter (fun (row, value) ->
      if row > waves + flights then refuse "equalities: there is no row %d" row;
      Hashtbl.replace table row value) equalities;
  let equality row = found table row in
  place taken 0 (equality (waves + flights));
  let pushes = Array.of_list (List.filter (fun (_, _, _, flies, _, _, _) -> not flies) blocks) in
  List.iter (fun (row, value) ->
      let (_, _, _, _, _, first, width) = pick "inequalities" pushes row in
      for m = first to first + width - 1 do take taken.push m (Q.mul half value) done)
    (non_negative "inequalities" (multipliers "inequalities" (certificate "inequalities")));
  (* Prefix sums: the coefficient of y is that of its row, less that of the next one in its flight. *)
  let y = ref waves in
  List.iter (fun (_, _, k, flies, last, first, width) ->
      if flies then begin
        let c = Q.sub (equality !y) (if last then Q.zero else equality (!y + 1)) in
        let m = first + width - 1 in
        incr y;
        if last && k + 1 < List.length scene.phases then landing taken k (Q.neg c)
        else if Q.sign c < 0 then way_at_most rows taken m (Q.neg c)
        else if Q.sign c > 0 then
          if limits.lowest = None then refuse "the rows do not cancel" else way_at_least rows taken m c
      end) blocks
