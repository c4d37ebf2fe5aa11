// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include <carom/oracles/rational.hpp>

namespace carom::oracles {

Rational lift(long double number) {
  // Doubles take the mantissa off in pieces, whatever format long double has here.
  int exponent = 0;
  Rational result(0);
  for (long double rest = std::frexp(number, &exponent); rest != 0;) {
    const auto piece = static_cast<double>(rest);
    result += Rational(piece);
    rest -= static_cast<long double>(piece);
  }
  if (exponent == 0) {
    return result;
  }
  // Scaling in GMP: the exponent of an extended number may lie outside the range of double.
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(exponent));
  Rational shifted;
  if (exponent > 0) {
    mpq_mul_2exp(shifted.mpq(), result.mpq(), shift);
  } else {
    mpq_div_2exp(shifted.mpq(), result.mpq(), shift);
  }
  return shifted;
}

BasicCollision<Rational> lift(const Collision& collision) {
  return map_numbers<Rational>(collision, [](double number) { return Rational(number); });
}

Outcome<Rational> lift(const ReportedOutcome& outcome) {
  return map_outcome<Rational>(outcome, [](long double number) { return lift(number); });
}

double to_double(const Rational& number) { return mpq_get_d(number.mpq()); }

double nearest_double(const Rational& number) {
  // mpq_get_d rounds toward zero, so the nearest number is this one or its neighbour away from zero.
  const double below = to_double(number);
  const double away = number < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  const double above = std::nextafter(below, away);
  if (!std::isfinite(above)) {
    return below;
  }
  const Rational to_below = CGAL::abs(number - Rational(below));
  const Rational to_above = CGAL::abs(Rational(above) - number);
  if (to_below != to_above) {
    return to_below < to_above ? below : above;
  }
  const bool below_is_even = (std::bit_cast<std::uint64_t>(below) & 1U) == 0;
  return below_is_even ? below : above;
}

std::string to_text(const Rational& number) {
  std::ostringstream text;
  text << number.numerator();
  if (number.denominator() != 1) {
    text << '/' << number.denominator();
  }
  return text.str();
}

bool is_finite(const ReportedOutcome& outcome) {
  bool finite = true;
  for (const auto* vector : vectors(outcome)) {
    for (int i = 0; i < 3; ++i) {
      finite = finite && std::isfinite((*vector)[i]);
    }
  }
  return finite;
}

}  // namespace carom::oracles
