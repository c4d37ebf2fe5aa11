// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/free_flight.hpp>

namespace carom::scene {
namespace {

/// The angle for which a rotation is computed at first [rad]. Each extension doubles it. A body that lies on another
/// body has its next impact long before it turns so far.
constexpr double first_turn = 0.25;

}  // namespace

BoundedRotation rotation_at(const FreeFlight& motion, double time) {
  CAROM_EXPECTS(motion.start <= time && time <= motion.end(), time, motion.start, motion.end());
  const double elapsed = std::min(time - motion.start, motion.rotation.duration());
  BoundedRotation rotation = motion.rotation.at(elapsed);
  if (motion.start != 0) {
    rotation.angle_error += 0x1p-52 * elapsed * motion.rotation.greatest_rate();
    rotation.rate_error += 0x1p-52 * elapsed * motion.rotation.greatest_rate() * motion.rotation.greatest_rate() *
                           motion.rotation.greatest_turning();
  }
  return rotation;
}

Placement placement_at(const FreeFlight& motion, double time) {
  const double elapsed = time - motion.start;
  const BoundedRotation rotation = rotation_at(motion, time);
  const Vector3<double> moved = elapsed * (motion.velocity + elapsed / 2 * motion.acceleration);
  const double terms =
      motion.position.norm() + elapsed * (motion.velocity.norm() + elapsed / 2 * motion.acceleration.norm());
  return {rotation.state.orientation, motion.position + moved, rotation.angle_error, 0x1p-49 * terms};
}

TumblingBody::TumblingBody(RigidBody body, bool is_ball)
    : body_(std::move(body)), is_ball_(is_ball), motion_{{}, {}, {}, RotationPath(body_.orientation)} {}

void TumblingBody::set_motion(double now, const Vector3<double>& position, const Quaternion<double>& orientation,
                              const BodyVelocity<double>& velocity, const Vector3<double>& gravity) {
  orientation_ = orientation;
  angular_velocity_ = velocity.angular_velocity;
  motion_ = {position, velocity.velocity, gravity, RotationPath(orientation), now};
  const bool turns = !is_ball_ && !angular_velocity_.isZero(0);
  known_until_ = turns ? now : never;
  renewal_ = turns ? now + longest_turn / angular_velocity_.stableNorm() : never;
  path_ = {};
  path_.start = now;
  path_.position = position;
  path_.velocity = velocity.velocity;
  path_.acceleration = gravity;
  path_.radius = body_.radius() * (1 + 2 * contact_tolerance);
  measure(path_);
}

void TumblingBody::know_beyond(double time) {
  while (known_until_ <= time && known_until_ < renewal_) {
    const double first = motion_.start + first_turn / angular_velocity_.stableNorm();
    const double further = known_until_ > motion_.start ? 2 * known_until_ - motion_.start : first;
    // If rounding of the time leaves no progress, the rotation is computed up to the renewal at once.
    known_until_ = further > known_until_ ? std::min(further, renewal_) : renewal_;
    motion_.rotation = RotationPath(body_.principal_inertia, rotation_state(orientation_, angular_velocity_),
                                    known_until_ - motion_.start);
  }
}

Arc TumblingBody::arc() const {
  Arc arc;
  arc.path = path_;
  arc.path.radius = body_.radius();
  arc.turning.angular_velocity = angular_velocity_;
  return arc;
}

Placement TumblingBody::placement_at(double time) const { return carom::scene::placement_at(motion_, time); }

Vector3<double> TumblingBody::velocity_at(double time) const { return carom::scene::velocity_at(path_, time); }

Vector3<double> TumblingBody::angular_velocity_at(double time) const {
  return is_ball_ || time == motion_.start ? angular_velocity_ : world_rate(rotation_at(motion_, time).state);
}

}  // namespace carom::scene
