// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>

#include <carom/collision/outcome.hpp>
#include <carom/oracles/laws/eigen_scalar.hpp>

namespace carom::oracles {

/// An exact rational number. The class hides a CGAL::Gmpq (gmpq.hpp), because CGAL's headers take seconds to compile.
class Rational {
 public:
  Rational();  // zero
  /// Implicit for int alone, because formulas contain 0, 1 and 2. With a plain int parameter, a double would lose its
  /// fraction.
  template <std::same_as<int> Int>
  Rational(Int whole) : Rational(whole, 1) {}  // NOLINT(google-explicit-constructor)
  /// Precondition: the denominator is not zero.
  Rational(int numerator, int denominator);
  /// The number itself, without rounding. Precondition: the number is finite.
  explicit Rational(double number);
  /// An integer in decimal digits.
  explicit Rational(const std::string& digits);
  Rational(const Rational& other) noexcept;
  Rational& operator=(const Rational& other) noexcept;
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  Rational operator-() const;
  Rational& operator+=(const Rational& other) { return *this = *this + other; }
  Rational& operator-=(const Rational& other) { return *this = *this - other; }
  Rational& operator*=(const Rational& other) { return *this = *this * other; }
  Rational& operator/=(const Rational& other) { return *this = *this / other; }

  /// The number · 2^exponent, for any exponent.
  [[nodiscard]] Rational times_power_of_two(int exponent) const;

  friend Rational operator+(const Rational& left, const Rational& right);
  friend Rational operator-(const Rational& left, const Rational& right);
  friend Rational operator*(const Rational& left, const Rational& right);
  /// Precondition: the right side is not zero.
  friend Rational operator/(const Rational& left, const Rational& right);
  friend bool operator==(const Rational& left, const Rational& right);
  friend std::strong_ordering operator<=>(const Rational& left, const Rational& right);
  template <std::same_as<int> Int>
  friend bool operator==(const Rational& left, Int right) {
    return left.compared_with(right) == 0;
  }
  template <std::same_as<int> Int>
  friend std::strong_ordering operator<=>(const Rational& left, Int right) {
    return left.compared_with(right) <=> 0;
  }
  friend Rational abs(const Rational& number) { return number < 0 ? -number : number; }
  friend std::ostream& operator<<(std::ostream& out, const Rational& number);
  friend double to_double(const Rational& number);
  friend int sign_of(const Rational& number);
  friend struct RootBelow root_below(const Rational& number);
  friend Rational common_denominator(std::span<const Rational> numbers);

  struct Number;  // access to CGAL's number, in gmpq.hpp

 private:
  template <class Make>
  Rational(std::in_place_t, const Make& make);
  [[nodiscard]] int compared_with(int whole) const;

  alignas(void*) std::array<std::byte, sizeof(void*)> number_;  // CGAL's handle of shared, reference-counted digits
};

/// The number itself, without rounding. Precondition: the number is finite.
[[nodiscard]] Rational lift(long double number);

/// Precondition: every number of the collision is finite.
[[nodiscard]] BasicCollision<Rational> lift(const Collision& collision);

/// Precondition: every number of the outcome is finite.
[[nodiscard]] Outcome<Rational> lift(const Outcome<long double>& outcome);

/// The number, accurate to one unit in the last place.
[[nodiscard]] double to_double(const Rational& number);

/// The nearest binary64 number, ties to even.
[[nodiscard]] double nearest_double(const Rational& number);

/// The sign: −1, 0 or 1.
[[nodiscard]] int sign_of(const Rational& number);

/// The least positive integer whose product with each of the numbers is an integer.
[[nodiscard]] Rational common_denominator(std::span<const Rational> numbers);

/// √x rounded down, with a relative error of at most 2⁻¹⁶⁰. The root is exact if √x is rational. Precondition: x ≥ 0.
struct RootBelow {
  Rational root;
  bool is_exact;
};
[[nodiscard]] RootBelow root_below(const Rational& number);

/// √x. Throws std::domain_error if √x is irrational. Precondition: x ≥ 0.
[[nodiscard]] Rational sqrt(const Rational& number);

/// "p/q" in lowest terms, or "p" if q = 1.
[[nodiscard]] std::string to_text(const Rational& number);

[[nodiscard]] bool is_finite(const Outcome<long double>& outcome);

}  // namespace carom::oracles

template <>
struct Eigen::NumTraits<carom::oracles::Rational> : carom::oracles::EigenScalar<carom::oracles::Rational, 6, 150, 100> {
};
