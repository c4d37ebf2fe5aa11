(* SPDX-License-Identifier: BSL-1.0 *)

(* The reader of collisions, in the form of the subject protocol. No theorem covers it: it has to be trusted. *)

(* Zarith's Z, which the extracted module Z would hide. *)
module Integer = Z
open Answers

exception Invalid of string

let member = Yojson.Safe.Util.member
let fail place what = raise (Invalid (place ^ ": " ^ what))

(* The binary64 number nearest to the number in the text, as a rational number. *)
let rational place json =
  let number =
    match json with
    | `Float x -> x
    | `Int i -> Float.of_int i
    | `Intlit text -> float_of_string text
    | _ -> fail place "expected a finite number"
  in
  if not (Float.is_finite number) then fail place "expected a finite number";
  let exact = Q.of_float number in
  { qnum = Q.num exact; qden = Q.den exact }

let zero = { qnum = Integer.zero; qden = Integer.one }
let one = { qnum = Integer.one; qden = Integer.one }
let sign x = Integer.sign x.qnum
let at_most_one x = Integer.leq x.qnum x.qden
let is_null v = sign v.x_of = 0 && sign v.y_of = 0 && sign v.z_of = 0

let vector place = function
  | `List [ x; y; z ] -> { x_of = rational place x; y_of = rational place y; z_of = rational place z }
  | _ -> fail place "expected three numbers"

let read place of_json json name =
  let place = place ^ "." ^ name in
  of_json place (member name json)

let quaternion place = function
  | `Null -> { w_part = one; x_part = zero; y_part = zero; z_part = zero }
  | `List [ w; x; y; z ] ->
    let q = { w_part = rational place w; x_part = rational place x; y_part = rational place y; z_part = rational place z } in
    if List.for_all (fun part -> sign part = 0) [ q.w_part; q.x_part; q.y_part; q.z_part ] then fail place "is zero";
    q
  | _ -> fail place "expected four numbers"

let positive place json =
  let x = rational place json in
  if sign x <= 0 then fail place "is not positive";
  x

let moments place json =
  let v = vector place json in
  if sign v.x_of <= 0 || sign v.y_of <= 0 || sign v.z_of <= 0 then fail place "is not positive";
  v

let immovable place = function
  | `Bool flag -> flag
  | `Null -> false
  | _ -> fail place "expected true or false"

let body place json =
  let read of_json = read place of_json json in
  let described_as_immovable = read immovable "immovable" in
  let of_movable of_json name otherwise = if described_as_immovable then otherwise else read of_json name in
  { described_mass = of_movable positive "mass" one;
    principal_moments = of_movable moments "principal_inertia" { x_of = one; y_of = one; z_of = one };
    orientation = of_movable quaternion "orientation" { w_part = one; x_part = zero; y_part = zero; z_part = zero };
    described_centre = read vector "position";
    described_velocity = read vector "velocity";
    described_spin = read vector "angular_velocity";
    described_as_immovable }

let normal place json =
  let n = vector place json in
  if is_null n then fail place "is zero";
  n

let restitution place json =
  let e = rational place json in
  if sign e < 0 || not (at_most_one e) then fail place "is not in [0, 1]";
  e

let friction place = function
  | `Null -> zero
  | json ->
    let mu = rational place json in
    if sign mu < 0 then fail place "is negative";
    mu

let tangential_restitution place = function
  | `Null -> zero
  | json ->
    let e = rational place json in
    if not (at_most_one e && at_most_one { e with qnum = Integer.neg e.qnum }) then fail place "is not in [-1, 1]";
    e

(* Throws Invalid, which names the field. *)
let collision json =
  let read of_json = read "collision" of_json json in
  { described_a = read body "a";
    described_b = read body "b";
    contact_point = read vector "point";
    contact_normal = read normal "normal";
    coefficient_of_restitution = read restitution "restitution";
    coefficient_of_friction = read friction "friction";
    coefficient_of_tangential_restitution = read tangential_restitution "tangential_restitution" }
