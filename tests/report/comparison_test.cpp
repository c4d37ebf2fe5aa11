// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/report/results/run.hpp>

namespace carom::report {
namespace {

using properties::Count;

RecordedRun report_with(std::map<std::string, Count> in_x, std::map<std::string, Count> in_y) {
  RecordedRun run;
  run.families = {"x", "y"};
  RecordedSubject subject;
  subject.name = "solver";
  subject.families = {{"x", std::move(in_x)}, {"y", std::move(in_y)}};
  subject.counts = true;
  subject.status = SubjectStatus::violated;
  run.subjects = {subject};
  return run;
}

constexpr Count held{100, 0, 0};
constexpr Count violated{90, 10, 0};
constexpr Count not_judged{0, 0, 0};

std::vector<Change> changes_between(Count before, Count now) {
  const Comparison comparison = compare_runs(report_with({{"push", before}}, {}), report_with({{"push", now}}, {}));
  std::vector<Change> changes;
  for (const ComparedViolation& violation : comparison.subjects.at(0).violations) {
    EXPECT_EQ(violation.invariant, "push");
    EXPECT_EQ(violation.family, "x");
    changes.push_back(violation.change);
  }
  return changes;
}

TEST(Comparison, TellsTheChangeOfAnInvariantInAFamily) {
  using Changes = std::vector<Change>;
  EXPECT_EQ(changes_between(held, violated), Changes{Change::newly_violated});
  EXPECT_EQ(changes_between(not_judged, violated), Changes{Change::violated_unknown});
  EXPECT_EQ(changes_between(violated, violated), Changes{Change::known});
  EXPECT_EQ(changes_between(violated, {0, 100, 0}), Changes{Change::known}) << "more cases of the same are no news";
  EXPECT_EQ(changes_between(violated, held), Changes{Change::fixed});
  EXPECT_EQ(changes_between(violated, not_judged), Changes{Change::no_longer_judged});
  EXPECT_EQ(changes_between(held, held), Changes{});
  EXPECT_EQ(changes_between(held, not_judged), Changes{});
}

TEST(Comparison, CountsAViolationThatWasNotJudgedBeforeAsNew) {
  const Comparison comparison = compare_runs(report_with({{"push", held}}, {{"push", violated}}),
                                             report_with({{"push", violated}, {"energy", violated}}, {{"push", held}}));
  EXPECT_EQ(comparison.count_new(false), 2U);
  EXPECT_EQ(comparison.count(Change::newly_violated), 1U);
  EXPECT_EQ(comparison.count(Change::violated_unknown), 1U);
  EXPECT_EQ(comparison.count(Change::fixed), 1U);
  EXPECT_EQ(summary_of(comparison), "2 new, 0 known, 1 fixed");
}

TEST(Comparison, CountsNewViolationsOfSubjectsThatDoNotCountOnlyWithoutABaseline) {
  RecordedRun now = report_with({{"push", violated}}, {});
  now.subjects[0].counts = false;
  const Comparison comparison = compare_runs(report_with({{"push", held}}, {}), now);
  EXPECT_EQ(comparison.count_new(false), 1U);
  EXPECT_EQ(comparison.count_new(true), 0U);
  EXPECT_EQ(baseline_verdict(comparison), "nothing new in subjects that count (1 in others), 0 known, 0 fixed");
}

TEST(Comparison, CallsAnInvariantKnownIfItIsNewInNoFamily) {
  const properties::Invariant& push = *properties::invariant_named("push");
  const RecordedRun before = report_with({{"push", violated}}, {{"push", held}});
  const Comparison same = compare_runs(before, before);
  EXPECT_TRUE(is_known(same, "solver", push));
  EXPECT_FALSE(is_known(same, "solver", *properties::invariant_named("energy")));
  EXPECT_FALSE(is_known(same, "other", push));
  const Comparison worse = compare_runs(before, report_with({{"push", violated}}, {{"push", violated}}));
  EXPECT_FALSE(is_known(worse, "solver", push));
}

TEST(Comparison, ListsSubjectsThatOnlyOneReportHas) {
  const RecordedRun before = report_with({{"push", violated}}, {});
  RecordedRun now = before;
  now.subjects[0].name = "other";
  const Comparison comparison = compare_runs(before, now);
  ASSERT_EQ(comparison.subjects.size(), 2U);
  EXPECT_EQ(comparison.subjects[0].name, "other");
  EXPECT_FALSE(comparison.subjects[0].was_before);
  EXPECT_EQ(comparison.subjects[0].violations.at(0).change, Change::violated_unknown);
  EXPECT_EQ(comparison.subjects[1].name, "solver");
  EXPECT_FALSE(comparison.subjects[1].is_now);
}

TEST(Comparison, RecognisesAProgramThatCannotStateItsNameByItsCommand) {
  RecordedRun before = report_with({{"push", held}}, {});
  before.subjects[0].specification = "exec:./solver";
  RecordedRun now = before;
  now.subjects[0].name = "exec:./solver";
  now.subjects[0].status = SubjectStatus::error;
  now.subjects[0].families.clear();
  const Comparison comparison = compare_runs(before, now);
  ASSERT_EQ(comparison.subjects.size(), 1U);
  EXPECT_TRUE(comparison.subjects[0].cannot_be_judged_now);
  EXPECT_EQ(comparison.count_new(true), 1U) << "a solver that does not start is no pass";
  EXPECT_EQ(compare_runs(now, now).count_new(true), 0U);
}

TEST(Comparison, ListsInvariantsThatAreNoLongerClaimed) {
  const RecordedRun before = report_with({{"push", violated}}, {});
  RecordedRun now = report_with({{"push", not_judged}}, {});
  now.subjects[0].deviates = {"push@x"};
  EXPECT_EQ(compare_runs(before, now).subjects[0].no_longer_claimed, std::vector<std::string>{"push@x"});
  EXPECT_TRUE(compare_runs(now, before).subjects[0].no_longer_claimed.empty());
}

TEST(Comparison, NamesEachSettingInWhichTheRunsDiffer) {
  const RecordedRun before = report_with({{"push", held}}, {});
  EXPECT_TRUE(compare_runs(before, before).differences.empty());
  const std::vector<std::pair<std::string, void (*)(RecordedRun&)>> changes{
      {"version of Carom", [](RecordedRun& run) { run.heading.carom = "9.0.0"; }},
      {"seed", [](RecordedRun& run) { run.heading.seed = 7; }},
      {"cases of each family", [](RecordedRun& run) { run.cases = "7"; }},
      {"families of one run only", [](RecordedRun& run) { run.families.emplace_back("z"); }},
      {"domain", [](RecordedRun& run) { run.domain = "size=1:2"; }},
      {"yardstick", [](RecordedRun& run) { run.yardstick = "4 digits"; }},
      {"interval between the cases on which relations are judged", [](RecordedRun& run) { run.relations_every = "4"; }},
      {"ended early", [](RecordedRun& run) { run.ended_early = "interrupted"; }},
      {"shard", [](RecordedRun& run) { run.shard = "1/3"; }}};
  for (const auto& [what, change] : changes) {
    RecordedRun now = before;
    change(now);
    const Comparison comparison = compare_runs(before, now);
    ASSERT_EQ(comparison.differences.size(), 1U) << what;
    EXPECT_EQ(comparison.differences[0].what, what);
    EXPECT_NE(comparison.differences[0].before, comparison.differences[0].now);
  }
}

}  // namespace
}  // namespace carom::report
