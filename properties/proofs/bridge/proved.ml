(* SPDX-License-Identifier: BSL-1.0 *)

(* An oracle whose specification is proved: the laws of properties/proofs over the rational numbers.
   Without an argument: reads collisions, one a line, and writes the answers of all laws, one line each.
   With the name of a law: a subject of Carom's protocol that follows it, each component rounded to binary64. *)

(* Zarith's Z, which the extracted module Z would hide. *)
module Integer = Z
open Answers

let exact x = Q.make x.qnum x.qden

(* p + q √s. *)
type number = { rational : Q.t; coefficient : Q.t; radicand : Q.t }

let numbers = function
  | `Rational v -> List.map (fun x -> { rational = exact x; coefficient = Q.zero; radicand = Q.zero }) [ v.x_of; v.y_of; v.z_of ]
  | `Radical (v, w, s) ->
    List.map2
      (fun x y -> { rational = exact x; coefficient = exact y; radicand = exact s })
      [ v.x_of; v.y_of; v.z_of ] [ w.x_of; w.y_of; w.z_of ]

let text { rational; coefficient; radicand } =
  let rational = Q.to_string rational in
  if Q.sign coefficient = 0 then rational
  else Printf.sprintf "%s + %s √(%s)" rational (Q.to_string coefficient) (Q.to_string radicand)

(* Rounds to the nearest binary64 number. The root has so many bits that its error matters only near a tie. *)
let nearest { rational; coefficient; radicand } =
  if Q.sign coefficient = 0 then Q.to_float rational
  else begin
    let bits = 2200 in
    let square = Q.mul radicand (Q.mul_2exp Q.one (2 * bits)) in
    let root = Q.div_2exp (Q.of_bigint (Integer.sqrt (Integer.fdiv (Q.num square) (Q.den square)))) bits in
    Q.to_float (Q.add rational (Q.mul coefficient root))
  end

let motion of_numbers vector =
  let body velocity spin =
    `Assoc [ ("velocity", `List (of_numbers velocity)); ("angular_velocity", `List (of_numbers spin)) ]
  in
  [ ("a", body (vector (fun m -> m.velocity_of_a)) (vector (fun m -> m.spin_of_a)));
    ("b", body (vector (fun m -> m.velocity_of_b)) (vector (fun m -> m.spin_of_b))) ]

let rational_motion law shown c =
  let m = law c in
  motion (fun v -> List.map shown (numbers v)) (fun part -> `Rational (part m))

let rough_motion shown c =
  let (first, second), s = rational_rough c in
  motion (fun v -> List.map shown (numbers v)) (fun part -> `Radical (part first, part second, s))

let laws =
  [ ("frictionless", rational_motion rational_frictionless);
    ("reflection", rational_motion rational_reflection);
    ("sticking", rational_motion rational_sticking);
    ("rough", rough_motion) ]

let write json =
  print_string (Yojson.Safe.to_string json);
  print_char '\n';
  flush stdout

let answer_all line =
  let c = Json_collision.collision (Yojson.Safe.from_string line) in
  `Assoc (List.map (fun (name, law) -> (name, `Assoc (law (fun x -> `String (text x)) c))) laws)

let rec each_line act =
  match input_line stdin with
  | line ->
    act line;
    each_line act
  | exception End_of_file -> ()

let float_json x = if Float.is_finite x then `Float x else `String (if x > 0. then "inf" else "-inf")

let solve law request =
  let id = ("id", Yojson.Safe.Util.member "id" request) in
  match law (fun x -> float_json (nearest x)) (Json_collision.collision (Yojson.Safe.Util.member "collision" request)) with
  | outcome -> `Assoc (id :: outcome)
  | exception (Json_collision.Invalid why | Yojson.Safe.Util.Type_error (why, _)) ->
    `Assoc [ id; ("error", `String why) ]

let serve name law line =
  let request = Yojson.Safe.from_string line in
  match Yojson.Safe.Util.member "cmd" request with
  | `String "start" ->
    write
      (`Assoc
        [ ("protocol", `Int 1); ("name", `String ("proved " ^ name)); ("version", `String "1");
          ("precision", `String "binary64"); ("model", `String name) ])
  | `String "solve" -> write (solve law request)
  | `String "stop" -> exit 0
  | _ -> failwith "a request that the protocol does not have"

let () =
  match Array.to_list Sys.argv with
  | [ _ ] -> (
    let number = ref 0 in
    try
      each_line (fun line ->
          incr number;
          write (answer_all line))
    with Json_collision.Invalid why | Yojson.Json_error why | Yojson.Safe.Util.Type_error (why, _) ->
      Printf.eprintf "proved: line %d: %s\n" !number why;
      exit 2)
  | [ _; name ] when List.mem_assoc name laws -> each_line (serve name (List.assoc name laws))
  | _ ->
    prerr_endline "proved: expected no argument, or one of frictionless, reflection, sticking, rough";
    exit 2
