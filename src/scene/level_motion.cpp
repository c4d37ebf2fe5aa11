// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <Eigen/Geometry>

#include <carom/scene/crossing.hpp>
#include <carom/scene/level_motion.hpp>

namespace carom::scene {
namespace {

Vector3<double> normal_of(const Level& level) {
  Vector3<double> n{0, 0, 0};
  n[level.axis] = level.up;
  return n;
}

void end_by(Arc& arc, double delay, Ending ending) {
  const double end = arc.path.start + delay;
  if (end < arc.path.end) {
    arc.path.end = end;
    arc.turning.ending = ending;
  }
}

}  // namespace

Arc level_arc(const Level& level, std::uint32_t plane, const MaterialPair& pair, bool has_friction, double radius,
              double start, const Vector3<double>& position, const Vector3<double>& velocity,
              const Vector3<double>& angular_velocity) {
  const Vector3<double> n = normal_of(level);
  Arc arc;
  arc.path.start = start;
  arc.path.position = position;
  arc.path.velocity = velocity;
  arc.path.velocity[level.axis] = 0;
  arc.path.radius = radius;
  arc.turning.angular_velocity = angular_velocity;
  arc.turning.plane = plane;

  Vector3<double>& v = arc.path.velocity;
  Vector3<double>& w = arc.turning.angular_velocity;
  const double g = level.gravity;
  const Vector3<double> by_spin = radius * w.cross(n);
  const Vector3<double> slip = v - by_spin;
  const double slip_speed = slip.norm();
  // v and `by_spin` have a few rounding errors each.
  const bool slips = slip_speed > 16 * roundoff * (v.norm() + by_spin.norm());
  if (!has_friction) {
    arc.turning.phase = v.isZero(0) ? Phase::resting : Phase::sliding;
  } else if (slips && pair.friction > 0) {
    const Vector3<double> direction = slip / slip_speed;
    arc.turning.phase = Phase::sliding;
    arc.path.acceleration = -pair.friction * g * direction;
    arc.turning.angular_acceleration = 2.5 * (pair.friction * g / radius) * n.cross(direction);
    end_by(arc, slip_speed / (3.5 * pair.friction * g), Ending::slip);
  } else if (slips) {
    arc.turning.phase = v.isZero(0) ? Phase::resting : Phase::sliding;
  } else {
    const double spin = w[level.axis];
    w = n.cross(v) / radius;
    w[level.axis] = spin;
    const double speed = v.norm();
    arc.turning.phase = speed > 0 ? Phase::rolling : Phase::resting;
    if (speed > 0 && pair.rolling_resistance > 0) {
      arc.path.acceleration = -pair.rolling_resistance * g * (v / speed);
      arc.turning.angular_acceleration = n.cross(arc.path.acceleration) / radius;
      end_by(arc, speed / (pair.rolling_resistance * g), Ending::roll);
    }
  }
  arc.path.acceleration[level.axis] = 0;
  const double spin = w[level.axis];
  if (has_friction && pair.spinning_resistance > 0 && spin != 0) {
    const double loss = 2.5 * pair.spinning_resistance * g / radius;
    arc.turning.angular_acceleration[level.axis] = std::copysign(loss, -spin);
    end_by(arc, std::abs(spin) / loss, Ending::spin);
  }
  measure(arc.path);
  return arc;
}

Arc after_end(const Level& level, const MaterialPair& pair, bool has_friction, const Arc& ended, double start,
              const Vector3<double>& position) {
  const Vector3<double> n = normal_of(level);
  Vector3<double> velocity = velocity_at(ended.path, start);
  Vector3<double> angular_velocity = angular_velocity_at(ended, start);
  const double radius = ended.path.radius;
  const double spin = angular_velocity[level.axis];
  switch (ended.turning.ending) {
    case Ending::slip:
      angular_velocity = n.cross(velocity) / radius;
      angular_velocity[level.axis] = spin;
      break;
    case Ending::roll:
      velocity.setZero();
      angular_velocity.setZero();
      angular_velocity[level.axis] = spin;
      break;
    case Ending::spin:
      angular_velocity[level.axis] = 0;
      break;
    case Ending::none:
      break;
  }
  return level_arc(level, ended.turning.plane, pair, has_friction, radius, start, position, velocity, angular_velocity);
}

}  // namespace carom::scene
