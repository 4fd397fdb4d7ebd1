(* Networks of Network.v for tests/formal/networks_proved.py: their rows in print, and what checkNetwork says.

   Lines: "rows NETWORK STEPS", "check NETWORK STEPS CERTIFICATE".
   NETWORK: cells and of each its left and right node and impedance; nodes and of each 1 for a clamp and the
   dashpot; contacts and of each 0, node, place (right stop), 1, node, place (left stop) or 2, two nodes, gap.
   STEPS: how many, and of each a set of closed contacts. CERTIFICATE: of each step two lists of multipliers,
   then those of the start and of the return; a list is its length and its items. *)

open Question

let words line = ref (List.filter (( <> ) "") (String.split_on_char ' ' line))
let word rest = match !rest with x :: more -> rest := more; x | [] -> failwith "a line ends too early"
let whole rest = int_of_string (word rest)
let fraction rest = q (Q.of_string (word rest))
let index rest = nat (whole rest)
let many rest item = let count = whole rest in List.init count (fun _ -> item rest)

let network rest : Proved.network =
  let cell rest = let leftEnd = index rest in let rightEnd = index rest in
    { Proved.leftEnd; rightEnd; impedance = fraction rest } in
  let meeting rest = let clamped = whole rest = 1 in { Proved.clamped; dashpot = fraction rest } in
  let contact rest = match whole rest with
    | 0 -> let node = index rest in Proved.StopRight (node, fraction rest)
    | 1 -> let node = index rest in Proved.StopLeft (node, fraction rest)
    | _ -> let left = index rest in let right = index rest in Proved.GapBetween (left, right, fraction rest) in
  let cells = many rest cell in
  let meetings = many rest meeting in
  { Proved.cells; meetings; contacts = many rest contact }

let steps rest (network : Proved.network) =
  many rest (fun rest ->
      let closed = whole rest in List.mapi (fun j _ -> (closed lsr j) land 1 = 1) network.contacts)

let certificate rest count : Proved.sumCertificate =
  let list () = many rest fraction in
  let ofSteps = List.init count (fun _ -> let equations = list () in (equations, list ())) in
  let ofStart = list () in
  { Proved.ofSteps; ofStart; ofReturn = list () }

let rec to_int = function Proved.O -> 0 | Proved.S n -> 1 + to_int n

let print_form name form constant =
  print_string (name ^ " " ^ Q.to_string constant);
  List.iter (fun (i, c) -> Printf.printf " %d %s" (to_int i) (Q.to_string (fraction_of c))) form;
  print_newline ()

let print_rows name = List.iter (fun (form, constant) -> print_form name form (fraction_of constant))

let answer line =
  let rest = words line in
  let kind = word rest in
  let network = network rest in
  let steps = steps rest network in
  match kind with
  | "rows" ->
    print_rows "equation" (Proved.startRows network);
    List.iter (fun closed ->
        print_endline "step";
        let step = Proved.stepOf network closed in
        List.iter (fun form -> print_form "next" form Q.zero) step.Proved.next;
        print_rows "equation" step.Proved.equations;
        print_rows "inequality" step.Proved.inequalities) steps;
    print_endline "."
  | _ ->
    let certificate = certificate rest (List.length steps) in
    print_endline (if Proved.checkNetwork network steps certificate then "proved" else "no proof")

let answers channel = try while true do answer (input_line channel) done with End_of_file -> ()
