// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/scene/arc.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// An error that ends a run early: bodies overlap at the beginning, impacts at one instant do not end, or a position is
/// too inaccurate.
class SceneError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class EventKind : std::uint8_t {
  impact,        // of two bodies
  plane_impact,  // of a body and a plane
  capture,       // a sphere stays on a plane
  phase,         // slipping, rolling or spinning has ended, or friction has turned
  renewal,       // a polyhedron has turned so far that its state is stored again
};

[[nodiscard]] constexpr std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::plane_impact:
      return "plane_impact";
    case EventKind::capture:
      return "capture";
    case EventKind::renewal:
      return "renewal";
    case EventKind::phase:
      break;
  }
  return "phase";
}

/// The motion of a body before and after an event.
struct Change {
  std::uint32_t body = 0;  // spheres first, then polyhedra, each in the scene's order
  Arc before, after;
  /// Only in scenes with polyhedra: the rotation from body axes to world axes at the event, and the angular velocity
  /// before the event [rad/s].
  Quaternion<double> orientation{1, 0, 0, 0};
  Vector3<double> angular_velocity_before{0, 0, 0};
};

struct Event {
  double time = 0;  // [s]
  EventKind kind = EventKind::impact;
  Change a;
  std::optional<Change> b;   // only for an impact of two bodies
  std::uint32_t plane = 0;   // only for plane impacts, captures and phases
  bool has_impulse = false;  // only for impacts and captures: whether the bodies approached
  Collision collision;       // only for impacts and captures; the origin is the contact point
  Outcome<double> outcome;   // by the law; the stored velocities are in `Change::after`
  /// Whether the approach is slower than `least_speed` (scene.hpp) and the body cannot rest. If so, ε is 1 in
  /// `collision`, and the bodies part at least at the least speed for ε = 1.
  bool was_slow = false;
};

struct Counts {
  unsigned long long events = 0;
  unsigned long long impacts = 0;  // of two bodies
  unsigned long long plane_impacts = 0;
  unsigned long long captures = 0;
  unsigned long long phases = 0;
  unsigned long long renewals = 0;
  unsigned long long crossings = 0;       // of cells; these are not events of the scene
  unsigned long long slow = 0;            // impacts with `was_slow`
  unsigned long long moved_clear = 0;     // positions moved by ulps until no third body overlaps
  unsigned long long at_one_instant = 0;  // largest number of impacts at one time
  unsigned long long advances = 0;        // steps of conservative advancement (time_of_contact.hpp)
  ExactCounts exact;
};

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
  double time = 0;                // [s]
  std::vector<BodyState> bodies;  // spheres first
};

}  // namespace carom::scene
