// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// An elastic rebound is worth following further down: it keeps its energy.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that is followed, √(2 a h R) with the scene's capture height h: so it rises to h R
/// against an acceleration a, that of gravity for a sphere [m/s].
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

}  // namespace carom::scene
