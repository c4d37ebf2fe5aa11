// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/scene/polyhedra/convex_shape.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

namespace carom::scene {

/// A body in flight: its centre on a parabola, turning freely. All vectors in the world, at time 0.
struct Motion {
  Vector3<double> position{0, 0, 0};      // of the centre of mass [m]
  Vector3<double> velocity{0, 0, 0};      // [m/s]
  Vector3<double> acceleration{0, 0, 0};  // [m/s²]
  RotationPath rotation;
};

/// Where a body is at a time [s], with what that may be wrong by: the position p + s (v + s a / 2) is rounded seven
/// times. Precondition: 0 ≤ time ≤ duration of the rotation.
[[nodiscard]] Placement placement_at(const Motion& motion, double time);

}  // namespace carom::scene
