// SPDX-License-Identifier: BSL-1.0
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <carom/oracles/exact/radical.hpp>

namespace carom::oracles {
namespace {

/// What a coefficient has to be multiplied by for √s to stand in place of its own root: √(s_x / s).
Rational change_of_root(const Rational& from, const Rational& to) {
  if (from == to) {
    return 1;
  }
  RootBelow ratio = root_below(from / to);
  if (!ratio.is_exact) {
    throw std::logic_error("numbers with different square roots");
  }
  return ratio.root;
}

/// The root that x and y are written with, and the coefficient of y with it.
struct Common {
  const Rational& under_root;
  Rational coefficient_of_y;
};
Common common_root(const Radical& x, const Radical& y) {
  if (x.is_rational() || y.is_rational()) {
    return {x.is_rational() ? y.under_the_root() : x.under_the_root(), y.coefficient()};
  }
  return {x.under_the_root(), y.coefficient() * change_of_root(y.under_the_root(), x.under_the_root())};
}

/// p² − q² s, which is not zero for a number that is not: √s is irrational where q is not zero.
Rational norm_of(const Radical& x) {
  return x.rational_part() * x.rational_part() - x.coefficient() * x.coefficient() * x.under_the_root();
}

}  // namespace

/// p − q √s.
Radical conjugate(const Radical& number) { return {number.rational_, -number.coefficient_, number.under_root_}; }

Radical Radical::root_of(const Rational& x) {
  RootBelow below = root_below(x);
  return below.is_exact ? Radical(below.root) : Radical(Rational(0), Rational(1), x);
}

Radical operator+(const Radical& x, const Radical& y) {
  const Common common = common_root(x, y);
  return {x.rational_ + y.rational_, x.coefficient_ + common.coefficient_of_y, common.under_root};
}

Radical operator-(const Radical& x, const Radical& y) { return x + -y; }

Radical operator*(const Radical& x, const Radical& y) {
  if (x.is_rational() && y.is_rational()) {
    return Radical(x.rational_ * y.rational_);
  }
  const auto [s, of_y] = common_root(x, y);
  return {x.rational_ * y.rational_ + x.coefficient_ * of_y * s, x.rational_ * of_y + x.coefficient_ * y.rational_, s};
}

Radical operator/(const Radical& x, const Radical& y) {
  if (y.is_rational()) {
    return {x.rational_ / y.rational_, x.coefficient_ / y.rational_, x.under_root_};
  }
  return x * conjugate(y) / Radical(norm_of(y));
}

int sign_of(const Radical& number) {
  const int of_rational = sign_of(number.rational_part());
  const int of_root = sign_of(number.coefficient());
  if (of_root == 0 || of_rational == of_root) {
    return of_rational;
  }
  if (of_rational == 0) {
    return of_root;
  }
  // The signs are opposite: the larger part decides.
  return of_rational * sign_of(norm_of(number));
}

Rational approximately(const Radical& number) {
  if (number.is_rational()) {
    return number.rational_part();
  }
  const Rational by_root = number.coefficient() * root_below(number.under_the_root()).root;
  if (sign_of(number.rational_part()) * sign_of(number.coefficient()) >= 0) {
    return number.rational_part() + by_root;
  }
  // Without cancellation: (p² − q² s) / (p − q √s).
  return norm_of(number) / (number.rational_part() - by_root);
}

double to_double(const Radical& number) { return to_double(approximately(number)); }

double nearest_double(const Radical& number) { return nearest_double(approximately(number)); }

std::ostream& operator<<(std::ostream& out, const Radical& number) {
  std::ostringstream text;
  text << number.rational_part();
  if (!number.is_rational()) {
    text << " + " << number.coefficient() << " √(" << number.under_the_root() << ')';
  }
  return out << text.str();
}

std::string to_text(const Radical& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace carom::oracles
