// SPDX-License-Identifier: BSL-1.0
#include <limits>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/lifted_outcome.hpp>

namespace carom::oracles {
namespace {

TEST(LiftedOutcome, IsModerateIfEachNumberIs) {
  EXPECT_TRUE(LiftedOutcome(ReportedOutcome{}).is_moderate());
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      ReportedOutcome reported;
      (*vectors(reported)[k])[i] = -static_cast<long double>(largest_moderate_outcome);
      EXPECT_TRUE(LiftedOutcome(reported).is_moderate()) << i;
      (*vectors(reported)[k])[i] *= 2;
      EXPECT_FALSE(LiftedOutcome(reported).is_moderate()) << i;
      (*vectors(reported)[k])[i] = std::numeric_limits<long double>::quiet_NaN();
      EXPECT_FALSE(LiftedOutcome(reported).is_moderate()) << i;
    }
  }
}

TEST(LiftedOutcome, IsExactlyRoundedIfEachNumberIsADouble) {
  EXPECT_TRUE(LiftedOutcome(ReportedOutcome{}).is_exactly_rounded());
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      ReportedOutcome reported;
      (*vectors(reported)[k])[i] = 1 + 0x1p-52L;
      EXPECT_TRUE(LiftedOutcome(reported).is_exactly_rounded()) << i;
      (*vectors(reported)[k])[i] += 0x1p-60L;
      EXPECT_FALSE(LiftedOutcome(reported).is_exactly_rounded()) << i;
    }
  }
}

}  // namespace
}  // namespace carom::oracles
