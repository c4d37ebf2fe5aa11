// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/report/model/run.hpp>

namespace carom::report {
namespace {

using properties::Count;

report::Run report_with(std::map<std::string, Count> in_x, std::map<std::string, Count> in_y) {
  report::Run run;
  run.settings.cases = 100;
  run.families = {{"x", "", {}, {}}, {"y", "", {}, {}}};
  JudgedSubject subject;
  subject.result.subject.name = "solver";
  subject.result.families.resize(2);
  subject.result.families[0].counts = std::move(in_x);
  subject.result.families[1].counts = std::move(in_y);
  subject.counts = true;
  subject.status = "violated";
  run.subjects = {subject};
  return run;
}

Comparison compared(const report::Run& before, const report::Run& now) {
  return compare_runs(before, "before.json", now, "now.json");
}

constexpr Count held{100, 0, 0};
constexpr Count violated{90, 10, 0};
constexpr Count not_judged{0, 0, 0};

std::vector<Change> changes_between(Count before, Count now) {
  const Comparison comparison = compared(report_with({{"push", before}}, {}), report_with({{"push", now}}, {}));
  std::vector<Change> changes;
  for (const ComparedViolation& violation : comparison.subjects.at(0).violations) {
    EXPECT_EQ(violation.invariant, "push");
    EXPECT_EQ(violation.family, "x");
    changes.push_back(violation.change);
  }
  return changes;
}

TEST(Comparison, TellsWhatBecameOfAnInvariantInAFamily) {
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

TEST(Comparison, CountsWhatIsNewAlsoWhereItWasNotJudgedBefore) {
  const Comparison comparison = compared(report_with({{"push", held}}, {{"push", violated}}),
                                         report_with({{"push", violated}, {"energy", violated}}, {{"push", held}}));
  EXPECT_EQ(comparison.count_new(false), 2U);
  EXPECT_EQ(comparison.count(Change::newly_violated), 1U);
  EXPECT_EQ(comparison.count(Change::violated_unknown), 1U);
  EXPECT_EQ(comparison.count(Change::fixed), 1U);
  EXPECT_EQ(summary_of(comparison), "2 new, 0 known, 1 fixed");
}

TEST(Comparison, ASubjectThatDoesNotCountIsNewForACompareAlone) {
  report::Run now = report_with({{"push", violated}}, {});
  now.subjects[0].counts = false;
  const Comparison comparison = compared(report_with({{"push", held}}, {}), now);
  EXPECT_EQ(comparison.count_new(false), 1U);
  EXPECT_EQ(comparison.count_new(true), 0U);
  EXPECT_EQ(baseline_verdict(comparison), "nothing new in subjects that count (1 in others), 0 known, 0 fixed");
}

TEST(Comparison, KnownIsAnInvariantThatIsNewInNoFamily) {
  const report::Run before = report_with({{"push", violated}}, {{"push", held}});
  const Comparison same = compared(before, before);
  EXPECT_TRUE(is_known(same, "solver", "push"));
  EXPECT_FALSE(is_known(same, "solver", "energy"));
  EXPECT_FALSE(is_known(same, "other", "push"));
  const Comparison worse = compared(before, report_with({{"push", violated}}, {{"push", violated}}));
  EXPECT_FALSE(is_known(worse, "solver", "push"));
}

TEST(Comparison, TellsSubjectsThatCameAndWent) {
  const report::Run before = report_with({{"push", violated}}, {});
  report::Run now = before;
  now.subjects[0].result.subject.name = "other";
  const Comparison comparison = compared(before, now);
  ASSERT_EQ(comparison.subjects.size(), 2U);
  EXPECT_EQ(comparison.subjects[0].name, "other");
  EXPECT_FALSE(comparison.subjects[0].before);
  EXPECT_EQ(comparison.subjects[0].violations.at(0).change, Change::violated_unknown);
  EXPECT_EQ(comparison.subjects[1].name, "solver");
  EXPECT_FALSE(comparison.subjects[1].now);
}

TEST(Comparison, AProgramThatCannotSayItsNameIsKnownByItsCommand) {
  report::Run before = report_with({{"push", held}}, {});
  before.subjects[0].result.subject.specification = "exec:./solver";
  report::Run now = before;
  now.subjects[0].result.subject.name = "exec:./solver";
  now.subjects[0].status = "error";
  now.subjects[0].result.families.clear();
  const Comparison comparison = compared(before, now);
  ASSERT_EQ(comparison.subjects.size(), 1U);
  EXPECT_TRUE(comparison.subjects[0].cannot_be_judged_now);
  EXPECT_EQ(comparison.count_new(true), 1U) << "a solver that does not start is no pass";
  EXPECT_EQ(compared(now, now).count_new(true), 0U);
}

TEST(Comparison, TellsWhatIsNoLongerClaimed) {
  const report::Run before = report_with({{"push", violated}}, {});
  report::Run now = report_with({{"push", not_judged}}, {});
  now.subjects[0].result.subject.deviates = {"push@x"};
  EXPECT_EQ(compared(before, now).subjects[0].no_longer_claimed, std::vector<std::string>{"push@x"});
  EXPECT_TRUE(compared(now, before).subjects[0].no_longer_claimed.empty());
}

TEST(Comparison, NamesEachSettingInWhichTheRunsDiffer) {
  const report::Run before = report_with({{"push", held}}, {});
  EXPECT_TRUE(compared(before, before).differences.empty());
  const std::vector<std::pair<std::string, void (*)(report::Run&)>> changes{
      {"version of Carom", [](report::Run& report) { report.carom = "9.0.0"; }},
      {"seed", [](report::Run& report) { report.settings.seed = 7; }},
      {"cases of each family", [](report::Run& report) { report.settings.cases = 7; }},
      {"families of one run only",
       [](report::Run& report) {
         report.families.push_back({"z", "", {}, {}});
       }},
      {"yardstick", [](report::Run& report) { report.settings.limits.digits = 4; }},
      {"interval between the cases on which relations are judged",
       [](report::Run& report) { report.settings.relations_every = 4; }},
      {"ended early", [](report::Run& report) { report.settings.fail_fast = true; }},
      {"ended early", [](report::Run& report) { report.interrupted = true; }},
      {"shard", [](report::Run& report) {
         report.settings.shard = {1, 3};
       }}};
  for (const auto& [what, change] : changes) {
    report::Run now = before;
    change(now);
    const Comparison comparison = compared(before, now);
    ASSERT_EQ(comparison.differences.size(), 1U) << what;
    EXPECT_EQ(comparison.differences[0].what, what);
    EXPECT_NE(comparison.differences[0].before, comparison.differences[0].now);
  }
}

}  // namespace
}  // namespace carom::report
