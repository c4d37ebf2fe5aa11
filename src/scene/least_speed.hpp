// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// The factor of the capture height for ε = 1. These rebounds never get lower by themselves. Capturing one, or sending
/// it off at the least speed, changes the energy by up to m g h R. Elastic scenes must not lose or gain that much. With
/// the default h this factor leaves 10⁻¹² m g R, which is within the ledger's allowance for rounding.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that is followed, √(2 a h R) [m/s], with the scene's capture height h, reduced for ε =
/// 1. At this speed a body rises by h R against the acceleration a, which is gravity for a sphere.
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

}  // namespace carom::scene
