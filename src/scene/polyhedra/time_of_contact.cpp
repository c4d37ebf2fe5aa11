// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/scene/polyhedra/time_of_contact.hpp>

namespace carom::scene {
namespace {

using Vector = Vector3<double>;

/// The height [m] and the speed [m/s] of a point along a direction.
struct MovingPoint {
  double height;
  double speed;
};

/// A lower bound of the gap between two sets of points, A and B, after the time Δ:
///
///   h(Δ) = min (height + speed Δ) over A − max (height + speed Δ) over B − lost − ½ curvature Δ².
struct GapBound {
  std::vector<MovingPoint> a;
  std::vector<MovingPoint> b;
  double lost = 0;       // chosen so that h(0) is the certified gap [m]
  double curvature = 0;  // ≥ 0 [m/s²]
};

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Value {
  double gap;
  double slope;
};

Value value_at(const GapBound& bound, double time) {
  Value a{infinity, 0};
  for (const MovingPoint& point : bound.a) {
    const double height = point.height + point.speed * time;
    if (height < a.gap) {
      a = {height, point.speed};
    }
  }
  Value b{-infinity, 0};
  for (const MovingPoint& point : bound.b) {
    const double height = point.height + point.speed * time;
    if (height > b.gap) {
      b = {height, point.speed};
    }
  }
  return {a.gap - b.gap - bound.lost - bound.curvature * time * time / 2, a.slope - b.slope - bound.curvature * time};
}

/// A time of at most `limit` [s] up to which h ≥ least; 0 if h(0) ≤ least. h is concave and lies above its chords. So a
/// search along chords approaches the time of h = least from below.
double time_open(const GapBound& bound, double least, double limit) {
  double open = 0;
  double excess = value_at(bound, 0).gap - least;
  if (!(excess > 0)) {
    return 0;
  }
  Value last = value_at(bound, limit);
  double closed = limit;
  if (last.gap >= least) {
    return limit;
  }
  constexpr int most_rounds = 30;  // about five suffice
  for (int round = 0; round < most_rounds && closed - open > 1e-3 * open; ++round) {
    // If h is linear, h at the end of the whole chord is `least` up to rounding, perhaps less. So the
    // search shortens the chord slightly, and more if necessary.
    const double whole = (closed - open) * (excess / (excess + (least - last.gap)));
    double chord = open + whole * (1 - 0x1p-30);
    double excess_there = value_at(bound, chord).gap - least;
    if (!(excess_there >= 0)) {
      chord = open + whole * (1 - 0x1p-8);
      excess_there = value_at(bound, chord).gap - least;
    }
    if (!(chord > open) || !(excess_there >= 0)) {
      break;
    }
    open = chord;
    excess = excess_there;
    // A tangent lies above the concave h. So h is at most `least`, up to rounding, where the tangent falls to `least`.
    const double tangent = closed + (last.gap - least) / -last.slope;
    if (last.slope < 0 && tangent > open && tangent < closed) {
      const Value there = value_at(bound, tangent);
      if (there.gap < least) {
        closed = tangent;
        last = there;
      } else {
        open = tangent;
        break;
      }
    }
  }
  return open;
}

/// The speed at which the gap certainly opens at Δ = 0 [m/s]: the least speed of A's points minus the greatest speed of
/// B's points. Only points of A within `band` [m] of A's lowest point count, and points of B within `band` of B's
/// highest.
double opening_speed(const GapBound& bound, double band) {
  const double lowest = std::ranges::min_element(bound.a, {}, &MovingPoint::height)->height;
  const double highest = std::ranges::max_element(bound.b, {}, &MovingPoint::height)->height;
  double slowest = infinity;
  for (const MovingPoint& point : bound.a) {
    slowest = point.height <= lowest + band ? std::min(slowest, point.speed) : slowest;
  }
  double fastest = -infinity;
  for (const MovingPoint& point : bound.b) {
    fastest = point.height >= highest - band ? std::max(fastest, point.speed) : fastest;
  }
  return slowest - fastest;
}

/// The state of a body at one time, with bounds of its motion that hold at any time.
struct Moving {
  Placement placement;
  Vector velocity;
  Vector acceleration;
  Vector rate;
  double greatest_rate;  // [rad/s]
  double bending;        // upper bound of the acceleration of any vertex by rotation [m/s²]
  double turning;        // upper bound of 1 + ‖ω'‖/‖ω‖²
  double radius;
  double speed_error;              // of the computed velocity of any vertex [m/s]
  std::vector<Vector> vertices;    // relative to the centre [m]
  std::vector<Vector> velocities;  // of the vertices, by rotation alone [m/s]
};

Moving moving(const ConvexShape& shape, const FreeFlight& motion, double time) {
  const BoundedRotation rotation = rotation_at(motion, time);
  const double elapsed = time - motion.start;
  Moving m;
  m.placement = placement_at(motion, time);
  m.velocity = motion.velocity + elapsed * motion.acceleration;
  m.acceleration = motion.acceleration;
  m.rate = world_rate(rotation.state);
  m.greatest_rate = motion.rotation.greatest_rate();
  m.turning = 1 + motion.rotation.greatest_turning();
  m.radius = shape.core_radius;
  m.bending = m.radius * m.greatest_rate * m.greatest_rate * m.turning;
  // The bound covers about 27 roundings of the terms of a speed, as in rounding_of_gap, and the errors of orientation
  // and rate.
  m.speed_error =
      0x1p-47 * (motion.velocity.norm() + elapsed * motion.acceleration.norm() + m.greatest_rate * m.radius) +
      (2 * rotation.angle_error * m.greatest_rate + rotation.rate_error) * m.radius;
  m.vertices = placed_vertices(shape, m.placement, m.placement.position);
  for (const Vector& vertex : m.vertices) {
    m.velocities.emplace_back(m.rate.cross(vertex));
  }
  return m;
}

/// The search tries this number of later times to find a direction along which the shapes draw apart. Each time is a
/// quarter as far ahead as the preceding time.
constexpr int most_trials = 24;

/// The gap along a direction n that turns at a constant rate Ω, up to a time `limit`. Speeds of vertices are relative
/// to B's centre, in axes that turn with n. Heights are relative to each body's own centre; `from_certified` corrects
/// for the distance of the centres.
GapBound along(const Moving& a, const Moving& b, const Vector& n, const Vector& turning, double limit) {
  const Vector between = a.placement.position - b.placement.position;
  const Vector velocity = a.velocity - b.velocity;
  const Vector acceleration = a.acceleration - b.acceleration;
  const double rate = turning.norm();
  const double centre_speed = velocity.norm() + acceleration.norm() * limit;
  const double greatest_speed = centre_speed + a.radius * a.greatest_rate + b.radius * b.greatest_rate;
  const double greatest_arm = between.norm() + a.radius + b.radius + centre_speed * limit;
  const double speed_error = a.speed_error + b.speed_error + 0x1p-47 * rate * greatest_arm;
  GapBound bound;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const double speed = n.dot(velocity + a.velocities[i] - turning.cross(between + a.vertices[i]));
    bound.a.push_back({n.dot(a.vertices[i]), speed - speed_error});
  }
  for (std::size_t i = 0; i < b.vertices.size(); ++i) {
    bound.b.push_back({n.dot(b.vertices[i]), n.dot(b.velocities[i] - turning.cross(b.vertices[i]))});
  }
  const double against = rate > 0 ? acceleration.norm() : -n.dot(acceleration);
  bound.curvature =
      std::max(0.0, a.bending + b.bending + against + 2 * rate * greatest_speed + rate * rate * greatest_arm) *
      (1 + 0x1p-40);
  return bound;
}

/// The edge between the two vertices that are lowest (`sign` 1) or highest (`sign` −1) along n; none unless exactly two
/// vertices are within 2⁻²⁶ radii of the foremost one.
std::optional<Vector> foremost_edge(const Moving& body, const Vector& n, double sign) {
  double foremost = sign * n.dot(body.vertices.front());
  for (const Vector& vertex : body.vertices) {
    foremost = std::min(foremost, sign * n.dot(vertex));
  }
  std::vector<const Vector*> ends;
  for (const Vector& vertex : body.vertices) {
    if (sign * n.dot(vertex) <= foremost + 0x1p-26 * body.radius) {
      ends.push_back(&vertex);
    }
  }
  return ends.size() == 2 ? std::optional<Vector>(*ends[1] - *ends[0]) : std::nullopt;
}

/// The rate Ω = n × n' of a direction n that stays perpendicular to an edge e of each body: n'·e = −n·(ω × e) for both
/// edges, and n'·n = 0.
std::optional<Vector> turning_with_edges(const Moving& a, const Moving& b, const Vector& n) {
  const std::optional<Vector> of_a = foremost_edge(a, n, 1);
  const std::optional<Vector> of_b = foremost_edge(b, n, -1);
  if (!of_a || !of_b) {
    return std::nullopt;
  }
  Matrix3<double> across;
  across << of_a->transpose(), of_b->transpose(), n.transpose();
  if (std::abs(across.determinant()) < 0x1p-10 * of_a->norm() * of_b->norm()) {
    return std::nullopt;
  }
  const Vector change(-n.dot(a.rate.cross(*of_a)), -n.dot(b.rate.cross(*of_b)), 0);
  return n.cross(across.inverse() * change);
}

/// Sets `lost` so that the bound begins with the certified gap.
GapBound from_certified(GapBound bound, double certified) {
  const double lowest = std::ranges::min_element(bound.a, {}, &MovingPoint::height)->height;
  const double highest = std::ranges::max_element(bound.b, {}, &MovingPoint::height)->height;
  bound.lost = (lowest - highest) - certified;
  return bound;
}

/// Conservative advancement. `separation_at(time)` returns a certified separation. `open_for(time, separation, least,
/// limit)` returns how long a gap certainly stays above `least`. `opens(time, separation)` returns whether the shapes
/// draw apart.
template <class SeparationAt, class OpenFor, class Opens>
TimeOfContact advance(const SeparationAt& separation_at, const OpenFor& open_for, const Opens& opens, double begin,
                      double horizon, double tolerance, const std::stop_token& stop) {
  TimeOfContact result;
  result.time = begin;
  constexpr int most_advances = 10000;
  for (result.advances = 1; result.advances <= most_advances && !stop.stop_requested(); ++result.advances) {
    const Separation separation = separation_at(result.time);
    result.separation = separation;
    if (!(separation.certified > 0) || !std::isfinite(separation.gap)) {
      // After the first step, the certified gap can vanish only because the error bounds grow.
      result.status = result.time == begin ? ContactStatus::overlaps : ContactStatus::undecided;
      return result;
    }
    const double limit = horizon - result.time;
    const bool within = separation.gap <= tolerance;
    if (within && !opens(result.time, separation)) {
      result.status = ContactStatus::touches;
      return result;
    }
    if (limit <= 0) {
      result.status = ContactStatus::misses;
      return result;
    }
    // If the gap is within the tolerance, `opens` is true here. Then the step is half of `whole`, because at the end of
    // `whole` only half the gap may remain.
    const double whole = open_for(result.time, separation, within ? separation.certified / 2 : tolerance / 2, limit);
    const double step = within && whole < limit ? whole / 2 : whole;
    // Rounded down.
    const double next = step >= limit ? horizon : std::nextafter(result.time + step, begin);
    if (!(next > result.time)) {
      result.status = ContactStatus::undecided;
      return result;
    }
    result.time = next;
  }
  result.status = ContactStatus::undecided;
  return result;
}

TimeOfContact at_rest(const Separation& separation, double begin, double horizon) {
  const bool is_apart = separation.certified > 0;
  return {is_apart ? ContactStatus::misses : ContactStatus::overlaps, is_apart ? horizon : begin, separation, 1};
}

}  // namespace

TimeOfContact time_of_contact(const ShapePair& pair, const FreeFlight& a, const FreeFlight& b, double begin,
                              double horizon, double tolerance, const std::stop_token& stop) {
  CAROM_EXPECTS(a.start <= begin && b.start <= begin && horizon <= a.end() && horizon <= b.end(), begin, horizon,
                a.start, a.end(), b.start, b.end());
  CAROM_EXPECTS(tolerance > 0, tolerance);
  const auto separation_at = [&](double time) { return pair.separation(placement_at(a, time), placement_at(b, time)); };
  std::optional<Vector> way_out;  // the rate of a direction along which the shapes draw apart
  // Calls use(Ω) for each rate Ω of the direction: 0, the rate of each body (the direction turns with a face), the rate
  // that follows an edge of each body, and `way_out`.
  const auto for_each_turning = [&](const Moving& at_a, const Moving& at_b, const Vector& n, const auto& use) {
    use(Vector::Zero());
    if (at_b.greatest_rate > 0 && at_b.radius > 0) {
      use(at_b.rate);
    }
    if (at_a.greatest_rate > 0 && at_a.radius > 0) {
      use(at_a.rate);
    }
    if (const std::optional<Vector> turning = turning_with_edges(at_a, at_b, n)) {
      use(*turning);
    }
    if (way_out) {
      use(*way_out);
    }
  };
  const auto open_for = [&](double time, const Separation& separation, double least, double limit) {
    const Moving at_a = moving(pair.a(), a, time);
    const Moving at_b = moving(pair.b(), b, time);
    double longest = 0;
    for_each_turning(at_a, at_b, separation.normal, [&](const Vector& turning) {
      // A turning direction is useful only until it has turned by about half a radian.
      const double rate = turning.norm();
      const double own_limit = rate * limit > 0.5 ? 0.5 / rate : limit;
      if (longest < own_limit) {
        const GapBound bound = along(at_a, at_b, separation.normal, turning, own_limit);
        longest = std::max(longest, time_open(from_certified(bound, separation.certified), least, own_limit));
      }
    });
    way_out.reset();
    return longest;
  };
  const auto opens = [&](double time, const Separation& separation) {
    const Moving at_a = moving(pair.a(), a, time);
    const Moving at_b = moving(pair.b(), b, time);
    const auto opens_along = [&](const Vector& turning) {
      return opening_speed(along(at_a, at_b, separation.normal, turning, 0), tolerance) > 0;
    };
    bool does = false;
    for_each_turning(at_a, at_b, separation.normal,
                     [&](const Vector& turning) { does = does || opens_along(turning); });
    // If only a part of a face or an edge touches, the shapes may draw apart along any direction. So the search tries
    // the directions along which they are apart soon afterwards.
    double later = horizon - time;
    for (int trial = 0; trial < most_trials && !does; ++trial, later /= 4) {
      const double soon = std::min(time + later, horizon);  // the sum may be rounded up
      const std::optional<Separation> then = pair.quick_separation(placement_at(a, soon), placement_at(b, soon));
      const Vector across = then ? separation.normal.cross(then->normal) : Vector(Vector::Zero());
      const double sine = across.norm();
      if (sine > 0 && sine < 0.5) {
        way_out = across * (std::asin(sine) / (sine * later));
        does = opens_along(*way_out);
      }
    }
    return does;
  };
  const bool are_at_rest = a.velocity == b.velocity && a.acceleration == b.acceleration &&
                           a.rotation.greatest_rate() == 0 && b.rotation.greatest_rate() == 0 && a.start == b.start;
  if (are_at_rest) {
    return at_rest(separation_at(begin), begin, horizon);
  }
  return advance(separation_at, open_for, opens, begin, horizon, tolerance, stop);
}

TimeOfContact time_of_contact(const ConvexShape& a, const FreeFlight& motion, const HalfSpace& b, double begin,
                              double horizon, double tolerance, const std::stop_token& stop) {
  CAROM_EXPECTS(motion.start <= begin && horizon <= motion.end(), begin, horizon, motion.start, motion.end());
  CAROM_EXPECTS(tolerance > 0, tolerance);
  Moving ground{};
  ground.vertices = {Vector::Zero()};
  ground.velocities = {Vector::Zero()};
  ground.velocity = ground.acceleration = ground.rate = Vector::Zero();
  const auto bound_at = [&](double time, const Separation& separation) {
    return along(moving(a, motion, time), ground, separation.normal, Vector::Zero(), horizon - time);
  };
  const bool is_at_rest = b.normal.dot(motion.velocity) == 0 && b.normal.dot(motion.acceleration) == 0 &&
                          motion.rotation.greatest_rate() == 0;
  if (is_at_rest) {
    return at_rest(separation(a, placement_at(motion, begin), b), begin, horizon);
  }
  return advance([&](double time) { return separation(a, placement_at(motion, time), b); },
                 [&](double time, const Separation& separation, double least, double limit) {
                   return time_open(from_certified(bound_at(time, separation), separation.certified), least, limit);
                 },
                 [&](double time, const Separation& separation) {
                   return opening_speed(bound_at(time, separation), tolerance) > 0;
                 },
                 begin, horizon, tolerance, stop);
}

}  // namespace carom::scene
