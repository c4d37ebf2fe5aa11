// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <limits>

#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

/// Checks the constants of oracles/bounds/norm.hpp, and those of oracles/judge/norm_at_most.hpp by its inequalities
/// (1) and (2).
namespace carom::bounds {
namespace {

namespace norm_bounds = oracles::norm_bounds;
using oracles::Enclosure;
using oracles::Rational;

constexpr std::size_t most_components = oracles::Components<double>::capacity;

RoundingCount six_squares() {
  const std::array<RoundingCount, most_components> vector = [] {
    std::array<RoundingCount, most_components> all;
    all.fill(RoundingCount::input(3));
    return all;
  }();
  return norm_bounds::sum_of_squares<RoundingCount>(std::span<const RoundingCount>(vector),
                                                    [](const RoundingCount& x) { return x; });
}

/// Counts the roundings of Σ a² (1 + ρ) ≤ bound² (1 − ρ).
TEST(NormBounds, RoundByMoreThanTheirRoundings) {
  const RoundingCount factor = RoundingCount::input(1 + norm_bounds::rounding);
  const RoundingCount bound = RoundingCount::input(3);
  const int by_squares = (six_squares() * factor).roundings() + (bound * bound * factor).roundings();
  EXPECT_TRUE(covers(norm_bounds::rounding, by_squares * u, 64));
}

/// By underflow, a square loses at most half the least number. The sum of these losses is less than a rounding of
/// bound².
TEST(NormBounds, CoverTheUnderflowOfSquares) {
  constexpr double squares_lose = most_components * 0x1p-1074;
  EXPECT_GE(norm_bounds::least * norm_bounds::least * u, squares_lose);
  EXPECT_LT(norm_bounds::largest * norm_bounds::largest, 0x1p+1023);
  // A matrix has nine components.
  EXPECT_GE(oracles::smallest_sum_of_squares * u, 9 * 0x1p-1074);
  EXPECT_LT(oracles::largest_sum_of_squares, 0x1p+1023);
}

/// Returns whether the bounds decide. Expects their decision to equal that of ℚ.
bool expect_as_in_rationals(const std::array<double, 3>& vector, double bound) {
  const std::array<Enclosure, 3> known{Enclosure(vector[0]), Enclosure(vector[1]), Enclosure(vector[2])};
  const std::array<Rational, 3> exact{Rational(vector[0]), Rational(vector[1]), Rational(vector[2])};
  const auto decided = oracles::norm_at_most(std::span<const Enclosure>(known), bound);
  const bool right = oracles::norm_at_most(std::span<const Rational>(exact), bound);
  EXPECT_EQ(decided.value_or(right), right) << vector[0] << ' ' << vector[1] << ' ' << vector[2] << ", " << bound;
  return decided.has_value();
}

/// Tests bounds inside and outside of the range in which enclosures decide.
TEST(NormBounds, DecideAsRationalsDo) {
  properties::Stream stream = properties::stream_from(61);
  for (const int exponent : {-1074, -540, -405, -399, 0, 395, 401, 900}) {
    int decided = 0;
    for (int i = 0; i < 300; ++i) {
      const auto component = [&] { return std::ldexp(stream.integer(-5, 5), exponent); };
      const std::array<double, 3> vector{component(), component(), component()};
      const double bound = std::ldexp(stream.integer(0, 9), exponent);
      decided += expect_as_in_rationals(vector, bound) ? 1 : 0;
    }
    EXPECT_GE(decided, std::abs(exponent) < 400 ? 200 : 0) << exponent;
  }
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

/// Beyond about 2^±500, squares overflow binary64 or lose digits by underflow.
TEST(Norm, KeepsItsDigitsWhateverTheSize) {
  for (const int exponent : {-1070, -1000, -540, -460, 0, 460, 540, 1000}) {
    const double unit = std::ldexp(1.0, exponent);
    EXPECT_EQ(oracles::norm_of(Vector3<double>{2 * unit, -3 * unit, 6 * unit}), 7 * unit) << exponent;
    EXPECT_EQ(oracles::norm_of(Vector3<double>{0, -unit, 0}), unit) << exponent;
  }
}

TEST(Norm, OfNothingIsZero) {
  EXPECT_EQ(oracles::norm_of(Vector3<double>{0, -0.0, 0}), 0);
  EXPECT_EQ(oracles::root_of_squares(0, [](std::size_t) { return 1.0; }), 0);
}

TEST(Norm, HidesNoNaN) { EXPECT_TRUE(std::isnan(oracles::norm_of(Vector3<double>{1, std::nan(""), 0}))); }

TEST(Norm, OfAnOutcomeIsTakenOfEachVector) {
  const Outcome<double> outcome{{{3, 4, 0}, {0, 5, 12}}, {{8, 0, 15}, {0, 0, 7}}};
  EXPECT_EQ(oracles::norms_of(outcome), (PerVector<double>{5, 13, 17, 7}));
}

}  // namespace
}  // namespace carom::bounds
