// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/scene/scene.hpp>

namespace carom::scene {

/// If ε = 1, this factor reduces the scene's capture height h, because the energy must stay constant. h is in units of
/// the radius R. A capture or a rebound at the least speed changes the energy by up to m g h R times this factor. With
/// the default h, this change is at most 10⁻¹² m g R, less than properties::Ledger allows for rounding.
inline constexpr double elastic_capture_share = 1e-6;

/// The least speed of a rebound that the simulation follows, √(2 a f h R) [m/s]. The factor f is
/// `elastic_capture_share` if ε = 1, otherwise 1. At this speed a body rises by f h R against the acceleration a.
[[nodiscard]] inline double least_speed(const Scene& scene, double acceleration, double radius, double restitution) {
  const double height = scene.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * acceleration * height);
}

}  // namespace carom::scene
