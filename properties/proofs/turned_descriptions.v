(* SPDX-License-Identifier: BSL-1.0 *)

(** A turned or mirrored description gives the turned or mirrored contact. Each orientation becomes a quaternion product
    or the mirrored quaternion. The matrices of these quaternions are those of relations.v, so the answers are turned or
    mirrored too. *)

Require Import Carom.reals Carom.similarity Carom.described_bodies Carom.answers.
Require Carom.relations.
Local Open Scope R_scope.

(** The rotation q followed by the rotation p. *)
Definition quaternion_product (p q : quaternion R) : quaternion R :=
  a_quaternion (w_part p * w_part q - x_part p * x_part q - y_part p * y_part q - z_part p * z_part q)
               (w_part p * x_part q + x_part p * w_part q + y_part p * z_part q - z_part p * y_part q)
               (w_part p * y_part q - x_part p * z_part q + y_part p * w_part q + z_part p * x_part q)
               (w_part p * z_part q + x_part p * y_part q - y_part p * x_part q + z_part p * w_part q).

Lemma square_of_product (p q : quaternion R) :
  quaternion_square (quaternion_product p q) = quaternion_square p * quaternion_square q.
Proof.
  destruct p as [p0 p1 p2 p3], q as [q0 q1 q2 q3]; unfold quaternion_square, quaternion_product.
  cbn [w_part x_part y_part z_part]; reals; ring.
Qed.

Theorem rotation_of_product (p q : quaternion R) :
  p <> zero_quaternion -> q <> zero_quaternion ->
  rotation (quaternion_product p q) = product (rotation p) (rotation q).
Proof.
  intros p_not_zero q_not_zero; pose proof (square_of_product p q) as of_product.
  pose proof (quaternion_square_positive p p_not_zero); pose proof (quaternion_square_positive q q_not_zero).
  destruct p as [p0 p1 p2 p3], q as [q0 q1 q2 q3]; unfold rotation, quaternion_product in *.
  cbn [w_part x_part y_part z_part] in *; rewrite of_product.
  generalize dependent (quaternion_square (a_quaternion p0 p1 p2 p3)).
  generalize dependent (quaternion_square (a_quaternion q0 q1 q2 q3)); intros.
  in_components; same_components; field; lra.
Qed.

Definition turned_description (q : quaternion R) (d : description R) : description R :=
  a_description (described_mass d) (principal_moments d) (quaternion_product q (orientation d))
                (applied (rotation q) (described_centre d)) (applied (rotation q) (described_velocity d))
                (applied (rotation q) (described_spin d)) (described_as_immovable d).

Definition turned_collision (q : quaternion R) (c : collision R) : collision R :=
  a_collision (turned_description q (described_a c)) (turned_description q (described_b c))
              (applied (rotation q) (contact_point c)) (applied (rotation q) (contact_normal c))
              (coefficient_of_restitution c) (coefficient_of_friction c) (coefficient_of_tangential_restitution c).

(** The mirror x = 0 keeps the x part and the real part of a quaternion. *)
Definition mirrored_quaternion (q : quaternion R) : quaternion R :=
  a_quaternion (w_part q) (x_part q) (- y_part q) (- z_part q).

Definition mirrored (v : vector R) : vector R := applied relations.mirror v.

Definition mirrored_description (d : description R) : description R :=
  a_description (described_mass d) (principal_moments d) (mirrored_quaternion (orientation d))
                (mirrored (described_centre d)) (mirrored (described_velocity d))
                (negated (mirrored (described_spin d))) (described_as_immovable d).

Definition mirrored_collision (c : collision R) : collision R :=
  a_collision (mirrored_description (described_a c)) (mirrored_description (described_b c))
              (mirrored (contact_point c)) (mirrored (contact_normal c))
              (coefficient_of_restitution c) (coefficient_of_friction c) (coefficient_of_tangential_restitution c).

Lemma no_inertia_turned (m : matrix R) : product m (product zero_matrix (transposed m)) = zero_matrix.
Proof. by_ring. Qed.

(** R J Rᵀ of a matrix J that is already turned. *)
Lemma turned_product (m n : matrix R) (d : vector R) :
  product (product m n) (product (diagonal d) (transposed (product m n))) =
  product m (product (product n (product (diagonal d) (transposed n))) (transposed m)).
Proof. by_ring. Qed.

Lemma orientation_not_zero (d : description R) :
  is_meaningful d -> described_as_immovable d = false -> orientation d <> zero_quaternion.
Proof. intros [immovable | (_ & not_zero & _)] movable; [congruence | auto]. Qed.

Theorem turned_body (q : quaternion R) (d : description R) :
  q <> zero_quaternion -> is_meaningful d ->
  body_of (turned_description q d) = relations.rotated_body (rotation q) (body_of d).
Proof.
  intros not_zero meaningful; pose proof (orientation_not_zero d meaningful) as oriented.
  unfold body_of, relations.rotated_body; cbn [turned_description described_as_immovable described_mass
    principal_moments orientation described_centre described_velocity described_spin].
  destruct (described_as_immovable d); cbn [inverse_mass inverse_inertia centre velocity spin].
  - rewrite no_inertia_turned; reflexivity.
  - unfold turned; rewrite rotation_of_product, turned_product by auto; reflexivity.
Qed.

Lemma mirrored_rotation (q : quaternion R) :
  q <> zero_quaternion ->
  rotation (mirrored_quaternion q) = product relations.mirror (product (rotation q) relations.mirror).
Proof.
  intros not_zero; pose proof (quaternion_square_positive q not_zero) as positive; clear not_zero.
  destruct q as [w x y z]; revert positive; unfold mirrored_quaternion, relations.mirror.
  cbv [rotation quaternion_square w_part x_part y_part z_part]; in_components; intros; same_components; field; lra.
Qed.

(** The mirror keeps the principal moments: M diag(d) M = diag(d). *)
Lemma mirrored_product (n : matrix R) (d : vector R) :
  let m := relations.mirror in
  product (product m (product n m)) (product (diagonal d) (transposed (product m (product n m)))) =
  product m (product (product n (product (diagonal d) (transposed n))) (transposed m)).
Proof. unfold relations.mirror; cbv zeta; by_ring. Qed.

Theorem mirrored_body (d : description R) :
  is_meaningful d -> body_of (mirrored_description d) = relations.reflected_body relations.mirror (body_of d).
Proof.
  intros meaningful; pose proof (orientation_not_zero d meaningful) as oriented.
  unfold body_of, relations.reflected_body; cbn [mirrored_description described_as_immovable described_mass
    principal_moments orientation described_centre described_velocity described_spin].
  destruct (described_as_immovable d); cbn [inverse_mass inverse_inertia centre velocity spin].
  - rewrite no_inertia_turned; reflexivity.
  - unfold turned; rewrite mirrored_rotation, mirrored_product by auto; reflexivity.
Qed.

Section Answers.
  Variables (l : law) (c : collision R).
  Hypotheses (meaningful_a : is_meaningful (described_a c)) (meaningful_b : is_meaningful (described_b c))
             (valid : is_valid (contact_of c)).

  Definition motion_by (polar axial : vector R -> vector R) (m : motion R) : motion R :=
    a_motion (polar (velocity_of_a m)) (axial (spin_of_a m)) (polar (velocity_of_b m)) (axial (spin_of_b m)).

  (** The answer to a turned description is the turned answer. *)
  Theorem answer_turned (q : quaternion R) :
    q <> zero_quaternion ->
    let turn := applied (rotation q) in
    answer (impulse_of l) (turned_collision q c) = motion_by turn turn (answer (impulse_of l) c).
  Proof.
    intros not_zero turn; unfold answer.
    assert (contact_of (turned_collision q c) = relations.rotated (rotation q) (contact_of c)) as ->.
    { unfold contact_of, turned_collision; cbn [described_a described_b contact_point contact_normal
        coefficient_of_restitution coefficient_of_friction coefficient_of_tangential_restitution].
      rewrite !turned_body by auto; reflexivity. }
    rewrite relations.rotation; [reflexivity | | |]; auto using rotation_determinant.
    exact (rotation_keeps_dot q not_zero).
  Qed.

  (** The answer to a mirrored description is the mirrored answer. *)
  Theorem answer_mirrored :
    answer (impulse_of l) (mirrored_collision c) =
    motion_by mirrored (fun w => negated (mirrored w)) (answer (impulse_of l) c).
  Proof.
    unfold answer.
    assert (contact_of (mirrored_collision c) = relations.reflected relations.mirror (contact_of c)) as ->.
    { unfold contact_of, mirrored_collision; cbn [described_a described_b contact_point contact_normal
        coefficient_of_restitution coefficient_of_friction coefficient_of_tangential_restitution].
      rewrite !mirrored_body by auto; reflexivity. }
    rewrite relations.mirror_symmetry by auto; reflexivity.
  Qed.
End Answers.
