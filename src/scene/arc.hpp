// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include <carom/collision/vector.hpp>

namespace carom::scene {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The kind of motion of a sphere between two of its events (event.hpp).
enum class Phase : std::uint8_t {
  flying,   // under gravity alone
  sliding,  // on a plane, with slip at the contact point
  rolling,  // on a plane, without slip
  resting,  // on a plane; it may still spin about the normal
};

[[nodiscard]] constexpr std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::flying:
      return "flying";
    case Phase::sliding:
      return "sliding";
    case Phase::rolling:
      return "rolling";
    case Phase::resting:
      break;
  }
  return "resting";
}

/// The path of a sphere's centre from `start` on: exactly x + v s + a s²/2 at the time start + s, with x, v and a
/// below.
struct Path {
  double start = 0;                       // [s]
  double end = never;                     // time at which the phase changes by itself [s]
  Vector3<double> position{0, 0, 0};      // x [m]
  Vector3<double> velocity{0, 0, 0};      // v [m/s]
  Vector3<double> acceleration{0, 0, 0};  // a [m/s²]
  double radius = 0;                      // of the sphere [m]
  double position_size = 0;               // ‖x‖₁
  double velocity_size = 0;               // ‖v‖₁
  double acceleration_size = 0;           // ‖a‖₁
};

/// The motion that becomes 0 at the end of an arc. `turn`: friction gets a new direction. `none`: only an impact ends
/// the arc.
enum class Ending : std::uint8_t { none, slip, roll, spin, turn };

/// The rotation of a sphere, and the plane that supports it.
struct Turning {
  Vector3<double> angular_velocity{0, 0, 0};      // w at the path's start, w + α s at start + s [rad/s]
  Vector3<double> angular_acceleration{0, 0, 0};  // α [rad/s²]
  Phase phase = Phase::flying;
  Ending ending = Ending::none;  // at the path's end
  std::uint32_t plane = 0;       // index of the plane that the sphere is on, if it is not flying
};

struct Arc {
  Path path;
  Turning turning;
};

/// Stores the three sizes, because every prediction reads them.
inline void measure(Path& path) {
  path.position_size = path.position.cwiseAbs().sum();
  path.velocity_size = path.velocity.cwiseAbs().sum();
  path.acceleration_size = path.acceleration.cwiseAbs().sum();
}

[[nodiscard]] inline Vector3<double> position_at(const Path& path, double time) {
  const double s = time - path.start;
  return path.position + s * (path.velocity + (0.5 * s) * path.acceleration);
}

[[nodiscard]] inline Vector3<double> velocity_at(const Path& path, double time) {
  return path.velocity + (time - path.start) * path.acceleration;
}

[[nodiscard]] inline Vector3<double> angular_velocity_at(const Arc& arc, double time) {
  return arc.turning.angular_velocity + (time - arc.path.start) * arc.turning.angular_acceleration;
}

}  // namespace carom::scene
