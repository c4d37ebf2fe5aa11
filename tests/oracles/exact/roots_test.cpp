// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/exact/roots.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;

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
