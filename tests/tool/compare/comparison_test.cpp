// SPDX-License-Identifier: BSL-1.0
#include "compare/comparison.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::tool::compare {
namespace {

/// A report of one subject on the families x and y.
ReadReport report_with(std::map<std::string, ReadCount> in_x, std::map<std::string, ReadCount> in_y) {
  ReadReport report;
  report.file = "report.json";
  report.cases = 100;
  report.families = {"x", "y"};
  ReadSubject subject;
  subject.name = "solver";
  subject.counts = true;
  subject.summary.status = "violated";
  subject.summary.cases = 200;
  subject.families = {{"x", std::move(in_x)}, {"y", std::move(in_y)}};
  report.subjects = {subject};
  return report;
}

constexpr ReadCount held{100, 0};
constexpr ReadCount violated{90, 10};
constexpr ReadCount not_judged{0, 0};

std::vector<Change> changes_between(ReadCount before, ReadCount now) {
  const Comparison comparison = compare_reports(report_with({{"push", before}}, {}), report_with({{"push", now}}, {}));
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
  EXPECT_EQ(changes_between(violated, {0, 100}), Changes{Change::known}) << "more cases of the same are no news";
  EXPECT_EQ(changes_between(violated, held), Changes{Change::fixed});
  EXPECT_EQ(changes_between(violated, not_judged), Changes{Change::no_longer_judged});
  EXPECT_EQ(changes_between(held, held), Changes{});
  EXPECT_EQ(changes_between(held, not_judged), Changes{});
}

TEST(Comparison, CountsWhatIsNewAlsoWhereItWasNotJudgedBefore) {
  const Comparison comparison =
      compare_reports(report_with({{"push", held}}, {{"push", violated}}),
                      report_with({{"push", violated}, {"energy", violated}}, {{"push", held}}));
  EXPECT_EQ(comparison.count_new(false), 2U);
  EXPECT_EQ(comparison.count(Change::newly_violated), 1U);
  EXPECT_EQ(comparison.count(Change::violated_unknown), 1U);
  EXPECT_EQ(comparison.count(Change::fixed), 1U);
  EXPECT_EQ(summary_of(comparison), "2 new, 0 known, 1 fixed");
}

TEST(Comparison, ASubjectThatDoesNotCountIsNewForACompareAlone) {
  ReadReport now = report_with({{"push", violated}}, {});
  now.subjects[0].counts = false;
  const Comparison comparison = compare_reports(report_with({{"push", held}}, {}), now);
  EXPECT_EQ(comparison.count_new(false), 1U);
  EXPECT_EQ(comparison.count_new(true), 0U);
  EXPECT_EQ(baseline_verdict(comparison), "nothing new in what counts (1 in what does not), 0 known, 0 fixed");
}

TEST(Comparison, KnownIsAnInvariantThatIsNewInNoFamily) {
  const ReadReport before = report_with({{"push", violated}}, {{"push", held}});
  const Comparison same = compare_reports(before, before);
  EXPECT_TRUE(is_known(same, "solver", "push"));
  EXPECT_FALSE(is_known(same, "solver", "energy"));
  EXPECT_FALSE(is_known(same, "other", "push"));
  const Comparison worse = compare_reports(before, report_with({{"push", violated}}, {{"push", violated}}));
  EXPECT_FALSE(is_known(worse, "solver", "push"));
}

TEST(Comparison, TellsSubjectsThatCameAndWent) {
  const ReadReport before = report_with({{"push", violated}}, {});
  ReadReport now = before;
  now.subjects[0].name = "other";
  const Comparison comparison = compare_reports(before, now);
  ASSERT_EQ(comparison.subjects.size(), 2U);
  EXPECT_EQ(comparison.subjects[0].name, "other");
  EXPECT_FALSE(comparison.subjects[0].before);
  EXPECT_EQ(comparison.subjects[0].violations.at(0).change, Change::violated_unknown);
  EXPECT_EQ(comparison.subjects[1].name, "solver");
  EXPECT_FALSE(comparison.subjects[1].now);
}

TEST(Comparison, AProgramThatCannotSayItsNameIsKnownByItsCommand) {
  ReadReport before = report_with({{"push", held}}, {});
  before.subjects[0].specification = "exec:./solver";
  ReadReport now = before;
  now.subjects[0].name = "exec:./solver";
  now.subjects[0].summary.status = "error";
  now.subjects[0].summary.cases = 0;
  now.subjects[0].families.clear();
  const Comparison comparison = compare_reports(before, now);
  ASSERT_EQ(comparison.subjects.size(), 1U);
  EXPECT_TRUE(comparison.subjects[0].cannot_be_judged_now);
  EXPECT_EQ(comparison.count_new(true), 1U) << "a solver that does not start is no pass";
  EXPECT_EQ(compare_reports(now, now).count_new(true), 0U);
}

TEST(Comparison, TellsWhatIsNoLongerClaimed) {
  const ReadReport before = report_with({{"push", violated}}, {});
  ReadReport now = report_with({{"push", not_judged}}, {});
  now.subjects[0].summary.deviates = {"push@x"};
  EXPECT_EQ(compare_reports(before, now).subjects[0].no_longer_claimed, std::vector<std::string>{"push@x"});
  EXPECT_TRUE(compare_reports(now, before).subjects[0].no_longer_claimed.empty());
}

TEST(Comparison, NamesEachSettingInWhichTheRunsDiffer) {
  const ReadReport before = report_with({{"push", held}}, {});
  EXPECT_TRUE(compare_reports(before, before).differences.empty());
  const std::vector<std::pair<std::string, void (*)(ReadReport&)>> changes{
      {"version of Carom", [](ReadReport& report) { report.carom = "9.0.0"; }},
      {"seed", [](ReadReport& report) { report.seed = 7; }},
      {"cases of each family", [](ReadReport& report) { report.cases = 7; }},
      {"families that the other has not", [](ReadReport& report) { report.families.emplace_back("z"); }},
      {"yardstick", [](ReadReport& report) { report.yardstick = "4 digits"; }},
      {"relations judged on every so many cases", [](ReadReport& report) { report.relations_every = 4; }},
      {"cut short", [](ReadReport& report) { report.fail_fast = true; }},
      {"cut short", [](ReadReport& report) { report.interrupted = true; }},
      {"shard", [](ReadReport& report) { report.shard = "1/3"; }}};
  for (const auto& [what, change] : changes) {
    ReadReport now = before;
    change(now);
    const Comparison comparison = compare_reports(before, now);
    ASSERT_EQ(comparison.differences.size(), 1U) << what;
    EXPECT_EQ(comparison.differences[0].what, what);
    EXPECT_NE(comparison.differences[0].before, comparison.differences[0].now);
  }
}

}  // namespace
}  // namespace carom::tool::compare
