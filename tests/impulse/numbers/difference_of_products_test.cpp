// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <carom/impulse/numbers/difference_of_products.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

using unit::Rational;

template <class S>
class DifferenceOfProducts : public testing::Test {};
using FloatingPoint = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(DifferenceOfProducts, FloatingPoint);

/// a b and c d are so close that the difference of the rounded products has no correct digit.
TYPED_TEST(DifferenceOfProducts, HasAllDigitsButTheLast) {
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

}  // namespace
}  // namespace carom::impulse
