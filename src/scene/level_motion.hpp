// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

#include <carom/scene/arc.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A level plane. Gravity g presses spheres onto it along an axis of the world.
struct Level {
  int axis = 2;
  double up = 1;       // 1 or −1: the normal along the axis
  double gravity = 0;  // g > 0 [m/s²]
};

/// The motion of a sphere on a level plane from `start` on: it slips, rolls or rests, and spins about the normal n. The
/// slip is u = v − R w × n, with the velocity v and the angular velocity w. Friction slows the slip by (7/2) μ g [m/s²]
/// along a fixed direction. Rolling resistance slows a rolling sphere by μ_r g [m/s²]. Spinning resistance slows the
/// spin about n by (5/2) μ_s g/R [rad/s²] (W. Leckie, M. Greenspan, "An event-based pool physics simulator", 2006). The
/// stored acceleration is rounded, and the path follows it exactly. A slip that is only rounding error counts as 0. The
/// velocity along n becomes 0. Without friction, a sphere that moves slips forever.
[[nodiscard]] Arc level_arc(const Level& level, std::uint32_t plane, const MaterialPair& pair, bool has_friction,
                            double radius, double start, const Vector3<double>& position,
                            const Vector3<double>& velocity, const Vector3<double>& angular_velocity);

/// The motion after the end of an arc. The motion that ended (slip, rolling or spin) is exactly 0 from then on.
[[nodiscard]] Arc after_end(const Level& level, const MaterialPair& pair, bool has_friction, const Arc& ended,
                            double start, const Vector3<double>& position);

}  // namespace carom::scene
