// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/collision.hpp>
#include <carom/oracles/bounds/quantities.hpp>

/// A collision is moderate if its numbers have such sizes that no computed number leaves the range of binary64.
namespace carom::oracles {

/// The limits of the nonzero numbers of a moderate collision. Zeros are moderate.
inline constexpr double smallest_moderate = 0x1p-64;
inline constexpr double largest_moderate = 0x1p+44;
inline constexpr double largest_moderate_mass = 0x1p+64;
inline constexpr double smallest_moderate_moment = 0x1p-104;
inline constexpr double largest_moderate_moment = 0x1p+104;
/// The limits of the components of normals and orientations. Only the direction of these vectors matters.
inline constexpr double smallest_moderate_direction = 0x1p-110;
inline constexpr double largest_moderate_direction = 0x1p+110;
/// The upper limit of the components of a moderate outcome. The components may be arbitrarily small.
inline constexpr double largest_moderate_outcome = 0x1p+63;

/// The constants of the inequalities (2) to (4) of `is_moderate`. Tests evaluate the laws on collisions whose numbers
/// are at the limits above. The tests compute with logarithms of sizes in place of numbers. They check that each
/// constant suffices (docs/internals/bounds.md).
inline constexpr double largest_scale_of_moderate = 0x1p+244;
inline constexpr double largest_scale_of_moderate_friction = 0x1p+569;
inline constexpr double largest_sensitivity_of_moderate = 0x1p+592;
inline constexpr double largest_on_the_way_of_moderate = 0x1p+918;

/// Whether every number of the collision and the extents of its bodies (quantities.hpp) are moderate. For a valid
/// moderate collision and a moderate outcome, let K be the collision matrix, and M the largest moderate mass. Let q be
/// the quantities of the collision, ŷ_k the four vectors of the outcome, and y_k⁻ these vectors before the impulse.
/// Then:
///
///   (1) λ = 1/m_A + 1/m_B ≥ 1/M, and λI ⪯ K (ExactCase::is_definite), so ‖K⁻¹‖ ≤ M and N·K N ≥ N·N / M.
///   (2) The scale Σ_q ‖∂g/∂q‖ ‖q‖ + Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖) of an equation g = 0 is at most 2²⁴⁴. If g is an
///       equation of friction, which is quadratic in the outcome, the scale is at most 2⁵⁶⁹.
///   (3) Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖ ≤ 2⁵⁹² for the exact answer y of each of `linear_laws`, by (1). Σ_q ‖∂K/∂q‖ ‖q‖ has
///       the same bound.
///   (4) No intermediate number exceeds 2⁹¹⁸, so nothing overflows.
[[nodiscard]] inline bool is_moderate(const Collision& collision) {
  bool moderate = true;
  for_each_number(
      [&](const FieldPath& path, const double& number) __attribute__((always_inline)) {  // so no path is compared
        const double size = std::abs(number);
        const auto is_within = [&](double smallest, double largest) { return size >= smallest && size <= largest; };
        moderate = moderate &&
                   (size == 0 ||
                    (path.field == "normal" || path.field == "orientation"
                         ? is_within(smallest_moderate_direction, largest_moderate_direction)
                     : path.field == "principal_inertia" ? is_within(smallest_moderate_moment, largest_moderate_moment)
                     : path.field == "mass"              ? is_within(smallest_moderate, largest_moderate_mass)
                                                         : is_within(smallest_moderate, largest_moderate)));
      },
      collision);
  return moderate && extent_of(collision.a) <= largest_moderate && extent_of(collision.b) <= largest_moderate;
}

}  // namespace carom::oracles
