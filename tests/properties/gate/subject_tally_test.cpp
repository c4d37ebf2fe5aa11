// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/properties/gate/histogram.hpp>
#include <carom/properties/gate/subject_tally.hpp>
#include <carom/properties/gate/task.hpp>

#include "support/cases.hpp"
#include "support/changed_subject.hpp"

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
  ASSERT_EQ(judged_case.exact().state(), oracles::ContactState::colliding);
  const Claim claim{Law::any, oracles::Yardstick::of(Precision::binary64), {}};
  Stream stream = stream_from(count);
  Judgement judgement;
  judgement.verdicts.push_back({invariant_named("restitution"), {.status = Status::violated}});
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

std::vector<Task> first_tasks(const GateOptions& options, std::size_t most) {
  Schedule schedule(options);
  std::vector<Task> tasks;
  while (tasks.size() < most) {
    const auto task = schedule.next();
    if (!task) {
      break;
    }
    tasks.push_back(*task);
  }
  return tasks;
}

constexpr std::size_t every_task = 1'000'000;

TEST(Schedule, HasEveryCaseInOneTask) {
  const GateOptions options = unit::gate_options(137);
  std::vector<std::uint64_t> drawn(options.families.size());
  std::uint64_t number = 0;
  for (const Task& task : first_tasks(options, every_task)) {
    EXPECT_EQ(task.number, number++);
    EXPECT_EQ(task.first, drawn[task.family]) << "cases come in the order of their numbers";
    EXPECT_LT(task.first, task.last);
    EXPECT_LE(task.last, task.first + 50);
    drawn[task.family] = task.last;
  }
  for (std::size_t f = 0; f < drawn.size(); ++f) {
    EXPECT_EQ(drawn[f], cases_of(options, *options.families[f])) << options.families[f]->name;
  }
}

TEST(Schedule, TakesFamiliesInTurnFromOneCaseOn) {
  const GateOptions options = unit::gate_options(1000);
  std::set<std::size_t> had;
  for (const Task& task : first_tasks(options, options.families.size())) {
    EXPECT_TRUE(had.insert(task.family).second) << "again before the others had their turn";
    EXPECT_EQ(task.last - task.first, static_cast<std::uint64_t>(options.families[task.family]->weight));
  }
}

TEST(Schedule, DoesNotDependOnTheOrderInWhichFamiliesAreReported) {
  const GateOptions options = unit::gate_options(100);
  GateOptions reversed = options;
  std::reverse(reversed.families.begin(), reversed.families.end());
  const std::vector<Task> tasks = first_tasks(options, every_task);
  const std::vector<Task> others = first_tasks(reversed, every_task);
  ASSERT_EQ(tasks.size(), others.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    EXPECT_EQ(options.families[tasks[i].family], reversed.families[others[i].family])
        << "a family has no place in the order";
    EXPECT_EQ(tasks[i].first, others[i].first);
  }
}

/// Even with a budget, the cases come in the order of their numbers. So a longer run starts with the cases of a shorter
/// run.
TEST(Schedule, GoesOnWithoutEndOnABudget) {
  GateOptions options = unit::gate_options(1);
  options.budget = std::chrono::seconds(1);
  const std::vector<Task> tasks = first_tasks(options, 5000);
  ASSERT_EQ(tasks.size(), 5000U);
  std::map<std::size_t, std::uint64_t> drawn;
  for (const Task& task : tasks) {
    EXPECT_EQ(task.first, drawn[task.family]);
    drawn[task.family] = task.last;
  }
  EXPECT_EQ(drawn.size(), options.families.size());
}

TEST(Schedule, IsOverAtOnceWithoutFamilies) { EXPECT_FALSE(Schedule(GateOptions()).next()); }

TEST(Schedule, OfAllShardsHasEveryCaseOnce) {
  for (const std::uint64_t of_each : {1U, 2U, 7U, 137U}) {
    GateOptions options = unit::gate_options(of_each);
    std::map<std::size_t, std::multiset<std::uint64_t>> numbers;
    for (options.shard = {1, 3}; options.shard.number <= options.shard.of; ++options.shard.number) {
      for (const Task& task : first_tasks(options, every_task)) {
        for (std::uint64_t i = 0; i < task.last - task.first; ++i) {
          EXPECT_EQ(task.case_number(i) % 3, options.shard.number - 1);
          numbers[task.family].insert(task.case_number(i));
        }
      }
    }
    options.shard = {};
    for (std::size_t f = 0; f < options.families.size(); ++f) {
      const std::uint64_t all = cases_of(options, *options.families[f]);
      ASSERT_EQ(numbers[f].size(), all);
      EXPECT_EQ(std::set<std::uint64_t>(numbers[f].begin(), numbers[f].end()).size(), all) << "each once";
      EXPECT_EQ(*numbers[f].rbegin(), all - 1);
    }
  }
}

}  // namespace
}  // namespace carom::properties
