(* SPDX-License-Identifier: BSL-1.0 *)

(** The extracted answers are those of the laws over the real numbers. Each answer of answers.v over the rational
    numbers equals the answer of the law to the same collision. The two parts of rough, with the root, give the outcome
    of the law. *)

Require Import QArith Qreals.
Require Import Carom.reals Carom.described_bodies Carom.friction Carom.rationals Carom.answers.
Local Open Scope R_scope.

Definition of_collision (c : collision Q) : collision R :=
  a_collision (of_description (described_a c)) (of_description (described_b c)) (of_vector (contact_point c))
              (of_vector (contact_normal c)) (Q2R (coefficient_of_restitution c)) (Q2R (coefficient_of_friction c))
              (Q2R (coefficient_of_tangential_restitution c)).

Definition of_motion (m : motion Q) : motion R :=
  a_motion (of_vector (velocity_of_a m)) (of_vector (spin_of_a m)) (of_vector (velocity_of_b m))
           (of_vector (spin_of_b m)).

Lemma contact_of_computes c : of_contact (contact_of c) = contact_of (of_collision c).
Proof.
  unfold contact_of, of_contact, of_collision; cbn [body_a body_b point normal restitution friction
    tangential_restitution described_a described_b contact_point contact_normal coefficient_of_restitution
    coefficient_of_friction coefficient_of_tangential_restitution].
  rewrite !body_of_computes; reflexivity.
Qed.

Lemma motion_of_computes c : of_motion (motion_of c) = motion_of (of_contact c).
Proof. reflexivity. Qed.

Lemma answer_computes (rational_law : contact Q -> vector Q) (law : contact R -> vector R) c :
  (forall here, of_vector (rational_law here) = law (of_contact here)) ->
  of_motion (answer rational_law c) = answer law (of_collision c).
Proof.
  intros same; unfold answer; rewrite motion_of_computes, (resolved_computes _ law) by apply same.
  rewrite contact_of_computes; reflexivity.
Qed.

Theorem frictionless_answer_computes c :
  of_motion (frictionless_answer c) = answer frictionless_impulse (of_collision c).
Proof. apply answer_computes, frictionless_computes. Qed.

Theorem reflection_answer_computes c : of_motion (reflection_answer c) = answer reflection_impulse (of_collision c).
Proof. apply answer_computes, reflection_computes. Qed.

Theorem sticking_answer_computes c : of_motion (sticking_answer c) = answer sticking_impulse (of_collision c).
Proof. apply answer_computes, sticking_computes. Qed.

(** A motion plus a multiple of another motion. *)
Definition with_share (m : motion R) (share : R) (n : motion R) : motion R :=
  a_motion (sum (velocity_of_a m) (scaled share (velocity_of_a n))) (sum (spin_of_a m) (scaled share (spin_of_a n)))
           (sum (velocity_of_b m) (scaled share (velocity_of_b n))) (sum (spin_of_b m) (scaled share (spin_of_b n))).

Lemma response_adds (c : contact R) (f g : vector R) (share : R) :
  with_share (motion_of (after c f)) share (response c g) = motion_of (after c (sum f (scaled share g))).
Proof.
  unfold with_share, motion_of, after, response, pushed;
    cbn [velocity_of_a spin_of_a velocity_of_b spin_of_b body_a body_b velocity spin].
  generalize (lever_arm (body_a c) (point c)) (lever_arm (body_b c) (point c)) (velocity (body_a c))
    (velocity (body_b c)) (spin (body_a c)) (spin (body_b c)) (inverse_mass (body_a c)) (inverse_mass (body_b c))
    (inverse_inertia (body_a c)) (inverse_inertia (body_b c)).
  intros; f_equal; by_ring.
Qed.

Theorem rough_answer_is_of_the_law (c : collision R) :
  let '(first, second, s) := rough_answer c in with_share first (sqrt s) second = answer rough_impulse c.
Proof.
  unfold rough_answer, answer, resolved; destruct (is_colliding (contact_of c)).
  - unfold rough_impulse; destruct (rough_impulses (contact_of c)) as [first second]; apply response_adds.
  - unfold with_share; cbn [velocity_of_a spin_of_a velocity_of_b spin_of_b]; rewrite !scaled_null, !sum_null.
    reflexivity.
Qed.

Lemma response_computes c f : of_motion (response c f) = response (of_contact c) (of_vector f).
Proof.
  unfold response, of_motion; cbn [velocity_of_a spin_of_a velocity_of_b spin_of_b].
  rewrite !of_scaled, !of_applied, !of_cross, !of_lever_arm, !of_negated; reflexivity.
Qed.

Theorem rough_answer_computes c :
  let '(first, second, s) := rough_answer c in
  (of_motion first, of_motion second, Q2R s) = rough_answer (of_collision c).
Proof.
  unfold rough_answer; rewrite <- contact_of_computes, <- is_colliding_computes.
  destruct (is_colliding (contact_of c)).
  - pose proof (rough_computes (contact_of c)) as parts.
    destruct (rough_impulses (contact_of c)) as [first second]; destruct parts as [<- root].
    rewrite motion_of_computes, response_computes, root; unfold after, of_contact at 1; cbn [body_a body_b point normal
      restitution friction tangential_restitution]; rewrite !pushed_computes, of_negated; reflexivity.
  - unfold of_motion at 2, null, of_vector at 1 2 3 4; cbn [velocity_of_a spin_of_a velocity_of_b spin_of_b x_of y_of z_of];
      rewrite !of_zero; reflexivity.
Qed.

(** A contact is valid if both descriptions are meaningful (described_bodies.v), one body is movable, the normal has a
    direction, and the coefficients are in their ranges. *)
Theorem described_contact_valid (c : collision R) :
  is_meaningful (described_a c) -> is_meaningful (described_b c) -> 0 < inverse_masses (contact_of c) ->
  contact_normal c <> null -> 0 <= coefficient_of_restitution c <= 1 -> 0 <= coefficient_of_friction c ->
  -1 <= coefficient_of_tangential_restitution c <= 1 -> is_valid (contact_of c).
Proof. intros; constructor; auto; apply body_of_possible; auto. Qed.
