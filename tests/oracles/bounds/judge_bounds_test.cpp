// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

#include "covers.hpp"

/// Checks the constants of the judge in yardstick.hpp and sensitivity.hpp.
namespace carom::bounds {
namespace {

/// The largest permitted residual of any invariant is that of `homogeneous` (relations.cpp): the allowance times four
/// sensitivities.
TEST(JudgeBounds, AllowAFiniteNumberOfModerateCollisions) {
  for (const double largest : {oracles::largest_scale_of_moderate, oracles::largest_sensitivity_of_moderate}) {
    EXPECT_LE(oracles::largest_allowance_for_bounds * (3 * largest + largest), std::numeric_limits<double>::max());
  }
}

/// By underflow, a square loses at most half the least number. A norm ‖∂y/∂q‖ is the root of up to twelve squares, and
/// the sum contains ‖∂y/∂q‖ ‖q‖. With the largest moderate direction D and number M, ‖q‖ is at most 2 D for the three
/// directions, and at most 3 M for the other 18 quantities.
TEST(JudgeBounds, KeepTenDigitsOfSumsBySquares) {
  const double lost = std::sqrt(12 * 0x1p-1074 / 2) *
                      (3 * 2 * oracles::largest_moderate_direction + 18 * 3 * oracles::largest_moderate);
  EXPECT_TRUE(covers(oracles::least_sum_by_squares, lost / oracles::ten_digits, 0x1p10));
  // If squares overflow, the norm is at least 2⁵¹¹. ‖q‖ is zero or at least 1/D.
  EXPECT_LE(oracles::largest_sum_by_squares, 0x1p511 * oracles::smallest_moderate_direction);
  EXPECT_TRUE(covers(1e-10, oracles::ten_digits, 2));
}

}  // namespace
}  // namespace carom::bounds
