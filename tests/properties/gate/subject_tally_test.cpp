// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/properties/gate/subject_tally.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

void add_many(SubjectTally& tally, std::uint64_t count) {
  const JudgedCase judged_case(unit::case_of("elastic", 1));
  ASSERT_EQ(judged_case.exact().approach(), oracles::Approach::colliding);
  Claim claim;
  claim.yardstick = oracles::Yardstick::of(Precision::binary64);
  Stream stream = stream_from(count);
  Judgement judgement;
  Verdict violated;
  violated.status = Status::violated;
  judgement.verdicts.push_back({invariant_named("restitution"), violated});
  for (std::uint64_t i = 0; i < count; ++i) {
    judgement.accuracy.emplace();
    judgement.accuracy->relative_error = std::pow(10.0, stream.between(-45, 45));
    tally.add(0, i, judged_case, Answer(), judgement, claim);
    tally.nanoseconds_per_solve.add(std::pow(10.0, stream.between(-5, 20)));
  }
}

TEST(SubjectTally, DoesNotGrowWithItsCases) {
  SubjectTally tally;
  tally.families.resize(1);
  add_many(tally, 200000);
  EXPECT_EQ(tally.digits.size(), 200000U);
  EXPECT_LE(tally.digits.bins(), DigitsScale::bins);
  EXPECT_EQ(tally.nanoseconds_per_solve.size(), 200000U);
  EXPECT_LE(tally.nanoseconds_per_solve.bins(), TimeScale::bins);
  EXPECT_EQ(tally.families[0].cases, 200000U);
  EXPECT_EQ(tally.families[0].worst.size(), 1U) << "one violation is kept of each invariant";
  // Besides these bins, a tally contains only a few numbers for each invariant and family.
  EXPECT_LT((DigitsScale::bins + TimeScale::bins) * sizeof(std::uint64_t), 128U << 10U);
}

TEST(Stream, ForgetsTheChangesOfWhatIsDrawnAgain) {
  Stream stream = stream_from(1);
  stream.note(Adjustment::moments_enlarged);
  EXPECT_TRUE(stream.adjusted()[Adjustment::moments_enlarged]);
  stream.note_drawn_again();
  EXPECT_FALSE(stream.adjusted()[Adjustment::moments_enlarged]);
  EXPECT_TRUE(stream.adjusted()[Adjustment::drawn_again]);
}

TEST(Coverage, CountsTheCasesThatAFamilyChanged) {
  const auto counted = [](const char* family) {
    Coverage sum;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      sum += coverage_of(JudgedCase(unit::case_of(family, i)));
    }
    return sum.adjusted;
  };
  const AdjustmentCounts of_structured = counted("structured");
  for (const Adjustment adjustment : all_adjustments) {
    EXPECT_GT(of_structured[adjustment], 0U) << name_of(adjustment);
    EXPECT_LT(of_structured[adjustment], 2000U) << name_of(adjustment);
  }
  EXPECT_EQ(counted("far_contacts")[Adjustment::moments_enlarged], 0U);
}

}  // namespace
}  // namespace carom::properties
