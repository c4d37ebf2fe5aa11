// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>

#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::oracles {

/// The error bounds of Approximation, as formulas for any scalar S, so that a test can count their roundings
/// (docs/internals/bounds.md). The computed values of x and y are x̂ and ŷ, with |x − x̂| ≤ r_x and |y − ŷ| ≤ r_y. The
/// rounded result of an operation on x̂ and ŷ is ẑ, and u is 2⁻⁵³:
///
///   (1) |x̂ + ŷ − ẑ|, |x̂ ŷ − ẑ| and |x̂ / ŷ − ẑ| are at most u |ẑ|, or half the least positive number if a product or
///       quotient underflows;
///   (2) |x + y − (x̂ + ŷ)| ≤ r_x + r_y;
///   (3) |x y − x̂ ŷ| ≤ |x̂| r_y + (|ŷ| + r_y) r_x;
///   (4) |x / y − x̂ / ŷ| ≤ (r_x + |x̂ / ŷ| r_y) / (|ŷ| − r_y);
///   (5) |√x − √x̂| ≤ r_x / √x̂, and |√x̂ − ẑ| ≤ u |ẑ|.
///
/// The factor `up` covers the roundings of each formula, and `least` the underflow.
namespace approximation {

inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr double up = 1 + 0x1p-45;
inline constexpr double down = 1 - 0x1p-45;
inline constexpr double least = 0x1p-1000;

/// An upper bound of the loss by underflow of the product in `radius_of_quotient`.
inline constexpr double least_number = 0x1p-1074;

/// An upper bound of |x| for x = ±size ± radius.
template <class S>
[[nodiscard]] S above(const S& size, const S& radius) {
  return (size + radius) * S(up);
}
/// A lower bound of |x| for x = ±size ± radius.
template <class S>
[[nodiscard]] S below(const S& size, const S& radius) {
  return size * S(down) - radius * S(up);
}

/// The radius of x + y by (1) and (2). `size` is |ẑ|.
template <class S>
[[nodiscard]] S radius_of_sum(const S& radius_x, const S& radius_y, const S& size) {
  return (radius_x + radius_y + size * S(unit_roundoff)) * S(up);
}
/// The radius of x y by (1) and (3).
template <class S>
[[nodiscard]] S radius_of_product(const S& size_x, const S& radius_x, const S& size_y, const S& radius_y,
                                  const S& size) {
  return (size_x * radius_y + (size_y + radius_y) * radius_x + size * S(unit_roundoff)) * S(up) + S(least);
}
/// The radius of x / y by (1) and (4). `below_y` is a lower bound of |ŷ| − r_y.
template <class S>
[[nodiscard]] S radius_of_quotient(const S& radius_x, const S& radius_y, const S& below_y, const S& size) {
  return ((radius_x + size * radius_y + S(least_number)) / below_y + size * S(unit_roundoff)) * S(up) + S(least);
}

/// The radius of √x by (5). `root` is ẑ, so that 1 / √x̂ ≤ (1 + u) / root.
template <class S>
[[nodiscard]] S radius_of_root(const S& radius_x, const S& root) {
  return (radius_x / root + root * S(unit_roundoff)) * S(up) + S(least);
}

}  // namespace approximation

/// A real number x with an error bound: |x − middle| ≤ radius. The operators do running error analysis in binary64 (J.
/// Wilkinson; N. Higham, Accuracy and Stability of Numerical Algorithms, §3.3). A bound that overflows is infinite or
/// NaN, and decides nothing.
class Approximation {
 public:
  Approximation() = default;
  Approximation(int exact) : middle_(exact) {}  // NOLINT(google-explicit-constructor)
  explicit Approximation(double exact) : middle_(exact) {}
  /// The radius covers the bits that binary64 does not hold.
  explicit Approximation(long double exact) : middle_(static_cast<double>(exact)) {
    const long double rest = exact - static_cast<long double>(middle_);
    radius_ = rest == 0 ? 0 : std::abs(static_cast<double>(rest)) * approximation::up + approximation::least;
  }

  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] Approximation widened_by(double radius) const {
    return {middle_, approximation::above(radius_, radius)};
  }

  /// At least |x|.
  [[nodiscard]] double magnitude_above() const { return approximation::above(std::abs(middle_), radius_); }

  /// At most |x|.
  [[nodiscard]] double magnitude_below() const {
    const double below = approximation::below(std::abs(middle_), radius_);
    return below > 0 ? below : 0;
  }

  [[nodiscard]] bool is_exactly_zero() const { return middle_ == 0 && radius_ == 0; }

  /// The sign of x: −1, 0 or 1. No value if the bound does not decide it.
  [[nodiscard]] std::optional<int> sign() const {
    if (is_exactly_zero()) {
      return 0;
    }
    if (magnitude_below() > 0) {
      return middle_ > 0 ? 1 : -1;
    }
    return std::nullopt;
  }

  friend Approximation operator-(const Approximation& x) { return {-x.middle_, x.radius_}; }

  friend Approximation operator+(const Approximation& x, const Approximation& y) {
    const double z = x.middle_ + y.middle_;
    // A sum does not underflow, but its bound can. A sum that rounds to zero is exact.
    return {z, approximation::radius_of_sum(x.radius_, y.radius_, std::abs(z)) + (z == 0 ? 0 : approximation::least)};
  }

  friend Approximation operator-(const Approximation& x, const Approximation& y) { return x + (-y); }

  friend Approximation operator*(const Approximation& x, const Approximation& y) {
    if (x.is_exactly_zero() || y.is_exactly_zero()) {
      return {};
    }
    const double z = x.middle_ * y.middle_;
    return {z, approximation::radius_of_product(std::abs(x.middle_), x.radius_, std::abs(y.middle_), y.radius_,
                                                std::abs(z))};
  }

  friend Approximation operator/(const Approximation& x, const Approximation& y) {
    const double q = x.middle_ / y.middle_;
    return {q, approximation::radius_of_quotient(x.radius_, y.radius_, y.magnitude_below(), std::abs(q))};
  }

  /// √x. Precondition: x ≥ 0, although the bounds of x may include negative numbers.
  friend Approximation sqrt(const Approximation& x) {
    if (x.is_exactly_zero()) {
      return {};
    }
    if (!(x.middle_ > 0 && x.magnitude_below() > 0)) {
      return {0, approximation::above(std::sqrt(x.magnitude_above()), 0.0)};
    }
    const double root = std::sqrt(x.middle_);
    return {root, approximation::radius_of_root(x.radius_, root)};
  }

  Approximation& operator+=(const Approximation& other) { return *this = *this + other; }
  Approximation& operator-=(const Approximation& other) { return *this = *this - other; }
  Approximation& operator*=(const Approximation& other) { return *this = *this * other; }
  Approximation& operator/=(const Approximation& other) { return *this = *this / other; }

 private:
  Approximation(double middle, double radius) : middle_(middle), radius_(radius) {}

  double middle_ = 0;
  double radius_ = 0;
};

}  // namespace carom::oracles

template <>
struct Eigen::NumTraits<carom::oracles::Approximation>
    : carom::oracles::EigenScalar<carom::oracles::Approximation, 2, 4, 8> {};
