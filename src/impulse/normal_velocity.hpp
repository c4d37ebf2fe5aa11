// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <carom/collision/outcome.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>

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

/// s N·(v + w × (P − X)) in S, and the sum of the absolute values of its terms, for one body.
template <class S>
void add_rounded_normal_velocity(const Collision& c, const Body& body, const BodyVelocity<double>& motion, double s,
                                 S& sum, double& terms) {
  const auto size = [](const S& x) { return std::abs(static_cast<double>(x)); };
  std::array<S, 3> r;
  for (int i = 0; i < 3; ++i) {
    r[static_cast<std::size_t>(i)] = S(c.point[i]) - S(body.position[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto normal = [&](std::size_t axis) { return S(c.normal[static_cast<int>(axis)]); };
    const double w = motion.angular_velocity[static_cast<int>(i)];
    const S direct = normal(i) * S(motion.velocity[static_cast<int>(i)]);
    const S left = r[j] * normal(k);
    const S right = r[k] * normal(j);
    sum += S(s) * (direct + (left - right) * S(w));
    terms += size(direct) + (size(left) + size(right)) * std::abs(w);
  }
}

/// N·V in S, and by how much it may be off: a term passes at most 11 roundings (P − X, two products, a difference, an
/// addition, and 6 additions to the sum), each relatively less than `rounding`, so the error is below γ₁₁ Σ|terms|, and
/// 16 times the rounding covers it and the roundings of Σ|terms| itself. What underflows loses less than 2⁻¹⁰⁷⁰ a
/// product, 18 times, times a component of the normal or of w.
template <class S>
struct RoundedNormalVelocity {
  RoundedNormalVelocity(const Collision& collision, const Outcome<double>& motion, double rounding) {
    double terms = 0;
    add_rounded_normal_velocity<S>(collision, collision.a, motion.a, 1, value, terms);
    add_rounded_normal_velocity<S>(collision, collision.b, motion.b, -1, value, terms);
    const double largest_factor = 1 + collision.normal.cwiseAbs().maxCoeff() +
                                  motion.a.angular_velocity.cwiseAbs().maxCoeff() +
                                  motion.b.angular_velocity.cwiseAbs().maxCoeff();
    bound = 16 * rounding * terms + std::numeric_limits<double>::min() * largest_factor;
  }

  S value{0};
  double bound = 0;
};

inline constexpr double unit_roundoff_of_double = std::numeric_limits<double>::epsilon() / 2;

}  // namespace detail

/// N·V exactly. Precondition: all numbers are finite.
[[nodiscard]] inline ExactSum exact_normal_velocity(const Collision& collision, const Outcome<double>& motion) {
  ExactSum sum;
  detail::add_normal_velocity(collision, collision.a, motion.a, 1, sum);
  detail::add_normal_velocity(collision, collision.b, motion.b, -1, sum);
  return sum;
}

/// What is asked of the exact N·V.
struct NormalVelocity {
  int sign;      // −1, 0 or 1
  double value;  // within a relative 2⁻⁴⁰; 0 or infinite where it leaves the range of double
};

/// By double-double arithmetic where its error bound decides, else by the exact sum. Precondition: all numbers are
/// finite.
[[nodiscard]] inline NormalVelocity known_normal_velocity(const Collision& collision, const Outcome<double>& motion) {
  constexpr double u = detail::unit_roundoff_of_double;
  const detail::RoundedNormalVelocity<DoubleDouble> closely(collision, motion, 7 * u * u);
  const auto value = static_cast<double>(closely.value);
  if (std::abs(value) > 0x1p+40 * closely.bound) {  // false where anything overflowed
    return {value < 0 ? -1 : 1, value};
  }
  const ExactSum exactly = exact_normal_velocity(collision, motion);
  return {exactly.sign(), exactly.approximately()};
}

/// The sign of the exact N·V: −1, 0 or 1, by a sum in double where its error bound decides. Precondition: all numbers
/// are finite.
[[nodiscard]] inline int normal_velocity_sign(const Collision& collision, const Outcome<double>& motion) {
  const detail::RoundedNormalVelocity<double> roughly(collision, motion, detail::unit_roundoff_of_double);
  if (std::abs(roughly.value) > roughly.bound) {  // false where anything overflowed
    return roughly.value < 0 ? -1 : 1;
  }
  return known_normal_velocity(collision, motion).sign;
}

}  // namespace carom::impulse
