(* SPDX-License-Identifier: BSL-1.0 *)

(** Maps a user's description of a body to the body of the laws, without a root. The description has the mass, the
    principal moments and a quaternion of any length except 0, or it says that the body is immovable. The theorems prove
    that the quaternion's matrix R is a rotation, that the body is possible, and that its inverse inertia is the inverse
    of R diag(I) Rᵀ, with the principal moments I. *)

Require Import Carom.operations Carom.vectors Carom.laws.

Record quaternion (T : Type) := a_quaternion { w_part : T; x_part : T; y_part : T; z_part : T }.
Arguments a_quaternion {T}.
Arguments w_part {T}.
Arguments x_part {T}.
Arguments y_part {T}.
Arguments z_part {T}.

Record description (T : Type) := a_description {
  described_mass : T;
  principal_moments : vector T;
  orientation : quaternion T;  (* turns the principal axes to the world's frame; of any length except 0 *)
  described_centre : vector T;
  described_velocity : vector T;
  described_spin : vector T;
  described_as_immovable : bool  (* mass and moments then have no meaning *)
}.
Arguments a_description {T}.
Arguments described_mass {T}.
Arguments principal_moments {T}.
Arguments orientation {T}.
Arguments described_centre {T}.
Arguments described_velocity {T}.
Arguments described_spin {T}.
Arguments described_as_immovable {T}.

Section Description.
  Context {T : Type} {of_T : operations T}.
  Local Open Scope number_scope.

  Definition quaternion_square (q : quaternion T) :=
    w_part q * w_part q + x_part q * x_part q + y_part q * y_part q + z_part q * z_part q.

  (** ((q₀² - q·q) I + 2 q qᵀ + 2 q₀ [q]) / (q₀² + q·q). *)
  Definition rotation (q : quaternion T) : matrix T :=
    let two := 1 + 1 in
    let (w, x, y, z) := q in
    let s := quaternion_square q in
    rows (vec ((w * w + x * x - y * y - z * z) / s) (two * (x * y - w * z) / s) (two * (x * z + w * y) / s))
         (vec (two * (x * y + w * z) / s) ((w * w - x * x + y * y - z * z) / s) (two * (y * z - w * x) / s))
         (vec (two * (x * z - w * y) / s) (two * (y * z + w * x) / s) ((w * w - x * x - y * y + z * z) / s)).

  (** R diag(d) Rᵀ: the matrix that is diag(d) in the principal axes. *)
  Definition turned (q : quaternion T) (d : vector T) : matrix T :=
    product (rotation q) (product (diagonal d) (transposed (rotation q))).

  Definition reciprocal (d : vector T) : vector T := vec (1 / x_of d) (1 / y_of d) (1 / z_of d).

  (** J = R diag(I) Rᵀ, in the world's frame. *)
  Definition inertia_of (d : description T) : matrix T := turned (orientation d) (principal_moments d).

  Definition body_of (d : description T) : body T :=
    if described_as_immovable d
    then a_body 0 zero_matrix (described_centre d) (described_velocity d) (described_spin d)
    else a_body (1 / described_mass d) (turned (orientation d) (reciprocal (principal_moments d)))
                (described_centre d) (described_velocity d) (described_spin d).
End Description.

Require Import Carom.reals.
Local Open Scope R_scope.

Definition zero_quaternion : quaternion R := a_quaternion 0 0 0 0.

Definition is_meaningful (d : description R) :=
  described_as_immovable d = true \/
  (0 < described_mass d /\ orientation d <> zero_quaternion /\
   0 < x_of (principal_moments d) /\ 0 < y_of (principal_moments d) /\ 0 < z_of (principal_moments d)).

Lemma quaternion_square_positive (q : quaternion R) : q <> zero_quaternion -> 0 < quaternion_square q.
Proof.
  destruct q as [w x y z]; unfold quaternion_square; cbn; intros not_zero.
  assert (0 <= w * w) by nra; assert (0 <= x * x) by nra; assert (0 <= y * y) by nra; assert (0 <= z * z) by nra.
  destruct (Rle_lt_dec (w * w + x * x + y * y + z * z) 0); auto.
  exfalso; apply not_zero; unfold zero_quaternion; f_equal; nra.
Qed.

Section Rotation.
  Variable q : quaternion R.
  Hypothesis not_zero : q <> zero_quaternion.

  (** The only divisor is the sum of the four squares. *)
  Ltac by_field :=
    pose proof (quaternion_square_positive q not_zero) as positive; clear not_zero; destruct q as [w x y z];
    cbv [rotation quaternion_square w_part x_part y_part z_part] in *; in_components; same_components;
    field; lra.

  (** The rows of rotation are the formula with q = (x, y, z) and q₀ = w. *)
  Theorem rotation_applied (v : vector R) :
    let u := vec (x_part q) (y_part q) (z_part q) in
    applied (rotation q) v =
    scaled (1 / quaternion_square q)
           (sum (scaled (w_part q * w_part q - square u) v)
                (sum (scaled (2 * dot u v) u) (scaled (2 * w_part q) (cross u v)))).
  Proof. destruct v; by_field. Qed.

  Theorem rotation_of_any_length (s : R) :
    s <> 0 ->
    rotation (a_quaternion (s * w_part q) (s * x_part q) (s * y_part q) (s * z_part q)) = rotation q.
  Proof.
    intros length; assert (0 < s * s) by nra.
    pose proof (quaternion_square_positive q not_zero) as positive; clear not_zero; destruct q as [w x y z].
    cbv [rotation quaternion_square w_part x_part y_part z_part] in *; in_components; same_components;
      field; (split; [lra |]); nra.
  Qed.

  Theorem rotation_orthogonal : product (transposed (rotation q)) (rotation q) = identity.
  Proof. by_field. Qed.

  Theorem rotation_transposed_orthogonal : product (rotation q) (transposed (rotation q)) = identity.
  Proof. by_field. Qed.

  (** Hence R is not a reflection. *)
  Theorem rotation_determinant : determinant (rotation q) = 1.
  Proof. by_field. Qed.

  Lemma turned_back (v : vector R) : applied (transposed (rotation q)) (applied (rotation q) v) = v.
  Proof. rewrite <- applied_product, rotation_orthogonal; apply applied_identity. Qed.

  Lemma turned_forth (v : vector R) : applied (rotation q) (applied (transposed (rotation q)) v) = v.
  Proof. rewrite <- applied_product, rotation_transposed_orthogonal; apply applied_identity. Qed.

  Theorem rotation_keeps_dot (v w : vector R) : dot (applied (rotation q) v) (applied (rotation q) w) = dot v w.
  Proof. rewrite <- dot_transposed, turned_back; reflexivity. Qed.

  Theorem rotation_transposed_keeps_dot (v w : vector R) :
    dot (applied (transposed (rotation q)) v) (applied (transposed (rotation q)) w) = dot v w.
  Proof. rewrite dot_transposed, turned_forth; reflexivity. Qed.

  (** The product of turned d and turned e, applied to a vector. *)
  Lemma turned_twice (d e v : vector R) :
    applied (turned q d) (applied (turned q e) v) =
    applied (rotation q) (applied (product (diagonal d) (diagonal e)) (applied (transposed (rotation q)) v)).
  Proof. unfold turned; rewrite !applied_product, turned_back; reflexivity. Qed.
End Rotation.

Lemma turned_form (q : quaternion R) (d v w : vector R) :
  dot v (applied (turned q d) w) =
  dot (applied (transposed (rotation q)) v) (applied (diagonal d) (applied (transposed (rotation q)) w)).
Proof. unfold turned; rewrite !applied_product; generalize (rotation q); by_ring. Qed.

Lemma turned_symmetric (q : quaternion R) (d : vector R) : symmetric (turned q d).
Proof.
  intros v w; rewrite !turned_form.
  generalize (applied (transposed (rotation q)) v) (applied (transposed (rotation q)) w); by_ring.
Qed.

Lemma turned_semidefinite (q : quaternion R) (d : vector R) :
  0 <= x_of d -> 0 <= y_of d -> 0 <= z_of d -> positive_semidefinite (turned q d).
Proof.
  intros x y z v; rewrite turned_form; generalize (applied (transposed (rotation q)) v); intros [a b c].
  destruct d as [i j k]; in_components.
  assert (0 <= i * (a * a)) by nra; assert (0 <= j * (b * b)) by nra; assert (0 <= k * (c * c)) by nra; lra.
Qed.

Lemma reciprocal_left (d : vector R) :
  x_of d <> 0 -> y_of d <> 0 -> z_of d <> 0 -> product (diagonal (reciprocal d)) (diagonal d) = identity.
Proof. destruct d; unfold reciprocal; in_components; intros; same_components; field; auto. Qed.

Lemma reciprocal_right (d : vector R) :
  x_of d <> 0 -> y_of d <> 0 -> z_of d <> 0 -> product (diagonal d) (diagonal (reciprocal d)) = identity.
Proof. destruct d; unfold reciprocal; in_components; intros; same_components; field; auto. Qed.

Lemma reciprocal_positive (s : R) : 0 < s -> 0 < 1 / s.
Proof. intros; apply Rdiv_lt_0_compat; lra. Qed.

Lemma immovable_possible (x v w : vector R) : is_possible (a_body 0 zero_matrix x v w).
Proof.
  split; [| split]; cbn [inverse_inertia inverse_mass].
  - intros y z; rewrite !applied_zero_matrix; by_ring.
  - intros y; rewrite applied_zero_matrix; destruct y; in_components; lra.
  - right; split; reflexivity.
Qed.

Theorem body_of_possible (d : description R) : is_meaningful d -> is_possible (body_of d).
Proof.
  unfold body_of; intros [-> | (mass & _ & x & y & z)]; [apply immovable_possible |].
  destruct (described_as_immovable d); [apply immovable_possible |].
  split; [| split]; cbn [inverse_inertia inverse_mass].
  - apply turned_symmetric.
  - apply turned_semidefinite; apply Rlt_le, reciprocal_positive; auto.
  - left; apply reciprocal_positive; auto.
Qed.

Lemma inertia_of_symmetric (d : description R) : symmetric (inertia_of d).
Proof. apply turned_symmetric. Qed.

Lemma inertia_of_semidefinite (d : description R) :
  described_as_immovable d = false -> is_meaningful d -> positive_semidefinite (inertia_of d).
Proof.
  intros movable [immovable | (_ & _ & x & y & z)]; [congruence |]; apply turned_semidefinite; lra.
Qed.

Section Inverse.
  Variable d : description R.
  Hypotheses (movable : described_as_immovable d = false) (meaningful : is_meaningful d).

  Theorem inverse_mass_of_body : described_mass d * inverse_mass (body_of d) = 1.
  Proof.
    destruct meaningful as [immovable | [mass _]]; [congruence |].
    unfold body_of; rewrite movable; cbn; field; lra.
  Qed.

  Theorem inertia_then_inverse (v : vector R) : applied (inverse_inertia (body_of d)) (applied (inertia_of d) v) = v.
  Proof.
    destruct meaningful as [immovable | (_ & not_zero & x & y & z)]; [congruence |].
    unfold body_of, inertia_of; rewrite movable; cbn [inverse_inertia].
    rewrite turned_twice, reciprocal_left, applied_identity by (auto; lra); apply turned_forth; auto.
  Qed.

  Theorem inverse_then_inertia (v : vector R) : applied (inertia_of d) (applied (inverse_inertia (body_of d)) v) = v.
  Proof.
    destruct meaningful as [immovable | (_ & not_zero & x & y & z)]; [congruence |].
    unfold body_of, inertia_of; rewrite movable; cbn [inverse_inertia].
    rewrite turned_twice, reciprocal_right, applied_identity by (auto; lra); apply turned_forth; auto.
  Qed.
End Inverse.
