// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/bounds/dual.hpp>

#include "support/exact.hpp"
#include "support/number_laws.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using D = Dual<Rational, 2>;

TEST(Dual, DifferentiatesARationalFunctionAsByHand) {
  properties::Stream stream = properties::stream_from(41);
  for (int i = 0; i < 300; ++i) {
    const Rational x = unit::exact_eighths(stream, 40);
    const Rational y = unit::exact_eighths(stream, 40);
    const Rational d = x - y * y;
    if (d == 0) {
      continue;
    }
    const D dx = D::input(x, 0);
    const D dy = D::input(y, 1);
    const D f = (dx * dx * dy + D(3) * dx - D(5)) / -(dy * dy - dx);
    const Rational top = x * x * y + 3 * x - 5;
    EXPECT_EQ(f.value, top / d);
    EXPECT_EQ(f.derivative[0], (2 * x * y + 3) / d - top / (d * d));
    EXPECT_EQ(f.derivative[1], x * x / d + 2 * y * top / (d * d));
  }
}

TEST(Dual, GivesConstantsNoDerivative) {
  for (const D& constant : {D(), D(5), D(ratio(1, 3))}) {
    EXPECT_EQ(constant.derivative[0], 0);
    EXPECT_EQ(constant.derivative[1], 0);
  }
  EXPECT_EQ(D().value, 0);
}

}  // namespace

}  // namespace carom::oracles

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
