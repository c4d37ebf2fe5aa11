// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <carom/scene/crossing.hpp>
#include <carom/scene/impact.hpp>
#include <carom/scene/supported_motion.hpp>

namespace carom::scene {
namespace {

/// A number that is at most this share of its terms is only their rounding error.
constexpr double rounding_share = 16 * roundoff;

/// The sine of the greatest angle between a velocity and the resistance against it.
constexpr double largest_turn = 0x1p-8;

/// A part of a motion, in which the resistance has one direction.
struct Stretch {
  Vector3<double> direction{0, 0, 0};  // of the resistance: it acts along −direction
  double duration = never;             // [s]
  bool stops = false;                  // whether the velocity is 0 at the end
};

/// The time after which x + G s = k s d for some d of length 1; `never` if there is none. This is the first root of
/// (k² − G²) s² − 2 x·G s − x² = 0, with the discriminant k² x² − (x × G)².
double straight_stop(const Vector3<double>& x, const Vector3<double>& driving, double resistance) {
  const double along = x.dot(driving);
  const double excess = (resistance - driving.norm()) * (resistance + driving.norm());
  const double discriminant = resistance * resistance * x.squaredNorm() - x.cross(driving).squaredNorm();
  if (discriminant < 0 || (excess <= 0 && along >= 0)) {
    return never;
  }
  const double root = std::sqrt(discriminant);
  return along > 0 ? (along + root) / excess : x.squaredNorm() / (root - along);
}

/// The first stretch of the motion x' = G − k x/‖x‖ of a velocity x, with the driving G and the resistance k [m/s²].
/// x stops at once, or turns at once, if this takes less than the time `shortest`, because such times are rounded too
/// much. Precondition: x is not 0, or ‖G‖ > k.
Stretch first_stretch(const Vector3<double>& x, const Vector3<double>& driving, double resistance, double shortest) {
  const double speed = x.norm();
  const double drive = driving.norm();
  if (resistance == 0) {
    return {};
  }
  if (speed == 0) {
    return {driving / drive, never, false};
  }
  if (drive == 0) {
    return {x / speed, speed / resistance, true};
  }
  const Vector3<double> before = x / speed;
  // If the direction that stops x on a straight way is near that of x, this way is the whole motion.
  if (const double stop = straight_stop(x, driving, resistance); stop < never) {
    const Vector3<double> direction = (x / stop + driving).normalized();
    if (stop <= shortest || (before.dot(direction) > 0 && before.cross(direction).norm() <= largest_turn)) {
      return {direction, stop, true};
    }
  }
  const Vector3<double> down = driving / drive;
  const double sine = before.cross(down).norm();
  if (resistance <= drive && before.dot(down) > 0 && sine <= largest_turn) {
    return {down, never, false};
  }
  // x turns by ‖G‖ sine/‖x‖ each second. In half of this time it is slowed by at most a half.
  const double duration =
      std::max(shortest, std::min(largest_turn * speed / (drive * sine), speed / (2 * (drive + resistance))));
  return {(x + duration / 2 * (driving - resistance * before)).normalized(), duration, false};
}

void end_by(Arc& arc, double delay, Ending ending) {
  const double end = arc.path.start + delay;
  if (end < arc.path.end) {
    arc.path.end = end;
    arc.turning.ending = ending;
  }
}

void end_by(Arc& arc, const Stretch& stretch, Ending ending) {
  end_by(arc, stretch.duration, stretch.stops ? ending : Ending::turn);
}

/// The spin of w about n. Less than the rounding error of w counts as 0, if w was computed from numbers of this size.
double spin_about(const Vector3<double>& n, const Vector3<double>& w, double size) {
  const double spin = w.dot(n);
  return std::abs(spin) > rounding_share * size ? spin : 0;
}

Vector3<double> along_plane(const Support& support, const Vector3<double>& vector) {
  return vector - support.normal * support.normal.dot(vector);
}

}  // namespace

std::optional<Support> support_of(const Vector3<double>& plane_normal, const Vector3<double>& gravity) {
  // The terms of the slope nearly cancel, so they have more digits.
  using Wide = Vector3<long double>;
  const double length = gravity.stableNorm();
  const Wide normal = plane_normal.cast<long double>().normalized();
  const long double pressing = -normal.dot(gravity.cast<long double>());
  if (!(pressing > rounding_share * length)) {
    return std::nullopt;
  }
  Wide along = gravity.cast<long double>() + pressing * normal;
  if (along.norm() <= rounding_share * length) {
    along.setZero();
  }
  return Support{plane_normal, normal.cast<double>(), static_cast<double>(pressing), along.cast<double>()};
}

Arc supported_arc(const Support& support, std::uint32_t plane, const MaterialPair& pair, bool has_friction,
                  double radius, double start, const Vector3<double>& position, const Vector3<double>& velocity,
                  const Vector3<double>& angular_velocity) {
  const Vector3<double>& n = support.normal;
  Arc arc;
  arc.path.start = start;
  arc.path.position = position;
  arc.path.velocity = along_plane(support, velocity);
  arc.path.radius = radius;
  arc.turning.angular_velocity = angular_velocity;
  arc.turning.plane = plane;

  Vector3<double>& v = arc.path.velocity;
  Vector3<double>& w = arc.turning.angular_velocity;
  Vector3<double>& acceleration = arc.path.acceleration;
  keep_apart(support.plane_normal, v);
  acceleration = support.along;
  const double p = support.pressing;
  const double spin = spin_about(n, w, w.norm());
  const Vector3<double> slip = v - radius * w.cross(n);
  const bool slips = slip.norm() > rounding_share * (v.norm() + radius * w.norm());
  const double drive = support.along.norm();
  const bool can_roll = 2.0 / 7 * drive <= pair.friction * p;
  const bool is_moving = !v.isZero(0) || drive > 0;
  const double shortest = 0x1p-40 * std::abs(start);
  if (!has_friction || (slips && pair.friction == 0)) {
    arc.turning.phase = is_moving ? Phase::sliding : Phase::resting;
  } else if (slips || !can_roll) {
    const Stretch stretch =
        first_stretch(slips ? slip : Vector3<double>::Zero(), support.along, 3.5 * pair.friction * p, shortest);
    arc.turning.phase = Phase::sliding;
    acceleration -= pair.friction * p * stretch.direction;
    arc.turning.angular_acceleration = 2.5 * (pair.friction * p / radius) * n.cross(stretch.direction);
    end_by(arc, stretch, Ending::slip);
  } else {
    w = n.cross(v) / radius + spin * n;
    const Vector3<double> driving = 5.0 / 7 * support.along;
    const double resistance = pair.rolling_resistance * p;
    const bool rolls = !v.isZero(0) || driving.norm() > resistance;
    arc.turning.phase = rolls ? Phase::rolling : Phase::resting;
    acceleration.setZero();
    if (rolls) {
      const Stretch stretch = first_stretch(v, driving, resistance, shortest);
      acceleration = driving - resistance * stretch.direction;
      arc.turning.angular_acceleration = n.cross(acceleration) / radius;
      end_by(arc, stretch, Ending::roll);
    }
  }
  keep_apart(support.plane_normal, acceleration);
  if (has_friction && pair.spinning_resistance > 0 && spin != 0) {
    const double loss = 2.5 * pair.spinning_resistance * p / radius;
    arc.turning.angular_acceleration -= std::copysign(loss, spin) * n;
    end_by(arc, std::abs(spin) / loss, Ending::spin);
  }
  measure(arc.path);
  return arc;
}

Arc after_end(const Support& support, const MaterialPair& pair, bool has_friction, const Arc& ended, double start,
              const Vector3<double>& position) {
  const Vector3<double>& n = support.normal;
  Vector3<double> velocity = velocity_at(ended.path, start);
  Vector3<double> angular_velocity = angular_velocity_at(ended, start);
  const double radius = ended.path.radius;
  const double size =
      ended.turning.angular_velocity.norm() + (start - ended.path.start) * ended.turning.angular_acceleration.norm();
  const double spin = spin_about(n, angular_velocity, size);
  switch (ended.turning.ending) {
    case Ending::slip:
      angular_velocity = n.cross(velocity) / radius + spin * n;
      break;
    case Ending::roll:
      velocity.setZero();
      angular_velocity = spin * n;
      break;
    case Ending::spin:
      angular_velocity = along_plane(support, angular_velocity);
      if (angular_velocity.norm() <= rounding_share * size) {
        angular_velocity.setZero();
      }
      break;
    case Ending::turn:
    case Ending::none:
      break;
  }
  return supported_arc(support, ended.turning.plane, pair, has_friction, radius, start, position, velocity,
                       angular_velocity);
}

}  // namespace carom::scene
