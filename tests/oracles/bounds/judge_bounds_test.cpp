// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/oracles/filters/moderate.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/sensitivity.hpp>

#include "covers.hpp"
#include "normalised_collision.hpp"

/// Checks the constants of the judge in stage.hpp, yardstick.hpp and sensitivity.hpp.
namespace carom::bounds {
namespace {

template <class OneEquation>
int roundings_of(const OneEquation& equation) {
  Outcome<RoundingCount> outcome;
  for (Vector3<RoundingCount>* part : vectors(outcome)) {
    part->setConstant(RoundingCount::input());
  }
  const auto sides = equation(normalised_collision<RoundingCount>(), outcome);
  int most = 0;
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    most = std::max(most, (sides.left[i] - sides.right[i]).roundings());
  }
  return most;
}

TEST(JudgeBounds, TryApproximationsWhereTheyMayDecide) {
  namespace equation = oracles::equation;
  const int most =
      std::max({roundings_of(equation::AngularMomentum{true}), roundings_of(equation::TotalAngularMomentum{}),
                roundings_of(equation::LinearMomentum{}), roundings_of(equation::Restitution{}),
                roundings_of(equation::Push{true}), roundings_of(equation::FrictionlessDirection{true}),
                roundings_of(equation::ReflectionPlane{}), roundings_of(equation::Energy{})});
  EXPECT_GE(most, 30);
  EXPECT_LE(most, 50);
  EXPECT_TRUE(covers(oracles::least_allowance_for_approximations, most * u, 64));
}

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
