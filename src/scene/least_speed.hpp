// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A capture or a rebound at the least speed (below) changes the energy by up to m g h R, with the scene's capture
/// height h in radii R. If ε = 1, the energy must stay constant, so this factor reduces h. With the default h, the
/// change is at most 10⁻¹² m g R. `carom scene` permits as much for rounding: 10⁻¹² of the energy.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that the simulation follows, √(2 a f h R) [m/s]. The factor f is
/// `elastic_capture_share` if ε = 1, otherwise 1. At this speed a body rises by f h R against the acceleration a.
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

}  // namespace carom::scene
