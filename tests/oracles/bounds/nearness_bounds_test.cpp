// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/invariants/verdicts.hpp>

#include "covers.hpp"
#include "support/rounding_count.hpp"

/// Checks the constants of surely_near (properties/invariants/verdicts.hpp) by its inequalities (1) to (4) and
/// nearness::distance_above, which define M, s, x and y.
namespace carom::bounds {
namespace {

namespace nearness = properties::nearness;

constexpr double u_of_long_double = static_cast<double>(nearness::two_u) / 2;

int roundings_of_distance() {
  const Vector3<RoundingCount> any = Vector3<RoundingCount>::Constant(RoundingCount::input(3));
  return nearness::distance_above<RoundingCount>(any, any, RoundingCount::input(3)).roundings();
}

/// Inequalities (3) and (4). M is the computed ‖x − y‖₁. M (1 + 8u) is at least the exact ‖x − y‖₁, despite five
/// roundings of each term.
TEST(NearnessBounds, RoundUpByMoreThanTheirRoundings) {
  EXPECT_TRUE(covers(static_cast<double>(nearness::up - 1), roundings_of_distance() * u_of_long_double, 2));
}

/// Inequalities (1), (2) and (4). The rounded 2u (s + ‖x‖₁) is at least u ‖x‖₁ + √3 (1 + 2⁻⁵⁰) (1 + u) u s.
TEST(NearnessBounds, CoverTheRoundingOfTheVectorItself) {
  const double left_by_rounding = 1 - roundings_of_distance() * u_of_long_double - 4 * u_of_long_double;
  const double of_scale = std::sqrt(3) * (1 + 0x1p-50) * (1 + u_of_long_double) * u_of_long_double;
  EXPECT_TRUE(covers(static_cast<double>(nearness::two_u) * left_by_rounding, of_scale, 1.2));
  EXPECT_GE(static_cast<double>(nearness::two_u) * left_by_rounding, u_of_long_double);
}

}  // namespace
}  // namespace carom::bounds
