// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/bounds/dual.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using D = Dual<Rational, 2>;

/// dual_laws_test.cpp tests the field laws.
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
