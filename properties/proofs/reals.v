(* SPDX-License-Identifier: BSL-1.0 *)

(** Vectors and matrices of real numbers, and the algebra that the proofs use. *)

Require Export Reals Lra Psatz Bool.
Require Export Carom.operations Carom.vectors Carom.laws.
Local Open Scope R_scope.

#[export] Instance real_operations : operations R := {
  zero := 0;
  one := 1;
  plus := Rplus;
  minus := Rminus;
  times := Rmult;
  over := Rdiv;
  opposite := Ropp;
  less x y := if Rlt_dec x y then true else false
}.

Lemma less_true x y : less x y = true <-> x < y.
Proof. simpl; destruct (Rlt_dec x y); split; intros; auto; discriminate. Qed.

Lemma less_false x y : less x y = false <-> y <= x.
Proof. simpl; destruct (Rlt_dec x y); split; intros; auto; try discriminate; lra. Qed.

(** Replaces the operations by those of the real numbers, and unfolds nothing else. *)
Ltac reals := cbn [zero one plus minus times over opposite real_operations] in *.

(** Equations of components. Vectors and matrices are taken apart, and ring proves the rest. *)
Ltac taken_apart :=
  repeat match goal with
  | m : matrix R |- _ => destruct m
  | v : vector R |- _ => destruct v
  end;
  cbn [x_of y_of z_of row_x row_y row_z] in *.

Ltac in_components :=
  cbv [null sum difference scaled negated dot cross applied transposed product matrix_sum diagonal uniform zero_matrix
       identity cross_matrix adjugate determinant square squared x_of y_of z_of row_x row_y row_z
       zero one plus minus times over opposite real_operations] in *.

Ltac same_components := repeat match goal with |- vec _ _ _ = vec _ _ _ => f_equal | |- rows _ _ _ = rows _ _ _ => f_equal end.

Ltac by_ring := intros; taken_apart; in_components; same_components; ring.

Lemma vector_equal (v w : vector R) : x_of v = x_of w -> y_of v = y_of w -> z_of v = z_of w -> v = w.
Proof. destruct v, w; simpl; intros; subst; reflexivity. Qed.

Section Algebra.
  Implicit Types u v w x y : vector R.
  Implicit Types m n : matrix R.
  Implicit Types s t : R.

  Lemma dot_symmetric v w : dot v w = dot w v. Proof. by_ring. Qed.
  Lemma dot_sum u v w : dot u (sum v w) = dot u v + dot u w. Proof. by_ring. Qed.
  Lemma dot_sum_left u v w : dot (sum v w) u = dot v u + dot w u. Proof. by_ring. Qed.
  Lemma dot_difference u v w : dot u (difference v w) = dot u v - dot u w. Proof. by_ring. Qed.
  Lemma dot_difference_left u v w : dot (difference v w) u = dot v u - dot w u. Proof. by_ring. Qed.
  Lemma dot_scaled s v w : dot v (scaled s w) = s * dot v w. Proof. by_ring. Qed.
  Lemma dot_scaled_left s v w : dot (scaled s v) w = s * dot v w. Proof. by_ring. Qed.
  Lemma dot_negated v w : dot v (negated w) = - dot v w. Proof. by_ring. Qed.
  Lemma dot_negated_left v w : dot (negated v) w = - dot v w. Proof. by_ring. Qed.
  Lemma cross_sum u v w : cross u (sum v w) = sum (cross u v) (cross u w). Proof. by_ring. Qed.
  Lemma cross_scaled s v w : cross v (scaled s w) = scaled s (cross v w). Proof. by_ring. Qed.
  Lemma cross_negated v w : cross v (negated w) = negated (cross v w). Proof. by_ring. Qed.
  Lemma cross_self v : cross v v = null. Proof. by_ring. Qed.
  Lemma scaled_null s : scaled s null = null. Proof. by_ring. Qed.
  Lemma scaled_0 v : scaled 0 v = null. Proof. by_ring. Qed.
  Lemma scaled_1 v : scaled 1 v = v. Proof. by_ring. Qed.
  Lemma scaled_scaled s t v : scaled s (scaled t v) = scaled (s * t) v. Proof. by_ring. Qed.
  Lemma sum_null v : sum v null = v. Proof. by_ring. Qed.
  Lemma negated_null : negated null = null. Proof. by_ring. Qed.
  Lemma applied_sum m v w : applied m (sum v w) = sum (applied m v) (applied m w). Proof. by_ring. Qed.
  Lemma applied_difference m v w : applied m (difference v w) = difference (applied m v) (applied m w).
  Proof. by_ring. Qed.
  Lemma applied_scaled m s v : applied m (scaled s v) = scaled s (applied m v). Proof. by_ring. Qed.
  Lemma applied_negated m v : applied m (negated v) = negated (applied m v). Proof. by_ring. Qed.
  Lemma applied_null m : applied m null = null. Proof. by_ring. Qed.
  Lemma applied_identity v : applied identity v = v. Proof. by_ring. Qed.
  Lemma applied_uniform s v : applied (uniform s) v = scaled s v. Proof. by_ring. Qed.
  Lemma applied_zero_matrix v : applied zero_matrix v = null. Proof. by_ring. Qed.
  Lemma applied_product m n v : applied (product m n) v = applied m (applied n v). Proof. by_ring. Qed.
  Lemma applied_matrix_sum m n v : applied (matrix_sum m n) v = sum (applied m v) (applied n v). Proof. by_ring. Qed.
  Lemma dot_transposed m v w : dot v (applied (transposed m) w) = dot (applied m v) w. Proof. by_ring. Qed.

  (** Lagrange's identity. *)
  Lemma square_cross v w : square (cross v w) = square v * square w - dot v w * dot v w. Proof. by_ring. Qed.

  Lemma square_nonnegative v : 0 <= square v.
  Proof. taken_apart; in_components; nra. Qed.

  Lemma square_zero v : square v = 0 -> v = null.
  Proof.
    taken_apart; in_components; intros; apply vector_equal; simpl; nra.
  Qed.

  Lemma square_positive v : v <> null -> 0 < square v.
  Proof.
    intros not_null; destruct (square_nonnegative v) as [| is_zero]; auto.
    exfalso; apply not_null; apply square_zero; auto.
  Qed.

  (** The inequality of Cauchy and Schwarz. *)
  Lemma dot_at_most v w : dot v w * dot v w <= square v * square w.
  Proof. pose proof (square_nonnegative (cross v w)); rewrite square_cross in *; lra. Qed.

  Lemma adjugate_left m v : applied (adjugate m) (applied m v) = scaled (determinant m) v. Proof. by_ring. Qed.
  Lemma adjugate_right m v : applied m (applied (adjugate m) v) = scaled (determinant m) v. Proof. by_ring. Qed.

  Lemma applied_solved m v : determinant m <> 0 -> applied m (solved m v) = v.
  Proof.
    intros; unfold solved; rewrite applied_scaled, adjugate_right, scaled_scaled.
    replace (_ * determinant m) with 1 by (reals; field; auto); apply scaled_1.
  Qed.

  Lemma solved_applied m v : determinant m <> 0 -> solved m (applied m v) = v.
  Proof.
    intros; unfold solved; rewrite adjugate_left, scaled_scaled.
    replace (_ * determinant m) with 1 by (reals; field; auto); apply scaled_1.
  Qed.

  Lemma solved_unique m v w : determinant m <> 0 -> applied m w = v -> solved m v = w.
  Proof. intros invertible <-; apply solved_applied; auto. Qed.
End Algebra.

Definition symmetric (m : matrix R) := forall v w, dot v (applied m w) = dot w (applied m v).
(** m ⪰ s I, and m ⪯ s I. *)
Definition at_least (s : R) (m : matrix R) := forall v, s * square v <= dot v (applied m v).
Definition at_most (s : R) (m : matrix R) := forall v, dot v (applied m v) <= s * square v.
Definition positive_semidefinite (m : matrix R) := forall v, 0 <= dot v (applied m v).

(** The inverse mass and the inverse inertia of an immovable body are 0. *)
Definition is_immovable (b : body R) := inverse_mass b = 0 /\ inverse_inertia b = zero_matrix.

Definition is_possible (b : body R) :=
  symmetric (inverse_inertia b) /\ positive_semidefinite (inverse_inertia b) /\ (0 < inverse_mass b \/ is_immovable b).

(** The conditions on a collision: one body can move, the normal has a direction, and the coefficients are in their
    ranges. *)
Record is_valid (c : contact R) : Prop := {
  possible_a : is_possible (body_a c);
  possible_b : is_possible (body_b c);
  one_moves : 0 < inverse_masses c;
  has_normal : normal c <> null;
  restitution_in_range : 0 <= restitution c <= 1;
  friction_in_range : 0 <= friction c;
  tangential_restitution_in_range : -1 <= tangential_restitution c <= 1
}.

Lemma is_colliding_true (c : contact R) : is_colliding c = true <-> 0 < inverse_masses c /\ approach c < 0.
Proof. unfold is_colliding; rewrite andb_true_iff, !less_true; reflexivity. Qed.
