// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/validate.hpp>
#include <carom/properties/plan/classed_collision.hpp>
#include <carom/properties/plan/lint_finding.hpp>

namespace carom::properties::plan {

/// The thresholds. What is compared with them is exact.
inline constexpr int largest_condition = 16;              // of K, for uniform bodies star-shaped from the contact point
inline constexpr double length_noted = 0x1p-20;           // |‖q‖ − 1| of some ulps of binary32
inline constexpr double length_warned = 0x1p-10;          // of no rounding
inline constexpr double moments_noted = 0x1p-50;          // what rounding makes of a flat body's moments in binary64
inline constexpr double moments_warned = 0x1p-20;         // and in binary32
inline constexpr double centre_of_mass_warned = 0x1p-20;  // beyond what binary32 rounds of places and N
inline constexpr double friction_noted = 5;               // greater than what is measured of solids
inline constexpr double mass_ratio_noted = 1e3;           // from which on many contacts at once converge slowly
inline constexpr double mass_ratio_warned = 1e6;

/// Whether the law of no solver is asked of it: ε, μ or e_t is out of range, and nothing else is wrong.
[[nodiscard]] bool is_out_of_range(const Collision& collision);

/// What is suspicious of a collision, each decided exactly. Precondition: it is valid, or `is_out_of_range`.
[[nodiscard]] std::vector<LintFinding> findings_of(const ClassedCollision& contact);

}  // namespace carom::properties::plan
