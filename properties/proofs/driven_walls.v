(* SPDX-License-Identifier: BSL-1.0 *)

(** Energy if a driven wall, an immovable body with a velocity, does work on the other body. Frictionless and rough gain
    no energy beyond this work. *)

Require Import Carom.reals Carom.collision_matrix Carom.laws_of_impulse Carom.energy Carom.friction.
Local Open Scope R_scope.

(** The work w that a body does when it receives the impulse f at p. It is 0 for a movable body, and -f·V_p for an
    immovable body. *)
Definition gives (mass : R) (inertia : matrix R) (b : body R) (p f : vector R) (w : R) :=
  (has_inertia mass inertia b /\ w = 0) \/ (is_immovable b /\ w = - dot f (velocity_at b p)).

Lemma gained_beyond (mass : R) (inertia : matrix R) (b : body R) (p f : vector R) (w : R) :
  gives mass inertia b p f w ->
  kinetic_energy mass inertia (pushed b p f) - kinetic_energy mass inertia b - w =
  dot f (velocity_at b p) + 1 / 2 * (inverse_mass b * dot f f + dot f (applied (of_spin b p) f)).
Proof.
  intros [[movable ->] | [immovable ->]].
  - rewrite <- (work_on_movable mass inertia b p f movable); ring.
  - rewrite immovable_untouched, of_spin_form by auto; destruct immovable as [-> ->].
    rewrite applied_zero_matrix, dot_null; ring.
Qed.

Section Walls.
  Variables (c : contact R) (mass_a mass_b : R) (inertia_a inertia_b : matrix R).

  Local Notation energy := (total_energy mass_a mass_b inertia_a inertia_b).
  Local Notation both_give f w_a w_b :=
    (gives mass_a inertia_a (body_a c) (point c) f w_a /\ gives mass_b inertia_b (body_b c) (point c) (negated f) w_b).

  (** ΔE = W + F·V⁻ + ½ F·K F. *)
  Theorem energy_with_driven_walls (f : vector R) (w_a w_b : R) :
    both_give f w_a w_b ->
    energy (after c f) - energy c =
    w_a + w_b + (dot f (relative_velocity c) + 1 / 2 * dot f (applied (collision_matrix c) f)).
  Proof.
    intros [of_a of_b]; apply gained_beyond in of_a; apply gained_beyond in of_b.
    unfold total_energy; cbn [after body_a body_b].
    rewrite collision_matrix_form; unfold relative_velocity, inverse_masses; rewrite dot_difference.
    rewrite applied_negated, !dot_negated, !dot_negated_left in of_b; reals; lra.
  Qed.

  Theorem energy_of_frictionless_with_driven_walls (w_a w_b : R) :
    is_valid c -> both_give (frictionless_impulse c) w_a w_b ->
    energy (after c (frictionless_impulse c)) - energy c <= w_a + w_b.
  Proof.
    intros valid give; rewrite (energy_with_driven_walls _ _ _ give).
    pose proof (work_of_frictionless c valid); lra.
  Qed.

  Theorem energy_of_rough_with_driven_walls (w_a w_b : R) :
    is_valid c -> approach c < 0 -> both_give (rough_impulse c) w_a w_b ->
    energy (after c (rough_impulse c)) - energy c <= w_a + w_b.
  Proof.
    intros valid colliding give; rewrite (energy_with_driven_walls _ _ _ give), rough_impulse_is.
    pose proof (kappa_in_range c valid colliding) as in_range.
    pose proof (tangential_restitution_in_range c valid).
    pose proof (work_of_rough c valid (kappa c)); reals; lra.
  Qed.
End Walls.
