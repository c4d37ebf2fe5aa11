// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <carom/oracles/filters/refined_truth.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;

struct Approximated {
  Approximation approximate;
  Rational exact;
};

/// Checks |x − middle| ≤ radius, and the bounds of size and sign.
testing::AssertionResult contains(const Approximated& both) {
  const Approximation& x = both.approximate;
  if (!std::isfinite(x.radius()) || !std::isfinite(x.middle())) {
    return x.sign() ? testing::AssertionFailure() << "the sign of no number" : testing::AssertionSuccess();
  }
  const Rational magnitude = abs(both.exact);
  if (abs(both.exact - Rational(x.middle())) > Rational(x.radius())) {
    return testing::AssertionFailure() << "off by more than " << x.radius();
  }
  if (std::isfinite(x.magnitude_above()) && Rational(x.magnitude_above()) < magnitude) {
    return testing::AssertionFailure() << "magnitude_above " << x.magnitude_above();
  }
  if (Rational(x.magnitude_below()) > magnitude) {
    return testing::AssertionFailure() << "magnitude_below " << x.magnitude_below();
  }
  if (x.sign().value_or(sign_of(both.exact)) != sign_of(both.exact)) {
    return testing::AssertionFailure() << "wrong sign";
  }
  return testing::AssertionSuccess();
}

Approximated expression(properties::Stream& stream, int depth, int exponents, int& operations, int& decided) {
  if (depth == 0 || stream.chance(8)) {
    const double x = stream.chance(8)
                         ? stream.integer(-3, 3)
                         : std::ldexp(stream.signed_unit(), stream.integer(-exponents, std::min(exponents, 1020)));
    return {Approximation(x), Rational(x)};
  }
  Approximated x = expression(stream, depth - 1, exponents, operations, decided);
  Approximated y = expression(stream, depth - 1, exponents, operations, decided);
  if (stream.chance(6) && std::isfinite(x.approximate.middle())) {
    y = {Approximation(x.approximate.middle()), Rational(x.approximate.middle())};
  }
  Approximated result;
  switch (stream.integer(0, 3)) {
    case 0:
      result = {x.approximate + y.approximate, x.exact + y.exact};
      break;
    case 1:
      result = {x.approximate - y.approximate, x.exact - y.exact};
      break;
    case 2:
      result = {x.approximate * y.approximate, x.exact * y.exact};
      break;
    default:
      if (y.exact == 0) {
        EXPECT_EQ((x.approximate / y.approximate).sign(), std::nullopt);
        return x;
      }
      result = {x.approximate / y.approximate, x.exact / y.exact};
  }
  ++operations;
  decided += result.approximate.sign() ? 1 : 0;
  EXPECT_TRUE(contains(result));
  EXPECT_TRUE(contains({-result.approximate, -result.exact}));
  return result;
}

TEST(Approximation, ContainsTheExactValueOfEveryExpression) {
  for (const int exponents : {4, 60, 250, 1000, 1070}) {
    int operations = 0;
    int decided = 0;
    for (std::uint64_t i = 0; operations < 20000; ++i) {
      properties::Stream stream = properties::case_stream(static_cast<std::uint64_t>(exponents), "approximation", i);
      expression(stream, 5, exponents, operations, decided);
      ASSERT_FALSE(testing::Test::HasFailure()) << "exponents " << exponents << ", expression " << i;
    }
    if (exponents <= 60) {
      EXPECT_GT(decided, operations / 10 * 7);
    }
  }
}

TEST(Approximation, KeepsExactZeros) {
  const Approximation third = Approximation(1) / Approximation(3);
  EXPECT_EQ((Approximation(0) * third).sign(), 0);
  EXPECT_EQ((Approximation(0.25) - Approximation(0.25)).sign(), 0);
  EXPECT_EQ((third * Approximation(3) - Approximation(1)).sign(), std::nullopt);  // 0, but the bound cannot prove it
}

TEST(Approximation, GoesToEnclosuresAndBack) {
  properties::Stream stream = properties::stream_from(5);
  for (int i = 0; i < 2000; ++i) {
    const Rational x = ratio(stream.integer(1, 1 << 30), stream.integer(1, 1 << 30));
    EXPECT_TRUE(contains({approximation_of(Enclosure(x)), x}));
    const Approximated third{Approximation(to_double(x)) / Approximation(3), Rational(to_double(x)) / 3};
    EXPECT_TRUE(contains({approximation_of(enclosure_of(third.approximate)), third.exact}));
  }
}

const Rational& nearly(const Rational& x) { return x; }
Rational nearly(const Radical& x) { return approximately(x); }

TEST(RefinedTruth, ContainsTheTruth) {
  int good = 0;
  int all = 0;
  for (const auto& [family, one] : unit::sampled_cases(8)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.approach() != Approach::colliding) {
      continue;
    }
    for (const Law law : laws_with_truth) {
      const Truth<Enclosure> refined =
          refined_truth(one.collision, exact_case.bounds().enclosed(), exact_case.bounds().approximate(), law,
                        exact_case.branch(law), ApproximateResponse(exact_case.bounds().approximate()));
      const auto enclosed = vectors(refined.outcome);
      const auto exact = exact_case.with_truth(law, Approach::colliding, []<class T>(const Truth<T>& truth) {
        return map_outcome<Rational>(truth.outcome, [](const T& x) { return nearly(x); });
      });
      for (const OutcomeVector k : all_outcome_vectors) {
        double radius = 0;
        for (int i = 0; i < 3; ++i) {
          const Rational& y = (*vectors(exact)[k])[i];
          // Square roots in `exact` have 150 bits, of which an enclosure keeps at most 110.
          const Enclosure difference = (*enclosed[k])[i] - Enclosure(y);
          EXPECT_EQ(difference.magnitude_below(), 0) << family << ' ' << name_of(k);
          radius = std::max(radius, (*enclosed[k])[i].radius());
        }
        ++all;
        good += radius <= 0x1p-80 * exact_case.sensitivity(law, 0x1p-48)[k] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(all, unit::effort(500));
  EXPECT_GT(good, all / 10 * 9);
}

/// The bounds low and high of √x satisfy low² ≤ x ≤ high² for each x within the radius.
TEST(Approximation, ContainsSquareRoots) {
  properties::Stream stream = properties::stream_from(61);
  for (int i = 0; i < 2000; ++i) {
    const Rational x =
        ratio(stream.integer(1, 1 << 30), stream.integer(1, 1 << 30)) * unit::two_to(stream.integer(-300, 300));
    const double radius = stream.chance(2) ? 0 : to_double(x) * stream.power_of_ten(-30, -1);
    const Approximation around = approximation_of(Enclosure(x)).widened_by(radius);
    const Approximation root = sqrt(around);
    for (const Rational& end : {Rational(x - Rational(radius)), x, Rational(x + Rational(radius))}) {
      const Rational low = Rational(root.middle()) - Rational(root.radius());
      const Rational high = Rational(root.middle()) + Rational(root.radius());
      EXPECT_TRUE((low < 0 || low * low <= end) && end <= high * high) << to_double(x) << ' ' << radius;
    }
    if (radius == 0) {
      EXPECT_LE(root.radius(), 0x1p-51 * root.middle()) << to_double(x);
    }
  }
}

TEST(Approximation, ContainsTheRootOfWhatMayBeZero) {
  EXPECT_TRUE(sqrt(Approximation(0)).is_exactly_zero());
  const Approximation root = sqrt(Approximation(0.25).widened_by(0.5));  // 0 to 3/4
  EXPECT_LE(root.middle() - root.radius(), 0);
  EXPECT_GE((root.middle() + root.radius()) * (root.middle() + root.radius()), 0.75);
  EXPECT_LT(root.radius(), 1);
}

}  // namespace
}  // namespace carom::oracles
