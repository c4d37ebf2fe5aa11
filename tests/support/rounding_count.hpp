// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::bounds {

/// A scalar that bounds the rounding error of the code that computes with it. The exact result is a sum of terms t.
/// Each rounding multiplies terms by a factor 1 + δ with |δ| ≤ u, the unit roundoff. The class tracks Σ|t|, and the
/// largest number n of such factors in one term. So the error is at most γ_n Σ|t|, with γ_n = n u / (1 − n u) (N.
/// Higham, Accuracy and Stability of Numerical Algorithms, §3.1). Operations with 0, and products and quotients with
/// powers of two, are exact. Precondition: any other divisor is at least 1 and a sum of positive terms.
class RoundingCount {
 public:
  RoundingCount() = default;
  RoundingCount(int exact) : RoundingCount(static_cast<double>(exact)) {}  // NOLINT(google-explicit-constructor)
  explicit RoundingCount(double exact) : terms_(std::abs(exact)), is_power_of_two_(is_power_of_two(exact)) {}
  explicit RoundingCount(long double exact)
      : terms_(static_cast<double>(std::abs(exact))), is_power_of_two_(is_power_of_two(exact)) {}

  /// An input of at most `size`, after `roundings` earlier roundings.
  [[nodiscard]] static RoundingCount input(double size = 1, int roundings = 0) { return {roundings, size}; }

  [[nodiscard]] int roundings() const { return roundings_; }

  /// The error bound n Σ|t| in units of u, to first order.
  [[nodiscard]] double error() const { return roundings_ * terms_; }

  friend RoundingCount operator-(const RoundingCount& x) { return x; }
  friend RoundingCount operator+(const RoundingCount& x, const RoundingCount& y) {
    if (x.terms_ == 0 || y.terms_ == 0) {
      return x.terms_ == 0 ? y : x;
    }
    return {std::max(x.roundings_, y.roundings_) + 1, x.terms_ + y.terms_};
  }
  friend RoundingCount operator-(const RoundingCount& x, const RoundingCount& y) { return x + y; }
  friend RoundingCount operator*(const RoundingCount& x, const RoundingCount& y) {
    if (x.terms_ == 0 || y.terms_ == 0) {
      return {};
    }
    const int own = x.is_power_of_two_ || y.is_power_of_two_ ? 0 : 1;
    return {x.roundings_ + y.roundings_ + own, x.terms_ * y.terms_};
  }
  friend RoundingCount operator/(const RoundingCount& x, const RoundingCount& y) {
    if (y.terms_ == 0) {
      throw std::domain_error("a quotient by zero");
    }
    if (x.terms_ == 0) {
      return {};
    }
    return y.is_power_of_two_ ? RoundingCount(x.roundings_, x.terms_ / y.terms_)
                              : RoundingCount(x.roundings_ + y.roundings_ + 1, x.terms_);
  }
  RoundingCount& operator+=(const RoundingCount& y) { return *this = *this + y; }
  RoundingCount& operator-=(const RoundingCount& y) { return *this = *this - y; }
  RoundingCount& operator*=(const RoundingCount& y) { return *this = *this * y; }
  RoundingCount& operator/=(const RoundingCount& y) { return *this = *this / y; }

  friend RoundingCount abs(const RoundingCount& x) { return x; }
  /// Precondition: x is a sum of positive terms. The root halves the relative error of x, and rounds once.
  friend RoundingCount sqrt(const RoundingCount& x) { return {(x.roundings_ + 1) / 2 + 1, std::sqrt(x.terms_)}; }

  // Compares Σ|t|, for code that checks whether a number is too large.
  friend bool operator==(const RoundingCount& x, const RoundingCount& y) { return x.terms_ == y.terms_; }
  friend bool operator<=(const RoundingCount& x, const RoundingCount& y) { return x.terms_ <= y.terms_; }
  friend bool operator>=(const RoundingCount& x, const RoundingCount& y) { return y <= x; }

 private:
  RoundingCount(int roundings, double terms) : roundings_(roundings), terms_(terms) {}

  static bool is_power_of_two(long double x) {
    int exponent = 0;
    return std::abs(std::frexp(x, &exponent)) == 0.5L;
  }

  int roundings_ = 0;
  double terms_ = 0;
  bool is_power_of_two_ = false;
};

}  // namespace carom::bounds

template <>
struct Eigen::NumTraits<carom::bounds::RoundingCount>
    : carom::oracles::EigenScalar<carom::bounds::RoundingCount, 1, 1, 1> {};
