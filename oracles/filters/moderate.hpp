// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <carom/collision/collision.hpp>

/// Collisions whose numbers are all of ordinary size, so that nothing that is made of them leaves the range of
/// binary64.
namespace carom::oracles {

inline constexpr double largest_moderate = 0x1p+64;
inline constexpr double smallest_moderate = 0x1p-64;

/// The same for normals and orientations, of which the direction alone matters.
inline constexpr double largest_moderate_direction = 0x1p+110;
inline constexpr double smallest_moderate_direction = 0x1p-110;

/// What the inequalities (2) to (5) of `is_moderate` say, each found by running the laws over magnitudes
/// (docs/internals/bounds.md).
inline constexpr double largest_scale_of_moderate = 0x1p+264;
inline constexpr double largest_sensitivity_of_moderate = 0x1p+612;
inline constexpr double largest_on_the_way_of_moderate = 0x1p+940;
inline constexpr double least_slope_of_moderate = 0x1p-280;

/// Whether every number of the collision is zero or has a size from 1/M to M, M = 2⁶⁴, or 1/D to D, D = 2¹¹⁰, in a
/// normal or an orientation. If it is valid, then, for an outcome of at most M/2 a component:
///
///   (1) λ = 1/m_A + 1/m_B ≥ 1/M, and λI ⪯ K (ExactCase::is_definite), so ‖K⁻¹‖ ≤ M and N·K N ≥ N·N / M;
///   (2) Σ_j ‖∂g/∂x_j‖ |x_j| + Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖) ≤ 2²⁶⁴ for every law g: its scale;
///   (3) Σ_j ‖∂y_k/∂x_j‖ |x_j| + ‖y_k⁻‖ ≤ 2⁶¹² for the truth y of either law, by (1), and Σ_j ‖∂K/∂x_j‖ |x_j| too;
///   (4) whatever is computed on the way is at most 2⁹⁴⁰, so that nothing overflows;
///   (5) a slope ∂g/∂ŷ_k of an affine law is zero or at least 2⁻²⁸⁰ in size.
[[nodiscard]] inline bool is_moderate(const Collision& collision) {
  bool moderate = true;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        const double size = std::abs(number);
        const bool is_direction = path.field == "normal" || path.field == "orientation";
        moderate =
            moderate && (size == 0 || (size >= (is_direction ? smallest_moderate_direction : smallest_moderate) &&
                                       size <= (is_direction ? largest_moderate_direction : largest_moderate)));
      },
      collision);
  return moderate;
}

}  // namespace carom::oracles
