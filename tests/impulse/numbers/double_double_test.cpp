// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <carom/impulse/numbers/double_double.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

using unit::Rational;

Rational exact(const DoubleDouble& x) { return Rational(x.high()) + Rational(x.low()); }

const Rational u2 = Rational(std::ldexp(1.0, -106));

Rational size(const Rational& x) { return x < 0 ? -x : x; }

/// A number between 2⁻²⁰ and 2²¹ in size, with all 106 bits random.
DoubleDouble draw(properties::Stream& stream) {
  const double high = stream.between(1, 2) * stream.power_of_two(-20, 20) * (stream.chance(2) ? 1 : -1);
  return DoubleDouble(high) + DoubleDouble(high * std::ldexp(stream.between(-1, 1), -54));
}

template <class F>
void for_each_pair(const F& f) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    properties::Stream stream = properties::case_stream(unit::seed, "double_double", i);
    const DoubleDouble x = draw(stream);
    const DoubleDouble y = draw(stream);
    f(x, y);
    f(x, -(x + y * DoubleDouble(std::ldexp(1.0, -60))));  // nearly −x, so the sum cancels
  }
}

TEST(DoubleDouble, KeepsTheBoundsOfThePaper) {
  int inexact = 0;
  for_each_pair([&](const DoubleDouble& x, const DoubleDouble& y) {
    const Rational sum = exact(x) + exact(y);
    const Rational difference = exact(x) - exact(y);
    const Rational product = exact(x) * exact(y);
    const Rational quotient = exact(x) / exact(y);
    // Sums: 3u² / (1 − 4u) < 4u². Quotients: 15u² + 56u³ < 16u².
    EXPECT_LE(size(exact(x + y) - sum), 4 * u2 * size(sum));
    EXPECT_LE(size(exact(x - y) - difference), 4 * u2 * size(difference));
    EXPECT_LE(size(exact(x * y) - product), 7 * u2 * size(product));
    EXPECT_LE(size(exact(x / y) - quotient), 16 * u2 * size(quotient));
    inexact += exact(x * y) != product && exact(x / y) != quotient ? 1 : 0;
  });
  EXPECT_GT(inexact, 3000);  // the pairs do use the low bits
}

TEST(DoubleDouble, KeepsTheLowPartBelowHalfAnUlp) {
  for_each_pair([](const DoubleDouble& x, const DoubleDouble& y) {
    for (const DoubleDouble& z : {x + y, x - y, x * y, x / y}) {
      EXPECT_EQ(z.high() + z.low(), z.high());
    }
  });
}

TEST(DoubleDouble, ComparesByBothParts) {
  const DoubleDouble one(1);
  const DoubleDouble more = DoubleDouble::of_parts(1, 1e-20);
  EXPECT_TRUE(one < more && more > one && !(more < one) && !(one > more) && one == DoubleDouble(1) && !(one == more));
  EXPECT_TRUE(DoubleDouble(-2) < one && DoubleDouble(2) > more);
}

/// The computed root r satisfies |√x − r| ≤ e r with e = 25/8 u². The squares of r (1 ± e) check this.
TEST(DoubleDouble, TakesSquareRootsAsThePaperSays) {
  const Rational most = u2 * Rational(25, 8);
  for_each_pair([&](const DoubleDouble& x, const DoubleDouble&) {
    const Rational square = size(exact(x));
    const Rational root = exact(sqrt(x.high() < 0 ? -x : x));
    const Rational low = root * (1 - most);
    const Rational high = root * (1 + most);
    EXPECT_TRUE(low * low <= square && square <= high * high) << x.high();
  });
  EXPECT_TRUE(sqrt(DoubleDouble(0)) == DoubleDouble(0));
}

}  // namespace
}  // namespace carom::impulse
