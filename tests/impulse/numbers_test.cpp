// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <carom/impulse/numbers/difference_of_products.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/impulse/numbers/exact_sum.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

using unit::Rational;
using unit::sign_of;

template <class S>
class DifferenceOfProducts : public testing::Test {};
using FloatingPoint = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(DifferenceOfProducts, FloatingPoint);

/// a b and c d are so close that the difference of the rounded products has no correct digit.
TYPED_TEST(DifferenceOfProducts, IsWrongInTheLastDigitAtMost) {
  using S = TypeParam;
  properties::Stream stream = properties::case_stream(unit::seed, "difference_of_products", 0);
  int lost_by_rounded_products = 0;
  // The numbers have more digits than binary64 has.
  const auto drawn = [&] { return static_cast<S>(stream.between(1, 2) + 0x1p-53L * stream.between(0, 1)); };
  for (int i = 0; i < 1000; ++i) {
    const S a = drawn();
    const S b = drawn();
    const S c = drawn();
    const S d = a * b / c;
    const Rational exact = oracles::lift(a) * oracles::lift(b) - oracles::lift(c) * oracles::lift(d);
    const auto missed = [&](S difference) {
      return std::abs(oracles::to_double(Rational(oracles::lift(difference) - exact)));
    };
    // An error of 3/2 ulps is at most 3 u, and the test's own rounding costs less than one u.
    const double allowed =
        4 * static_cast<double>(std::numeric_limits<S>::epsilon() / 2) * std::abs(oracles::to_double(exact));
    EXPECT_LE(missed(difference_of_products(a, b, c, d)), allowed) << i;
    lost_by_rounded_products += missed(a * b - c * d) > allowed ? 1 : 0;
  }
  EXPECT_GT(lost_by_rounded_products, 500);
}

TEST(AccurateCross, IsTheCrossProduct) {
  const Vector3<double> x{1, 2, 3};
  const Vector3<double> y{-4, 5, 7};
  EXPECT_EQ(accurate_cross(x, y), x.cross(y));
}

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

/// EnclosureBounds.KeepToTheTheoremOnDoubleDouble tests the errors of the operations.
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
TEST(DoubleDouble, TakesSquareRootsWithinTheBoundOfThePaper) {
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

/// A random finite double, possibly subnormal, with an exponent from `least` to `most`.
double draw(properties::Stream& stream, int least, int most) {
  return std::ldexp(stream.between(-1, 1), stream.integer(least, most));
}

void compare(int least, int most) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    properties::Stream stream = properties::case_stream(unit::seed, "exact_sum", i);
    ExactSum sum;
    Rational exact(0);
    const int terms = stream.integer(1, 40);
    std::array<double, 3> last{};
    for (int t = 0; t < terms; ++t) {
      last = {draw(stream, least, most), draw(stream, least, most), t % 3 == 0 ? 1 : draw(stream, least, most)};
      const int times = t % 2 == 0 ? 1 : -1;
      sum.add(times * last[0], last[1], last[2]);
      exact += times * Rational(last[0]) * Rational(last[1]) * Rational(last[2]);
    }
    EXPECT_EQ(sum.sign(), sign_of(exact)) << i;
    const double approximately = sum.approximately();
    if (std::isfinite(approximately) && std::abs(approximately) > std::numeric_limits<double>::min()) {
      const Rational error = Rational(approximately) - exact;
      EXPECT_LE((error < 0 ? -error : error), Rational(std::ldexp(1.0, -50)) * (exact < 0 ? -exact : exact)) << i;
    }
  }
}

TEST(ExactSum, EqualsTheSumInRationalArithmetic) { compare(-40, 40); }

TEST(ExactSum, NeitherOverflowsNorUnderflows) { compare(-1074, 1023); }

TEST(ExactSum, KeepsTheSmallestDoubleBesideTheLargest) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const int sign : {-1, 1}) {
    ExactSum sum;
    for (int i = 0; i < 1000; ++i) {
      sum.add(most, most, most);
    }
    EXPECT_EQ(sum.sign(), 1);
    EXPECT_EQ(sum.approximately(), std::numeric_limits<double>::infinity());
    sum.add(sign * least, least, least);
    for (int i = 0; i < 1000; ++i) {
      sum.add(-most, most, most);
    }
    EXPECT_EQ(sum.sign(), sign);
    EXPECT_EQ(sum.approximately(), 0);  // 2⁻³²²² is below every double
    sum.add(-sign * least, least, least);
    EXPECT_EQ(sum.sign(), 0);
  }
}

TEST(ExactSum, OfNothingIsZero) {
  EXPECT_EQ(ExactSum().sign(), 0);
  EXPECT_EQ(ExactSum().approximately(), 0);
}

}  // namespace
}  // namespace carom::impulse
