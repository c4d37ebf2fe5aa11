// SPDX-License-Identifier: BSL-1.0
#include <carom/oracles/bounds/dual.hpp>

#include "support/exact.hpp"
#include "support/number_laws.hpp"

namespace carom::unit {

using RationalDual = oracles::Dual<Rational, 2>;

/// A dual number of value zero has no inverse, so `is_zero` tests the value.
template <>
struct NumberType<RationalDual> {
  static RationalDual draw(properties::Stream& stream) {
    const auto any = [&] { return ratio(stream.integer(-20, 20), stream.integer(1, 9)); };
    RationalDual x(any());
    x.derivative = {any(), any()};
    return x;
  }
  static bool is_zero(const RationalDual& x) { return x.value == 0; }
  static bool same(const RationalDual& x, const RationalDual& y) {
    return x.value == y.value && x.derivative == y.derivative;
  }
  static bool same_value(const RationalDual& x, const RationalDual& y) { return same(x, y); }
  static bool agrees(const RationalDual& x, const RationalDual& y, double) { return same(x, y); }
  static double size(const RationalDual& x) { return oracles::to_double(abs(x.value)); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Dual, NumberLaws, RationalDual);

}  // namespace carom::unit
