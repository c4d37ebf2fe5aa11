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

/// Whether every number of the collision is zero or has a size from 1/M to M, M = 2⁶⁴, or 1/D to D, D = 2¹¹⁰, in a
/// normal or an orientation. For a valid collision the scale of every law for an outcome of at most M, and the
/// sensitivities of the truth and of the collision matrix, are then below 2⁹⁰⁰: with the lever arms r ≤ 4 M, the
/// impulse of either law is at most 2⁹ M⁷ (‖K⁻¹‖ ≤ 1/λ ≤ M), K at most 2⁹ M³, a derivative multiplies it by no more
/// than ‖K⁻¹‖ times that of K, and the change of a velocity is at most an impulse times 4 M²: 2³⁰ M¹³ = 2⁸⁶² with room.
/// These are of degree zero in the normal and in the quaternions. Laws are of lower degree, and of degree one in the
/// normal: below 2²⁰ D M⁵ = 2⁴⁵⁰.
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
