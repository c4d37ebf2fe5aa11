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
  accepts_normal_zero,
  demands_unit_normal,

  // What is read of the bodies.
  lever_arm_from_origin,
  lever_arm_of_other_body,
  lever_arm_in_float,
  lever_arm_normalised,
  tiny_lever_arm_as_zero,
  contact_point_displaced,
  anchors_apart,
  near_axis_as_axis,
  inertia_in_body_frame,
  quaternion_unnormalised,
  quaternion_order,
  negative_quaternion_conjugated,
  small_turn_as_none,
  half_turn_divides,
  two_equal_moments_as_sphere,
  moments_sorted,
  inverse_moments_capped,
  small_moments_as_infinite,
  velocities_in_fixed_point,
  spin_in_body_frame,
  immovable_as_heavy,
  immovable_mass_in_lambda,
  heavy_as_immovable,
  resting_body_asleep,

  // The relative velocity, and whether the contact is colliding.
  spin_crossed_in_reverse_for_b,
  other_body_left_out,
  wall_velocity_as_zero,
  wall_spin_as_zero,
  approach_of_centres,
  separating_pulled,
  slow_separating_pulled,
  slow_approach_ignored,
  approach_as_resting,
  velocity_of_frame_before,
  immovable_pair_divides,

  // The collision matrix.
  angular_term_twice,
  angular_term_subtracted,
  angular_term_of_a_for_both,
  moments_too_small,
  lambda_twice_in_tangents,
  regularised,
  mass_ratio_capped,
  centre_contact_skips_turning,
  equal_masses_exchange,

  // The law.
  normal_length_ignored,
  velocity_twice_in_restitution,
  restitution_threshold,
  restitution_increased,
  restitution_ignored,
  restitution_by_size,
  restitution_by_place,
  restitution_from_friction,
  elastic_lossy,
  each_body_alone,
  normal_matrix_for_tangents,
  determinant_in_float,
  head_on_falls_back,
  tangent_from_rounding,
  basis_near_pole,
  component_tie,
  impulse_capped,
  small_impulse_dropped,
  warm_start_kept,
  friction_added,
  tangent_of_nothing,
  slip_without_spin,
  slip_stopped_by_mass_alone,
  slip_left_over,
  slip_crossed_in_reverse,
  slip_stopped_as_of_spheres,
  slip_reversed,
  tangents_not_orthogonal,

  // What the impulse does.
  normal_flipped_for_a,
  wrong_mass_in_reaction,
  masses_left_out,
  reaction_dropped,
  angular_factor_on_mass,
  spin_of_b_reversed,
  spin_in_plane_only,
  normal_in_plane_as_planar,
  identity_drops_spin,
  spin_about_normal_stopped,
  gyroscopic_torque,
  push_out_velocity,
  gravity_of_step,

  // What is answered.
  outcome_to_ten_digits,
  outcome_in_float,
  input_returned,
  contact_skipped_at_times,
  constant_outcome,
  previous_outcome,
};

}  // namespace carom::mutants
