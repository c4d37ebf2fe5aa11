// SPDX-License-Identifier: BSL-1.0
#include "catalogue.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <stdexcept>

namespace carom::mutants {
namespace {

using enum Law;

constexpr Mutant mutants[]{
    // Validation of the collision.
    {"accepts_restitution_above_one", frictionless, "22", "a restitution above 1 or below 0 is answered",
     "invalid_refused"},
    {"accepts_mass_zero", frictionless, "28", "a mass of zero or less is answered", "invalid_refused"},
    {"accepts_normal_zero", reflection, "12", "a normal of length zero is answered", "invalid_refused"},
    {"demands_unit_normal", frictionless, "11", "a normal that is not of unit length is refused", "finite"},

    // Reading the bodies.
    {"lever_arm_from_origin", frictionless, "7",
     "the lever arm is measured from the world's origin, not from the centre of mass",
     "angular_momentum restitution translation"},
    {"lever_arm_of_other_body", frictionless, "8", "the lever arm of A is measured from the centre of B",
     "angular_momentum restitution swap"},
    {"lever_arm_in_float", reflection, "", "world positions are rounded to float before the lever arm is taken",
     "angular_momentum translation"},
    {"lever_arm_normalised", frictionless, "6",
     "a lever arm of length zero is divided by its length, and NaN is not colliding", "restitution non_penetration"},
    {"tiny_lever_arm_as_zero", frictionless, "", "a lever arm shorter than a micrometre is taken for zero",
     "angular_momentum unit_scaling"},
    {"contact_point_displaced", frictionless, "5",
     "the contact point is stale by a millimetre, so that spheres get a spurious spin",
     "angular_momentum collinear_spin"},
    {"anchors_apart", reflection, "2",
     "each body is struck at its own anchor, a centimetre from the other's along the normal",
     "angular_momentum reflection_plane"},
    {"near_axis_as_axis", frictionless, "", "a normal within 2.5° of an axis is taken for that axis",
     "frictionless_direction restitution"},
    {"inertia_in_body_frame", reflection, "23",
     "the inertia along the body axes is used as if it were along the world's", "angular_momentum"},
    {"quaternion_unnormalised", frictionless, "9", "the orientation is not normalised, so that J J⁻¹ ≠ I",
     "angular_momentum energy"},
    {"quaternion_order", reflection, "", "the quaternion w, x, y, z is read as x, y, z, w",
     "angular_momentum rotation reflection_symmetry"},
    {"negative_quaternion_conjugated", frictionless, "",
     "a quaternion with w < 0 is made to have w > 0 by turning the sign of w alone", "angular_momentum"},
    {"small_turn_as_none", reflection, "", "an orientation of less than 36° is taken for the identity",
     "angular_momentum"},
    {"half_turn_divides", frictionless, "",
     "the axis of a turn is taken by way of tan, and half a turn divides by zero", "finite"},
    {"two_equal_moments_as_sphere", frictionless, "", "a body with two equal moments is taken for one with three",
     "angular_momentum"},
    {"moments_sorted", reflection, "", "moments are sorted, as eigenvalues come, and the axes are not",
     "angular_momentum"},
    {"inverse_moments_capped", frictionless, "32", "moments below 10⁻⁶ kg m² are taken for that",
     "angular_momentum unit_scaling"},
    {"small_moments_as_infinite", frictionless, "64", "moments whose product is below 10⁻³² are taken for infinite",
     "angular_momentum"},
    {"velocities_in_fixed_point", frictionless, "", "velocities are kept in whole nanometres a second",
     "restitution homogeneous"},
    {"spin_in_body_frame", frictionless, "", "the angular velocity is taken to be in the body frame",
     "restitution separating_untouched"},
    {"immovable_as_heavy", frictionless, "26", "an immovable body is one of 10¹⁰ kg", "immovable_untouched"},
    {"immovable_mass_in_lambda", frictionless, "27", "the default mass of an immovable body counts in λ",
     "restitution unit_scaling"},
    {"heavy_as_immovable", frictionless, "32", "a body a million times as heavy as the other is taken for immovable",
     "linear_momentum"},
    {"resting_body_asleep", reflection, "", "a body at rest is taken for immovable", "linear_momentum galilean"},

    // The relative velocity, and whether the contact is colliding.
    {"spin_crossed_in_reverse_for_b", frictionless, "24", "w × r is taken as r × w for B", "restitution swap"},
    {"other_body_left_out", reflection, "18", "the velocity of A is taken for the relative velocity",
     "restitution galilean swap"},
    {"wall_velocity_as_zero", frictionless, "", "the velocity of a driven wall is taken as zero",
     "restitution galilean"},
    {"wall_spin_as_zero", frictionless, "", "the spin of a driven wall is taken as zero", "restitution"},
    {"approach_of_centres", frictionless, "",
     "whether the bodies approach is decided by their centres of mass, without spin",
     "restitution separating_untouched push non_penetration"},
    {"separating_pulled", frictionless, "1", "a separating contact gets an impulse",
     "separating_untouched push non_penetration repeat"},
    {"slow_separating_pulled", reflection, "1, 38", "a contact that separates slower than 5 cm/s gets an impulse",
     "separating_untouched push homogeneous unit_scaling"},
    {"slow_approach_ignored", frictionless, "39, 50", "an approach slower than 1 mm/s is taken for none",
     "restitution non_penetration homogeneous unit_scaling"},
    {"approach_as_resting", reflection, "", "an approach slower than 10⁻¹⁰ m/s is taken for none", "restitution"},
    {"velocity_of_frame_before", frictionless, "52", "the approach is that of the collision before", "restitution"},
    {"immovable_pair_divides", reflection, "25", "two immovable bodies are solved for, so that K = 0 is divided by",
     "finite"},

    // The collision matrix.
    {"angular_term_twice", frictionless, "13", "the angular term counts twice in K", "restitution non_penetration"},
    {"angular_term_subtracted", reflection, "24",
     "[r] stands where [r]ᵀ should, so that the angular term is subtracted",
     "definite restitution reflection_plane push"},
    {"angular_term_of_a_for_both", frictionless, "19", "the angular term of A is taken for B as well",
     "restitution swap"},
    {"moments_too_small", reflection, "", "K takes moments in kg m² for moments in kg cm²",
     "well_conditioned restitution reflection_plane"},
    {"lambda_twice_in_tangents", reflection, "13",
     "λ counts twice in the tangential entries of K, as eq. 27 is printed; eq. 17 holds all the same",
     "reflection_plane"},
    {"regularised", reflection, "", "a thousandth is added to the diagonal of K, whatever the unit of mass",
     "restitution unit_scaling"},
    {"mass_ratio_capped", frictionless, "32", "masses in K are kept within a ratio of 100", "restitution"},
    {"centre_contact_skips_turning", frictionless, "6",
     "where one body is touched at its centre K leaves out the turning of both", "restitution"},
    {"equal_masses_exchange", frictionless, "",
     "bodies of equal mass exchange velocities along the normal, as points do", "restitution"},

    // The law.
    {"normal_length_ignored", reflection, "11", "the normal is taken to have length 1", "restitution"},
    {"velocity_twice_in_restitution", frictionless, "21", "ε is multiplied by the velocity twice",
     "restitution homogeneous unit_scaling"},
    {"restitution_threshold", reflection, "38, 39, 51", "an approach slower than 0.2 m/s has restitution 0",
     "restitution homogeneous unit_scaling"},
    {"restitution_increased", frictionless, "48, 53", "0.1 is added to the restitution", "restitution energy"},
    {"restitution_ignored", reflection, "37, 62", "ε is taken for 0", "restitution"},
    {"restitution_by_size", frictionless, "49", "the larger the lever arm of A, the smaller the restitution",
     "restitution unit_scaling"},
    {"restitution_by_place", frictionless, "63", "the restitution depends on where the contact is",
     "restitution translation"},
    {"restitution_from_friction", frictionless, "", "where there is friction, the restitution is the mean of ε and μ",
     "restitution"},
    {"elastic_lossy", frictionless, "", "a billionth of the restitution is lost where it is 1", "restitution"},
    {"each_body_alone", frictionless, "20",
     "each body bounces as if the other were a wall, right against walls and a rebound at ε = 0 without",
     "linear_momentum restitution"},
    {"normal_matrix_for_tangents", reflection, "14", "K of the normal direction stands for the whole of K",
     "reflection_plane"},
    {"determinant_in_float", reflection, "31", "the determinant of K is computed in float",
     "backward_error restitution"},
    {"head_on_falls_back", reflection, "4", "where V⁻ has no tangential part the frictionless law takes over",
     "continuous reflection_plane"},
    {"tangent_from_rounding", reflection, "3",
     "the tangent basis is taken from V⁻ also where its tangential part is rounding noise",
     "backward_error restitution reflection_plane continuous"},
    {"basis_near_pole", reflection, "", "the tangents of a normal near −z are those of −z, as in a method of 2012",
     "reflection_plane"},
    {"component_tie", reflection, "",
     "the tangent is taken from the least component of the normal, and none where two are the least",
     "reflection_plane"},
    {"impulse_capped", frictionless, "", "impulses are cut off at 10 N s", "restitution non_penetration homogeneous"},
    {"small_impulse_dropped", frictionless, "", "an impulse of less than 10⁻¹² N s is taken for none", "restitution"},
    {"warm_start_kept", frictionless, "40",
     "a thousandth of the impulse of the collision before is left from a warm start",
     "frictionless_direction restitution memoryless"},
    {"friction_added", frictionless, "42", "the frictionless impulse has a tangential part",
     "frictionless_direction restitution continuous"},
    {"tangent_of_nothing", frictionless, "29, 34",
     "the direction of the slip is taken where there is none, and NaN times no friction is NaN", "finite"},
    {"slip_without_spin", sticking, "", "the slip that is stopped is that of the centres of mass, without spin",
     "sticks backward_error"},
    {"slip_stopped_by_mass_alone", sticking, "14", "the slip is stopped as if the bodies could not turn", "sticks"},
    {"slip_left_over", sticking, "", "a billionth of the slip is left over", "sticks"},
    {"slip_crossed_in_reverse", sticking, "58", "the slip has r × w for w × r, so that friction speeds the spin up",
     "sticks"},
    {"slip_stopped_as_of_spheres", sticking, "57", "the slip is stopped by 2/7 of itself over λ, as of solid spheres",
     "sticks"},
    {"slip_reversed", sticking, "", "a tangential restitution is read, which is another law's", "sticks"},
    {"tangents_not_orthogonal", sticking, "59",
     "the slip that is stopped has a part along the normal, which bounces at ε = 0", "restitution"},

    // Friction.
    {"cone_wider", rough, "", "the friction cone is wider by a billionth", "friction_cone backward_error"},
    {"friction_multiplied", rough, "", "μ is multiplied by itself, as if it were one body's",
     "backward_error friction_cone"},
    {"friction_before_restitution", rough, "", "the cone is that of the normal impulse without restitution",
     "backward_error"},
    {"friction_clamped_by_axis", rough, "41", "friction is clamped along each of two tangents by itself: a box",
     "friction_cone backward_error rotation"},
    {"friction_in_pyramid", rough, "41", "the cone is a pyramid inside it", "backward_error rotation energy"},
    {"friction_along_slip", rough, "", "friction is against the slip, and not against what K makes of it",
     "backward_error energy"},
    {"friction_kept_out_of_normal", rough, "", "friction has no part along N, so that what it does to N·V is left",
     "restitution backward_error"},
    {"friction_along_rounded_tangents", rough, "3, 4", "the tangents are those of V⁻, which head-on are rounding",
     "backward_error energy"},
    {"tangential_restitution_ignored", rough, "", "e_t is taken for 0", "backward_error"},
    {"tangential_restitution_reversed", rough, "", "e_t has the wrong sign", "backward_error"},
    {"friction_without_spin", rough, "", "the slip that friction stops is that of the centres of mass, without spin",
     "backward_error energy", "slip_without_spin"},
    {"friction_of_spin_in_reverse", rough, "58", "the slip has r × w for w × r, so that friction speeds the spin up",
     "backward_error energy", "slip_crossed_in_reverse"},
    {"coulomb_cone_wider", coulomb, "", "the friction cone is wider by a billionth", "friction_cone slip_opposed",
     "cone_wider"},
    {"coulomb_friction_multiplied", coulomb, "", "μ is multiplied by itself, as if it were one body's",
     "friction_cone slip_opposed", "friction_multiplied"},
    {"coulomb_clamped_by_axis", coulomb, "41", "friction is clamped along each of two tangents by itself: a box",
     "friction_cone slip_opposed", "friction_clamped_by_axis"},
    {"coulomb_along_slip_before", coulomb, "", "friction is against the slip before the impulse, not after it",
     "slip_opposed", "friction_along_slip"},
    {"coulomb_without_spin", coulomb, "", "the slip is that of the centres of mass, without spin", "slip_opposed",
     "slip_without_spin"},
    {"coulomb_of_spin_in_reverse", coulomb, "58", "the slip has r × w for w × r, so that friction speeds the spin up",
     "slip_opposed", "slip_crossed_in_reverse"},
    {"coulomb_always_slides", coulomb, "",
     "friction is all that the cone allows, so that it turns the slip round where less would stop it", "slip_opposed",
     "always_slides"},
    {"rough_for_coulomb", coulomb, "", "the law `rough` in place of `coulomb`, with its tangential restitution",
     "slip_opposed"},
    {"cone_not_asked", coulomb, "", "the contact point sticks, whatever friction that takes", "friction_cone"},

    // Applying the impulse.
    {"normal_flipped_for_a", frictionless, "10, 17", "the normal has the wrong sign for A alone",
     "linear_momentum restitution swap"},
    {"wrong_mass_in_reaction", frictionless, "16", "the reaction on B is divided by the mass of A",
     "linear_momentum angular_momentum swap"},
    {"masses_left_out", frictionless, "46", "what the impulse changes of a velocity has no mass in it",
     "linear_momentum restitution"},
    {"reaction_dropped", frictionless, "60", "B is not struck", "linear_momentum restitution"},
    {"angular_factor_on_mass", frictionless, "15", "the inverse masses are scaled by the factor of the angular part",
     "angular_momentum restitution"},
    {"spin_of_b_reversed", reflection, "24, 55", "the angular velocity of B is changed with the wrong sign",
     "angular_momentum restitution reflection_plane swap"},
    {"spin_in_plane_only", frictionless, "", "only the spin about the z axis changes, as in two dimensions",
     "angular_momentum rotation"},
    {"normal_in_plane_as_planar", frictionless, "",
     "where the normal has no z component the scene is taken for one in the plane", "angular_momentum"},
    {"identity_drops_spin", reflection, "", "where the orientation is the identity J⁻¹ is left out together with R",
     "angular_momentum"},
    {"spin_about_normal_stopped", sticking, "56", "sticking stops the spin about the normal too", "angular_momentum"},
    {"gyroscopic_torque", frictionless, "40", "the gyroscopic torque of a time step is added to the impulse",
     "angular_momentum collinear_spin homogeneous unit_scaling"},
    {"push_out_velocity", frictionless, "45, 53", "a velocity that pushes the bodies out of each other is added",
     "energy restitution homogeneous unit_scaling"},
    {"resting_pushed_apart", coulomb, "45",
     "bodies whose contact points do not move relative to each other are pushed apart", "parting_speed impulse_bound"},
    {"resting_pushed_aside", coulomb, "45",
     "bodies whose contact points do not move relative to each other are pushed along the tangent plane",
     "impulse_bound friction_cone"},
    {"gravity_of_step", frictionless, "35, 36, 40", "the gravity of a time step is added to the impulse",
     "linear_momentum homogeneous unit_scaling"},

    // The answer.
    {"outcome_to_ten_digits", frictionless, "", "the outcome is right to ten digits only", "backward_error"},
    {"outcome_in_float", reflection, "", "the outcome is rounded to float", "backward_error"},
    {"input_returned", frictionless, "37, 61", "the velocities before the impulse are returned",
     "restitution non_penetration"},
    {"contact_skipped_at_times", reflection, "61", "every sixteenth contact is not answered, and nothing says so",
     "restitution non_penetration"},
    {"constant_outcome", frictionless, "", "the same outcome is returned whatever the collision",
     "linear_momentum angular_momentum restitution separating_untouched immovable_untouched homogeneous galilean "
     "rotation"},
    {"previous_outcome", reflection, "40", "the outcome of the previous collision is returned",
     "linear_momentum restitution separating_untouched repeat memoryless"},
    {"one_triangle_shown", reflection, "",
     "of the collision matrix one triangle is shown, and zeros in place of the other", "matrix_used"},
    {"diagonal_shown", sticking, "", "of the collision matrix the diagonal is shown", "matrix_used"},
};

}  // namespace

std::span<const Mutant> all_mutants() { return mutants; }

const Mutant& mutant_named(std::string_view name) {
  const auto* found = std::ranges::find(mutants, name, &Mutant::name);
  if (found == std::end(mutants)) {
    throw std::invalid_argument("there is no mutant " + std::string(name));
  }
  return *found;
}

std::vector<std::string_view> names_in(std::string_view text) {
  std::vector<std::string_view> names;
  for (const auto& name : std::views::split(text, ' ')) {
    names.emplace_back(name.begin(), name.end());
  }
  return names;
}

Subject subject_of(const Mutant& mutant) { return make_subject(std::string(mutant.name), mutant.law, {mutant.defect}); }

}  // namespace carom::mutants
