// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/validate.hpp>
#include <carom/properties/plan/classed_collision.hpp>
#include <carom/properties/plan/lint_finding.hpp>

namespace carom::properties::plan {

inline constexpr int largest_condition = 16;       // of K/λ, for uniform bodies star-shaped from the contact point
inline constexpr double length_noted = 0x1p-20;    // from here on, |length − 1| exceeds some ulps of binary32
inline constexpr double length_warned = 0x1p-10;   // from here on it is not rounding
inline constexpr double moments_noted = 0x1p-50;   // relative excess of a flat body's moments, rounded to binary64
inline constexpr double moments_warned = 0x1p-20;  // the same, rounded to binary32
inline constexpr double centre_of_mass_warned = 0x1p-20;  // more than the rounding of positions and N to binary32
inline constexpr double friction_noted = 5;               // greater than the measured values of solids
inline constexpr double mass_ratio_noted = 1e3;  // from here on, solvers of many contacts at once converge slowly
inline constexpr double mass_ratio_warned = 1e6;

/// Whether a collision is invalid only because ε, μ or e_t is finite but out of range. Then no law is defined.
[[nodiscard]] bool is_out_of_range(const Collision& collision);

/// The suspicious properties of a collision, decided exactly. Precondition: the collision is valid or
/// `is_out_of_range`.
[[nodiscard]] std::vector<LintFinding> findings_of(const ClassedCollision& contact);

}  // namespace carom::properties::plan
