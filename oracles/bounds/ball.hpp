// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/vector.hpp>
#include <carom/oracles/bounds/norm.hpp>

/// Numbers and vectors with an error radius. Vectors lie in Euclidean balls, so the results do not depend on the axes.
/// The functions do not bound their own rounding, because a ball only tells how much error the judge permits
/// (permitted_inputs.hpp).
namespace carom::oracles {

struct ScalarBall {
  double centre = 0;
  double radius = 0;

  [[nodiscard]] double least() const { return centre - radius; }
  [[nodiscard]] double largest() const { return centre + radius; }
  [[nodiscard]] bool contains(double x) const { return std::abs(x - centre) <= radius; }
};

struct VectorBall {
  Vector3<double> centre = Vector3<double>::Zero();
  double radius = 0;

  /// The largest length of a vector in the ball.
  [[nodiscard]] double largest() const { return norm_of(centre) + radius; }
};

[[nodiscard]] inline ScalarBall operator-(const ScalarBall& x) { return {-x.centre, x.radius}; }
[[nodiscard]] inline ScalarBall operator+(const ScalarBall& x, const ScalarBall& y) {
  return {x.centre + y.centre, x.radius + y.radius};
}
[[nodiscard]] inline ScalarBall operator*(const ScalarBall& x, const ScalarBall& y) {
  return {x.centre * y.centre, std::abs(x.centre) * y.radius + x.radius * std::abs(y.centre) + x.radius * y.radius};
}

[[nodiscard]] inline VectorBall operator-(const VectorBall& v) { return {-v.centre, v.radius}; }
[[nodiscard]] inline VectorBall operator+(const VectorBall& v, const VectorBall& w) {
  return {v.centre + w.centre, v.radius + w.radius};
}
[[nodiscard]] inline VectorBall operator-(const VectorBall& v, const VectorBall& w) { return v + -w; }
[[nodiscard]] inline VectorBall operator*(const ScalarBall& x, const VectorBall& v) {
  return {x.centre * v.centre, std::abs(x.centre) * v.radius + x.radius * v.largest()};
}

namespace detail {

/// The radius of a bilinear product v ∘ w of two vectors. Precondition: ‖v ∘ w‖ ≤ ‖v‖ ‖w‖.
[[nodiscard]] inline double radius_of_product(const VectorBall& v, const VectorBall& w) {
  return norm_of(v.centre) * w.radius + v.radius * w.largest();
}

}  // namespace detail

[[nodiscard]] inline ScalarBall dot(const VectorBall& v, const VectorBall& w) {
  return {v.centre.dot(w.centre), detail::radius_of_product(v, w)};
}
[[nodiscard]] inline VectorBall cross(const VectorBall& v, const VectorBall& w) {
  return {v.centre.cross(w.centre), detail::radius_of_product(v, w)};
}

}  // namespace carom::oracles
