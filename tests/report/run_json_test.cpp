// SPDX-License-Identifier: BSL-1.0
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/gate.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/merged_run.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/run_json.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

Subject idle_subject() {
  Subject subject;
  subject.name = "idle";
  subject.summary = "leaves everything as it is";
  subject.law = Law::frictionless;
  subject.open = [] {
    return Session([](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& c : collisions) {
        answers.emplace_back(
            ReportedOutcome({c.a.velocity.cast<long double>(), c.a.angular_velocity.cast<long double>()},
                            {c.b.velocity.cast<long double>(), c.b.angular_velocity.cast<long double>()}));
      }
      return answers;
    });
  };
  return subject;
}

properties::GateReport judged_report() {
  properties::GateOptions options;
  options.cases = 30;
  for (const char* name : {"generic", "separating"}) {
    options.families.push_back(properties::family_named(name));
  }
  return properties::run_gate({idle_subject()}, options);
}

report::Run run_with(const properties::GateReport& report, bool is_shard) {
  Environment environment;
  environment.date = "2026-11-25T00:00:00Z";
  environment.processor_threads = 2;
  environment.compiler_flags["carom_report"] = "-O1";
  return diagnosed({report, environment, {"push@generic"}, {}, {true}, {}, is_shard});
}

ReadShard read_back(const properties::GateReport& report) {
  const report::Run run = run_with(report, true);
  ReadShard shard = shard_from(json::parse(report_record(run).dump()), "shard");
  for (properties::Witness& witness : shard.run.results[0].witnesses) {
    const properties::Witness& written = run.results[0].witnesses[&witness - shard.run.results[0].witnesses.data()];
    const json record = json::parse(witness_record(written, run.results[0].subject, run.options, "file").dump());
    witness = witness_from(record, *witness.invariant);
  }
  return shard;
}

TEST(JudgeFault, GivesExitStatusTwoAndIsInEachFormOfTheReport) {
  properties::GateReport report = judged_report();
  Collision collision;
  collision.a.mass = 1234.5;
  report.judge_error = oracles::JudgeError("a wrong formula", collision);
  const report::Run run = run_with(report, false);
  EXPECT_EQ(run.exit_status(), exit_usage);
  const std::string record = report_record(run).dump();
  for (const std::string& form :
       {run_text(run, ""), run_markdown(run, ""), run_html(run, ""), junit_xml(run), record}) {
    for (const char* part : {"a wrong formula", "1234.5"}) {
      EXPECT_NE(form.find(part), std::string::npos) << part << " in\n" << form;
    }
  }
  const std::optional<oracles::JudgeError> read =
      shard_from(json::parse(report_record(run_with(report, true)).dump()), "shard").run.judge_error;
  ASSERT_TRUE(read);
  EXPECT_STREQ(read->what(), "a wrong formula");
  EXPECT_EQ(read->collision().a.mass, 1234.5);
}

TEST(MergedRun, OfOneShardIsTheWholeRun) {
  const properties::GateReport report = judged_report();
  ASSERT_FALSE(report.results[0].witnesses.empty()) << "what does nothing violates something";
  EXPECT_EQ(report_record(merged_run({read_back(report)})), report_record(run_with(report, false)));
}

TEST(RecordedRun, ComparedWithItselfHasNoDifference) {
  const json record = report_record(run_with(judged_report(), false));
  const Comparison comparison =
      compare_runs(recorded_run(record, "run"), recorded_run(json::parse(record.dump()), "read"));
  EXPECT_TRUE(comparison.differences.empty());
  EXPECT_EQ(comparison.count_new(false), 0U);
  EXPECT_EQ(comparison.count(Change::fixed), 0U);
  EXPECT_GT(comparison.count(Change::known), 0U);
  ASSERT_EQ(comparison.subjects.size(), 1U);
  EXPECT_TRUE(comparison.subjects[0].was_before && comparison.subjects[0].is_now);
}

/// The baseline contains all violations of the run, so only the error makes the run fail.
TEST(MergedRun, KeepsTheErrorOfAShardThatAlsoViolatesSomething) {
  properties::GateReport report = judged_report();
  const report::Run baseline = run_with(report, false);
  report.results[0].error = "it ended in the middle";
  report::Run merged = merged_run({read_back(report)});
  EXPECT_EQ(status_of(merged.results[0]), SubjectStatus::violated);
  EXPECT_EQ(merged.results[0].error, "it ended in the middle");
  merged.baseline =
      compare_runs(recorded_run(report_record(baseline), "baseline"), recorded_run(report_record(merged), "merged"));
  EXPECT_EQ(merged.baseline->count_new(true), 0U);
  EXPECT_EQ(merged.exit_status(), exit_violated);
}

}  // namespace
}  // namespace carom::report
