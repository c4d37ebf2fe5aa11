// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <carom/properties/invariants/invariant.hpp>

/// What each invariant of the catalogue checks, and what it asks.
namespace carom::properties {

// What the defining equations say of one outcome (one_outcome.cpp).
[[nodiscard]] Verdict check_backward_error(const Evidence& evidence);
[[nodiscard]] Verdict check_linear_momentum(const Evidence& evidence);
[[nodiscard]] Verdict check_angular_momentum(const Evidence& evidence);
[[nodiscard]] Verdict check_restitution(const Evidence& evidence);
[[nodiscard]] Verdict check_non_penetration(const Evidence& evidence);
[[nodiscard]] Verdict check_push(const Evidence& evidence);
[[nodiscard]] Verdict check_separating_untouched(const Evidence& evidence);
[[nodiscard]] Verdict check_immovable_untouched(const Evidence& evidence);
[[nodiscard]] Verdict check_frictionless_direction(const Evidence& evidence);
[[nodiscard]] Verdict check_reflection_plane(const Evidence& evidence);
[[nodiscard]] Verdict check_energy(const Evidence& evidence);
[[nodiscard]] Verdict check_collinear_spin(const Evidence& evidence);

// What holds for the collision matrix (matrix.cpp).
[[nodiscard]] Verdict check_definite(const Evidence& evidence);
[[nodiscard]] Verdict check_well_conditioned(const Evidence& evidence);

// What relates the outcomes of several collisions (relations.cpp).
[[nodiscard]] Verdict check_swap(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_swap(const Collision& collision);
[[nodiscard]] Verdict check_galilean(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_galilean(const Collision& collision);
[[nodiscard]] Verdict check_translation(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_translation(const Collision& collision);
[[nodiscard]] Verdict check_rotation(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_rotation(const Collision& collision);
[[nodiscard]] Verdict check_reflection_symmetry(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_reflection_symmetry(const Collision& collision);
[[nodiscard]] Verdict check_unit_scaling(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_unit_scaling(const Collision& collision);
[[nodiscard]] Verdict check_homogeneous(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_homogeneous(const Collision& collision);
[[nodiscard]] Verdict check_continuous(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_continuous(const Collision& collision);
[[nodiscard]] Verdict check_repeat(const Evidence& evidence);
[[nodiscard]] std::vector<Collision> ask_repeat(const Collision& collision, const Outcome<double>& outcome);

}  // namespace carom::properties
