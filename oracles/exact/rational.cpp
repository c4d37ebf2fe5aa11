// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/oracles/exact/gmpq.hpp>

namespace carom::oracles {

Rational::Rational() : Rational(std::in_place, [] { return CGAL::Gmpq(); }) {}
Rational::Rational(int numerator, int denominator)
    : Rational(std::in_place, [&] {
        CAROM_EXPECTS(denominator != 0, numerator);
        return denominator == 1 ? CGAL::Gmpq(numerator) : CGAL::Gmpq(numerator, denominator);
      }) {}
Rational::Rational(double number)
    : Rational(std::in_place, [&] {
        CAROM_EXPECTS(std::isfinite(number), number);
        return CGAL::Gmpq(number);
      }) {}
Rational::Rational(const std::string& digits) : Rational(std::in_place, [&] { return CGAL::Gmpq(digits); }) {}
Rational::Rational(const Rational& other) noexcept
    : Rational(std::in_place, [&]() -> const CGAL::Gmpq& { return Number::of(other); }) {}
Rational::~Rational() { Number::of(*this).~Gmpq(); }

Rational& Rational::operator=(const Rational& other) noexcept {
  Number::of(*this) = Number::of(other);
  return *this;
}

Rational& Rational::operator=(Rational&& other) noexcept {
  swap(Number::of(*this), Number::of(other));
  return *this;
}

Rational Rational::operator-() const {
  return Number::made([&] { return -Number::of(*this); });
}

Rational operator+(const Rational& left, const Rational& right) {
  return Rational::Number::made([&] { return Rational::Number::of(left) + Rational::Number::of(right); });
}
Rational operator-(const Rational& left, const Rational& right) {
  return Rational::Number::made([&] { return Rational::Number::of(left) - Rational::Number::of(right); });
}
Rational operator*(const Rational& left, const Rational& right) {
  return Rational::Number::made([&] { return Rational::Number::of(left) * Rational::Number::of(right); });
}
Rational operator/(const Rational& left, const Rational& right) {
  CAROM_EXPECTS(right != 0, left);
  return Rational::Number::made([&] { return Rational::Number::of(left) / Rational::Number::of(right); });
}

bool operator==(const Rational& left, const Rational& right) {
  return Rational::Number::of(left) == Rational::Number::of(right);
}
std::strong_ordering operator<=>(const Rational& left, const Rational& right) {
  return mpq_cmp(Rational::Number::of(left).mpq(), Rational::Number::of(right).mpq()) <=> 0;
}
int Rational::compared_with(int whole) const { return mpq_cmp_si(Number::of(*this).mpq(), whole, 1); }

Rational Rational::times_power_of_two(int exponent) const {
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(exponent));
  Rational result;
  if (exponent > 0) {
    mpq_mul_2exp(Number::of(result).mpq(), Number::of(*this).mpq(), shift);
  } else {
    mpq_div_2exp(Number::of(result).mpq(), Number::of(*this).mpq(), shift);
  }
  return result;
}

double to_double(const Rational& number) { return mpq_get_d(Rational::Number::of(number).mpq()); }
int sign_of(const Rational& number) { return mpq_sgn(Rational::Number::of(number).mpq()); }

Rational common_denominator(std::span<const Rational> numbers) {
  Rational least(1);
  const mpz_ptr multiple = mpq_numref(Rational::Number::of(least).mpq());
  for (const Rational& number : numbers) {
    mpz_lcm(multiple, multiple, mpq_denref(Rational::Number::of(number).mpq()));
  }
  return least;
}

RootBelow root_below(const Rational& number) {
  CAROM_EXPECTS(number >= 0, number);
  // For the number n/d, √(n/d) = √(n d 4^k) / (d 2^k). The integer part of √(n d 4^k) is at least 2^k and errs by less
  // than 1. So its relative error is below 2^−k.
  const CGAL::Gmpq& x = Rational::Number::of(number);
  const CGAL::Gmpz product = x.numerator() * x.denominator();
  const bool is_exact = mpz_perfect_square_p(product.mpz()) != 0;
  const mp_bitcnt_t k = is_exact ? 0 : 160;
  CGAL::Gmpz shifted;
  mpz_mul_2exp(shifted.mpz(), product.mpz(), 2 * k);
  CGAL::Gmpz root;
  mpz_sqrt(root.mpz(), shifted.mpz());
  const Rational quotient = Rational::Number::made([&] { return CGAL::Gmpq(root, x.denominator()); });
  return {quotient.times_power_of_two(-static_cast<int>(k)), is_exact};
}

Rational sqrt(const Rational& number) {
  RootBelow below = root_below(number);
  if (!below.is_exact) {
    throw std::domain_error("an irrational square root");
  }
  return below.root;
}

std::ostream& operator<<(std::ostream& out, const Rational& number) {
  return out << to_text(number);  // one field, for any width
}

Rational lift(long double number) {
  CAROM_EXPECTS(std::isfinite(number), number);
  // Splitting the mantissa into doubles works for every format of long double.
  int exponent{};
  Rational result;
  for (long double rest = std::frexp(number, &exponent); rest != 0;) {
    const auto piece = static_cast<double>(rest);
    result += Rational(piece);
    rest -= static_cast<long double>(piece);
  }
  return result.times_power_of_two(exponent);
}

BasicCollision<Rational> lift(const Collision& collision) {
  return map_numbers<Rational>(collision, [](double number) { return Rational(number); });
}

Outcome<Rational> lift(const Outcome<long double>& outcome) {
  return map_outcome<Rational>(outcome, [](long double number) { return lift(number); });
}

double nearest_double(const Rational& number) {
  // mpq_get_d rounds toward zero, so the nearest number is `below` or its neighbour away from zero.
  // For zero, `above` is NaN, and the result is `below`.
  const double below = to_double(number);
  const double above = std::nextafter(below, sign_of(number) * std::numeric_limits<double>::infinity());
  if (!std::isfinite(above)) {
    return below;
  }
  const Rational to_below = abs(number - Rational(below));
  const Rational to_above = abs(Rational(above) - number);
  const bool below_is_even = (std::bit_cast<std::uint64_t>(below) & 1U) == 0;
  return to_below < to_above || (to_below == to_above && below_is_even) ? below : above;
}

std::string to_text(const Rational& number) {
  const CGAL::Gmpq& value = Rational::Number::of(number);
  std::ostringstream text;
  text << value.numerator();
  if (value.denominator() != 1) {
    text << '/' << value.denominator();
  }
  return text.str();
}

bool is_finite(const Outcome<long double>& outcome) {
  return std::ranges::all_of(vectors(outcome), [](const auto* vector) { return vector->allFinite(); });
}

}  // namespace carom::oracles
