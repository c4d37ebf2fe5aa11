// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/collision/vector.hpp>
#include <carom/oracles/numbers/dual.hpp>

#include "support/exact.hpp"

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
    const D f = (dx * dx * dy + D(3) * dx - D(5)) / (dx - dy * dy);
    const Rational top = x * x * y + 3 * x - 5;
    EXPECT_EQ(f.value, top / d);
    EXPECT_EQ(f.derivative[0], (2 * x * y + 3) / d - top / (d * d));
    EXPECT_EQ(f.derivative[1], x * x / d + 2 * y * top / (d * d));
  }
}

TEST(Dual, NegatesBothParts) {
  const D x = -(D::input(ratio(3, 2), 0) * D::input(7, 1));
  EXPECT_EQ(x.value, ratio(-21, 2));
  EXPECT_EQ(x.derivative[0], -7);
  EXPECT_EQ(x.derivative[1], ratio(-3, 2));
}

TEST(Dual, GivesConstantsNoDerivative) {
  for (const D& constant : {D(), D(5), D(ratio(1, 3))}) {
    EXPECT_EQ(constant.derivative[0], 0);
    EXPECT_EQ(constant.derivative[1], 0);
  }
  EXPECT_EQ(D().value, 0);
}

/// Returns x. `sum += sum` would cause a compiler warning.
const D& itself(const D& x) { return x; }

TEST(Dual, SurvivesBeingItsOwnOperand) {
  const D x = D::input(ratio(3, 2), 0);
  D sum = x;
  sum += itself(sum);
  EXPECT_EQ(sum.derivative[0], 2);
  D difference = x;
  difference -= itself(difference);
  EXPECT_EQ(difference.value, 0);
  EXPECT_EQ(difference.derivative[0], 0);
  D product = x;
  product *= itself(product);
  EXPECT_EQ(product.value, ratio(9, 4));
  EXPECT_EQ(product.derivative[0], 3);
  D quotient = x;
  quotient /= itself(quotient);
  EXPECT_EQ(quotient.value, 1);
  EXPECT_EQ(quotient.derivative[0], 0);
}

/// A polynomial of degree one in each variable, so that any difference quotient equals the derivative.
template <class T>
T multilinear(const std::array<T, 4>& x) {
  return x[0] * x[1] * x[2] - T(7) * x[1] * x[3] + (x[0] - T(2)) * (x[3] + T(1)) / T(3) + x[2];
}

TEST(Dual, EqualsTheDifferenceQuotientOfWhatIsLinear) {
  properties::Stream stream = properties::stream_from(42);
  for (int i = 0; i < 200; ++i) {
    std::array<Rational, 4> x;
    std::array<Dual<Rational, 4>, 4> inputs;
    for (std::size_t j = 0; j < 4; ++j) {
      x[j] = unit::exact_eighths(stream, 80);
      inputs[j] = Dual<Rational, 4>::input(x[j], j);
    }
    const auto y = multilinear(inputs);
    EXPECT_EQ(y.value, multilinear(x));
    for (std::size_t j = 0; j < 4; ++j) {
      std::array<Rational, 4> moved = x;
      const Rational step = ratio(stream.integer(1, 100), 7);
      moved[j] += step;
      EXPECT_EQ(y.derivative[j], (multilinear(moved) - multilinear(x)) / step) << j;
    }
  }
}

TEST(Dual, GoesThroughEigen) {
  using D3 = Dual<Rational, 3>;
  const Vector3<D3> x{D3::input(1, 0), D3::input(2, 1), D3::input(3, 2)};
  const Vector3<D3> c{D3(4), D3(5), D3(6)};
  const D3 dot = x.dot(c);
  EXPECT_EQ(dot.value, 32);
  EXPECT_EQ(dot.derivative[2], 6);
  const Vector3<D3> cross = x.cross(c);
  EXPECT_EQ(cross[0].value, -3);  // x1 c2 − x2 c1
  EXPECT_EQ(cross[0].derivative[1], 6);
  EXPECT_EQ(cross[0].derivative[2], -5);
  EXPECT_EQ(cross[0].derivative[0], 0);
}

}  // namespace
}  // namespace carom::oracles
