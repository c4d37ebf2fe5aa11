// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/exact/polynomial.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;

/// (x − r₀)(x − r₁)…
Polynomial with_roots(const std::vector<Rational>& roots) {
  Polynomial product({Rational(1)});
  for (const Rational& root : roots) {
    product = product * Polynomial({-root, Rational(1)});
  }
  return product;
}

/// Whether they are the roots that are isolated, in order.
void expect_isolated(const std::vector<Rational>& roots, const PositiveRoots& isolated) {
  ASSERT_EQ(isolated.intervals().size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Interval interval = isolated.refined(isolated.intervals()[i], 60);
    EXPECT_LT(interval.low, roots[i]);
    EXPECT_LE(roots[i], interval.high);
    EXPECT_LE(interval.high - interval.low, interval.high.times_power_of_two(-60));
  }
}

TEST(Polynomial, IsEvaluated) {
  const Polynomial p({Rational(1), Rational(-3), Rational(2)});
  EXPECT_EQ(p.degree(), 2);
  EXPECT_EQ(p(Rational(5)), 36);
  EXPECT_EQ(p.derivative()(Rational(5)), 17);
  EXPECT_EQ((p - p).degree(), -1);
  EXPECT_EQ((p * p)(Rational(5)), 1296);
  EXPECT_EQ(quadratic_through(p(Rational(0)), p(Rational(1)), p(Rational(-1))).coefficients(), p.coefficients());
}

TEST(PositiveRoots, AreIsolated) {
  expect_isolated({ratio(1, 3), Rational(2), ratio(7, 3)},
                  PositiveRoots(with_roots({Rational(2), ratio(7, 3), ratio(1, 3), Rational(-5)})));
}

TEST(PositiveRoots, AreToldApartHoweverNear) {
  const Rational near = Rational(1) + Rational(1).times_power_of_two(-200);
  expect_isolated({Rational(1), near}, PositiveRoots(with_roots({Rational(1), near, Rational(-1)})));
}

TEST(PositiveRoots, AreFoundHoweverFarApart) {
  const Rational small = Rational(3).times_power_of_two(-900);
  const Rational large = Rational(5).times_power_of_two(900);
  expect_isolated({small, large}, PositiveRoots(with_roots({large, small})));
}

TEST(PositiveRoots, CountOnceWhereTheyAreMultiple) {
  expect_isolated({Rational(1), Rational(4)},
                  PositiveRoots(with_roots({Rational(1), Rational(1), Rational(4), Rational(4)})));
}

TEST(PositiveRoots, DoNotIncludeZero) {
  expect_isolated({Rational(3)}, PositiveRoots(with_roots({Rational(0), Rational(0), Rational(3)})));
}

TEST(PositiveRoots, AreNoneOfAConstantOrOfASum) {
  EXPECT_TRUE(PositiveRoots(Polynomial({Rational(7)})).intervals().empty());
  EXPECT_TRUE(PositiveRoots(Polynomial({Rational(1), Rational(0), Rational(1)})).intervals().empty());
  EXPECT_TRUE(PositiveRoots(Polynomial({Rational(1), Rational(2), Rational(1)})).intervals().empty());
}

/// A root at an end of an interval that is halved belongs to one half.
TEST(PositiveRoots, CountTheUpperEnd) {
  const PositiveRoots roots(with_roots({Rational(1), Rational(2), Rational(4)}));
  EXPECT_EQ(roots.count_in({Rational(1), Rational(4)}), 2);
  EXPECT_EQ(roots.count_in({ratio(1, 2), Rational(1)}), 1);
}

}  // namespace
}  // namespace carom::oracles
