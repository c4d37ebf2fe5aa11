// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <carom/impulse/rotation.hpp>
#include <carom/scene/polyhedra/open_gap.hpp>
#include <carom/scene/polyhedra/time_of_contact.hpp>

namespace carom::scene {
namespace {

using Vector = Vector3<double>;

/// A body at one time, with bounds for all times.
struct Moving {
  Placement placement;
  Vector velocity;
  Vector acceleration;
  Vector rate;
  double greatest_rate;  // [rad/s]
  double bending;        // at least the acceleration that turning gives to any vertex [m/s²]
  double turning;        // 1 + ‖ω'‖/‖ω‖²
  double radius;
  double speed_error;              // of any vertex, as computed [m/s]
  std::vector<Vector> vertices;    // from the centre
  std::vector<Vector> velocities;  // of the vertices, by turning alone
};

Moving moving(const ConvexShape& shape, const Motion& motion, double time) {
  const BoundedRotation rotation = motion.rotation.at(time);
  Moving m;
  m.placement = placement_at(motion, time);
  m.velocity = motion.velocity + time * motion.acceleration;
  m.acceleration = motion.acceleration;
  m.rate = world_rate(rotation.state);
  m.greatest_rate = motion.rotation.greatest_rate();
  m.turning = 1 + motion.rotation.greatest_turning();
  m.radius = shape.core_radius;
  m.bending = m.radius * m.greatest_rate * m.greatest_rate * m.turning;
  // Some 27 roundings of what a speed is the sum of, as of a gap, and the errors of orientation and rate.
  m.speed_error = 0x1p-47 * (motion.velocity.norm() + time * motion.acceleration.norm() + m.greatest_rate * m.radius) +
                  (2 * rotation.angle_error * m.greatest_rate + rotation.rate_error) * m.radius;
  m.vertices = placed_vertices(shape, m.placement, m.placement.position);
  for (const Vector& vertex : m.vertices) {
    m.velocities.emplace_back(m.rate.cross(vertex));
  }
  return m;
}

/// The gap along a direction that stands still. What is certain is `certified`: less than the computed gap by what may
/// be wrong.
GapBound along_fixed(const Moving& a, const Moving& b, const Separation& separation) {
  const Vector& n = separation.normal;
  const double approach = n.dot(a.velocity - b.velocity);
  GapBound bound;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    bound.a.push_back({n.dot(a.vertices[i]), approach + n.dot(a.velocities[i]) - a.speed_error - b.speed_error});
  }
  for (std::size_t i = 0; i < b.vertices.size(); ++i) {
    bound.b.push_back({n.dot(b.vertices[i]), n.dot(b.velocities[i])});
  }
  const double relative = n.dot(a.acceleration - b.acceleration);
  bound.curvature = std::max(0.0, a.bending + b.bending - relative) * (1 + 0x1p-40);
  return bound;
}

/// The gap along a direction that turns with B, where B's points rest; up to a time.
GapBound along_turning(const Moving& a, const Moving& b, const Separation& separation, double limit) {
  const Vector& n = separation.normal;
  const Vector between = a.placement.position - b.placement.position;
  const Vector velocity = a.velocity - b.velocity;
  const double acceleration = (a.acceleration - b.acceleration).norm();
  // In place of the errors of ω_B, and of the arm that it acts on.
  const double arm = between.norm() + a.radius;
  const double speed_error =
      a.speed_error + b.speed_error * (b.radius > 0 ? 1 + arm / b.radius : 1) + 0x1p-47 * b.greatest_rate * arm;
  GapBound bound;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Vector from_b = between + a.vertices[i];
    bound.a.push_back({n.dot(a.vertices[i]), n.dot(velocity + a.velocities[i] - b.rate.cross(from_b)) - speed_error});
  }
  for (const Vector& vertex : b.vertices) {
    bound.b.push_back({n.dot(vertex), 0});
  }
  const double centre_speed = velocity.norm() + acceleration * limit;
  const double greatest_speed = centre_speed + a.radius * a.greatest_rate;
  const double greatest_arm = arm + centre_speed * limit;
  bound.curvature = (a.bending + acceleration + 2 * b.greatest_rate * greatest_speed +
                     b.greatest_rate * b.greatest_rate * b.turning * greatest_arm) *
                    (1 + 0x1p-40);
  return bound;
}

/// Sets what is lost so that the bound begins with what is certified of the gap.
GapBound from_certified(GapBound bound, double certified) {
  bound.lost = 0;
  double lowest = bound.a.front().height;
  for (const MovingPoint& point : bound.a) {
    lowest = std::min(lowest, point.height);
  }
  double highest = bound.b.front().height;
  for (const MovingPoint& point : bound.b) {
    highest = std::max(highest, point.height);
  }
  bound.lost = (lowest - highest) - certified;
  return bound;
}

/// Conservative advancement. `separation_at(time)` certifies, `open_for(time, separation, least, limit)` says how long
/// a gap is certain to stay above `least`, and `opens(time, separation)` whether the shapes draw apart.
template <class SeparationAt, class OpenFor, class Opens>
TimeOfContact advance(const SeparationAt& separation_at, const OpenFor& open_for, const Opens& opens, double horizon,
                      double tolerance) {
  TimeOfContact result;
  constexpr int most_advances = 10000;
  for (result.advances = 1; result.advances <= most_advances; ++result.advances) {
    const Separation separation = separation_at(result.time);
    if (!(separation.certified > 0)) {
      // The step before this one left the gap open; what errors have grown by since closes it.
      result.approach = result.time == 0 ? Approach::overlaps : Approach::undecided;
      result.separation = separation;
      return result;
    }
    result.separation = separation;
    const bool within = separation.certified <= tolerance;
    if (within && !opens(result.time, separation)) {
      result.approach = Approach::touches;
      return result;
    }
    const double least = within ? separation.certified / 2 : tolerance / 2;
    const double limit = horizon - result.time;
    if (limit <= 0) {
      result.approach = Approach::misses;
      return result;
    }
    // Rounded down, so that the sum is not beyond the step either.
    const double step = open_for(result.time, separation, least, limit);
    const double next = step >= limit ? horizon : std::nextafter(result.time + step, 0.0);
    if (!(next > result.time)) {
      result.approach = Approach::undecided;
      return result;
    }
    result.time = next;
  }
  result.approach = Approach::undecided;
  return result;
}

Separation reversed(Separation separation) {
  separation.normal = -separation.normal;
  return separation;
}

}  // namespace

TimeOfContact time_of_contact(const ShapePair& pair, const Motion& a, const Motion& b, double horizon,
                              double tolerance) {
  const auto separation_at = [&](double time) { return pair.separation(placement_at(a, time), placement_at(b, time)); };
  const auto open_for = [&](double time, const Separation& separation, double least, double limit) {
    const Moving at_a = moving(pair.a(), a, time);
    const Moving at_b = moving(pair.b(), b, time);
    double step = time_open(from_certified(along_fixed(at_a, at_b, separation), separation.certified), least, limit);
    // A direction that turns is of use for as long as it does not turn far.
    const double rates = at_a.greatest_rate + at_b.greatest_rate;
    const double short_limit = rates * limit > 0.5 ? 0.5 / rates : limit;
    if (step < short_limit && at_b.greatest_rate > 0 && at_b.radius > 0) {
      const GapBound bound = along_turning(at_a, at_b, separation, short_limit);
      step = std::max(step, time_open(from_certified(bound, separation.certified), least, short_limit));
    }
    if (step < short_limit && at_a.greatest_rate > 0 && at_a.radius > 0) {
      const GapBound bound = along_turning(at_b, at_a, reversed(separation), short_limit);
      step = std::max(step, time_open(from_certified(bound, separation.certified), least, short_limit));
    }
    return step;
  };
  const auto opens = [&](double time, const Separation& separation) {
    return opening_speed(along_fixed(moving(pair.a(), a, time), moving(pair.b(), b, time), separation), tolerance) > 0;
  };
  return advance(separation_at, open_for, opens, horizon, tolerance);
}

TimeOfContact time_of_contact(const ConvexShape& a, const Motion& motion, const HalfSpace& b, double horizon,
                              double tolerance) {
  Moving ground{};
  ground.vertices = {Vector::Zero()};
  ground.velocities = {Vector::Zero()};
  ground.velocity = ground.acceleration = ground.rate = Vector::Zero();
  const auto bound_at = [&](double time, const Separation& separation) {
    return along_fixed(moving(a, motion, time), ground, separation);
  };
  return advance([&](double time) { return separation(a, placement_at(motion, time), b); },
                 [&](double time, const Separation& separation, double least, double limit) {
                   return time_open(from_certified(bound_at(time, separation), separation.certified), least, limit);
                 },
                 [&](double time, const Separation& separation) {
                   return opening_speed(bound_at(time, separation), tolerance) > 0;
                 },
                 horizon, tolerance);
}

}  // namespace carom::scene
