(* SPDX-License-Identifier: BSL-1.0 *)

(** Vectors of three components, and matrices of three rows. *)

Require Import Carom.operations.

Record vector (T : Type) := vec { x_of : T; y_of : T; z_of : T }.
Arguments vec {T}.
Arguments x_of {T}.
Arguments y_of {T}.
Arguments z_of {T}.

Record matrix (T : Type) := rows { row_x : vector T; row_y : vector T; row_z : vector T }.
Arguments rows {T}.
Arguments row_x {T}.
Arguments row_y {T}.
Arguments row_z {T}.

Section Algebra.
  Context {T : Type} {of_T : operations T}.
  Local Open Scope number_scope.

  Definition null : vector T := vec 0 0 0.
  Definition sum (v w : vector T) := vec (x_of v + x_of w) (y_of v + y_of w) (z_of v + z_of w).
  Definition difference (v w : vector T) := vec (x_of v - x_of w) (y_of v - y_of w) (z_of v - z_of w).
  Definition scaled (s : T) (v : vector T) := vec (s * x_of v) (s * y_of v) (s * z_of v).
  Definition negated (v : vector T) := vec (- x_of v) (- y_of v) (- z_of v).
  Definition dot (v w : vector T) := x_of v * x_of w + y_of v * y_of w + z_of v * z_of w.
  Definition cross (v w : vector T) :=
    vec (y_of v * z_of w - z_of v * y_of w) (z_of v * x_of w - x_of v * z_of w) (x_of v * y_of w - y_of v * x_of w).

  Definition applied (m : matrix T) (v : vector T) := vec (dot (row_x m) v) (dot (row_y m) v) (dot (row_z m) v).
  Definition transposed (m : matrix T) :=
    rows (vec (x_of (row_x m)) (x_of (row_y m)) (x_of (row_z m)))
         (vec (y_of (row_x m)) (y_of (row_y m)) (y_of (row_z m)))
         (vec (z_of (row_x m)) (z_of (row_y m)) (z_of (row_z m))).
  Definition product (m n : matrix T) :=
    let columns := transposed n in
    rows (applied columns (row_x m)) (applied columns (row_y m)) (applied columns (row_z m)).
  Definition matrix_sum (m n : matrix T) :=
    rows (sum (row_x m) (row_x n)) (sum (row_y m) (row_y n)) (sum (row_z m) (row_z n)).
  Definition diagonal (d : vector T) := rows (vec (x_of d) 0 0) (vec 0 (y_of d) 0) (vec 0 0 (z_of d)).
  Definition uniform (s : T) := diagonal (vec s s s).
  Definition zero_matrix := uniform 0.
  Definition identity := uniform 1.

  (** [r], the matrix that maps x to r × x. *)
  Definition cross_matrix (r : vector T) :=
    rows (vec 0 (- z_of r) (y_of r)) (vec (z_of r) 0 (- x_of r)) (vec (- y_of r) (x_of r) 0).

  (** The columns of the adjugate are the cross products of the rows. *)
  Definition adjugate (m : matrix T) :=
    transposed (rows (cross (row_y m) (row_z m)) (cross (row_z m) (row_x m)) (cross (row_x m) (row_y m))).
  Definition determinant (m : matrix T) := dot (row_x m) (cross (row_y m) (row_z m)).

  (** The x with m x = v if the determinant is not 0. *)
  Definition solved (m : matrix T) (v : vector T) := scaled (1 / determinant m) (applied (adjugate m) v).
End Algebra.
