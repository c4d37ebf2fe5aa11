// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/norm.hpp>

namespace carom::oracles {
namespace {

/// Beyond about 2^±500, squares overflow binary64 or lose digits by underflow.
TEST(Norm, KeepsItsDigitsWhateverTheSize) {
  for (const int exponent : {-1070, -1000, -540, -460, 0, 460, 540, 1000}) {
    const double unit = std::ldexp(1.0, exponent);
    EXPECT_EQ(norm_of(Vector3<double>{2 * unit, -3 * unit, 6 * unit}), 7 * unit) << exponent;
    EXPECT_EQ(norm_of(Vector3<double>{0, -unit, 0}), unit) << exponent;
  }
}

TEST(Norm, OfNothingIsZero) {
  EXPECT_EQ(norm_of(Vector3<double>{0, -0.0, 0}), 0);
  EXPECT_EQ(root_of_squares(0, [](std::size_t) { return 1.0; }), 0);
}

TEST(Norm, HidesNoNaN) { EXPECT_TRUE(std::isnan(norm_of(Vector3<double>{1, std::nan(""), 0}))); }

TEST(Norm, OfAnOutcomeIsTakenOfEachVector) {
  const Outcome<double> outcome{{{3, 4, 0}, {0, 5, 12}}, {{8, 0, 15}, {0, 0, 7}}};
  EXPECT_EQ(norms_of(outcome), (PerVector<double>{5, 13, 17, 7}));
}

}  // namespace
}  // namespace carom::oracles
