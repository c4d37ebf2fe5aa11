// SPDX-License-Identifier: BSL-1.0
#include <functional>
#include <ostream>
#include <stdexcept>
#include <vector>

#include <CGAL/Sqrt_extension.h>

#include <carom/oracles/exact/gmpq.hpp>
#include <carom/oracles/exact/radical.hpp>

namespace carom::oracles {
namespace {

/// The factor √(from / to): c √from = c √(from / to) · √to for every c. Throws std::logic_error if the factor is
/// irrational.
Rational change_of_root(const Rational& from, const Rational& to) {
  RootBelow ratio = root_below(from / to);
  if (!ratio.is_exact) {
    throw std::logic_error("numbers with different square roots");
  }
  return ratio.root;
}

using Extension = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq>;

Extension extension_of(const Radical& x) {
  const CGAL::Gmpq& rational = Rational::Number::of(x.rational_part());
  return x.is_rational()
             ? Extension(rational)
             : Extension(rational, Rational::Number::of(x.coefficient()), Rational::Number::of(x.under_the_root()));
}

Rational rational_of(const CGAL::Gmpq& x) {
  return Rational::Number::made([&]() -> const CGAL::Gmpq& { return x; });
}

}  // namespace

Radical Radical::root_of(const Rational& x) {
  RootBelow below = root_below(x);
  return below.is_exact ? Radical(below.root) : Radical(Rational(0), Rational(1), x);
}

template <class Operation>
Radical Radical::combined(const Radical& x, const Radical& y, const Operation& operation) {
  if (!x.is_rational() && !y.is_rational() && x.under_root_ != y.under_root_) {
    const Rational coefficient = y.coefficient_ * change_of_root(y.under_root_, x.under_root_);
    return combined(x, {y.rational_, coefficient, x.under_root_}, operation);
  }
  const Extension result = operation(extension_of(x), extension_of(y));
  return {rational_of(result.a0()), rational_of(result.a1()), x.is_rational() ? y.under_root_ : x.under_root_};
}

Radical operator+(const Radical& x, const Radical& y) { return Radical::combined(x, y, std::plus<>()); }
Radical operator-(const Radical& x, const Radical& y) { return Radical::combined(x, y, std::minus<>()); }
Radical operator*(const Radical& x, const Radical& y) { return Radical::combined(x, y, std::multiplies<>()); }
Radical operator/(const Radical& x, const Radical& y) { return Radical::combined(x, y, std::divides<>()); }

Rational common_denominator(std::span<const Radical> numbers) {
  std::vector<Rational> parts;
  parts.reserve(2 * numbers.size());
  for (const Radical& number : numbers) {
    parts.push_back(number.rational_part());
    parts.push_back(number.coefficient());
  }
  return common_denominator(parts);
}

int sign_of(const Radical& number) { return CGAL::sign(extension_of(number)); }

Rational approximately(const Radical& number) {
  if (number.is_rational()) {
    return number.rational_part();
  }
  const Rational by_root = number.coefficient() * root_below(number.under_the_root()).root;
  if (sign_of(number.rational_part()) != -sign_of(number.coefficient())) {
    return number.rational_part() + by_root;
  }
  // p and q √s have opposite signs, so their sum would cancel. (p² − q² s) / (p − q √s) equals the sum.
  const Rational& p = number.rational_part();
  const Rational& q = number.coefficient();
  return (p * p - q * q * number.under_the_root()) / (p - by_root);
}

double to_double(const Radical& number) { return to_double(approximately(number)); }

double nearest_double(const Radical& number) { return nearest_double(approximately(number)); }

std::ostream& operator<<(std::ostream& out, const Radical& number) { return out << to_text(number); }

std::string to_text(const Radical& number) {
  const std::string rational = to_text(number.rational_part());
  return number.is_rational()
             ? rational
             : rational + " + " + to_text(number.coefficient()) + " √(" + to_text(number.under_the_root()) + ')';
}

}  // namespace carom::oracles
