(* SPDX-License-Identifier: BSL-1.0 *)

(** The answers over the rational numbers as OCaml. Integers become those of Zarith (GMP); the greatest common divisor
    and the quotients of both by it, with which fractions are reduced, are Zarith's too: what is trusted here is the
    extractor and the constants below and of ExtrOcamlZBigInt. *)

Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
Require Import Carom.rationals Carom.answers.

Extract Constant BinInt.Z.ggcd =>
  "(fun a b -> let g = Z.gcd a b in if Z.equal g Z.zero then (g, (Z.zero, Z.zero)) else (g, (Z.divexact a g, Z.divexact b g)))".

Definition rational_frictionless := @frictionless_answer _ rational_operations.
Definition rational_reflection := @reflection_answer _ rational_operations.
Definition rational_sticking := @sticking_answer _ rational_operations.
Definition rational_rough := @rough_answer _ rational_operations.

Extraction "answers.ml" rational_frictionless rational_reflection rational_sticking rational_rough.
