// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/outcome.hpp>
#include <carom/scene/arc.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

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

/// The gap at which two bodies collide, relative to the lesser radius. Up to some thousand radii from the origin,
/// stored positions are a hundred times more accurate than this gap.
inline constexpr double contact_tolerance = 0x1p-30;

/// The angle by which a body turns before its state is stored again [rad]. An error of the angular velocity grows at
/// most by e^angle, so the orientation stays accurate to 2⁻⁴⁰.
inline constexpr double longest_turn = 8;

/// A body in flight. Its rotation is computed only as far as it is needed.
class TumblingBody {
 public:
  /// The rotation of a ball is not computed.
  TumblingBody(RigidBody body, bool is_ball);

  void set_motion(double now, const Vector3<double>& position, const Quaternion<double>& orientation,
                  const BodyVelocity<double>& velocity, const Vector3<double>& gravity);

  /// Computes the rotation beyond a time, or up to the renewal if the renewal is earlier.
  void know_beyond(double time);
  /// The time up to which the rotation is known [s].
  [[nodiscard]] double known_until() const { return known_until_; }
  /// The time at which the body's state must be stored again [s]; `never` if the body does not turn.
  [[nodiscard]] double renewal() const { return renewal_; }

  [[nodiscard]] const RigidBody& body() const { return body_; }
  [[nodiscard]] const FreeFlight& motion() const { return motion_; }
  [[nodiscard]] const Quaternion<double>& orientation_at_start() const { return orientation_; }
  /// The path of the body's bounding sphere. The sphere is slightly too large, so that rounding cannot let two bodies
  /// touch while their spheres are apart.
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] Arc arc() const;

  // Precondition: the time is from the motion's start to known_until().
  [[nodiscard]] Placement placement_at(double time) const;
  [[nodiscard]] Vector3<double> velocity_at(double time) const;
  [[nodiscard]] Vector3<double> angular_velocity_at(double time) const;  // world

 private:
  RigidBody body_;
  bool is_ball_;
  FreeFlight motion_;
  Quaternion<double> orientation_;
  Vector3<double> angular_velocity_;  // at the motion's start, world
  double known_until_ = 0;
  double renewal_ = never;
  Path path_;
};

}  // namespace carom::scene
