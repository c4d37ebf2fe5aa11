(* SPDX-License-Identifier: BSL-1.0 *)

(** The operations of the laws. The same text of the laws therefore has a meaning over the real numbers, for theorems,
    and over the rational numbers, for computation. *)

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
