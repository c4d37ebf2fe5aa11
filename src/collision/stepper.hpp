// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <carom/collision/precision.hpp>
#include <carom/collision/subject.hpp>
#include <carom/collision/vector.hpp>

/// The language of engines in time: a scene that an engine advances in steps, and the states that it reports.
namespace carom {

struct SphereShape {
  double radius;  // > 0 [m]
};

struct BoxShape {
  Vector3<double> lengths;  // of the edges along the body axes, > 0 [m]
};

/// The solid half-space through the position of a fixed body. The normal points out of it.
struct HalfSpaceShape {
  Vector3<double> normal;
};

using Shape = std::variant<SphereShape, BoxShape, HalfSpaceShape>;

/// The state of a body, in world axes.
struct BodyState {
  Vector3<double> position{0, 0, 0};           // of the centre of mass [m]
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes
  Vector3<double> velocity{0, 0, 0};           // of the centre of mass [m/s]
  Vector3<double> angular_velocity{0, 0, 0};   // [rad/s]
};

struct SteppedBody {
  Shape shape;
  bool is_fixed = false;                       // it has an infinite mass, and is at rest
  double mass = 1;                             // > 0 [kg]
  Vector3<double> principal_inertia{1, 1, 1};  // along the body axes, > 0 [kg m²]
  BodyState state = {};
};

struct SteppedScene {
  Vector3<double> gravity{0, 0, 0};  // [m/s²]
  double restitution = 0;            // ε of every pair, in [0, 1]
  double friction = 0;               // μ of every pair, ≥ 0
  bool is_continuous = false;        // whether the engine should look for contacts between the ends of steps
  std::vector<SteppedBody> bodies;
};

/// The engine advances the scene by steps of equal length.
struct Stepping {
  SteppedScene scene;
  double step = 0;                    // h > 0 [s]
  std::vector<std::uint64_t> report;  // after so many steps the states are reported; ascending, not empty
  /// If it is not 0, it is in `report`: the engine saves its state after so many steps, advances to the end, restores
  /// the state, and advances again. What it reports after the restored state is of the second time.
  std::uint64_t restored = 0;
};

struct SteppedStates {
  std::vector<std::vector<BodyState>> states;  // of each body, for each number of `Stepping::report`
  double seconds = 0;                          // of the stepping alone, by the engine's clock
};

using SteppingAnswer = std::variant<SteppedStates, Skipped, Refused, Failed>;

/// An engine that advances scenes in steps.
struct Stepper {
  std::string name;
  std::string specification = {};  // on the command line, if it differs from `name`: "exec:PROGRAM ARG…"
  std::string version = {};
  Precision precision = Precision::binary64;
  bool is_planar = false;  // it poses only scenes in the plane z = 0
  std::vector<std::string> cannot =
      {};                 // "sphere", "box", "half_space", "continuous", "friction": it skips such scenes
  bool restores = false;  // whether it takes a `Stepping` with `restored`
  std::vector<std::string> claims = {};  // "bounce within 5% at 1/60 s"
  std::string absent = {};               // why it cannot run here; empty if it can

  using Session = std::function<SteppingAnswer(const Stepping&)>;
  /// Opens a session. Only the thread that opened it may use it.
  std::function<Session()> open = {};
};

/// The greatest number of steps that a stepping takes.
[[nodiscard]] inline std::uint64_t steps_of(const Stepping& stepping) { return stepping.report.back(); }

}  // namespace carom
