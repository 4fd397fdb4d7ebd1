(* What is left of a sum of rows is taken away by (30), and by rows of contact where a sum of waves has a
   sign: multipliers that docs/certificates.md leaves to the reader. A guess, as all but the checker. *)

open Rows

(* Unknowns that W mixes, each such part with the kernel of W - 1 on it. *)
type part = { unknowns : int array; kernel : Q.t Ints.t list }

let dot (f : form) v =
  Ints.fold (fun i a sum -> match Ints.find_opt i v with Some b -> Q.add sum (Q.mul a b) | None -> sum)
    f.of_wave Q.zero

(* Reduced rows, in place; the columns of their leading ones. *)
let reduce rows columns =
  let lead = ref [] and at = ref 0 in
  for column = 0 to columns - 1 do
    let pivot = ref !at in
    while !pivot < Array.length rows && Q.sign rows.(!pivot).(column) = 0 do incr pivot done;
    if !pivot < Array.length rows then begin
      let row = rows.(!pivot) in
      rows.(!pivot) <- rows.(!at);
      let factor = Q.inv row.(column) in
      rows.(!at) <- Array.map (Q.mul factor) row;
      Array.iteri (fun i other ->
          let value = other.(column) in
          if i <> !at && Q.sign value <> 0 then
            rows.(i) <- Array.mapi (fun j x -> Q.sub x (Q.mul value rows.(!at).(j))) other) rows;
      lead := column :: !lead; incr at
    end
  done;
  List.rev !lead

(* The entries of W - 1 on one part, by rows. *)
let less_one rows unknowns =
  Array.map (fun i ->
      let row = (minus rows.period.(i) (wave i)).of_wave in
      Array.map (fun j -> try Ints.find j row with Not_found -> Q.zero) unknowns) unknowns

(* Is W a signed permutation? Then x'_i = sign x_j. *)
let source rows i =
  match Ints.bindings rows.period.(i).of_wave with [(j, sign)] -> Some (j, sign) | _ -> None

let is_cycle rows unknowns = Array.for_all (fun i -> source rows i <> None) unknowns

let cycle_kernel rows unknowns =
  let first = unknowns.(0) in
  let rec go v i value =
    let v = Ints.add i value v in
    match source rows i with
    | Some (j, sign) when j = first -> if Q.equal value sign then [v] else []
    | Some (j, sign) -> go v j (Q.div value sign)
    | None -> [] in
  go Ints.empty first Q.one

let dense_kernel rows unknowns =
  let matrix = less_one rows unknowns in
  let size = Array.length unknowns in
  let lead = reduce matrix size in
  List.filter_map (fun free ->
      if List.mem free lead then None
      else Some (List.fold_left (fun (v, row) column ->
          let value = Q.neg matrix.(row).(free) in
          ((if Q.sign value = 0 then v else Ints.add unknowns.(column) value v), row + 1))
          (Ints.singleton unknowns.(free) Q.one, 0) lead |> fst))
    (List.init size Fun.id)

let parts rows =
  let size = Array.length rows.period in
  let root = Array.init size Fun.id in
  let rec find i = if root.(i) = i then i else begin root.(i) <- find root.(i); root.(i) end in
  Array.iteri (fun i row -> Ints.iter (fun j _ -> root.(find i) <- find j) row.of_wave) rows.period;
  let members = Array.make size [] in
  for i = size - 1 downto 0 do members.(find i) <- i :: members.(find i) done;
  List.filter_map (fun list ->
      if list = [] then None
      else
        let unknowns = Array.of_list list in
        Some { unknowns; kernel = if is_cycle rows unknowns then cycle_kernel rows unknowns
                 else dense_kernel rows unknowns }) (Array.to_list members)

(* y with target = sum of y_i (W x - x)_i on one part, if there is one; else numbers that do not do. *)
let close rows part (target : form) y =
  let at j = try Ints.find j target.of_wave with Not_found -> Q.zero in
  let unknowns = part.unknowns in
  if is_cycle rows unknowns then begin
    (* x'_i = sign x_j: y_j = sign y_i - target_j; once around the same, or its negative. *)
    let turn value =
      let value = ref value and i = ref unknowns.(0) in
      Array.iter (fun _ ->
          match source rows !i with
          | Some (j, sign) -> y.(!i) <- !value; value := Q.sub (Q.mul sign !value) (at j); i := j
          | None -> ()) unknowns;
      !value in
    let defect = turn Q.zero in
    if Q.sign defect <> 0 then ignore (turn (Q.div defect (Q.of_int 2)))
  end else begin
    let size = Array.length unknowns in
    let matrix = less_one rows unknowns in
    let transposed = Array.init size (fun j ->
        Array.init (size + 1) (fun i -> if i < size then matrix.(i).(j) else at unknowns.(j))) in
    List.iteri (fun row column -> y.(unknowns.(column)) <- transposed.(row).(size)) (reduce transposed size)
  end

(* Rows of contact, and limits of strain, by the part and the sign that they have on its kernel. *)
let cancel scene rows limits taken parts sum =
  let size = Array.length rows.period in
  let part_of = Array.make size None in
  List.iter (fun part -> match part.kernel with
      | [v] when is_cycle rows part.unknowns -> Array.iter (fun i -> part_of.(i) <- Some (part.unknowns.(0), v)) part.unknowns
      | _ -> ()) parts;
  let rows_of = Hashtbl.create 64 in
  let offer table m (form : form) =
    match Ints.bindings form.of_wave with
    | [(i, _)] ->
      (match part_of.(i) with
       | Some (part, v) ->
         let value = dot form v in
         let key = (part, Q.sign value) in
         if not (Hashtbl.mem rows_of key) then Hashtbl.add rows_of key (table, m, form, value)
       | None -> ())
    | _ -> () in
  Array.iteri (fun m held ->
      if held then offer taken.push m (times (push_sign scene (phase rows m)) rows.arrivals.(m))) rows.held;
  (match limits.strain_limit with
   | Some limit ->
     Array.iteri (fun m form ->
         offer taken.strain m (plus (times (Q.of_int 2) form) { zero with constant = limit })) rows.at_clamp
   | None -> ());
  List.fold_left (fun sum part -> match part.kernel with
      | [v] when is_cycle rows part.unknowns ->
        let left = dot sum v in
        (match if Q.sign left = 0 then None else Hashtbl.find_opt rows_of (part.unknowns.(0), - (Q.sign left)) with
         | Some (table, m, form, value) ->
           let factor = Q.neg (Q.div left value) in
           take table m factor;
           plus sum (times factor form)
         | None -> sum)
      | _ -> sum) sum parts

(* The form of least norm that agrees with [sum] on ker(W - 1): with it the bound on the energy is best. *)
let shortest weight parts sum =
  List.fold_left (fun target part ->
      let vectors = Array.of_list part.kernel in
      let size = Array.length vectors in
      let scaled = Array.map (fun v -> { zero with of_wave = Ints.mapi (fun i a -> Q.mul (weight i) a) v }) vectors in
      let system = Array.init size (fun i ->
          Array.init (size + 1) (fun j -> dot (if j < size then scaled.(j) else sum) vectors.(i))) in
      let lead = reduce system size in
      List.fold_left (fun (target, row) column ->
          (plus target (times system.(row).(size) scaled.(column)), row + 1)) (target, 0) lead |> fst)
    zero parts
