// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <compare>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/exact/roots.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using unit::two_to;
using Limits = std::numeric_limits<double>;
using LongLimits = std::numeric_limits<long double>;

Rational scaled(const Rational& p, int exponent) {
  const Rational power = two_to(std::abs(exponent));
  return exponent < 0 ? p / power : p * power;
}

Rational integer(const char* digits) { return Rational(digits); }

TEST(Rational, IsOrderedAndHasASign) {
  const std::vector<Rational> ascending{ratio(-3, 2), Rational(-1), ratio(2, -3),
                                        Rational(0),  ratio(1, 2),  Rational(1)};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) {
      EXPECT_EQ(ascending[i] <=> ascending[j], i <=> j);
      EXPECT_EQ(ascending[i] == ascending[j], i == j);
    }
    EXPECT_EQ(ascending[i] <=> 0, i <=> std::size_t{3});
    EXPECT_EQ(1 == ascending[i], i == 5);
    EXPECT_EQ(sign_of(ascending[i]), i < 3 ? -1 : i > 3 ? 1 : 0);
    EXPECT_EQ(abs(ascending[i]), i < 3 ? -ascending[i] : ascending[i]);
  }
}

static_assert(std::is_convertible_v<int, Rational>);
static_assert(!std::is_convertible_v<double, Rational> && !std::is_convertible_v<unsigned, Rational> &&
              !std::is_convertible_v<long, Rational>);
template <class Number>
concept ComparesWithRational = requires(Rational x, Number y) {
  x == y || x < y;
};
static_assert(ComparesWithRational<int> && !ComparesWithRational<double> && !ComparesWithRational<unsigned>);

TEST(Rational, IsAScalarOfEigen) {
  const Vector3<Rational> x{ratio(1, 2), Rational(-3), Rational(0)};
  EXPECT_EQ(unit::to_text(2 * x / 3), "1/3 -2 0 ");
  std::ostringstream text;
  text << x.transpose();
  EXPECT_EQ(text.str(), "1/2  -3   0");
}

/// Copies share their digits until one of them changes.
TEST(Rational, IsAValue) {
  Rational x(2, 3);
  const Rational copy = x;
  x += copy;
  EXPECT_EQ(x, ratio(4, 3));
  EXPECT_EQ(copy, ratio(2, 3));
  const Rational& same = x;
  x *= same;
  EXPECT_EQ(x, ratio(16, 9));
  x -= same;
  EXPECT_EQ(x, 0);
  Rational moved(1, 7);
  moved = std::move(x);
  EXPECT_EQ(moved, 0);
  moved = copy;
  const Rational& itself = moved;
  moved = itself;
  EXPECT_EQ(moved, copy);
  moved /= itself;
  EXPECT_EQ(moved, 1);
  EXPECT_EQ(copy, ratio(2, 3));
}

TEST(Rational, TimesAPowerOfTwo) {
  for (const int exponent : {0, 1, -1, 63, -64, 16445, -16445}) {
    EXPECT_EQ(ratio(-5, 3).times_power_of_two(exponent), ratio(-5, 3) * two_to(exponent)) << exponent;
  }
}

TEST(Rational, HasARootOnlyIfItIsASquare) {
  EXPECT_EQ(sqrt(Rational(9) / Rational(4)), Rational(3) / Rational(2));
  EXPECT_EQ(sqrt(Rational(0)), Rational(0));
  EXPECT_THROW(static_cast<void>(sqrt(Rational(2))), std::domain_error);
}

TEST(Lift, IsExactForExtendedNumbers) {
  constexpr int digits = LongLimits::digits;
  EXPECT_EQ(lift(-0.0L), 0);
  EXPECT_EQ(lift(1 + LongLimits::epsilon()), 1 + scaled(1, 1 - digits));
  EXPECT_EQ(lift(1 - LongLimits::epsilon() / 2), 1 - scaled(1, -digits));
  const Rational largest = scaled(scaled(1, digits) - 1, LongLimits::max_exponent - digits);
  EXPECT_EQ(lift(LongLimits::max()), largest);
  EXPECT_EQ(lift(-LongLimits::max()), -largest);
  EXPECT_EQ(lift(LongLimits::min()), scaled(1, LongLimits::min_exponent - 1));
  EXPECT_EQ(lift(LongLimits::denorm_min()), scaled(1, LongLimits::min_exponent - digits));
  EXPECT_EQ(lift(3 * LongLimits::denorm_min()), scaled(3, LongLimits::min_exponent - digits));
  // The largest subnormal number: ones in all places except the first.
  EXPECT_EQ(lift(LongLimits::min() - LongLimits::denorm_min()),
            scaled(scaled(1, digits - 1) - 1, LongLimits::min_exponent - digits));
  // 64 bits whose leading 53 round up.
  EXPECT_EQ(lift(std::ldexp(18446744073709551614.0L, 100)), scaled(integer("18446744073709551614"), 100));
}

TEST(Lift, IsExactForRandomBitsAndExponents) {
  properties::Stream stream = properties::stream_from(21);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t bits = stream.bits();
    const int exponent = stream.integer(-16445, 16319);
    // ldexp rounds bits below the smallest subnormal number. The test skips numbers that have such bits.
    const long double number = std::ldexp(static_cast<long double>(bits), exponent);
    if (exponent < -16380 && std::ldexp(number, -exponent) != static_cast<long double>(bits)) {
      continue;
    }
    const Rational expected = scaled(integer(std::to_string(bits).c_str()), exponent);
    EXPECT_EQ(lift(number), expected) << bits << " 2^" << exponent;
    EXPECT_EQ(lift(-number), -expected);
  }
}

TEST(ToDouble, IsWithinOneUnitInTheLastPlace) {
  properties::Stream stream = properties::stream_from(22);
  for (int i = 0; i < 2000; ++i) {
    const Rational exact = ratio(stream.integer(1, 1 << 30), stream.integer(1, 1 << 30));
    const double rounded = to_double(exact);
    EXPECT_LE(Rational(std::nextafter(rounded, 0)), exact);
    EXPECT_GE(Rational(std::nextafter(rounded, Limits::infinity())), exact);
  }
}

TEST(NearestDouble, IsExactForDoubles) {
  for (const double x : {0.0, Limits::max(), -Limits::max(), Limits::denorm_min(), -Limits::min()}) {
    EXPECT_EQ(nearest_double(Rational(x)), x);
  }
}

/// The mean of two neighbouring doubles rounds to the even neighbour. A number beside the mean rounds to the nearer
/// neighbour.
void expect_ties_to_even(double lower, double upper, bool lower_is_even) {
  SCOPED_TRACE(lower);
  const Rational half = (Rational(lower) + Rational(upper)) / 2;
  const Rational hair = scaled(1, -1300);
  ASSERT_EQ(nearest_double(half), lower_is_even ? lower : upper);
  ASSERT_EQ(nearest_double(half - hair), lower);
  ASSERT_EQ(nearest_double(half + hair), upper);
  ASSERT_EQ(nearest_double(-half), lower_is_even ? -lower : -upper);
}

TEST(NearestDouble, BreaksTiesToEven) {
  const double u = Limits::epsilon() / 2;
  expect_ties_to_even(1, 1 + 2 * u, true);
  expect_ties_to_even(1 + 2 * u, 1 + 4 * u, false);
  expect_ties_to_even(1 - u, 1, false);
  expect_ties_to_even(9007199254740992.0, 9007199254740994.0, true);   // 2^53 + 1
  expect_ties_to_even(9007199254740994.0, 9007199254740996.0, false);  // 2^53 + 3
}

TEST(NearestDouble, BreaksTiesToEvenAmongSubnormalNumbers) {
  const double least = Limits::denorm_min();
  for (int k = 0; k < 20; ++k) {
    ASSERT_NO_FATAL_FAILURE(expect_ties_to_even(k * least, (k + 1) * least, k % 2 == 0));
  }
  expect_ties_to_even(Limits::min() - least, Limits::min(), false);
}

TEST(NearestDouble, IsTheNearestOfTheNeighbours) {
  properties::Stream stream = properties::stream_from(24);
  for (int i = 0; i < 3000; ++i) {
    const Rational exact =
        scaled(ratio(stream.integer(-(1 << 30), 1 << 30), stream.integer(1, 1 << 30)), stream.integer(-1090, 900));
    const double nearest = nearest_double(exact);
    const Rational distance = abs(exact - Rational(nearest));
    for (const double to : {-Limits::infinity(), Limits::infinity()}) {
      EXPECT_LE(distance, abs(exact - Rational(std::nextafter(nearest, to))));
    }
  }
}

TEST(ToText, WritesLowestTerms) {
  EXPECT_EQ(to_text(ratio(6, -4)), "-3/2");
  EXPECT_EQ(to_text(Rational(7)), "7");
  EXPECT_EQ(to_text(Rational(0)), "0");
  EXPECT_EQ(to_text(Rational(0.1)), "3602879701896397/36028797018963968");
}

TEST(IsFinite, SeesEachComponent) {
  Outcome<long double> outcome;
  EXPECT_TRUE(is_finite(outcome));
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      for (const long double bad : {LongLimits::infinity(), -LongLimits::infinity(), LongLimits::quiet_NaN()}) {
        Outcome<long double> spoiled = outcome;
        (*vectors(spoiled)[k])[i] = bad;
        EXPECT_FALSE(is_finite(spoiled)) << name_of(k) << ' ' << i;
      }
    }
  }
  outcome.b.velocity[1] = LongLimits::max();
  EXPECT_TRUE(is_finite(outcome));
}

const Coefficients everywhere{Rational(1)};

/// (x − r₀)(x − r₁)…
Coefficients with_roots(const std::vector<Rational>& roots) {
  Coefficients product = everywhere;
  for (const Rational& root : roots) {
    Coefficients next(product.size() + 1);
    for (std::size_t i = 0; i < product.size(); ++i) {
      next[i] -= root * product[i];
      next[i + 1] += product[i];
    }
    product = next;
  }
  return product;
}

void expect_positive_roots(const std::vector<Rational>& expected, const Coefficients& polynomial,
                           const Coefficients& side = everywhere) {
  for (const int bits : {1, 60}) {
    const std::vector<Rational> roots = positive_roots(polynomial, side, bits);
    ASSERT_EQ(roots.size(), expected.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      EXPECT_LE(abs(Rational(roots[i] - expected[i])), expected[i].times_power_of_two(-bits)) << expected[i];
    }
  }
}

TEST(PositiveRoots, AreAllDifferentOnesInAscendingOrderHoweverNearOrFarApart) {
  const Rational near = Rational(1) + Rational(1).times_power_of_two(-200);
  const Rational small = Rational(3).times_power_of_two(-900);
  const Rational large = Rational(5).times_power_of_two(900);
  expect_positive_roots({ratio(1, 3), 2, ratio(7, 3)}, with_roots({2, ratio(7, 3), ratio(1, 3), -5}));
  expect_positive_roots({1, near}, with_roots({1, near, -1}));
  expect_positive_roots({small, large}, with_roots({large, small}));
  expect_positive_roots({1, 4}, with_roots({1, 1, 4, 4}));
  expect_positive_roots({3}, with_roots({0, 0, 3}));
  expect_positive_roots({2}, {-2, 1, 0});  // the leading coefficient is zero
  for (const Coefficients& without_roots : {Coefficients{7}, Coefficients{1, 0, 1}, Coefficients{1, 2, 1}}) {
    expect_positive_roots({}, without_roots);
  }
}

/// A root counts only if `side` is positive at the root, even if only slightly.
TEST(PositiveRoots, LieOnThePositiveSide) {
  const Rational near = Rational(2) - Rational(1).times_power_of_two(-200);
  const Coefficients polynomial = with_roots({Rational(1), Rational(2), Rational(4)});
  expect_positive_roots({Rational(4)}, polynomial, with_roots({Rational(2)}));
  expect_positive_roots({Rational(2), Rational(4)}, polynomial, with_roots({near}));
  expect_positive_roots({}, polynomial, {Rational(0)});
  expect_positive_roots({}, polynomial, {Rational(-1), Rational(0)});
}

/// The computed root r of x² = 2 is accurate to 2⁻²⁰⁰, so 2 lies between (r (1 − 2⁻²⁰⁰))² and (r (1 + 2⁻²⁰⁰))².
TEST(PositiveRoots, AreAsNearAsAsked) {
  constexpr int bits = 200;
  const std::vector<Rational> roots = positive_roots({Rational(-2), Rational(0), Rational(1)}, everywhere, bits);
  ASSERT_EQ(roots.size(), 1U);
  const Rational error = Rational(1).times_power_of_two(-bits);
  const Rational below = roots[0] * (1 - error);
  const Rational above = roots[0] * (1 + error);
  EXPECT_LE(below * below, 2);
  EXPECT_GE(above * above, 2);
}

}  // namespace
}  // namespace carom::oracles
