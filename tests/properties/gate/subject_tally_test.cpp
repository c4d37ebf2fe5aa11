// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/properties/gate/histogram.hpp>
#include <carom/properties/gate/subject_tally.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

std::vector<double> some_digits(std::size_t count) {
  Stream stream = stream_from(17);
  std::vector<double> digits;
  for (std::size_t i = 0; i < count; ++i) {
    digits.push_back(stream.chance(10) ? stream.between(-40, 16) : stream.between(14, 17));
    if (stream.chance(20)) {
      digits.back() = stream.chance(2) ? 40 : -std::numeric_limits<double>::infinity();
    }
  }
  return digits;
}

template <class Scale>
Histogram<Scale> histogram_of(const std::vector<double>& numbers) {
  Histogram<Scale> histogram;
  for (const double number : numbers) {
    histogram.add(number);
  }
  return histogram;
}

TEST(Histogram, OfDigitsIsOffByHalfAHundredthAtMost) {
  std::vector<double> digits = some_digits(20000);
  const auto histogram = histogram_of<DigitsScale>(digits);
  std::sort(digits.begin(), digits.end());
  ASSERT_EQ(histogram.size(), digits.size());
  for (std::size_t rank = 0; rank < digits.size(); ++rank) {
    const double exact = digits[rank];
    if (exact < DigitsScale::lowest) {
      EXPECT_EQ(histogram.at(rank), digits.front());
    } else {
      EXPECT_LE(std::abs(histogram.at(rank) - exact), 0.005 * (1 + 0x1p-40)) << exact;
      const bool is_tie = exact * 20 == std::round(exact * 20);  // halfway between two tenths
      EXPECT_TRUE(is_tie || fmt::format("{:.1f}", histogram.at(rank)) == fmt::format("{:.1f}", exact)) << exact;
    }
  }
}

TEST(Histogram, HasTheSmallestAndTheLargestThemselves) {
  const auto histogram = histogram_of<DigitsScale>({15.123456789, 3.3333333333, 15.98765});
  EXPECT_EQ(histogram.at(0), 3.3333333333);
  EXPECT_EQ(histogram.at(2), 15.98765);
  EXPECT_EQ(histogram_of<DigitsScale>({40, 40, 40}).at(1), 40);
  EXPECT_EQ(histogram_of<DigitsScale>({-30}).at(0), -30);
}

TEST(Histogram, OfTimesIsOffByOnePartIn128AtMost) {
  Stream stream = stream_from(18);
  std::vector<double> times{0, 0x1p-20, 1, 0x1.fffffffffffffp0, 2};
  for (int i = 0; i < 20000; ++i) {
    times.push_back(std::exp2(stream.between(-9.5, 53)));
  }
  const auto histogram = histogram_of<TimeScale>(times);
  std::sort(times.begin(), times.end());
  for (std::size_t rank = 2; rank < times.size(); ++rank) {
    EXPECT_LE(std::abs(histogram.at(rank) - times[rank]), times[rank] / 128) << times[rank];
  }
  EXPECT_EQ(histogram_of<TimeScale>({0, HUGE_VAL, 1e300}).bins(), TimeScale::bins);
}

TEST(Histogram, IsTheSameHoweverItsNumbersWereDivided) {
  const std::vector<double> digits = some_digits(3000);
  const auto whole = histogram_of<DigitsScale>(digits);
  std::vector<Histogram<DigitsScale>> parts(7);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    parts[(i * i) % parts.size()].add(digits[i]);
  }
  Histogram<DigitsScale> merged;
  for (std::size_t part = parts.size(); part-- > 0;) {
    merged += parts[part];
  }
  ASSERT_EQ(merged.size(), whole.size());
  for (std::size_t rank = 0; rank < digits.size(); ++rank) {
    EXPECT_EQ(merged.at(rank), whole.at(rank));
  }
}

TEST(Histogram, IsRestoredFromItsCounts) {
  const std::vector<double> digits = some_digits(500);
  const auto whole = histogram_of<DigitsScale>(digits);
  const auto restored = Histogram<DigitsScale>::restored(whole.counts(), whole.smallest(), whole.largest());
  ASSERT_EQ(restored.size(), digits.size());
  for (std::uint64_t rank = 0; rank < restored.size(); ++rank) {
    EXPECT_EQ(restored.at(rank), whole.at(rank));
  }
  const Histogram<DigitsScale> empty;
  EXPECT_EQ(Histogram<DigitsScale>::restored(empty.counts(), empty.smallest(), empty.largest()).size(), 0U);
}

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
