// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/scene/polyhedra/convex_shape.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

namespace carom::scene {

/// A body in flight from `start` on, on a parabola and in free rotation. All vectors are in world axes, at the time
/// `start`.
struct FreeFlight {
  Vector3<double> position{0, 0, 0};      // of the centre of mass [m]
  Vector3<double> velocity{0, 0, 0};      // [m/s]
  Vector3<double> acceleration{0, 0, 0};  // [m/s²]
  RotationPath rotation;
  double start = 0;  // [s]

  /// The time up to which the rotation is known [s].
  [[nodiscard]] double end() const { return start + rotation.duration(); }
};

/// The placement of a body at a time [s], with bounds of its errors. Precondition: start ≤ time ≤ end.
[[nodiscard]] Placement placement_at(const FreeFlight& motion, double time);

/// The rotation of a body at a time [s], with bounds of its errors. Precondition: start ≤ time ≤ end.
[[nodiscard]] BoundedRotation rotation_at(const FreeFlight& motion, double time);

}  // namespace carom::scene
