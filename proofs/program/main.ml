(* tools/check-proved: reads answers, guesses the multipliers that are not written down, and asks the
   checker that Coq has proved (Proved, extracted from Checker.v). Nothing else says yes. *)

open Answer
open Rows
open Question

let usage = "usage: check-proved FILE.json...     \"-\" reads standard input\n\
       \       check-proved --rows < LINES       tests/formal/rows_compared.py\n\
       \       check-proved --networks < LINES   tests/formal/networks_proved.py\n"

(* ---- what a file claims, in words *)

let phases_in_words scene =
  String.concat ", " (List.map (fun (stop, contact, free) ->
      Printf.sprintf "%d on the %s and %d free" contact (if stop = Right then "wall" else "second stop") free) scene.phases)

let scene_in_words scene limits =
  let segments = match scene.segments with
    | [_] -> Printf.sprintf "a bar of %d cells" scene.cells
    | list -> Printf.sprintf "a bar of %s cells, joints %s"
                (String.concat " + " (List.map (fun (n, _, _) -> string_of_int n) list))
                (String.concat ", " (List.filter_map (fun (_, joint, _) -> Option.map (fun (a, b, z) ->
                     String.concat ":" (List.map Q.to_string [a; b; z])) joint) list)) in
  let cells value = Q.to_string (Q.div value (Q.of_int scene.cells)) in
  Printf.sprintf "%s, wall at %s%s%s; steps: %s" segments (cells limits.highest)
    (match limits.lowest with Some low -> ", tip not below " ^ cells low | None -> "")
    (match limits.strain_limit with Some s -> ", strain not below -" ^ Q.to_string s | None -> "")
    (phases_in_words scene)

let near value exact tolerance =
  match value with
  | `Null -> false
  | value -> let x = Q.of_float (double "energy" value) in
    Q.leq (Q.abs (Q.sub x exact)) (Q.mul exact tolerance)

let tenth_to k = (if k < 0 then Fun.id else Q.inv) (Q.of_bigint (Z.pow (Z.of_int 10) (abs k)))

let float_of x = Printf.sprintf "%.15g" (Q.to_float x)

(* The least energy that was proved, against what the answer claims. *)
let judge_energy answer member ~knows_most tolerance least =
  (match answer.range with
   | Some [_; most] when most <> `Null && not knows_most -> refuse "energy_ratio_range: of its upper end nothing can be known"
   | Some [lower; _] when near lower least tolerance -> ()
   | _ -> refuse "energy_ratio_range: its lower end is not near %s, which is proved" (float_of least));
  let said = Printf.sprintf "every motion has E/E_1 >= %s" (float_of least) in
  match answer.status with
  | "none" ->
    let wanted = Q.of_float (double "energy_ratio" (member "energy_ratio")) in
    if Q.geq wanted (Q.mul least (Q.sub Q.one tolerance)) then
      refuse "%s, and %s is no less; of most energies this checker knows nothing" said (float_of wanted);
    Printf.sprintf "%s, so none has %s" said (float_of wanted)
  | _ ->
    if answer.objective = Some "max-energy" then refuse "%s; of most energies this checker knows nothing" said;
    if answer.objective = Some "min-energy" && not (near answer.ratio least (tenth_to 7)) then
      refuse "energy_ratio: not near %s, which is proved" (float_of least);
    (match member "energy_ratio" with
     | `Null -> ()
     | value -> if not (near value least (tenth_to 7)) then refuse "certificate: energy_ratio");
    said ^ "; that a motion with it exists is not checked here, nor the most energy"

(* That no motion has less energy than is claimed: more than any bar bears, or, where the reason is a
   constraint, than the one that was to be held. *)
let judge_floor answer member least =
  let claimed = Q.of_float (double "energy_ratio" (member "energy_ratio")) in
  let lowest = if answer.reason = Some "constraints" then Q.zero else tenth_to (-9) in
  if answer.ratio <> `Null || answer.range <> None then refuse "energies of no motion";
  if Q.lt claimed lowest then refuse "energy_ratio: allowed %s or more" (float_of lowest);
  if Q.gt claimed least then refuse "energy_ratio: %s, and %s is proved" (float_of claimed) (float_of least);
  Printf.sprintf "none has E/E_1 below %s" (float_of claimed)

(* ---- one answer *)

let limits_of scene member =
  let optional name = match member name with
    | `Null -> None | value -> Some (Q.of_float (double name value)) in
  let n = Q.of_int scene.cells in
  let strain_limit = optional "strain_limit" and floor = optional "tip_floor" in
  (match strain_limit with Some s when Q.sign s <= 0 -> refuse "strain_limit: allowed > 0" | _ -> ());
  (match floor with
   | Some f when Q.geq f (Formats.place_of scene Right) -> refuse "tip_floor: allowed below the wall" | _ -> ());
  let on_left = List.exists (fun (stop, _, _) -> stop = Left) scene.phases in
  let left = scene.places Left in
  let lowest = match left, floor with
    | Some l, Some f when Q.gt f l && on_left -> refuse "tip_floor: above a stop with contacts; not known to this checker"
    | Some l, Some f -> Some (Q.max l f)
    | None, floor -> floor
    | left, None -> left in
  (floor,
   { lowest = Option.map (Q.mul n) lowest; strain_limit;
     highest = Q.mul n (Formats.place_of scene Right);
     stops = Array.map (fun stop -> Q.mul n (Formats.place_of scene stop)) (Formats.sides scene) })

let certificate_keys = [
  "kind"; "verified"; "rows"; "gap"; "size"; "periodicity"; "pressure"; "penetration"; "landing"; "strain_limit";
  "tip_floor"; "equalities"; "inequalities"; "energy_ratio"; "state"; "places"; "pushes" ]

(* "state" is the motion of the least energy, which is not looked at here, and the yes says so. *)
let keys_of_rows = function
  | "paper" -> [ "gap"; "size"; "periodicity"; "pressure"; "penetration"; "landing" ]
  | "lumped" -> [ "strain_limit"; "tip_floor"; "equalities"; "inequalities"; "energy_ratio" ]
  | "network" -> [ "tip_floor"; "periodicity"; "places"; "pushes"; "energy_ratio"; "state" ]
  | "joints" -> [ "tip_floor"; "equalities"; "inequalities" ]
  | rows -> refuse "certificate: rows %S are not known to this checker" rows

let text what : json -> string = function `String s -> s | _ -> refuse "%s: no text" what

let proved answer =
  let scene = answer.scene in
  let rows_name = text "rows" (members "certificate" certificate_keys answer.certificate "rows") in
  let member = members "certificate" ("kind" :: "verified" :: "rows" :: keys_of_rows rows_name) answer.certificate in
  let kind = text "kind" (member "kind") in
  let is_network = rows_name = "network" in
  let is_stepped = is_network || rows_name = "joints" in
  if not is_stepped && not scene.uniform then refuse "rows: of other segments they are \"network\" or \"joints\"";
  let scene = if is_stepped then scene
    else { scene with segments = [(scene.cells, None, Q.one)] } in
  let floor, limits = limits_of scene member in
  let rows = Rows.make scene in
  let taken = Rows.nothing (List.length scene.phases) in
  let y = match rows_name with
    | "paper" -> Formats.paper scene rows taken member
    | "lumped" -> Formats.lumped scene rows floor taken member; [||]
    | "network" -> Formats.network scene rows floor taken member; [||]
    | _ -> Formats.joints scene rows limits taken member; [||] in
  let y =
    if rows_name = "paper" then y
    else begin
      let sum = Rows.total scene rows limits taken in
      let parts = Solve.parts rows in
      let sum = if rows_name = "lumped" then Solve.cancel scene rows limits taken parts sum else sum in
      let target = if kind = "farkas" then Rows.zero else Solve.shortest (weight scene) parts sum in
      let y = Array.make (2 * scene.cells) Q.zero in
      List.iter (fun part -> Solve.close rows part (Rows.minus target sum) y) parts;
      y
    end in
  let taken, y = Rows.made_whole taken y in
  let question = question scene limits in
  let certificate = certificate scene rows taken y in
  let words = scene_in_words scene limits in
  match kind, answer.status with
  | "farkas", "none" ->
    if answer.ratio <> `Null || answer.range <> None then refuse "energies of no motion";
    if not (Proved.check question.nodes question.steps certificate) then
      refuse "the multipliers do not contradict each other";
    Printf.sprintf "no motion of %s" words
  | "energy-floor", "none" when is_network && Proved.check question.nodes question.steps certificate ->
    ignore (judge_floor answer member (tenth_to (-400)));
    Printf.sprintf "no motion of %s" words
  | ("energy-floor", ("none" | "found") | "energy-range", ("none" | "found"))
    when rows_name = (if kind = "energy-floor" then "network" else "lumped") ->
    (match Proved.leastEnergy question.weights question.nodes question.steps certificate with
     | Some least ->
       let least = fraction_of least in
       Printf.sprintf "of %s: %s" words
         (if is_network && answer.status = "none" then judge_floor answer member least
          else judge_energy answer member ~knows_most:(not is_network) (tenth_to (if is_network then 7 else 12)) least)
     | None -> refuse "the multipliers bound no energy")
  | _ -> refuse "certificate: kind %S with status %S is not known to this checker" kind answer.status

let () =
  let files = List.tl (Array.to_list Sys.argv) in
  if files = ["--rows"] then begin Printed.rows stdin; exit 0 end;
  if files = ["--networks"] then begin Networks.answers stdin; exit 0 end;
  let bad file = String.length file > 1 && file.[0] = '-' in
  if files = [] || List.exists bad files then begin prerr_string usage; exit 2 end;
  let status = ref 0 in
  List.iter (fun file ->
      let say verdict text = Printf.printf "%s: %s: %s\n" file verdict text in
      match
        let json = if file = "-" then Yojson.Safe.from_channel stdin else Yojson.Safe.from_file file in
        proved (read json)
      with
      | text -> say "proved" text
      | exception Refused why -> say "no proof" why; if !status = 0 then status := 1
      | exception Stack_overflow -> say "no proof" "too large for this checker"; if !status = 0 then status := 1
      | exception (Sys_error why | Yojson.Json_error why | Failure why) ->
        Printf.eprintf "%s: %s\n" file why; status := 2) files;
  exit !status
