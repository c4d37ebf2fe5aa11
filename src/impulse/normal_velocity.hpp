// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <carom/collision/outcome.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>

/// N·V of the stored numbers of a collision: V = (v_A + w_A × (P − X_A)) − (v_B + w_B × (P − X_B)), with P the contact
/// point and X a centre of mass. (The lever arms P − X of a Contact are rounded.)
namespace carom::impulse {

namespace detail {

/// Adds s N·(v + w × (P − X)) of one body to `sum`, exactly. s = ±1.
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

template <class Size, class S>
[[nodiscard]] Size size_of(const S& x) {
  using std::abs;
  return abs(static_cast<Size>(x));
}

/// r_j N_k and r_k N_j for cyclic i, j, k. Their difference is component i of r × N.
template <class S>
struct MomentTerms {
  S left;
  S right;
};

template <class S>
[[nodiscard]] MomentTerms<S> moment_terms(const Vector3<S>& r, const Vector3<S>& n, int i) {
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  return {r[j] * n[k], r[k] * n[j]};
}

/// Adds s N·(v + w × (P − X)) of one body, computed in S, to `sum`. Adds the absolute values of its terms to `terms`.
template <class S, class Size>
void add_rounded_normal_velocity(const Collision& c, const Body& body, const BodyVelocity<double>& motion, double s,
                                 S& sum, Size& terms) {
  Vector3<S> r;
  Vector3<S> n;
  for (int i = 0; i < 3; ++i) {
    r[i] = S(c.point[i]) - S(body.position[i]);
    n[i] = S(c.normal[i]);
  }
  for (int i = 0; i < 3; ++i) {
    const double w = motion.angular_velocity[i];
    const S direct = n[i] * S(motion.velocity[i]);
    const auto [left, right] = moment_terms<S>(r, n, i);
    sum += S(s) * (direct + (left - right) * S(w));
    terms += size_of<Size>(direct) + (size_of<Size>(left) + size_of<Size>(right)) * size_of<Size>(w);
  }
}

/// At most this many roundings affect each term of the computed N·V.
inline constexpr int roundings_of_normal_velocity = 10;

/// The factor of the error bound in `RoundedNormalVelocity`. It also covers the rounding errors of the bound itself.
inline constexpr int covered_roundings_of_normal_velocity = 16;

/// The error of N·V by underflow is below this number times (1 + max_i |w_A,i| + max_i |w_B,i|).
inline constexpr double underflow_of_normal_velocity = std::numeric_limits<double>::min();

/// N·V in S, and a bound of its error. ρ = `rounding` is the relative error of one operation of S. n = 10 is
/// `roundings_of_normal_velocity`. t are the terms of N·V, and T is the computed Σ|t|. The bound is 16 ρ T + underflow:
///
///   (1) |value − N·V| ≤ n ρ / (1 − n ρ) Σ|t| + underflow, by n roundings of each term;
///   (2) Σ|t| ≤ (1 + 2⁻⁴⁸) T, because fewer than 2⁵ roundings of double affect a term in T;
///   (3) n / (1 − n ρ) (1 + 2⁻⁴⁸) ≤ 16;
///   (4) each of the 24 products loses less than 2⁻¹⁰⁷⁰ to underflow, and the loss in r × N is multiplied by w.
template <class S>
struct RoundedNormalVelocity {
  RoundedNormalVelocity(const Collision& collision, const Outcome<double>& motion, double rounding) {
    double terms = 0;
    add_rounded_normal_velocity<S>(collision, collision.a, motion.a, 1, value, terms);
    add_rounded_normal_velocity<S>(collision, collision.b, motion.b, -1, value, terms);
    const double largest_factor =
        1 + motion.a.angular_velocity.cwiseAbs().maxCoeff() + motion.b.angular_velocity.cwiseAbs().maxCoeff();
    bound = covered_roundings_of_normal_velocity * rounding * terms + underflow_of_normal_velocity * largest_factor;
  }

  S value{0};
  double bound = 0;
};

inline constexpr double unit_roundoff_of_double = std::numeric_limits<double>::epsilon() / 2;

/// The largest relative error of a DoubleDouble operation except division: 7 u², the error of the product.
inline constexpr double unit_roundoff_of_double_double = 7 * unit_roundoff_of_double * unit_roundoff_of_double;

/// A double-double value counts as known if |value| > 2⁵⁰ bound. The factor 16 of the bound covers 10 roundings, so the
/// error of the value is at most about 10/16 of the bound. Its relative error is at most about 10/16 · 2⁻⁵⁰, and at
/// most 2⁻⁵⁰ after rounding to double.
inline constexpr double known_multiple_of_bound = 0x1p+50;

}  // namespace detail

/// N·V exactly. Precondition: all numbers are finite.
[[nodiscard]] inline ExactSum exact_normal_velocity(const Collision& collision, const Outcome<double>& motion) {
  ExactSum sum;
  detail::add_normal_velocity(collision, collision.a, motion.a, 1, sum);
  detail::add_normal_velocity(collision, collision.b, motion.b, -1, sum);
  return sum;
}

/// The sign and the value of the exact N·V.
struct NormalVelocity {
  int sign;      // −1, 0 or 1
  double value;  // relative error at most 2⁻⁵⁰; 0 or infinite if beyond the range of double
};

/// The exact N·V, by double-double arithmetic if its error bound is small enough, otherwise by an exact sum.
/// Precondition: all numbers are finite.
[[nodiscard]] inline NormalVelocity known_normal_velocity(const Collision& collision, const Outcome<double>& motion) {
  const detail::RoundedNormalVelocity<DoubleDouble> closely(collision, motion, detail::unit_roundoff_of_double_double);
  const auto value = static_cast<double>(closely.value);
  if (std::abs(value) > detail::known_multiple_of_bound * closely.bound) {  // false if anything overflowed
    return {value < 0 ? -1 : 1, value};
  }
  const ExactSum exactly = exact_normal_velocity(collision, motion);
  return {exactly.sign(), exactly.approximately()};
}

/// The sign of the exact N·V: −1, 0 or 1. Computed in double if the error bound decides the sign. Precondition: all
/// numbers are finite.
[[nodiscard]] inline int normal_velocity_sign(const Collision& collision, const Outcome<double>& motion) {
  const detail::RoundedNormalVelocity<double> roughly(collision, motion, detail::unit_roundoff_of_double);
  if (std::abs(roughly.value) > roughly.bound) {  // false if anything overflowed
    return roughly.value < 0 ? -1 : 1;
  }
  return known_normal_velocity(collision, motion).sign;
}

}  // namespace carom::impulse
