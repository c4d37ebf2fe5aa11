// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>

/// Polynomials in one unknown over ℚ, and their positive roots, isolated by Sturm's theorem (S. Basu, R. Pollack, M.-F.
/// Roy, "Algorithms in Real Algebraic Geometry", §2.2.2).
namespace carom::oracles {

/// The coefficients, that of x⁰ first; the last one is not zero, and the zero polynomial has none.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<Rational> coefficients);

  /// −1 of the zero polynomial.
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] const std::vector<Rational>& coefficients() const { return coefficients_; }
  [[nodiscard]] Rational operator()(const Rational& x) const;
  [[nodiscard]] Polynomial derivative() const;

  friend Polynomial operator+(const Polynomial& left, const Polynomial& right);
  friend Polynomial operator-(const Polynomial& left, const Polynomial& right);
  friend Polynomial operator*(const Polynomial& left, const Polynomial& right);

 private:
  std::vector<Rational> coefficients_;
};

/// The quadratic polynomial with these values at 0, 1 and −1.
[[nodiscard]] Polynomial quadratic_through(const Rational& at_zero, const Rational& at_one,
                                           const Rational& at_minus_one);

/// low < x ≤ high, both positive.
struct Interval {
  Rational low;
  Rational high;
};

/// The distinct positive roots of one polynomial.
class PositiveRoots {
 public:
  /// Precondition: the polynomial is not zero.
  explicit PositiveRoots(const Polynomial& polynomial);

  /// One root in each, in ascending order.
  [[nodiscard]] const std::vector<Interval>& intervals() const { return intervals_; }

  /// How many of them lie in the interval.
  [[nodiscard]] int count_in(const Interval& interval) const;

  /// An interval about the same root of at most 2^−bits of its upper end.
  [[nodiscard]] Interval refined(const Interval& interval, int bits) const;

 private:
  [[nodiscard]] int variations_at(const Rational& x) const;
  void isolate(int low, int high);  // in (2^low, 2^high]
  void isolate(const Interval& interval);

  std::vector<Polynomial> sturm_sequence_;
  std::vector<Interval> intervals_;
};

}  // namespace carom::oracles
