// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/bounds/enclosure.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using unit::two_to;
using Limits = std::numeric_limits<double>;

struct Both {
  Enclosure enclosed;
  Rational exact;
};

/// Checks magnitude_below ≤ |x| ≤ magnitude_above, and the sign if it is given.
testing::AssertionResult encloses(const Both& both) {
  const Rational magnitude = abs(both.exact);
  const double above = both.enclosed.magnitude_above();
  const double below = both.enclosed.magnitude_below();
  if (std::isnan(above) || (std::isfinite(above) && Rational(above) < magnitude)) {
    return testing::AssertionFailure() << "magnitude_above " << above << " is below " << to_double(magnitude);
  }
  if (!std::isfinite(below) || Rational(below) > magnitude) {
    return testing::AssertionFailure() << "magnitude_below " << below << " is above " << to_double(magnitude);
  }
  if (both.enclosed.sign().value_or(sign_of(both.exact)) != sign_of(both.exact)) {
    return testing::AssertionFailure() << "the sign of " << to_double(both.exact) << " is wrong";
  }
  return testing::AssertionSuccess();
}

/// A sharper test of the radius than `encloses`. The enclosure minus the exact value must contain zero. `exact` becomes
/// an enclosure here, so the test misses relative errors below 2⁻¹⁰⁰.
testing::AssertionResult contains(const Both& both) {
  const double rounded = std::abs(to_double(both.exact));
  if (!(rounded > 0x1p-800 && rounded < 0x1p800)) {
    return testing::AssertionSuccess();
  }
  const Enclosure difference = both.enclosed - Enclosure(both.exact);
  if (difference.magnitude_below() > 0) {
    return testing::AssertionFailure() << "off by " << difference.middle() << " with a radius of "
                                       << both.enclosed.radius();
  }
  return testing::AssertionSuccess();
}

Both leaf(properties::Stream& stream, int exponents) {
  const int exponent = stream.integer(-exponents, exponents);
  switch (stream.integer(0, 6)) {
    case 0: {
      const int small = stream.integer(-3, 3);  // sometimes zero
      return {Enclosure(small), Rational(small)};
    }
    case 1: {
      const long double x = std::ldexp(static_cast<long double>(stream.bits()), exponent - 63);
      return {Enclosure(x), lift(x)};
    }
    case 2: {
      // Separate tests cover other rationals.
      const int inside = std::clamp(exponent, -900, 900);
      const Rational x = ratio(stream.integer(-(1 << 30), 1 << 30), stream.integer(1, 1 << 30)) * two_to(inside);
      return {Enclosure(x), x};
    }
    default: {
      const double x = std::ldexp(stream.signed_unit(), exponent);
      return {Enclosure(x), Rational(x)};
    }
  }
}

struct Count {
  int operations = 0;
  int decided = 0;  // the sign is given
};

Both combined(const Both& x, const Both& y, int operation, Count& count) {
  Both result;
  switch (operation) {
    case 0:
      result = {x.enclosed + y.enclosed, x.exact + y.exact};
      break;
    case 1:
      result = {x.enclosed - y.enclosed, x.exact - y.exact};
      break;
    case 2:
      result = {x.enclosed * y.enclosed, x.exact * y.exact};
      break;
    default:
      if (y.exact == 0) {
        EXPECT_EQ((x.enclosed / y.enclosed).sign(), std::nullopt);
        return x;
      }
      result = {x.enclosed / y.enclosed, x.exact / y.exact};
  }
  ++count.operations;
  count.decided += result.enclosed.sign() ? 1 : 0;
  EXPECT_TRUE(encloses(result)) << "operation " << operation;
  EXPECT_TRUE(contains(result)) << "operation " << operation;
  EXPECT_TRUE(encloses({-result.enclosed, -result.exact}));
  return result;
}

Both expression(properties::Stream& stream, int depth, int exponents, Count& count) {
  if (depth == 0 || stream.chance(8)) {
    return leaf(stream, exponents);
  }
  const Both x = expression(stream, depth - 1, exponents, count);
  if (stream.chance(6)) {
    // Nearly cancels x: subtracts the leading bits of x, and adds or subtracts a trifle.
    const double leading = to_double(x.exact);
    if (std::isfinite(leading) && (leading == 0 || std::abs(leading) > Limits::min())) {
      const double trifle = std::ldexp(leading, -stream.integer(40, 110));
      const Both rest = combined(x, {Enclosure(leading), Rational(leading)}, 1, count);
      return combined(rest, {Enclosure(trifle), Rational(trifle)}, stream.integer(0, 1), count);
    }
  }
  const Both y = expression(stream, depth - 1, exponents, count);
  return combined(x, y, stream.integer(0, 3), count);
}

TEST(Enclosure, ContainsTheExactValueOfEveryExpression) {
  for (const int exponents : {4, 60, 250, 1000}) {
    Count count;
    for (std::uint64_t i = 0; count.operations < 30000; ++i) {
      properties::Stream stream = properties::case_stream(static_cast<std::uint64_t>(exponents), "enclosure", i);
      expression(stream, 5, exponents, count);
      if (testing::Test::HasFailure()) {
        FAIL() << "exponents " << exponents << ", expression " << i;
      }
    }
    if (exponents <= 60) {
      // A sign is open only if a sum cancels beyond double-double.
      EXPECT_GT(count.decided, count.operations / 10 * 8);
    }
  }
}

TEST(Enclosure, HoldsDoublesExactly) {
  for (const double x : {0.0, 1.0, -0.1, Limits::max(), -Limits::denorm_min(), Limits::min()}) {
    EXPECT_EQ(Enclosure(x).radius(), 0);
    EXPECT_TRUE(encloses({Enclosure(x), Rational(x)}));
    EXPECT_EQ(Enclosure(x).sign(), sign_of(Rational(x)));
  }
}

TEST(Enclosure, KnowsTheSignOfADifferenceInTheHundredthBit) {
  const Enclosure third = Enclosure(1) / Enclosure(3);
  const Enclosure slightly_more = third + Enclosure(0x1p-98);
  EXPECT_EQ((slightly_more - third).sign(), 1);
  EXPECT_EQ((third - slightly_more).sign(), -1);
  EXPECT_EQ((third * Enclosure(3) - Enclosure(1)).sign(), std::nullopt);  // 0, but the enclosure cannot prove it
}

TEST(Enclosure, RefusesWhatOverflows) {
  const Enclosure huge(1e200);
  const Enclosure largest(Limits::max());
  const Enclosure tiny(1e-200);
  for (const Enclosure& overflown : {huge * huge, -(huge * huge), largest + largest, -largest - largest, huge / tiny,
                                     largest * Enclosure(2), Enclosure(std::numeric_limits<long double>::max())}) {
    EXPECT_EQ(overflown.sign(), std::nullopt);
    EXPECT_EQ(overflown.magnitude_below(), 0);
    EXPECT_EQ(overflown.magnitude_above(), Limits::infinity());
    EXPECT_EQ((overflown + Enclosure(1)).sign(), std::nullopt);
    EXPECT_EQ((Enclosure(1) / overflown).sign(), std::nullopt);
    EXPECT_EQ((overflown - overflown).sign(), std::nullopt);
    EXPECT_EQ((overflown * tiny).sign(), std::nullopt);
  }
}

TEST(Enclosure, RefusesToDivideByWhatMayBeZero) {
  EXPECT_EQ((Enclosure(1) / Enclosure(0)).sign(), std::nullopt);
  const Enclosure maybe_zero = Enclosure(1) / Enclosure(3) * Enclosure(3) - Enclosure(1);
  EXPECT_EQ((Enclosure(1) / maybe_zero).sign(), std::nullopt);
}

TEST(Enclosure, DoesNotCallATinyProductZero) {
  const Enclosure tiny(1e-200);
  EXPECT_NE((tiny * tiny).sign(), 0);
  EXPECT_NE((tiny / Enclosure(1e200)).sign(), 0);
  EXPECT_TRUE(encloses({tiny * tiny, Rational(1e-200) * Rational(1e-200)}));
  EXPECT_EQ((tiny * Enclosure(0)).sign(), 0);
}

TEST(Enclosure, ContainsExtendedNumbersOfEveryExponent) {
  properties::Stream stream = properties::stream_from(31);
  for (int i = 0; i < 5000; ++i) {
    const long double x =
        std::ldexp(static_cast<long double>(stream.bits()), stream.integer(-16445, 16319)) * (i % 2 == 0 ? 1 : -1);
    EXPECT_TRUE(encloses({Enclosure(x), lift(x)})) << x;
  }
}

/// Below 2⁻⁹⁰⁰, the low part of the double-double or the whole number is subnormal, or underflows.
TEST(Enclosure, ContainsRationalsOfEveryExponentOfBinary64AndBelow) {
  properties::Stream stream = properties::stream_from(32);
  for (int i = 0; i < 5000; ++i) {
    const Rational x =
        ratio(stream.integer(-(1 << 30), 1 << 30), stream.integer(1, 1 << 30)) * two_to(stream.integer(-1200, 960));
    const Both both{Enclosure(x), x};
    ASSERT_TRUE(encloses(both)) << to_double(x);
    ASSERT_TRUE(encloses({both.enclosed - Enclosure(to_double(x)), x - Rational(to_double(x))})) << to_double(x);
  }
}

/// Runs in a separate process, because CGAL aborts if an infinite double becomes a rational.
TEST(Enclosure, RefusesRationalsAboveTheRangeOfBinary64) {
  const auto encloses_huge = [] {
    const Rational x = two_to(1100);
    std::exit(encloses({Enclosure(x), x}) ? 0 : 1);
  };
  EXPECT_EXIT(encloses_huge(), testing::ExitedWithCode(0), "");
}

/// The bounds low and high of √x satisfy low² ≤ x ≤ high² for each x within the radius.
TEST(Enclosure, ContainsSquareRoots) {
  properties::Stream stream = properties::stream_from(61);
  for (int i = 0; i < 2000; ++i) {
    const Rational x =
        ratio(stream.integer(1, 1 << 30), stream.integer(1, 1 << 30)) * two_to(stream.integer(-300, 300));
    const double radius = stream.chance(2) ? 0 : to_double(x) * stream.power_of_ten(-30, -1);
    const Enclosure around = Enclosure(x).widened_by(radius);
    const Enclosure root = sqrt(around);
    for (const Rational& end : {Rational(x - Rational(radius)), x, Rational(x + Rational(radius))}) {
      const Rational low = (Rational(root.middle()) + Rational(root.lower_part())) - Rational(root.radius());
      const Rational high = (Rational(root.middle()) + Rational(root.lower_part())) + Rational(root.radius());
      EXPECT_TRUE((low < 0 || low * low <= end) && end <= high * high) << to_double(x) << ' ' << radius;
    }
    if (radius == 0) {
      EXPECT_LE(root.radius(), 0x1p-98 * root.middle()) << to_double(x);
    }
  }
}

TEST(Enclosure, ContainsTheRootOfWhatMayBeZero) {
  EXPECT_TRUE(sqrt(Enclosure(0)).is_exactly_zero());
  const Enclosure root = sqrt(Enclosure(0.25).widened_by(0.5));  // 0 to 3/4
  EXPECT_LE(root.middle() - root.radius(), 0);
  EXPECT_GE((root.middle() + root.radius()) * (root.middle() + root.radius()), 0.75);
  EXPECT_LT(root.radius(), 1);
}

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
