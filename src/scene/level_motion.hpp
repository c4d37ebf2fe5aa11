// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

#include <carom/scene/motion.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A level plane: gravity g presses spheres onto it along an axis of the world.
struct Level {
  int axis = 2;
  double up = 1;       // 1 or −1, the normal along that axis
  double gravity = 0;  // g > 0 [m/s²]
};

/// The motion, from `start` on, of a sphere on a level plane: slipping, rolling or resting, and spinning about the
/// normal. With n the normal, u = v − R w × n is the slip. Friction μ g against it slows the slip by (7/2) μ g a second
/// along a fixed direction; rolling resistance slows a sphere that rolls by μ_r g; spin about n loses (5/2) μ_s g/R (W.
/// Leckie, M. Greenspan, "An event-based pool physics simulator", 2006). The direction u/‖u‖ is rounded, and is then
/// what it is: the path is exactly that of the acceleration that stands in it. A slip that is nothing but rounding is
/// none.
///
/// Velocity along n is not read: it is 0. `has_friction`: whether the law reads μ; without, a sphere slips for ever.
[[nodiscard]] Arc level_arc(const Level& level, std::uint32_t plane, const MaterialPair& pair, bool has_friction,
                            double radius, double start, const Vector3<double>& position,
                            const Vector3<double>& velocity, const Vector3<double>& angular_velocity);

/// The motion that follows on an arc's end: what ended by itself is exactly 0 then. `position` and `start` as the loop
/// has stored them.
[[nodiscard]] Arc after_end(const Level& level, const MaterialPair& pair, bool has_friction, const Arc& ended,
                            double start, const Vector3<double>& position);

}  // namespace carom::scene
