// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <vector>

#include <carom/collision/vector.hpp>
#include <carom/scene/level_motion.hpp>
#include <carom/scene/motion.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A body at one time of a run: the arc that it is on, and where that has led.
struct BodyState {
  double mass = 1;                             // [kg]
  Vector3<double> principal_inertia{1, 1, 1};  // along the body axes [kg m²]
  Arc arc;
  /// Body axes to world axes, at the arc's start and now; of a sphere in a scene without polyhedra not followed.
  Quaternion<double> orientation_at_start{1, 0, 0, 0};
  Quaternion<double> orientation{1, 0, 0, 0};
  Vector3<double> angular_velocity{0, 0, 0};  // now, world [rad/s]
};

/// A run at one time: what those who watch it begin and end with.
struct SceneState {
  const Scene* scene = nullptr;
  double time = 0;                           // [s]
  std::vector<BodyState> bodies;             // spheres first
  std::vector<std::optional<Level>> levels;  // of each plane: how spheres rest on it, where they do
};

}  // namespace carom::scene
