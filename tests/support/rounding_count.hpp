// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::bounds {

/// Bounds the rounding error of a number by running the code that computes it. Let u be the unit roundoff. The computed
/// number is Σ t Π (1 + δ) over the terms t of the exact number, with |δ| ≤ u. The type tracks Σ|t|, and the largest
/// number n of factors 1 + δ (roundings) of a term. The error is at most γ_n Σ|t|, with γ_n = n u / (1 − n u) (N.
/// Higham, Accuracy and Stability of Numerical Algorithms, §3.1). Operations with 0, and products and quotients with
/// powers of two, are exact. Any other divisor must be at least 1, and a sum of positive terms, so that its relative
/// error is that of its roundings.
class RoundingCount {
 public:
  RoundingCount() = default;
  RoundingCount(int exact) : RoundingCount(static_cast<double>(exact)) {}  // NOLINT(google-explicit-constructor)
  explicit RoundingCount(double exact) : terms_(std::abs(exact)), is_power_of_two_(is_power_of_two(exact)) {}
  explicit RoundingCount(long double exact)
      : terms_(static_cast<double>(std::abs(exact))), is_power_of_two_(is_power_of_two(exact)) {}

  /// An input of at most this size, with this many earlier roundings.
  [[nodiscard]] static RoundingCount input(double size = 1, int roundings = 0) { return {roundings, size}; }

  [[nodiscard]] int roundings() const { return roundings_; }
  [[nodiscard]] double terms() const { return terms_; }

  /// n Σ|t|: the error of the computed number in u, to first order.
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
  /// For a sum of positive terms: half of its roundings, plus one.
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
