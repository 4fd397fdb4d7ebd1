(* Rows of the checker in print, as tests/formal/rows_printer.cpp prints those of our C++. *)

open Answer
open Rows
open Question

let print_row name values =
  print_string (name ^ ":");
  List.iter (fun value -> print_string (" " ^ Q.to_string value)) values;
  print_newline ()

(* ---- "paper N n_c n_f ...": rows (30)-(32) of the chain that files over rows "paper" are about *)

let waves cells (forms : Proved.form list) =
  let forms = Array.of_list forms in
  let at i = if i < Array.length forms then forms.(i) else Proved.zero in
  List.init cells (fun i -> fraction_of (at (i + 1)).Proved.ofLeft) @
  List.init cells (fun i -> fraction_of (at i).Proved.ofRight)

(* The paper's own operators on unit states: C, W and (31) by columns, for one contact. The rows of the chain have to
   be theirs: (10) and (12) halved. *)
let operators cells contact free =
  let state j = List.init (2 * cells) (fun i -> q (if i = j then Q.one else Q.zero)) in
  let waves j = (List.filteri (fun i _ -> i < cells) (state j), List.filteri (fun i _ -> i >= cells) (state j)) in
  let values forms = Array.of_list (List.map fraction_of forms) in
  let columns of_state = Array.init (2 * cells) (fun j -> values (of_state (waves j))) in
  let n = nat cells and c = nat contact and f = nat free in
  let conditions = columns (Proved.conditionsQ n c f) in
  let period = columns (fun x -> let a, b = Proved.periodQ n c f x in a @ b) in
  let opened = columns (fun x -> [Proved.openedQ x]) in
  let row table scale i = List.map (fun column -> Q.mul scale column.(i)) (Array.to_list table) in
  let same name i ours = if not (List.for_all2 Q.equal ours (
      match name with
      | "pressure" -> row conditions Formats.half i
      | "penetration" -> row conditions Formats.half (contact + 1 + i)
      | "period" -> row period Q.one i
      | _ -> row opened Q.one i)) then failwith (Printf.sprintf "%s %d: the paper's operators say something else" name i) in
  if not (List.for_all2 Q.equal (row conditions Q.one contact) (row conditions Q.one (contact + 1))) then
    failwith "(11) is not the first row (12)";
  same

let paper cells phases =
  let same = match phases with
    | [(_, contact, free)] -> operators cells contact free
    | _ -> fun _ _ _ -> () in
  let print_row name i values = same name i values; print_row (Printf.sprintf "%s %d" name i) values in
  let places = function Right -> Some Q.one | Left -> None in
  let scene = { cells; segments = [(cells, None, Q.one)]; places; phases; uniform = true } in
  let rows = Rows.make scene in
  let n = Q.of_int cells in
  let limits = { lowest = None; highest = n; strain_limit = None; stops = Array.make (List.length phases) n } in
  let question = question scene limits in
  let no_end = Array.make (2 * cells) Q.zero in
  (* One row alone, through the checker's own sum: what is left of places must be nothing. *)
  let row ?(end_ = no_end) prepare =
    let taken = Rows.nothing (List.length phases) in
    prepare taken;
    match Proved.summed question.nodes question.steps (certificate scene rows taken end_) with
    | Some (forms, _) ->
      List.iter (fun (form : Proved.form) ->
          if not (Proved.is_zero form.ofLeftFace && Proved.is_zero form.ofRightFace) then failwith "a place is left") forms;
      waves cells forms
    | None -> failwith "no row" in
  let minus = List.map Q.neg in
  let each name wanted prepare =
    Array.iteri (fun i m -> print_row name i (minus (row (fun taken -> prepare taken m))))
      (Formats.numbered rows wanted) in
  each "pressure" true (fun taken m -> take taken.push m Formats.half);
  each "penetration" false (fun taken m -> way_at_most rows taken m Q.one);
  for i = 0 to 2 * cells - 1 do
    let end_ = Array.mapi (fun j _ -> if i = j then Q.one else Q.zero) no_end in
    let less_one = row ~end_ (fun _ -> ()) in
    print_row "period" i (List.mapi (fun j x -> if i = j then Q.add x Q.one else x) less_one)
  done;
  print_row "gap" 0 (row (fun taken -> place taken 0 Q.one))

(* ---- "chain ...": any chain, in the words of rows_printer.cpp *)

let rec take_first n list = if n = 0 then [] else List.hd list :: take_first (n - 1) (List.tl list)

let chain numbers =
  let rest = ref numbers in
  let next () = match !rest with x :: more -> rest := more; x | [] -> failwith "a line ends too early" in
  let fraction () = Q.of_int (next ()) in
  let r = next () in
  let rows = Array.init r (fun _ -> let cells = next () in (cells, fraction ())) in
  let impedance k = if k < 0 || k >= r then Q.zero else snd rows.(k) in
  (* Nodes of the chain, and of each contact its node, status when closed, and the row that tells how far
     it has opened. *)
  let nodes = ref [] and count = ref 0 and contacts = ref [] in
  let add node = nodes := node :: !nodes; incr count in
  for k = 0 to r do
    let z1 = impedance (k - 1) and z2 = impedance k in
    let joint d low high =
      add (Proved.Joint (q z1, q z2, q (Q.add (Q.add z1 z2) d), Option.map q low, Option.map q high)) in
    (match next () with
     | 0 -> add (Proved.Clamp None)
     | 1 -> let d = fraction () in joint d None None
     | 2 -> let d = fraction () in let g = fraction () in
       contacts := (!count, Proved.OnHigh, [Q.zero; Q.one]) :: !contacts; joint d None (Some g)
     | 3 -> let d = fraction () in let g = fraction () in
       contacts := (!count, Proved.OnLow, [Q.one]) :: !contacts; joint d (Some (Q.neg g)) None
     | _ -> let d1 = fraction () in let d2 = fraction () in let g = fraction () in
       contacts := (!count, Proved.Shut, [Q.one]) :: !contacts;
       add (Proved.Gap (q z1, q d1, q z2, q d2, q g)));
    if k < r then for _ = 2 to fst rows.(k) do add Proved.Through done
  done;
  let nodes = List.rev !nodes and contacts = List.rev !contacts in
  let steps = List.init (next ()) (fun _ ->
      let closed = next () in
      List.init !count (fun node ->
          let rec find j = function
            | [] -> Proved.Open
            | (at, status, _) :: _ when at = node && (closed lsr j) land 1 = 1 -> status
            | _ :: rest -> find (j + 1) rest in
          find 0 contacts)) in
  (* Row by row, what runs to the right, then what runs to the left. *)
  let in_order forms =
    let cells = !count - 1 in
    let all = Array.of_list (waves cells forms) in
    let first = ref 0 in
    List.concat_map (fun (n, _) ->
        let from = !first in
        first := from + n;
        List.init n (fun i -> all.(from + i)) @ List.init n (fun i -> all.(cells + from + i))) (Array.to_list rows) in
  List.iteri (fun m _ ->
      List.iteri (fun j (node, status, opened) ->
          let now = List.nth (List.nth steps m) node in
          let multipliers = List.map q (if now = status then [Q.zero; Q.one] else opened) in
          let listed = List.init (m + 1) (fun i -> if i = m then [(nat node, multipliers)] else []) in
          match Proved.pulled nodes (take_first (m + 1) steps) listed [] with
          | Some (forms, _) -> print_row (Printf.sprintf "row %d %d" m j) (in_order forms)
          | None -> failwith "no row") contacts) steps;
  let index = ref 0 in
  let at_end form_at =
    (match Proved.pulled nodes steps [] (List.init !count form_at) with
     | Some (forms, _) -> print_row (Printf.sprintf "end %d" !index) (in_order forms)
     | None -> failwith "no row");
    incr index in
  let one = q Q.one in
  let first = ref 0 in
  Array.iter (fun (n, _) ->
      for i = !first + 1 to !first + n do
        at_end (fun node -> if node = i then { Proved.zero with Proved.ofLeft = one } else Proved.zero)
      done;
      for i = !first to !first + n - 1 do
        at_end (fun node -> if node = i then { Proved.zero with Proved.ofRight = one } else Proved.zero)
      done;
      first := !first + n) rows

let rows channel =
  try
    while true do
      let words = String.split_on_char ' ' (String.trim (input_line channel)) in
      let numbers = List.map int_of_string (List.tl words) in
      (match List.hd words, numbers with
       | "paper", cells :: steps ->
         let rec phases = function
           | contact :: free :: rest -> (Right, contact, free) :: phases rest | _ -> [] in
         paper cells (phases steps)
       | _ -> chain numbers);
      print_endline "."
    done
  with End_of_file -> ()
