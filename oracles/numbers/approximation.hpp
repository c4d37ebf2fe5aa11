// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::oracles {

/// A real number known to within a radius: |x − middle| ≤ radius. Binary64 with a bound that is carried along, a tenth
/// of the work of an `Enclosure`: running error analysis, J. Wilkinson; N. Higham, Accuracy and Stability of Numerical
/// Algorithms, §3.3. The rounded result ẑ of an operation is off by at most u |ẑ|, or by the least number where it
/// underflows. Each operation on the bound is rounded up: the few roundings of 2⁻⁵³ each are less than `up`, and what
/// underflows is less than `least`. Where a bound overflows it is infinite or no number, and nothing is decided.
class Approximation {
 public:
  Approximation() = default;
  Approximation(int exact) : middle_(exact) {}  // NOLINT(google-explicit-constructor)
  explicit Approximation(double exact) : middle_(exact) {}
  /// What is beyond binary64 becomes part of the radius.
  explicit Approximation(long double exact) : middle_(static_cast<double>(exact)) {
    const long double rest = exact - static_cast<long double>(middle_);
    radius_ = rest == 0 ? 0 : std::abs(static_cast<double>(rest)) * up + least;
  }

  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }

  /// The same, known to within so much less.
  [[nodiscard]] Approximation widened_by(double radius) const { return {middle_, (radius_ + radius) * up}; }

  /// At least |x|.
  [[nodiscard]] double magnitude_above() const { return (std::abs(middle_) + radius_) * up; }

  /// At most |x|.
  [[nodiscard]] double magnitude_below() const {
    const double below = std::abs(middle_) * down - radius_ * up;
    return below > 0 ? below : 0;
  }

  [[nodiscard]] bool is_exactly_zero() const { return middle_ == 0 && radius_ == 0; }

  /// −1, 0 or 1 where it is certain.
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
    // Sums do not underflow, their bounds can; a sum of zero is exact.
    return {z, (x.radius_ + y.radius_ + std::abs(z) * unit_roundoff) * up + (z == 0 ? 0 : least)};
  }

  friend Approximation operator-(const Approximation& x, const Approximation& y) { return x + (-y); }

  // |x y − x̂ ŷ| ≤ |x̂| r_y + (|ŷ| + r_y) r_x.
  friend Approximation operator*(const Approximation& x, const Approximation& y) {
    if (x.is_exactly_zero() || y.is_exactly_zero()) {
      return {};
    }
    const double z = x.middle_ * y.middle_;
    return {z, (std::abs(x.middle_) * y.radius_ + (std::abs(y.middle_) + y.radius_) * x.radius_ +
                std::abs(z) * unit_roundoff) *
                       up +
                   least};
  }

  // |x / y − q| = |x − q y| / |y| ≤ (r_x + |q| r_y) / (|ŷ| − r_y) with q = x̂ / ŷ, up to the rounding of q.
  friend Approximation operator/(const Approximation& x, const Approximation& y) {
    const double divisor = y.magnitude_below();
    const double q = x.middle_ / y.middle_;
    return {q, ((x.radius_ + std::abs(q) * y.radius_) / divisor + std::abs(q) * unit_roundoff) * up + least};
  }

  Approximation& operator+=(const Approximation& other) { return *this = *this + other; }
  Approximation& operator-=(const Approximation& other) { return *this = *this - other; }
  Approximation& operator*=(const Approximation& other) { return *this = *this * other; }
  Approximation& operator/=(const Approximation& other) { return *this = *this / other; }

 private:
  Approximation(double middle, double radius) : middle_(middle), radius_(radius) {}

  // Half an ulp, and a little more: the bound of q's rounding enters the error bound a second time.
  static constexpr double unit_roundoff = 0x1p-53 * (1 + 0x1p-20);
  static constexpr double up = 1 + 0x1p-45;
  static constexpr double down = 1 - 0x1p-45;
  static constexpr double least = 0x1p-1000;

  double middle_ = 0;
  double radius_ = 0;
};

}  // namespace carom::oracles

template <>
struct Eigen::NumTraits<carom::oracles::Approximation>
    : carom::oracles::EigenScalar<carom::oracles::Approximation, 2, 4, 8> {};
