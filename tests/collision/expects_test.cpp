// SPDX-License-Identifier: BSL-1.0
#include <optional>

#include <gtest/gtest.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/vector.hpp>
#include <carom/impulse/numbers/pack.hpp>
#include <carom/oracles/exact/rational.hpp>

namespace carom::unit {

/// How often a build without checks evaluates the condition of a precondition.
[[nodiscard]] int evaluations_of_an_unchecked_precondition();  // unchecked.cpp

}  // namespace carom::unit

namespace carom {
namespace {

TEST(Expects, EvaluatesItsConditionOnceAndNoValueWhereItHolds) {
  int conditions = 0;
  int values = 0;
  CAROM_EXPECTS(++conditions == 1, ++values);
  EXPECT_EQ(conditions, 1);
  EXPECT_EQ(values, 0);
}

TEST(Expects, EvaluatesNothingInABuildThatIsNotChecked) {
  EXPECT_EQ(unit::evaluations_of_an_unchecked_precondition(), 0);
}

TEST(ExpectsDeathTest, NamesThePlaceTheConditionAndTheValues) {
  const double mass = -0.5;
  const int body = 3;
  EXPECT_DEATH(CAROM_EXPECTS(mass > 0, mass, body),
               "expects_test.cpp:[0-9]+: TestBody: .*mass > 0\n *mass, body: -0.5 3\n");
  EXPECT_DEATH(CAROM_EXPECTS(mass > 0), "mass > 0\n$");
}

TEST(ExpectsDeathTest, PrintsWhatEachScalarTypeCanShow) {
  struct Silent {};
  const bool never = false;
  EXPECT_DEATH(CAROM_EXPECTS(never, 0.1f), ": 0.1000000014901161");
  EXPECT_DEATH(CAROM_EXPECTS(never, oracles::Rational(1, 3)), ": 1/3\n");
  EXPECT_DEATH(CAROM_EXPECTS(never, Law::rough), ": rough\n");
  EXPECT_DEATH(CAROM_EXPECTS(never, Vector3<double>(1, 2, 3)), ": \\(1, 2, 3\\)\n");
  EXPECT_DEATH(CAROM_EXPECTS(never, impulse::Pack<double>(1), Silent()), ": [?] [?]\n");
}

TEST(ExpectsDeathTest, AcceptsWhateverConvertsToBool) {
  const std::optional<int> nothing;
  const int* const nowhere = nullptr;
  EXPECT_DEATH(CAROM_EXPECTS(nothing), "nothing");
  EXPECT_DEATH(CAROM_EXPECTS(nowhere), "nowhere");
}

TEST(Expects, DoesNotCheckConditionsOnPacks) { CAROM_EXPECTS(impulse::Pack<double>(-1) > impulse::Pack<double>(0)); }

}  // namespace
}  // namespace carom
