// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/oracles/filters/moderate.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/oracles/judge/judged_laws.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/models/sensitivity.hpp>

#include "covers.hpp"
#include "normalised_collision.hpp"

/// What of the judge's constants does not stand in a header of bounds: stage.hpp, yardstick.hpp, sensitivity.hpp.
namespace carom::bounds {
namespace {

template <class Law>
int roundings_of(const Law& law) {
  Outcome<RoundingCount> outcome;
  for (Vector3<RoundingCount>* part : vectors(outcome)) {
    part->setConstant(RoundingCount::input());
  }
  const auto sides = law(normalised_collision<RoundingCount>(), outcome);
  int most = 0;
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    most = std::max(most, (sides.left[i] - sides.right[i]).roundings());
  }
  return most;
}

TEST(JudgeBounds, TryApproximationsWhereTheyMayDecide) {
  namespace law = oracles::law;
  const int most = std::max({roundings_of(law::AngularMomentum{true}), roundings_of(law::TotalAngularMomentum{}),
                             roundings_of(law::LinearMomentum{}), roundings_of(law::Restitution{}),
                             roundings_of(law::Push{true}), roundings_of(law::FrictionlessDirection{true}),
                             roundings_of(law::ReflectionPlane{}), roundings_of(law::Energy{})});
  EXPECT_GE(most, 30);
  EXPECT_LE(most, 50);
  EXPECT_TRUE(covers(oracles::least_allowance_for_approximations, most * u, 64));
}

/// The allowance times three sensitivities and one, as the relation `homogeneous` adds them.
TEST(JudgeBounds, AllowAFiniteNumberOfModerateCollisions) {
  for (const double largest : {oracles::largest_scale_of_moderate, oracles::largest_sensitivity_of_moderate}) {
    EXPECT_LE(oracles::largest_allowance_for_bounds * (3 * largest + largest), std::numeric_limits<double>::max());
  }
}

/// Each of a column's three squares loses half the least number; of an orientation or the normal, eleven numbers, it is
/// multiplied by up to D, of the other 32 by up to M.
TEST(JudgeBounds, KeepTenDigitsOfSumsBySquares) {
  const double lost =
      std::sqrt(3 * 0x1p-1074 / 2) * (11 * oracles::largest_moderate_direction + 32 * oracles::largest_moderate);
  EXPECT_TRUE(covers(oracles::least_sum_by_squares, lost / oracles::ten_digits, 0x1p10));
  // A column whose squares overflow is at least 2^511 long, and |x_j| is zero or 1/D at least.
  EXPECT_LE(oracles::largest_sum_by_squares, 0x1p511 * oracles::smallest_moderate_direction);
  EXPECT_TRUE(covers(1e-10, oracles::ten_digits, 2));
}

}  // namespace
}  // namespace carom::bounds
