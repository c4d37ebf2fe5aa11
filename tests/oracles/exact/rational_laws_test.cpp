// SPDX-License-Identifier: BSL-1.0
#include "support/exact.hpp"
#include "support/number_laws.hpp"

namespace carom::unit {

template <>
struct NumberType<Rational> {
  static Rational draw(properties::Stream& stream) { return ratio(stream.integer(-40, 40), stream.integer(1, 40)); }
  static bool is_zero(const Rational& x) { return x == 0; }
  static bool same(const Rational& x, const Rational& y) { return x == y; }
  static bool same_value(const Rational& x, const Rational& y) { return same(x, y); }
  static bool agrees(const Rational& x, const Rational& y, double) { return x == y; }
  static double size(const Rational& x) { return oracles::to_double(abs(x)); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Rational, NumberLaws, Rational);

}  // namespace carom::unit
