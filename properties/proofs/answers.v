(* SPDX-License-Identifier: BSL-1.0 *)

(** The source of the extraction: a collision as a user describes it, and the velocities after it by each law that has
    one answer. *)

Require Import Carom.operations Carom.vectors Carom.laws Carom.described_bodies.

Record collision (T : Type) := a_collision {
  described_a : description T;
  described_b : description T;
  contact_point : vector T;
  contact_normal : vector T;
  coefficient_of_restitution : T;
  coefficient_of_friction : T;
  coefficient_of_tangential_restitution : T
}.
Arguments a_collision {T}.
Arguments described_a {T}.
Arguments described_b {T}.
Arguments contact_point {T}.
Arguments contact_normal {T}.
Arguments coefficient_of_restitution {T}.
Arguments coefficient_of_friction {T}.
Arguments coefficient_of_tangential_restitution {T}.

Record motion (T : Type) := a_motion {
  velocity_of_a : vector T;
  spin_of_a : vector T;
  velocity_of_b : vector T;
  spin_of_b : vector T
}.
Arguments a_motion {T}.
Arguments velocity_of_a {T}.
Arguments spin_of_a {T}.
Arguments velocity_of_b {T}.
Arguments spin_of_b {T}.

Section Answers.
  Context {T : Type} {of_T : operations T}.

  Definition contact_of (c : collision T) : contact T :=
    a_contact (body_of (described_a c)) (body_of (described_b c)) (contact_point c) (contact_normal c)
              (coefficient_of_restitution c) (coefficient_of_friction c) (coefficient_of_tangential_restitution c).

  Definition motion_of (c : contact T) : motion T :=
    a_motion (velocity (body_a c)) (spin (body_a c)) (velocity (body_b c)) (spin (body_b c)).

  Definition answer (law : contact T -> vector T) (c : collision T) : motion T := motion_of (resolved law (contact_of c)).

  Definition frictionless_answer := answer frictionless_impulse.
  Definition reflection_answer := answer reflection_impulse.
  Definition sticking_answer := answer sticking_impulse.

  (** The changes of the motion by an impulse f. *)
  Definition response (c : contact T) (f : vector T) : motion T :=
    a_motion (scaled (inverse_mass (body_a c)) f)
             (applied (inverse_inertia (body_a c)) (cross (lever_arm (body_a c) (point c)) f))
             (scaled (inverse_mass (body_b c)) (negated f))
             (applied (inverse_inertia (body_b c)) (cross (lever_arm (body_b c) (point c)) (negated f))).

  (** Two motions m, n and a number s. The answer of rough is m + √s n. *)
  Definition rough_answer (c : collision T) : motion T * motion T * T :=
    let here := contact_of c in
    if is_colliding here
    then let (first, second) := rough_impulses here in
         (motion_of (after here first), response here second, radicand here)
    else (motion_of here, a_motion null null null null, zero).
End Answers.
