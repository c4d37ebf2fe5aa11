(* SPDX-License-Identifier: BSL-1.0 *)

(** The operations that the laws are written in, so that one text is read over the real numbers, where theorems hold of
    it, and over the rational ones, where it computes. *)

Class operations (T : Type) := {
  zero : T;
  one : T;
  plus : T -> T -> T;
  minus : T -> T -> T;
  times : T -> T -> T;
  over : T -> T -> T;
  opposite : T -> T;
  less : T -> T -> bool
}.

Declare Scope number_scope.
Delimit Scope number_scope with num.
Notation "0" := zero : number_scope.
Notation "1" := one : number_scope.
Infix "+" := plus : number_scope.
Infix "-" := minus : number_scope.
Infix "*" := times : number_scope.
Infix "/" := over : number_scope.
Notation "- x" := (opposite x) : number_scope.
