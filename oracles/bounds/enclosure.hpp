// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::oracles {

/// The error bounds of Enclosure, as formulas for any scalar S, so that a test can count their roundings
/// (docs/internals/bounds.md). The computed values of x and y are x̂ and ŷ, with |x − x̂| ≤ r_x and |y − ŷ| ≤ r_y. The
/// result of double-double arithmetic on x̂ and ŷ is z, and u is 2⁻⁵³. If no number leaves the range of binary64:
///
///   (1) |x̂ + ŷ − z| ≤ 3u² / (1 − 4u) |x̂ + ŷ| and |x̂ ŷ − z| ≤ 7u² |x̂ ŷ| (M. Joldes, J.-M. Muller, V. Popescu, ACM
///       Trans. Math. Softw. 44 (2017), algorithms 6 and 10). Both errors are at most 16u² |z|;
///   (2) |x y − x̂ ŷ| ≤ |x| r_y + |y| r_x;
///   (3) |x / y − q| ≤ (|x̂ − q ŷ| + r_x + |q| r_y) / (|ŷ| − r_y) for every q;
///   (4) |√x − q| ≤ (|x̂ − q²| + r_x) / q for every q > 0.
///
/// The factor `up` covers the roundings of each formula. A product or quotient loses less than `least` to underflow.
namespace enclosure {

inline constexpr double rounding = 0x1p-102;  // 16 u²
inline constexpr double up = 1 + 0x1p-48;
inline constexpr double down = 1 - 0x1p-48;
inline constexpr double least = 0x1p-900;

/// An upper bound of |x| for x = ±high ± low ± radius.
template <class S>
[[nodiscard]] S above(const S& high, const S& low, const S& radius) {
  return (high * S(up) + low) + radius * S(up);
}
/// A lower bound of |x| for x = ±high ± low ± radius.
template <class S>
[[nodiscard]] S below(const S& high, const S& low, const S& radius) {
  return high * S(down) - low - radius * S(up);
}

/// The radius of z = ±high ± low: the error `of_operands`, the rounding by (1), and the underflow `absolute`.
template <class S>
[[nodiscard]] S radius_of_result(const S& of_operands, const S& high, const S& low, double absolute) {
  return of_operands * S(up) + (high + low) * S(rounding) + S(absolute);
}
/// The error of x y that comes from the errors of x and y, by (2).
template <class S>
[[nodiscard]] S radius_of_product(const S& above_x, const S& radius_x, const S& above_y, const S& radius_y) {
  return above_x * radius_y + above_y * radius_x;
}
/// The radius of a quotient q, by (3). `rest` is an upper bound of |x̂ − q ŷ|, and `above_q` of |q|. `below_y` is a
/// lower bound of |ŷ| − r_y.
template <class S>
[[nodiscard]] S radius_of_quotient(const S& rest, const S& radius_x, const S& above_q, const S& radius_y,
                                   const S& below_y) {
  return (rest + radius_x + above_q * radius_y) / below_y * S(up);
}

/// The radius of a root q, by (4). `rest` is an upper bound of |x̂ − q²|, and `below_q` a lower bound of q.
template <class S>
[[nodiscard]] S radius_of_root(const S& rest, const S& radius_x, const S& below_q) {
  return (rest + radius_x) / below_q * S(up);
}

}  // namespace enclosure

/// A real number x with an error bound: |x − (high + low)| ≤ radius. The operators do double-double arithmetic, to
/// about 100 bits. If a number leaves the range of binary64, the radius is infinite, and the enclosure decides nothing.
/// Sums and products are inlined by force, because calls would cost a tenth of the gate's time.
class Enclosure {
 public:
  Enclosure() = default;
  Enclosure(int exact) : high_(exact) {}  // NOLINT(google-explicit-constructor)
  explicit Enclosure(double exact) : high_(exact) {}
  explicit Enclosure(long double exact)
      : high_(static_cast<double>(exact)), low_(static_cast<double>(exact - static_cast<long double>(high_))) {
    // A long double may have a wider range or more bits than two doubles. If the number does not fit into two doubles,
    // the radius is infinite, so that rationals decide.
    const bool is_held = std::isfinite(high_) && std::abs(high_) >= enclosure::least &&
                         exact - static_cast<long double>(high_) == static_cast<long double>(low_);
    radius_ = is_held || exact == 0 ? 0 : infinity;
  }
  explicit Enclosure(const Rational& exact) : high_(to_double(exact)) {
    if (!std::isfinite(high_)) {
      *this = {0, 0, infinity};
      return;
    }
    low_ = to_double(exact - Rational(high_));
    // The remainder exact − high − low is at most an ulp of low, or lies below the range of binary64.
    const bool is_exact = exact == Rational(high_) + Rational(low_);
    const Pair normalised = fast_two_sum(high_, low_);
    *this = {normalised.high, normalised.low, is_exact ? 0 : std::abs(low_) * part_of_lower + enclosure::least};
  }

  [[nodiscard]] double middle() const { return high_; }
  [[nodiscard]] double lower_part() const { return low_; }
  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] Enclosure widened_by(double radius) const { return {high_, low_, (radius_ + radius) * enclosure::up}; }

  /// At least |x|.
  [[nodiscard]] double magnitude_above() const { return enclosure::above(std::abs(high_), std::abs(low_), radius_); }

  /// At most |x|.
  [[nodiscard]] double magnitude_below() const {
    return std::max(0.0, enclosure::below(std::abs(high_), std::abs(low_), radius_));
  }

  [[nodiscard]] bool is_exactly_zero() const { return high_ == 0 && low_ == 0 && radius_ == 0; }

  /// The sign of x: −1, 0 or 1. No value if the bound does not decide it.
  [[nodiscard]] std::optional<int> sign() const {
    if (is_exactly_zero()) {
      return 0;
    }
    if (magnitude_below() > 0) {
      return high_ > 0 ? 1 : -1;
    }
    return std::nullopt;
  }

  [[gnu::always_inline]] friend Enclosure operator-(const Enclosure& x) { return {-x.high_, -x.low_, x.radius_}; }

  [[gnu::always_inline]] friend Enclosure operator+(const Enclosure& x, const Enclosure& y) {
    const Pair s = two_sum(x.high_, y.high_);
    const Pair t = two_sum(x.low_, y.low_);
    const Pair v = fast_two_sum(s.high, s.low + t.high);
    const Pair z = fast_two_sum(v.high, t.low + v.low);
    return with_rounding(z, x.radius_ + y.radius_, 0);  // sums do not underflow
  }

  [[gnu::always_inline]] friend Enclosure operator-(const Enclosure& x, const Enclosure& y) { return x + (-y); }

  [[gnu::always_inline]] friend Enclosure operator*(const Enclosure& x, const Enclosure& y) {
    if (x.is_exactly_zero() || y.is_exactly_zero()) {
      return {};
    }
    const Pair c = two_product(x.high_, y.high_);
    const Pair z = fast_two_sum(c.high, c.low + (x.high_ * y.low_ + x.low_ * y.high_));
    const double radius = x.radius_ > 0 || y.radius_ > 0 ? enclosure::radius_of_product(x.magnitude_above(), x.radius_,
                                                                                        y.magnitude_above(), y.radius_)
                                                         : 0;
    return with_rounding(z, radius, enclosure::least);
  }

  friend Enclosure operator/(const Enclosure& x, const Enclosure& y) {
    const double divisor = y.magnitude_below();
    if (!(divisor > 0)) {
      return {0, 0, infinity};
    }
    // Two steps of long division give x = (q1 + q2) y + rest. The rest bounds the error of the quotient.
    const double q1 = x.high_ / y.high_;
    const Enclosure rest1 = without_radius(x) - without_radius(y) * Enclosure(q1);
    const double q2 = rest1.high_ / y.high_;
    const Enclosure rest2 = rest1 - without_radius(y) * Enclosure(q2);
    const Pair q = fast_two_sum(q1, q2);
    const double radius = enclosure::radius_of_quotient(
        rest2.magnitude_above(), x.radius_, (std::abs(q1) + std::abs(q2)) * enclosure::up, y.radius_, divisor);
    return with_rounding(q, radius, enclosure::least);
  }

  /// √x. Precondition: x ≥ 0, although the bounds of x may include negative numbers.
  friend Enclosure sqrt(const Enclosure& x) {
    if (x.is_exactly_zero()) {
      return {};
    }
    if (!(x.high_ > 0 && x.magnitude_below() > 0)) {
      return {0, 0, std::sqrt(x.magnitude_above()) * enclosure::up};
    }
    // One step of Newton's method gives x = (q1 + q2)² + rest. The rest bounds the error of the root.
    const double q1 = std::sqrt(x.high_);
    const Enclosure rest1 = without_radius(x) - Enclosure(q1) * Enclosure(q1);
    const Pair q = fast_two_sum(q1, rest1.high_ / (2 * q1));
    const Enclosure root{q.high, q.low, 0};
    const Enclosure rest2 = without_radius(x) - root * root;
    return with_rounding(q, enclosure::radius_of_root(rest2.magnitude_above(), x.radius_, root.magnitude_below()),
                         enclosure::least);
  }

  Enclosure& operator+=(const Enclosure& other) { return *this = *this + other; }
  Enclosure& operator-=(const Enclosure& other) { return *this = *this - other; }
  Enclosure& operator*=(const Enclosure& other) { return *this = *this * other; }

 private:
  struct Pair {
    double high;
    double low;
  };

  Enclosure(double high, double low, double radius) : high_(high), low_(low), radius_(radius) {}

  static Enclosure without_radius(const Enclosure& x) { return {x.high_, x.low_, 0}; }

  static Pair two_sum(double a, double b) {
    const double s = a + b;
    const double of_b = s - a;
    const double of_a = s - of_b;
    return {s, (a - of_a) + (b - of_b)};
  }

  static Pair fast_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  static Pair split(double a) {
    const double c = splitter * a;
    const double high = c - (c - a);
    return {high, a - high};
  }

  /// Dekker's product, without fused multiply-add. An overflow gives NaN, which with_rounding turns into an infinite
  /// radius.
  static Pair two_product(double a, double b) {
    const double p = a * b;
    const Pair x = split(a);
    const Pair y = split(b);
    return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }

  /// z with its error bound: `radius`, plus the roundings of z and of the bound, plus the underflow `absolute`.
  static Enclosure with_rounding(const Pair& z, double radius, double absolute) {
    // `bound` includes the lower part, so that an infinity or NaN in any part makes `bound` infinite or NaN.
    const double bound = enclosure::radius_of_result(radius, std::abs(z.high), std::abs(z.low), absolute);
    if (!(bound < infinity)) {
      return {0, 0, infinity};
    }
    return {z.high, z.low, bound};
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double splitter = 134217729;  // 2²⁷ + 1
  // An upper bound of |exact − high − low| / |low| for a rational. to_double errs by less than an ulp, which is at most
  // 2⁻⁵² of its result.
  static constexpr double part_of_lower = 0x1p-50;

  double high_ = 0;
  double low_ = 0;
  double radius_ = 0;
};

}  // namespace carom::oracles

template <>
struct Eigen::NumTraits<carom::oracles::Enclosure> : carom::oracles::EigenScalar<carom::oracles::Enclosure, 3, 20, 30> {
};
