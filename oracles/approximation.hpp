// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Core>

namespace carom::oracles {

/// A real number known to within an error: |x − value| ≤ error. Extended precision with a bound that is carried along,
/// a tenth of the work of an `Enclosure`: running error analysis, J. Wilkinson; N. Higham, Accuracy and Stability of
/// Numerical Algorithms, §3.3. The rounded result ẑ of an operation is off by at most u |ẑ|, or by the least number
/// where it underflows. The bound itself is kept in binary64, each operation on it rounded up: three roundings of 2⁻⁵³
/// each are less than `up`, and what underflows is less than `least`. Where a bound overflows it is infinite or no
/// number, and nothing is decided.
class Approximation {
 public:
  Approximation() = default;
  Approximation(int exact) : value_(exact) {}  // NOLINT(google-explicit-constructor)
  explicit Approximation(double exact) : value_(static_cast<long double>(exact)) {}
  explicit Approximation(long double exact) : value_(exact) {}

  [[nodiscard]] long double value() const { return value_; }
  [[nodiscard]] double error() const { return error_; }

  /// The same, known to within so much less.
  [[nodiscard]] Approximation widened_by(double error) const { return {value_, (error_ + error) * up}; }

  /// The value and the error in binary64.
  [[nodiscard]] double middle() const { return static_cast<double>(value_); }
  [[nodiscard]] double radius() const { return error_ * up + std::abs(middle()) * half_ulp + least; }

  /// At least |x|.
  [[nodiscard]] double magnitude_above() const { return (size(value_) + error_) * up; }

  /// At most |x|.
  [[nodiscard]] double magnitude_below() const {
    const double below = static_cast<double>(std::abs(value_)) * down - error_ * up - least;
    return below > 0 ? below : 0;
  }

  [[nodiscard]] bool is_exactly_zero() const { return value_ == 0 && error_ == 0; }

  /// −1, 0 or 1 where it is certain.
  [[nodiscard]] std::optional<int> sign() const {
    if (is_exactly_zero()) {
      return 0;
    }
    if (magnitude_below() > 0) {
      return value_ > 0 ? 1 : -1;
    }
    return std::nullopt;
  }

  friend Approximation operator-(const Approximation& x) { return {-x.value_, x.error_}; }

  friend Approximation operator+(const Approximation& x, const Approximation& y) {
    const long double z = x.value_ + y.value_;
    // Sums do not underflow, their bounds can; a sum of zero is exact.
    return {z, (x.error_ + y.error_ + size(z) * unit_roundoff) * up + (z == 0 ? 0 : least)};
  }

  friend Approximation operator-(const Approximation& x, const Approximation& y) { return x + (-y); }

  // |x y − x̂ ŷ| ≤ |x̂| e_y + (|ŷ| + e_y) e_x.
  friend Approximation operator*(const Approximation& x, const Approximation& y) {
    const long double z = x.value_ * y.value_;
    if (z == 0 && (x.is_exactly_zero() || y.is_exactly_zero())) {
      return {};
    }
    return {
        z, (size(x.value_) * y.error_ + (size(y.value_) + y.error_) * x.error_ + size(z) * unit_roundoff) * up + least};
  }

  // |x / y − q| = |x − q y| / |y| ≤ (e_x + |q| e_y) / (|ŷ| − e_y) with q = x̂ / ŷ, up to the rounding of q.
  friend Approximation operator/(const Approximation& x, const Approximation& y) {
    const double divisor = y.magnitude_below();
    const long double q = x.value_ / y.value_;
    return {q, ((x.error_ + size(q) * y.error_) / divisor + size(q) * unit_roundoff) * up + least};
  }

  Approximation& operator+=(const Approximation& other) { return *this = *this + other; }
  Approximation& operator-=(const Approximation& other) { return *this = *this - other; }
  Approximation& operator*=(const Approximation& other) { return *this = *this * other; }
  Approximation& operator/=(const Approximation& other) { return *this = *this / other; }

 private:
  Approximation(long double value, double error) : value_(value), error_(error) {}

  /// At least |x|, but for one rounding.
  static double size(long double x) { return std::abs(static_cast<double>(x)) + std::numeric_limits<double>::min(); }

  // Half an ulp, and a little more: the bound of q's rounding enters the error bound a second time.
  static constexpr double unit_roundoff =
      static_cast<double>(std::numeric_limits<long double>::epsilon()) * (0.5 + 0x1p-20);
  static constexpr double half_ulp = 0x1p-53;
  static constexpr double up = 1 + 0x1p-45;
  static constexpr double down = 1 - 0x1p-45;
  static constexpr double least = 0x1p-1000;

  long double value_ = 0;
  double error_ = 0;
};

}  // namespace carom::oracles

namespace Eigen {

template <>
struct NumTraits<carom::oracles::Approximation> : GenericNumTraits<carom::oracles::Approximation> {
  using Real = carom::oracles::Approximation;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = int;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 4,
    MulCost = 8
  };
};

}  // namespace Eigen
