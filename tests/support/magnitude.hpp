// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::bounds {

/// A scalar that bounds the size of a number x. It computes on binary logarithms, which do not overflow.
///
/// - `above`: |x| ≤ 2^above.
/// - `below`: |x| ≥ 2^below. NaN if unknown, as for a sum that may cancel.
///
/// All results since `forget()` are at most 2^highest() in size.
class Magnitude {
 public:
  Magnitude() = default;
  Magnitude(int exact) : Magnitude(static_cast<double>(exact)) {}  // NOLINT(google-explicit-constructor)
  /// A number of this size and of either sign. All of its bits may be set.
  explicit Magnitude(double size) {
    if (size != 0) {
      above_ = std::log2(std::abs(size));
      below_ = above_;
      identity_ = next_identity();
    }
  }

  /// A number of at most this size.
  [[nodiscard]] static Magnitude at_most(double size) {
    Magnitude x(size);
    x.below_ = unknown;
    return x;
  }
  /// A number of at most 2^above in size.
  [[nodiscard]] static Magnitude of_exponent(double above) {
    Magnitude x;
    x.above_ = above;
    return x;
  }

  [[nodiscard]] double above() const { return above_; }
  [[nodiscard]] double below() const { return below_; }
  [[nodiscard]] bool is_zero() const { return above_ == -infinity; }

  /// While this object exists, a divisor without a known lower bound counts as a number of at least 2^below. A theorem
  /// must justify this bound.
  class DivisorsAtLeast {
   public:
    explicit DivisorsAtLeast(double below) : outer_(divisors_below()) { divisors_below() = below; }
    ~DivisorsAtLeast() { divisors_below() = outer_; }
    DivisorsAtLeast(const DivisorsAtLeast&) = delete;
    DivisorsAtLeast& operator=(const DivisorsAtLeast&) = delete;

   private:
    double outer_;
  };

  static void forget() { highest_ever() = -infinity; }
  [[nodiscard]] static double highest() { return highest_ever(); }

  friend Magnitude operator-(Magnitude x) {
    x.is_positive_ = false;
    x.identity_ = -x.identity_;
    return x;
  }
  friend Magnitude operator+(const Magnitude& x, const Magnitude& y) {
    if (x.is_zero() || y.is_zero()) {
      return x.is_zero() ? y : x;
    }
    Magnitude sum = of_exponent(log_of_sum(x.above_, y.above_));
    sum.is_positive_ = x.is_positive_ && y.is_positive_;
    if (sum.is_positive_) {
      // A number without a lower bound may be zero.
      sum.below_ = std::isnan(x.below_) ? y.below_ : (std::isnan(y.below_) ? x.below_ : log_of_sum(x.below_, y.below_));
    }
    return sum.noted();
  }
  friend Magnitude operator-(const Magnitude& x, const Magnitude& y) {
    if (x.is_zero() || y.is_zero()) {
      return x.is_zero() ? -y : x;
    }
    Magnitude difference = x + y;
    difference.is_positive_ = false;
    difference.below_ = unknown;
    return difference;
  }
  friend Magnitude operator*(const Magnitude& x, const Magnitude& y) {
    if (x.is_zero() || y.is_zero()) {
      return {};
    }
    Magnitude product = of_exponent(x.above_ + y.above_);
    product.below_ = x.below_ + y.below_;
    product.is_positive_ = (x.is_positive_ && y.is_positive_) || (x.identity_ != 0 && x.identity_ == y.identity_);
    return product.noted();
  }
  /// Precondition: the divisor has a lower bound, its own or that of a DivisorsAtLeast.
  friend Magnitude operator/(const Magnitude& x, const Magnitude& y) {
    const double below = std::isnan(y.below_) ? divisors_below() : y.below_;
    if (std::isnan(below)) {
      throw std::domain_error("a quotient by what has no lower bound");
    }
    if (x.is_zero()) {
      return {};
    }
    Magnitude quotient = of_exponent(x.above_ - below);
    quotient.below_ = x.below_ - y.above_;
    quotient.is_positive_ = x.is_positive_ && y.is_positive_;
    return quotient.noted();
  }
  Magnitude& operator+=(const Magnitude& y) { return *this = *this + y; }
  Magnitude& operator-=(const Magnitude& y) { return *this = *this - y; }
  Magnitude& operator*=(const Magnitude& y) { return *this = *this * y; }
  Magnitude& operator/=(const Magnitude& y) { return *this = *this / y; }

  friend Magnitude sqrt(const Magnitude& x) {
    Magnitude root = of_exponent(x.above_ / 2);
    root.below_ = x.below_ / 2;
    root.is_positive_ = x.is_positive_;
    return root;
  }
  friend Magnitude hypot(const Magnitude& x, const Magnitude& y) { return sqrt(x * x + y * y); }

  // Compares upper bounds, for code that checks whether a number is too large.
  friend bool operator==(const Magnitude& x, int zero) { return zero == 0 && x.is_zero(); }
  friend bool operator<=(const Magnitude& x, const Magnitude& y) { return x.above_ <= y.above_; }
  friend bool operator>=(const Magnitude& x, const Magnitude& y) { return y <= x; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  static int next_identity() {
    static int last = 0;
    return ++last;
  }
  static double& divisors_below() {
    static double below = unknown;
    return below;
  }
  static double& highest_ever() {
    static double highest = -infinity;
    return highest;
  }
  static double log_of_sum(double x, double y) {
    const double larger = std::max(x, y);
    return larger + std::log2(1 + std::exp2(std::min(x, y) - larger));
  }
  [[nodiscard]] Magnitude noted() const {
    highest_ever() = std::max(highest_ever(), above_);
    return *this;
  }

  double above_ = -infinity;  // zero
  double below_ = unknown;
  bool is_positive_ = false;
  int identity_ = 0;  // copies share it, so a product of equal identities is a square
};

}  // namespace carom::bounds

template <>
struct Eigen::NumTraits<carom::bounds::Magnitude> : carom::oracles::EigenScalar<carom::bounds::Magnitude, 1, 1, 1> {};
