// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue.hpp"

#include <array>
#include <string>

#include "mutable_solver.hpp"

namespace carom::mutants {
namespace {

constexpr Model frictionless = Model::frictionless;
constexpr Model reflection = Model::reflection;

const std::array mutants{
    // What is taken for a valid collision.
    Mutant{"accepts_restitution_above_one", Defect::accepts_restitution_above_one, frictionless, "22",
           "a restitution above 1 or below 0 is answered", {"invalid_refused"}},
    Mutant{"accepts_mass_zero", Defect::accepts_mass_zero, frictionless, "28",
           "a mass of zero or less is answered", {"invalid_refused"}},
    Mutant{"demands_unit_normal", Defect::demands_unit_normal, frictionless, "11",
           "a normal that is not of unit length is refused", {"finite"}},

    // What is read of the bodies.
    Mutant{"lever_arm_from_origin", Defect::lever_arm_from_origin, frictionless, "7",
           "the lever arm is measured from the world's origin, not from the centre of mass",
           {"angular_momentum", "restitution", "translation"}},
    Mutant{"lever_arm_of_other_body", Defect::lever_arm_of_other_body, frictionless, "8",
           "the lever arm of A is measured from the centre of B", {"angular_momentum", "restitution", "swap"}},
    Mutant{"lever_arm_in_float", Defect::lever_arm_in_float, reflection, "",
           "world positions are rounded to float before the lever arm is taken", {"angular_momentum", "translation"}},
    Mutant{"lever_arm_normalised", Defect::lever_arm_normalised, frictionless, "6",
           "a lever arm of length zero is divided by its length, and NaN is not colliding", {"restitution", "non_penetration"}},
    Mutant{"contact_point_displaced", Defect::contact_point_displaced, frictionless, "5",
           "the contact point is stale by a millimetre, so that spheres get a spurious spin",
           {"angular_momentum", "collinear_spin"}},
    Mutant{"inertia_in_body_frame", Defect::inertia_in_body_frame, reflection, "23",
           "the inertia along the body axes is used as if it were along the world's",
           {"angular_momentum"}},
    Mutant{"quaternion_unnormalised", Defect::quaternion_unnormalised, frictionless, "9",
           "the orientation is not normalised, so that J J⁻¹ ≠ I", {"angular_momentum", "energy"}},
    Mutant{"quaternion_order", Defect::quaternion_order, reflection, "",
           "the quaternion w, x, y, z is read as x, y, z, w",
           {"angular_momentum", "rotation", "reflection_symmetry"}},
    Mutant{"spin_in_body_frame", Defect::spin_in_body_frame, frictionless, "",
           "the angular velocity is taken to be in the body frame", {"restitution", "separating_untouched"}},
    Mutant{"immovable_as_heavy", Defect::immovable_as_heavy, frictionless, "26",
           "an immovable body is one of 10¹⁰ kg", {"immovable_untouched"}},
    Mutant{"immovable_mass_in_lambda", Defect::immovable_mass_in_lambda, frictionless, "27",
           "the default mass of an immovable body counts in λ", {"restitution", "unit_scaling"}},

    // The relative velocity, and whether the contact is colliding.
    Mutant{"spin_crossed_in_reverse_for_b", Defect::spin_crossed_in_reverse_for_b, frictionless, "24",
           "w × r is taken as r × w for B", {"restitution", "swap"}},
    Mutant{"other_body_left_out", Defect::other_body_left_out, reflection, "18",
           "the velocity of A is taken for the relative velocity", {"restitution", "galilean", "swap"}},
    Mutant{"wall_velocity_as_zero", Defect::wall_velocity_as_zero, frictionless, "",
           "the velocity of a driven wall is taken as zero", {"restitution", "galilean"}},
    Mutant{"approach_of_centres", Defect::approach_of_centres, frictionless, "",
           "whether the bodies approach is decided by their centres of mass, without spin",
           {"restitution", "separating_untouched", "push", "non_penetration"}},
    Mutant{"separating_pulled", Defect::separating_pulled, frictionless, "1",
           "a separating contact gets an impulse", {"separating_untouched", "push", "non_penetration", "repeat"}},
    Mutant{"slow_separating_pulled", Defect::slow_separating_pulled, reflection, "1, 38",
           "a contact that separates slower than 5 cm/s gets an impulse",
           {"separating_untouched", "push", "homogeneous", "unit_scaling"}},
    Mutant{"immovable_pair_divides", Defect::immovable_pair_divides, reflection, "25",
           "two immovable bodies are solved for, so that K = 0 is divided by", {"finite"}},

    // The collision matrix.
    Mutant{"angular_term_twice", Defect::angular_term_twice, frictionless, "13",
           "the angular term counts twice in K", {"restitution", "non_penetration"}},
    Mutant{"angular_term_subtracted", Defect::angular_term_subtracted, reflection, "24",
           "[r] stands where [r]ᵀ should, so that the angular term is subtracted",
           {"definite", "restitution", "reflection_plane", "push"}},
    Mutant{"angular_term_of_a_for_both", Defect::angular_term_of_a_for_both, frictionless, "19",
           "the angular term of A is taken for B as well", {"restitution", "swap"}},
    Mutant{"moments_too_small", Defect::moments_too_small, reflection, "",
           "K takes moments in kg m² for moments in kg cm²", {"well_conditioned", "restitution", "reflection_plane"}},
    Mutant{"lambda_twice_in_tangents", Defect::lambda_twice_in_tangents, reflection, "13",
           "λ counts twice in the tangential entries of K, as eq. 27 is printed; eq. 17 holds all the same",
           {"reflection_plane"}},
    Mutant{"regularised", Defect::regularised, reflection, "",
           "a thousandth is added to the diagonal of K, whatever the unit of mass", {"restitution", "unit_scaling"}},
    Mutant{"mass_ratio_capped", Defect::mass_ratio_capped, frictionless, "32",
           "masses in K are kept within a ratio of 100", {"restitution"}},

    // The law.
    Mutant{"normal_length_ignored", Defect::normal_length_ignored, reflection, "11",
           "the normal is taken to have length 1", {"restitution"}},
    Mutant{"velocity_twice_in_restitution", Defect::velocity_twice_in_restitution, frictionless, "21",
           "ε is multiplied by the velocity twice", {"restitution", "homogeneous", "unit_scaling"}},
    Mutant{"restitution_threshold", Defect::restitution_threshold, reflection, "38, 39",
           "an approach slower than 0.2 m/s has restitution 0", {"restitution", "homogeneous", "unit_scaling"}},
    Mutant{"restitution_increased", Defect::restitution_increased, frictionless, "",
           "0.1 is added to the restitution", {"restitution", "energy"}},
    Mutant{"each_body_alone", Defect::each_body_alone, frictionless, "20",
           "each body bounces as if the other were a wall, right against walls and a rebound at ε = 0 without",
           {"linear_momentum", "restitution"}},
    Mutant{"normal_matrix_for_tangents", Defect::normal_matrix_for_tangents, reflection, "14",
           "K of the normal direction stands for the whole of K", {"reflection_plane"}},
    Mutant{"determinant_in_float", Defect::determinant_in_float, reflection, "31",
           "the determinant of K is computed in float", {"backward_error", "restitution"}},
    Mutant{"head_on_falls_back", Defect::head_on_falls_back, reflection, "4",
           "where V⁻ has no tangential part the frictionless law takes over", {"continuous", "reflection_plane"}},
    Mutant{"tangent_from_rounding", Defect::tangent_from_rounding, reflection, "3",
           "the tangent basis is taken from V⁻ also where its tangential part is rounding noise",
           {"backward_error", "restitution", "reflection_plane", "continuous"}},
    Mutant{"impulse_capped", Defect::impulse_capped, frictionless, "",
           "impulses are cut off at 10 N s", {"restitution", "non_penetration", "homogeneous"}},
    Mutant{"friction_added", Defect::friction_added, frictionless, "42",
           "the frictionless impulse has a tangential part", {"frictionless_direction", "restitution", "continuous"}},
    Mutant{"tangent_of_nothing", Defect::tangent_of_nothing, frictionless, "29, 34",
           "the direction of the slip is taken where there is none, and NaN times no friction is NaN", {"finite"}},

    // What the impulse does.
    Mutant{"normal_flipped_for_a", Defect::normal_flipped_for_a, frictionless, "10, 17",
           "the normal has the wrong sign for A alone", {"linear_momentum", "restitution", "swap"}},
    Mutant{"wrong_mass_in_reaction", Defect::wrong_mass_in_reaction, frictionless, "16",
           "the reaction on B is divided by the mass of A", {"linear_momentum", "angular_momentum", "swap"}},
    Mutant{"angular_factor_on_mass", Defect::angular_factor_on_mass, frictionless, "15",
           "the inverse masses are scaled by the factor of the angular part", {"angular_momentum", "restitution"}},
    Mutant{"spin_of_b_reversed", Defect::spin_of_b_reversed, reflection, "24",
           "the angular velocity of B is changed with the wrong sign",
           {"angular_momentum", "restitution", "reflection_plane", "swap"}},
    Mutant{"spin_in_plane_only", Defect::spin_in_plane_only, frictionless, "",
           "only the spin about the z axis changes, as in two dimensions", {"angular_momentum", "rotation"}},
    Mutant{"gyroscopic_torque", Defect::gyroscopic_torque, frictionless, "40",
           "the gyroscopic torque of a time step is added to the impulse",
           {"angular_momentum", "collinear_spin", "homogeneous", "unit_scaling"}},
    Mutant{"push_out_velocity", Defect::push_out_velocity, frictionless, "45",
           "a velocity that pushes the bodies out of each other is added",
           {"energy", "restitution", "homogeneous", "unit_scaling"}},

    // What is answered.
    Mutant{"outcome_to_ten_digits", Defect::outcome_to_ten_digits, frictionless, "",
           "the outcome is right to ten digits only", {"backward_error"}},
    Mutant{"outcome_in_float", Defect::outcome_in_float, reflection, "",
           "the outcome is rounded to float", {"backward_error"}},
    Mutant{"input_returned", Defect::input_returned, frictionless, "37",
           "the velocities before the impulse are returned", {"restitution", "non_penetration"}},
    Mutant{"constant_outcome", Defect::constant_outcome, frictionless, "",
           "the same outcome is returned whatever the collision",
           {"linear_momentum", "angular_momentum", "restitution", "separating_untouched", "immovable_untouched",
            "homogeneous", "galilean", "rotation"}},
    Mutant{"previous_outcome", Defect::previous_outcome, reflection, "40",
           "the outcome of the previous collision is returned",
           {"linear_momentum", "restitution", "separating_untouched", "repeat"}},
};

}  // namespace

std::span<const Mutant> all_mutants() { return mutants; }

Subject subject_of(const Mutant& mutant) { return make_subject(std::string(mutant.name), mutant.model, mutant.defect); }

Subject repaired(const Mutant& mutant) {
  return make_subject(std::string(mutant.name) + "-repaired", mutant.model, Defect::none);
}

}  // namespace carom::mutants
