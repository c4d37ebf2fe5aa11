// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/bounds/lifted_matrix.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

TEST(LiftedMatrix, IsTheReportedOneInEachNumber) {
  Matrix3<long double> reported;
  reported << 1, 2, 3, 4, 5, 6, 7, 8, 1 + 0x1p-60L;
  const LiftedMatrix lifted(reported);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(lifted.exact()(i, j), lift(reported(i, j))) << i << ' ' << j;
    }
  }
  EXPECT_EQ(lifted.exact()(2, 2) - Rational(1), unit::two_to(-60));
  EXPECT_TRUE(lifted.is_finite());
}

}  // namespace
}  // namespace carom::oracles
