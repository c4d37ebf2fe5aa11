// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <carom/impulse/guaranteed.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

/// Checks the constants of guaranteed.hpp, and of src/impulse/normal_velocity.hpp by its inequalities (1) to (4). That
/// header defines T, S and ρ.
namespace carom::bounds {
namespace {

using impulse::DoubleDouble;
using oracles::Rational;
namespace detail = impulse::detail;

/// A collision without powers of two, so that no product is exact.
Collision any_collision() {
  Collision c;
  for (Body* body : {&c.a, &c.b}) {
    body->position = {3, 3, 3};
    body->velocity = {3, 3, 3};
    body->angular_velocity = {3, 3, 3};
  }
  c.point = {3, 3, 3};
  c.normal = {3, 3, 3};
  return c;
}

struct Counted {
  RoundingCount value;
  RoundingCount terms;
};

Counted counted_normal_velocity() {
  const Collision c = any_collision();
  const Outcome<double> motion = unchanged(c);
  Counted counted;
  detail::add_rounded_normal_velocity<RoundingCount>(c, c.a, motion.a, 1, counted.value, counted.terms);
  detail::add_rounded_normal_velocity<RoundingCount>(c, c.b, motion.b, -1, counted.value, counted.terms);
  return counted;
}

/// Inequality (1).
TEST(NormalVelocityBounds, CountTheRoundingsOfATerm) {
  EXPECT_EQ(detail::roundings_of_normal_velocity, counted_normal_velocity().value.roundings());
}

/// Inequalities (2) and (3). T has three more roundings than the sum of its terms: the conversion from S, the product
/// with 16 ρ, and the addition of the bound of underflow.
TEST(NormalVelocityBounds, CoverTheRoundingsOfATermAndOfTheirSum) {
  const Counted counted = counted_normal_velocity();
  const int roundings_of_terms = counted.terms.roundings() + 3;
  EXPECT_TRUE(covers(0x1p-48, roundings_of_terms * u, 4));
  for (const double rounding : {detail::unit_roundoff_of_double, detail::unit_roundoff_of_double_double}) {
    const double n = counted.value.roundings();
    EXPECT_TRUE(covers(detail::covered_roundings_of_normal_velocity, n / (1 - n * rounding) * (1 + 0x1p-48), 2));
  }
}

/// The error of a DoubleDouble product is at most 7 u² (enclosure_bounds_test.cpp), and the error of a sum is smaller.
TEST(NormalVelocityBounds, KnowTheRoundingOfDoubleDouble) {
  EXPECT_EQ(detail::unit_roundoff_of_double_double, 7 * u * u);
  EXPECT_GT(detail::unit_roundoff_of_double_double, 3 * u * u / (1 - 4 * u));
}

/// Inequality (4). A product in DoubleDouble takes four products in double.
TEST(NormalVelocityBounds, CoverUnderflow) {
  constexpr double products = 24 * 4;
  EXPECT_GE(detail::underflow_of_normal_velocity, products * 0x1p-1074);
}

/// A value that counts as known is accurate to 2⁻⁵⁰. Its error is at most 10/16 of the bound, plus one rounding to
/// double.
TEST(NormalVelocityBounds, KnowTwelveDigits) {
  const double share =
      static_cast<double>(detail::roundings_of_normal_velocity) / detail::covered_roundings_of_normal_velocity;
  EXPECT_TRUE(covers(0x1p-50, share / detail::known_multiple_of_bound + u, 2));
}

TEST(NormalVelocityBounds, CoverTheRoundingOfASlope) {
  const Vector3<RoundingCount> n = Vector3<RoundingCount>::Constant(RoundingCount::input(3));
  const Vector3<RoundingCount> r = n - n;
  const auto [left, right] = detail::moment_terms<RoundingCount>(r, n, 0);
  const int of_slope = (left - right).roundings();
  const int of_size = (left + right).roundings();
  EXPECT_TRUE(covers(detail::rounding_of_slope, of_slope * u / (1 - (of_slope + of_size) * u), 2));
}

/// The largest ratio of the exact error to the bound, over collisions with numbers of many sizes. Terms may cancel.
template <class S>
double worst_share_of_bound(double rounding, int exponents) {
  double worst = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    properties::Stream stream = properties::case_stream(unit::seed, "normal velocity bounds", i);
    const auto vector = [&] { return Vector3<double>(stream.vector() * stream.power_of_two(-exponents, exponents)); };
    Collision c;
    for (Body* body : {&c.a, &c.b}) {
      body->position = vector();
      body->velocity = vector();
      body->angular_velocity = vector();
    }
    c.point = vector();
    c.normal = vector();
    const detail::RoundedNormalVelocity<S> rounded(c, unchanged(c), rounding);
    if (!std::isfinite(rounded.bound) || !std::isfinite(static_cast<double>(rounded.value))) {
      continue;
    }
    const Rational exact = oracles::normal_velocity_before(oracles::lift(c));
    Rational value(static_cast<double>(rounded.value));
    if constexpr (std::is_same_v<S, DoubleDouble>) {
      value += Rational(rounded.value.low());
    }
    EXPECT_LE(abs(value - exact), Rational(rounded.bound)) << i;
    worst = std::max(worst, to_double(abs(value - exact) / Rational(rounded.bound)));
  }
  return worst;
}

TEST(NormalVelocityBounds, HoldAgainstTheExactNumber) {
  for (const int exponents : {1, 30, 300}) {
    EXPECT_GT(worst_share_of_bound<double>(detail::unit_roundoff_of_double, exponents), 0x1p-8);
    EXPECT_GT(worst_share_of_bound<DoubleDouble>(detail::unit_roundoff_of_double_double, exponents), 0x1p-10);
  }
  // At the exponent −540, every product underflows.
  const auto at_the_end = [](auto scalar, double rounding) {
    return worst_share_of_bound<decltype(scalar)>(rounding, 540);
  };
  EXPECT_LE(at_the_end(double(), detail::unit_roundoff_of_double), 1);
  EXPECT_LE(at_the_end(DoubleDouble(), detail::unit_roundoff_of_double_double), 1);
}

}  // namespace
}  // namespace carom::bounds
