// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <carom/collision/expects.hpp>

/// Numbers of about 106 bits as unevaluated sums of two doubles. The algorithms are numbered as in M. Joldes, J.-M.
/// Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM
/// Trans. Math. Softw. 44 (2017). u = 2⁻⁵³. The bounds hold if nothing overflows or underflows. The range is that of
/// double, and below about 2⁻⁹⁶⁹ the low part loses bits. Compile this file without contraction of a·b + c and without
/// -ffast-math.
namespace carom::impulse {

/// The operators are inlined: a call takes as long as the operation.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): exact, and solvers write S(1) and 2 * x alike
  DoubleDouble(double number) : high_(number) {}

  /// high + low. Precondition: |low| is at most half an ulp of high.
  [[nodiscard]] static DoubleDouble of_parts(double high, double low) {
    CAROM_EXPECTS(high + low == high || !std::isfinite(high), high, low);
    return {high, low};
  }

  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double low() const { return low_; }

  explicit operator double() const { return high_; }
  explicit operator float() const { return static_cast<float>(high_); }
  /// A zero keeps its sign.
  explicit operator long double() const {
    const auto high = static_cast<long double>(high_);
    return low_ == 0 ? high : high + static_cast<long double>(low_);
  }

  [[nodiscard, gnu::always_inline]] friend inline DoubleDouble operator-(const DoubleDouble& x) {
    return {-x.high_, -x.low_};
  }

  /// Algorithm 6, AccurateDWPlusDW; relative error at most 3u² / (1 − 4u).
  [[nodiscard, gnu::always_inline]] friend inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble s = two_sum(x.high_, y.high_);
    const DoubleDouble t = two_sum(x.low_, y.low_);
    const DoubleDouble v = fast_two_sum(s.high_, s.low_ + t.high_);
    return fast_two_sum(v.high_, t.low_ + v.low_);
  }
  [[nodiscard, gnu::always_inline]] friend inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) {
    return x + -y;
  }

  /// Algorithm 10, DWTimesDW1; relative error below 7u².
  [[nodiscard, gnu::always_inline]] friend inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble c = two_product(x.high_, y.high_);
    return fast_two_sum(c.high_, c.low_ + (x.high_ * y.low_ + x.low_ * y.high_));
  }

  /// Algorithm 17, DWDivDW2; relative error below 15u² + 56u³.
  [[nodiscard]] friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.high_ / y.high_;
    const DoubleDouble r = times_double(y, quotient);
    const double rest = (x.high_ - r.high_) + (x.low_ - r.low_);
    return fast_two_sum(quotient, rest / y.high_);
  }

  DoubleDouble& operator+=(const DoubleDouble& y) { return *this = *this + y; }
  DoubleDouble& operator-=(const DoubleDouble& y) { return *this = *this - y; }
  DoubleDouble& operator*=(const DoubleDouble& y) { return *this = *this * y; }
  DoubleDouble& operator/=(const DoubleDouble& y) { return *this = *this / y; }

  /// SQRTDWtoDW of V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, ACM Trans. Math. Softw. 49 (2023):
  /// relative error below 25/8 u². Precondition: x ≥ 0.
  [[nodiscard]] friend DoubleDouble sqrt(const DoubleDouble& x) {
    CAROM_EXPECTS(!(x.high_ < 0), x.high_);
    if (x.high_ == 0) {
      return {};
    }
    const double root = std::sqrt(x.high_);
    const double rest = x.low_ + std::fma(-root, root, x.high_);
    return fast_two_sum(root, rest / (2 * root));
  }

  [[nodiscard]] friend bool operator==(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ == y.high_ && x.low_ == y.low_;
  }
  [[nodiscard]] friend bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ < y.high_ || (x.high_ == y.high_ && x.low_ < y.low_);
  }
  [[nodiscard]] friend bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }

 private:
  DoubleDouble(double high, double low) : high_(high), low_(low) {}

  /// Algorithm 1, Fast2Sum: x + y exactly. Precondition: |x| ≥ |y|, or x is 0.
  static DoubleDouble fast_two_sum(double x, double y) {
    CAROM_EXPECTS(!(std::abs(x) < std::abs(y)) || x == 0, x, y);
    const double s = x + y;
    return {s, y - (s - x)};
  }
  /// Algorithm 2, 2Sum: x + y exactly.
  static DoubleDouble two_sum(double x, double y) {
    const double s = x + y;
    const double of_x = s - y;
    const double of_y = s - of_x;
    return {s, (x - of_x) + (y - of_y)};
  }
  /// Algorithm 3, 2Prod: x y exactly.
  static DoubleDouble two_product(double x, double y) {
    const double p = x * y;
    return {p, std::fma(x, y, -p)};
  }
  /// Algorithm 7, DWTimesFP1; relative error below 2u².
  static DoubleDouble times_double(const DoubleDouble& x, double y) {
    const DoubleDouble c = two_product(x.high_, y);
    const DoubleDouble t = fast_two_sum(c.high_, x.low_ * y);
    return fast_two_sum(t.high_, t.low_ + c.low_);
  }

  double high_ = 0;
  double low_ = 0;
};

}  // namespace carom::impulse

template <>
struct Eigen::NumTraits<carom::impulse::DoubleDouble> {
  using Real = carom::impulse::DoubleDouble;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 10
  };
};
