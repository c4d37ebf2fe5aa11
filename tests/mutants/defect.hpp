// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace carom::mutants {

/// What can be wrong with a solver. catalogue.cpp says of each what it is and where it was seen; mutable_solver.cpp has
/// each at the step where it happens. (Not `carom::Defect`, which is what is wrong with a collision.)
enum class Defect {
  none,

  // What is taken for a valid collision.
  accepts_restitution_above_one,
  accepts_mass_zero,
  demands_unit_normal,

  // What is read of the bodies.
  lever_arm_from_origin,
  lever_arm_of_other_body,
  lever_arm_in_float,
  lever_arm_normalised,
  contact_point_displaced,
  inertia_in_body_frame,
  quaternion_unnormalised,
  quaternion_order,
  spin_in_body_frame,
  immovable_as_heavy,
  immovable_mass_in_lambda,

  // The relative velocity, and whether the contact is colliding.
  spin_crossed_in_reverse_for_b,
  other_body_left_out,
  wall_velocity_as_zero,
  approach_of_centres,
  separating_pulled,
  slow_separating_pulled,
  immovable_pair_divides,

  // The collision matrix.
  angular_term_twice,
  angular_term_subtracted,
  angular_term_of_a_for_both,
  moments_too_small,
  lambda_twice_in_tangents,
  regularised,
  mass_ratio_capped,

  // The law.
  normal_length_ignored,
  velocity_twice_in_restitution,
  restitution_threshold,
  restitution_increased,
  each_body_alone,
  normal_matrix_for_tangents,
  determinant_in_float,
  head_on_falls_back,
  tangent_from_rounding,
  impulse_capped,
  friction_added,
  tangent_of_nothing,
  slip_without_spin,
  slip_stopped_by_mass_alone,
  slip_left_over,

  // What the impulse does.
  normal_flipped_for_a,
  wrong_mass_in_reaction,
  angular_factor_on_mass,
  spin_of_b_reversed,
  spin_in_plane_only,
  gyroscopic_torque,
  push_out_velocity,

  // What is answered.
  outcome_to_ten_digits,
  outcome_in_float,
  input_returned,
  constant_outcome,
  previous_outcome,
};

}  // namespace carom::mutants
