// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <carom/collision/outcome.hpp>
#include <carom/impulse/exact_sum.hpp>
#include <carom/impulse/products.hpp>

/// N·V of the numbers as they are stored: with V = (v_A + w_A × (P − X_A)) − (v_B + w_B × (P − X_B)), a polynomial of
/// the collision's N, P, X_A, X_B and of any four velocities. Not of a Contact, whose lever arms are rounded.
namespace carom::impulse {

namespace detail {

/// Adds s N·(v + w × (P − X)), s = ±1.
inline void add_normal_velocity(const Collision& c, const Body& body, const BodyVelocity<double>& motion, double s,
                                ExactSum& sum) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double n = s * c.normal[i];
    sum.add(n, motion.velocity[i]);
    sum.add(n, motion.angular_velocity[j], c.point[k]);
    sum.add(-n, motion.angular_velocity[j], body.position[k]);
    sum.add(-n, motion.angular_velocity[k], c.point[j]);
    sum.add(n, motion.angular_velocity[k], body.position[j]);
  }
}

/// N·V in double, and the sum of the absolute values of its terms, for one body.
inline void add_rounded_normal_velocity(const Collision& c, const Body& body, const BodyVelocity<double>& motion,
                                        double s, double& sum, double& terms) {
  const Vector3<double> r = c.point - body.position;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double direct = c.normal[i] * motion.velocity[i];
    const double left = r[j] * c.normal[k];
    const double right = r[k] * c.normal[j];
    sum += s * (direct + (left - right) * motion.angular_velocity[i]);
    terms += std::abs(direct) + (std::abs(left) + std::abs(right)) * std::abs(motion.angular_velocity[i]);
  }
}

}  // namespace detail

/// N·V exactly. Precondition: all numbers are finite.
[[nodiscard]] inline ExactSum exact_normal_velocity(const Collision& collision, const Outcome<double>& motion) {
  ExactSum sum;
  detail::add_normal_velocity(collision, collision.a, motion.a, 1, sum);
  detail::add_normal_velocity(collision, collision.b, motion.b, -1, sum);
  return sum;
}

/// The sign of the exact N·V: −1, 0 or 1, by a sum in double where its error bound decides. Precondition: all numbers
/// are finite.
[[nodiscard]] inline int normal_velocity_sign(const Collision& collision, const Outcome<double>& motion) {
  double sum = 0;
  double terms = 0;
  detail::add_rounded_normal_velocity(collision, collision.a, motion.a, 1, sum, terms);
  detail::add_rounded_normal_velocity(collision, collision.b, motion.b, -1, sum, terms);
  // A term passes at most 11 roundings: P − X, two products, a difference, an addition, and 6 additions to the sum; so
  // the error is at most γ₁₁ Σ|terms|, and 16 u covers it and the roundings of Σ|terms| itself. What underflows loses
  // at most 2⁻¹⁰⁷⁵ a product, 18 times, times a component of the normal or of w.
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const double largest_factor = 1 + collision.normal.cwiseAbs().maxCoeff() +
                                motion.a.angular_velocity.cwiseAbs().maxCoeff() +
                                motion.b.angular_velocity.cwiseAbs().maxCoeff();
  const double bound = 16 * u * terms + std::numeric_limits<double>::min() * largest_factor;
  if (std::abs(sum) > bound) {  // false where anything overflowed
    return sum < 0 ? -1 : 1;
  }
  return exact_normal_velocity(collision, motion).sign();
}

}  // namespace carom::impulse
