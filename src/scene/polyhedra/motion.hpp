// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/scene/polyhedra/convex_shape.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

namespace carom::scene {

/// A body in flight from `start` on: its centre on a parabola, turning freely. All vectors in the world, at the start.
struct Motion {
  Vector3<double> position{0, 0, 0};      // of the centre of mass [m]
  Vector3<double> velocity{0, 0, 0};      // [m/s]
  Vector3<double> acceleration{0, 0, 0};  // [m/s²]
  RotationPath rotation;
  double start = 0;  // [s]

  /// Until when it is known how the body turns [s].
  [[nodiscard]] double end() const { return start + rotation.duration(); }
};

/// Where a body is at a time [s], with what that may be wrong by: the position p + s (v + s a / 2), s = time − start,
/// is rounded eight times, and s once for the rotation. Precondition: start ≤ time ≤ end.
[[nodiscard]] Placement placement_at(const Motion& motion, double time);

/// How it turns at that time, with what that may be wrong by. Precondition: start ≤ time ≤ end.
[[nodiscard]] BoundedRotation rotation_at(const Motion& motion, double time);

}  // namespace carom::scene
