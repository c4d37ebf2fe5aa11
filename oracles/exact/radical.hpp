// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <concepts>
#include <iosfwd>
#include <span>
#include <string>

#include <carom/oracles/exact/rational.hpp>

namespace carom::oracles {

class Radical;

/// The sign: −1, 0 or 1.
[[nodiscard]] int sign_of(const Radical& number);

/// The exact number p + q √s with rational p, q and s ≥ 0. If q is not zero, √s is irrational. The numbers of an exact
/// answer of the law `rough` (laws/rough.hpp) have this form, all with the same √s.
class Radical {
 public:
  Radical() = default;
  template <std::same_as<int> Int>
  Radical(Int whole) : rational_(whole) {}  // NOLINT(google-explicit-constructor): formulas contain 0, 1 and 2
  explicit Radical(const Rational& rational) : rational_(rational) {}
  explicit Radical(double number) : rational_(number) {}

  /// √x. Precondition: x ≥ 0.
  [[nodiscard]] static Radical root_of(const Rational& x);

  [[nodiscard]] const Rational& rational_part() const { return rational_; }     // p
  [[nodiscard]] const Rational& coefficient() const { return coefficient_; }    // q
  [[nodiscard]] const Rational& under_the_root() const { return under_root_; }  // s; meaningless if q = 0
  [[nodiscard]] bool is_rational() const { return sign_of(coefficient_) == 0; }

  Radical operator-() const { return {-rational_, -coefficient_, under_root_}; }
  Radical& operator+=(const Radical& other) { return *this = *this + other; }
  Radical& operator-=(const Radical& other) { return *this = *this - other; }
  Radical& operator*=(const Radical& other) { return *this = *this * other; }
  Radical& operator/=(const Radical& other) { return *this = *this / other; }

  /// These operators throw std::logic_error if the operands contain roots √s and √t with an irrational ratio.
  friend Radical operator+(const Radical& x, const Radical& y);
  friend Radical operator-(const Radical& x, const Radical& y);
  friend Radical operator*(const Radical& x, const Radical& y);
  /// Precondition: the right side is not zero.
  friend Radical operator/(const Radical& x, const Radical& y);
  friend bool operator==(const Radical& x, const Radical& y) { return sign_of(x - y) == 0; }
  friend std::strong_ordering operator<=>(const Radical& x, const Radical& y) { return sign_of(x - y) <=> 0; }
  template <std::same_as<int> Int>
  friend bool operator==(const Radical& x, Int whole) {
    return x == Radical(whole);
  }
  template <std::same_as<int> Int>
  friend std::strong_ordering operator<=>(const Radical& x, Int whole) {
    return x <=> Radical(whole);
  }
  friend std::ostream& operator<<(std::ostream& out, const Radical& number);
  friend Rational common_denominator(std::span<const Radical> numbers);

 private:
  Radical(const Rational& rational, const Rational& coefficient, const Rational& under_root)
      : rational_(rational), coefficient_(coefficient), under_root_(under_root) {}
  template <class Operation>
  static Radical combined(const Radical& x, const Radical& y, const Operation& operation);

  Rational rational_;
  Rational coefficient_;
  Rational under_root_;
};

/// The least positive integer whose product with each p and q is an integer.
[[nodiscard]] Rational common_denominator(std::span<const Radical> numbers);

/// √x. Precondition: x is rational and not negative.
[[nodiscard]] inline Radical sqrt(const Radical& x) { return Radical::root_of(x.rational_part()); }

/// The number, rounded to a rational with a relative error of at most 2⁻¹⁵⁰.
[[nodiscard]] Rational approximately(const Radical& number);

/// The number, accurate to one unit in the last place.
[[nodiscard]] double to_double(const Radical& number);

/// The nearest binary64 number. A number within a relative 2⁻¹⁵⁰ of the middle between two neighbours may round to
/// either of them.
[[nodiscard]] double nearest_double(const Radical& number);

/// "p + q √(s)", or "p" if the number is rational.
[[nodiscard]] std::string to_text(const Radical& number);

}  // namespace carom::oracles

template <>
struct Eigen::NumTraits<carom::oracles::Radical> : carom::oracles::EigenScalar<carom::oracles::Radical, 18, 300, 500> {
};
