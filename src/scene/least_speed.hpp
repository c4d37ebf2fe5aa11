// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Of the capture height, for ε = 1, where rebounds never get lower by themselves: capturing one, or sending it off at
/// the least speed, changes the energy by up to m g h R, which elastic scenes are not to lose or gain. With the default
/// h that is 10⁻¹² m g R, no more than the ledger lets rounding take.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that is followed, √(2 a h R) with the scene's capture height h: so it rises to h R
/// against an acceleration a, that of gravity for a sphere [m/s].
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

}  // namespace carom::scene
