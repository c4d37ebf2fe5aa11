// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/outcome.hpp>
#include <carom/scene/motion.hpp>
#include <carom/scene/polyhedra/motion.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::scene {

/// How near two bodies come before they are struck, beside the lesser one's radius: stored places are known a hundred
/// times as well, up to some thousand radii from the origin.
inline constexpr double contact_tolerance = 0x1p-30;

/// How far a body turns before where it has come to is stored, and it goes on from there [rad]: an error of its rate
/// grows by no more than e to that power, which leaves the angle known to 2⁻⁴⁰.
inline constexpr double longest_turn = 8;

/// A body in flight. How it turns is worked out no further than is asked for.
class TumblingBody {
 public:
  /// A ball is not turned: its spin stays, and which way it has turned changes nothing.
  TumblingBody(RigidBody body, bool is_ball);

  /// From now on it moves so.
  void set_motion(double now, const Vector3<double>& position, const Quaternion<double>& orientation,
                  const BodyVelocity<double>& velocity, const Vector3<double>& gravity);

  /// Works out how it turns beyond a time, or until it is to be stored anew.
  void know_beyond(double time);
  /// Up to when that is worked out [s].
  [[nodiscard]] double known_until() const { return known_until_; }
  /// When it has turned so far that it is to be stored anew [s]; `never` where it does not turn.
  [[nodiscard]] double renewal() const { return renewal_; }

  [[nodiscard]] const RigidBody& body() const { return body_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] const Quaternion<double>& orientation_at_start() const { return orientation_; }
  /// Of the ball about it, a little wider than it is: what stays apart by it does so whatever is rounded.
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] Arc arc() const;

  // Precondition: from the motion's start to known_until().
  [[nodiscard]] Placement placement_at(double time) const;
  [[nodiscard]] Vector3<double> velocity_at(double time) const;
  [[nodiscard]] Vector3<double> angular_velocity_at(double time) const;  // world

 private:
  RigidBody body_;
  bool is_ball_;
  Motion motion_;
  Quaternion<double> orientation_;
  Vector3<double> angular_velocity_;  // at the motion's start, world
  double known_until_ = 0;
  double renewal_ = never;
  Path path_;
};

}  // namespace carom::scene
