(* SPDX-License-Identifier: BSL-1.0 *)

(** Extracts the answers over the rational numbers as OCaml. Integers become integers of Zarith (GMP). To reduce
    fractions, Zarith computes the greatest common divisor and both quotients by it. The extractor, the constants below
    and those of ExtrOcamlZBigInt have to be trusted. *)

Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
Require Import Carom.rationals Carom.answers.

Extract Constant BinInt.Z.ggcd =>
  "(fun a b -> let g = Z.gcd a b in if Z.equal g Z.zero then (g, (Z.zero, Z.zero)) else (g, (Z.divexact a g, Z.divexact b g)))".

Definition rational_frictionless := @frictionless_answer _ rational_operations.
Definition rational_reflection := @reflection_answer _ rational_operations.
Definition rational_sticking := @sticking_answer _ rational_operations.
Definition rational_rough := @rough_answer _ rational_operations.

Extraction "answers.ml" rational_frictionless rational_reflection rational_sticking rational_rough.
