// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <carom/scene/arc.hpp>
#include <carom/scene/crossing.hpp>
#include <carom/scene/exact_time.hpp>

namespace carom::scene {

/// The position and velocity of a path at a time, in double, with bounds of their errors. Each term of the position x +
/// s (v + (s/2) a) at the time start + s has at most 6 roundings (N. J. Higham, "Accuracy and Stability of Numerical
/// Algorithms", 2nd ed. 2002, ch. 3).
struct PathState {
  Vector3<double> position, velocity;
  double position_error, velocity_error;  // in the 1-norm
};

/// The state at the time start + s. Sizes are 1-norms.
[[nodiscard]] inline PathState state_at(double s, const Vector3<double>& position, const Vector3<double>& velocity,
                                        const Vector3<double>& acceleration, double position_size, double velocity_size,
                                        double acceleration_size) {
  if (s == 0) {
    return {position, velocity, 0, 0};
  }
  const double turn = acceleration_size * s;
  return {position + s * (velocity + (0.5 * s) * acceleration), velocity + s * acceleration,
          7 * roundoff * (position_size + s * (velocity_size + turn)),
          acceleration_size == 0 ? 0 : 4 * roundoff * (velocity_size + turn)};
}

[[nodiscard]] inline PathState state_at(const Path& path, double now) {
  return state_at(now - path.start, path.position, path.velocity, path.acceleration, path.position_size,
                  path.velocity_size, path.acceleration_size);
}

/// The state of a sphere relative to another sphere. Sizes and errors are 1-norms.
struct RelativeState {
  Vector3<double> distance, velocity;  // of A relative to B
  double distance_size, velocity_size;
  double distance_error, velocity_error;
  double radii;

  RelativeState(const PathState& a, const PathState& b, double both_radii)
      : distance(a.position - b.position),
        velocity(a.velocity - b.velocity),
        distance_size(distance.cwiseAbs().sum()),
        velocity_size(velocity.cwiseAbs().sum()),
        distance_error(a.position_error + b.position_error + 2 * roundoff * distance_size),
        velocity_error(a.velocity_error + b.velocity_error + 2 * roundoff * velocity_size),
        radii(both_radii) {}

  [[nodiscard]] double squared_gap() const { return distance.dot(distance) - radii * radii; }
  [[nodiscard]] double squared_gap_error() const {
    return (2 * distance_size + distance_error) * distance_error +
           8 * roundoff * (distance_size * distance_size + radii * radii);
  }
  [[nodiscard]] double receding() const { return distance.dot(velocity); }
  [[nodiscard]] double receding_error() const {
    return distance_size * velocity_error + (velocity_size + velocity_error) * distance_error +
           4 * roundoff * distance_size * velocity_size;
  }
};

/// The squared distance minus the squared sum of the radii, as a quadratic in the time s from now. Precondition: both
/// paths have the same acceleration.
[[nodiscard]] inline UncertainQuadratic squared_gap(const RelativeState& pair) {
  return {pair.squared_gap(),
          2 * pair.receding(),
          pair.velocity.dot(pair.velocity),
          pair.squared_gap_error(),
          2 * pair.receding_error(),
          (2 * pair.velocity_size + pair.velocity_error) * pair.velocity_error +
              8 * roundoff * pair.velocity_size * pair.velocity_size};
}

[[nodiscard]] inline UncertainQuadratic height_over(const Path& sphere, const Reach& plane, double now) {
  const PathState at = state_at(sphere, now);
  const Vector3<double>& n = plane.normal;
  const double n_size = n.cwiseAbs().maxCoeff();
  const auto rounding_of_dot = [&](const Vector3<double>& x) { return 5 * roundoff * n.cwiseAbs().dot(x.cwiseAbs()); };
  return {n.dot(at.position) - plane.reach,
          n.dot(at.velocity),
          0.5 * n.dot(sphere.acceleration),
          rounding_of_dot(at.position) + 2 * roundoff * std::abs(plane.reach) + n_size * at.position_error,
          rounding_of_dot(at.velocity) + n_size * at.velocity_error,
          0.5 * rounding_of_dot(sphere.acceleration)};
}

/// The squared gap of two spheres whose accelerations differ, as a quartic in the time s from now, for s in [0, span].
/// `bernstein` holds its Bernstein coefficients on this interval, each within `error` of the true coefficient.
struct UncertainQuartic {
  std::array<double, 5> bernstein;
  double error;
  double span;
};

[[nodiscard]] UncertainQuartic squared_gap(const RelativeState& pair, const Path& a, const Path& b, double span);

/// The first crossing in [0, span]: the least s at which the quartic falls below 0 (see `Crossing`). The search divides
/// the interval (R. T. Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29, 2012, §5). On
/// each part, the least and the greatest Bernstein coefficient bound the quartic.
[[nodiscard]] Crossing first_crossing(const UncertainQuartic& quartic);

/// Counts of decisions that needed exact arithmetic.
struct ExactCounts {
  unsigned long long predictions = 0;  // whether and when two paths touch
  unsigned long long orders = 0;       // which of two events is first
  unsigned long long gaps = 0;         // whether stored positions overlap
  unsigned long long ties = 0;         // two events at one instant, exactly
};

/// Bounds of the first time from `now` on at which the gap of two spheres falls below 0. Both bounds are `never` if the
/// gap certainly stays at least 0 up to `horizon`. Precondition: at `now` the gap is at least 0.
[[nodiscard]] TimeBounds contact_between(const Path& a, const Path& b, const RelativeState& pair, double now,
                                         double horizon, ExactCounts& counts);

/// The same bounds for a sphere and a plane.
[[nodiscard]] TimeBounds contact_between(const Path& sphere, const Reach& plane, double now, double horizon,
                                         ExactCounts& counts);

/// Whether two spheres certainly do not touch up to the horizon, because they are too far apart, or recede with equal
/// accelerations. `bends`: whether the accelerations differ. `acceleration_size`: the sum of their 1-norms.
[[nodiscard]] inline bool stay_apart(const RelativeState& pair, bool bends, double acceleration_size, double now,
                                     double horizon) {
  const double span = std::max(0.0, horizon - now);
  const double bend = bends ? 0.5 * acceleration_size * span : 0;
  // The factor 1 + 16 u (u = `roundoff`) covers the roundings of sums and products of positive numbers.
  const double reach = (pair.radii + pair.distance_error + (pair.velocity_size + pair.velocity_error + bend) * span) *
                       (1 + 16 * roundoff);
  // Computes both conditions without a branch, because a processor could not predict the branch.
  const bool is_far = pair.distance.dot(pair.distance) > reach * reach;
  const bool recedes = pair.receding() > pair.receding_error();
  return is_far | (!bends & recedes);
}

[[nodiscard]] inline bool stay_apart(const Path& a, const Path& b, const RelativeState& pair, double now,
                                     double horizon) {
  return stay_apart(pair, a.acceleration != b.acceleration, a.acceleration_size + b.acceleration_size, now, horizon);
}

}  // namespace carom::scene
