// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <vector>

#include <carom/collision/vector.hpp>
#include <carom/scene/arc.hpp>
#include <carom/scene/level_motion.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

struct BodyState {
  double mass = 1;                             // [kg]
  Vector3<double> principal_inertia{1, 1, 1};  // along the body axes [kg m²]
  Arc arc;
  /// Rotations from body axes to world axes, at the arc's start and at `SceneState::time`. Only computed for a scene
  /// with polyhedra.
  Quaternion<double> orientation_at_start{1, 0, 0, 0};
  Quaternion<double> orientation{1, 0, 0, 0};
  Vector3<double> angular_velocity{0, 0, 0};  // at `SceneState::time`, world [rad/s]
};

/// The state of a run at its beginning or end.
struct SceneState {
  const Scene* scene = nullptr;
  double time = 0;                           // [s]
  std::vector<BodyState> bodies;             // spheres first
  std::vector<std::optional<Level>> levels;  // for each plane, how spheres rest on it; nothing if they cannot
};

}  // namespace carom::scene
