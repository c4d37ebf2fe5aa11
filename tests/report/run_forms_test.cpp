// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/properties/gate/gate.hpp>
#include <carom/properties/kit/subject.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/merged_run.hpp>
#include <carom/report/results/run.hpp>
#include <carom/report/results/run_json.hpp>

#include "support/expect_in.hpp"

/// The forms of a run: they show a fault of the judge, and count violations out of the judged cases.
namespace carom::report {
namespace {

using nlohmann::json;

properties::GateReport judged_report() {
  properties::GateOptions options;
  options.cases = 30;
  options.families = {properties::family_named("generic"), properties::family_named("separating")};
  const auto idle = [](const Collision& collision) { return unchanged(collision); };
  return properties::run_gate({conformance::subject("idle", Law::frictionless, idle)}, options);
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
    unit::expect_in(form, {"a wrong formula", "1234.5"});
  }
  const std::optional<oracles::JudgeError> read =
      shard_from(json::parse(report_record(run_with(report, true)).dump()), "shard").run.judge_error;
  ASSERT_TRUE(read);
  EXPECT_STREQ(read->what(), "a wrong formula");
  EXPECT_EQ(read->collision().a.mass, 1234.5);
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

const properties::Invariant* const restitution = properties::invariant_named("restitution");
const properties::Invariant* const invalid_refused = properties::invariant_named("invalid_refused");
const properties::Family* const slow_family = properties::family_named("slow");

properties::Witness witness_of(const properties::Invariant* invariant, const char* family) {
  properties::Witness witness;
  witness.invariant = invariant;
  witness.family = properties::family_named(family);
  witness.verdict.status = properties::Status::violated;
  witness.answer = ReportedOutcome{};
  return witness;
}

/// A subject was judged on 80 of 100 cases of `slow`; `restitution` was judged on 60 of these 80. The subject answers
/// invalid collisions.
report::Run violated_run() {
  report::Run run;
  run.options.cases = 100;
  run.options.families = {slow_family, properties::family_named("invalid")};
  run.coverage.resize(2);
  run.sampled.resize(2);
  run.counts = {true};
  run.diagnoses.resize(1);
  properties::SubjectResult& result = run.results.emplace_back();
  result.subject.name = "solver";
  result.subject.law = Law::frictionless;
  result.families.resize(2);
  properties::FamilyResult& slow = result.families[0];
  slow.cases = 100;
  slow.skipped = 15;
  slow.unjudged[properties::Unjudged::leaves_range] = 5;
  slow.violated = 20;
  slow.worst_backward_error = 1900;
  slow.counts[restitution] = {48, 12, 20};
  properties::FamilyResult& invalid = result.families[1];
  invalid.cases = 50;
  invalid.violated = 39;
  invalid.counts[invalid_refused] = {11, 39, 0};
  for (properties::FamilyResult* family : {&slow, &invalid}) {
    for (const auto& [invariant, count] : family->counts) {
      family->worst[invariant] = {};
    }
  }
  result.witnesses = {witness_of(restitution, "slow"), witness_of(invalid_refused, "invalid")};
  return run;
}

TEST(Violations, AreCountedOutOfTheJudgedCasesInEachForm) {
  const report::Run run = violated_run();
  for (const std::string& text : {run_text(run, ""), run_markdown(run, "")}) {
    unit::expect_in(text, {"restitution in 12 of 60 judged cases, invalid_refused in 39 of 50\n"});
  }
  unit::expect_in(github_annotations(run, ""), {"12 of 60 judged cases, most often in slow."});
  unit::expect_in(junit_xml(run), {"12 of 60 judged cases violate it"});
  unit::expect_in(run_html(run, ""), {"The subject violates this in 12 of 60 judged cases."});
}

TEST(Violations, AreListedByFamilyWithTheirShareAndTheBackwardErrorInUlps) {
  for (const std::string& text : {run_text(violated_run(), "", true), run_markdown(violated_run(), "")}) {
    unit::expect_in(text,
                    {": 78 % of the judged cases of invalid, 25 % of slow (backward error up to 1.9e+03 ulps)\n"});
  }
}

/// If too few cases are violated, their diagnosis has no `where` and no `look at`.
TEST(Violations, AreAnnotatedWithWhatTheDiagnosisSays) {
  report::Run run = violated_run();
  run.diagnoses[0] = {restitution, 2, 2, {{"Only 2 were examined.", ""}}};
  unit::expect_in(github_annotations(run, ""), {"::notice title=diagnosis of solver::Only 2 were examined.\n"});
  run.diagnoses[0].faults[0].where = "unless ε = 0";
  run.diagnoses[0].faults[0].look_at = "the test";
  unit::expect_in(github_annotations(run, ""), {"examined, unless ε = 0.%0ALook at: the test\n"});
}

/// A terminal has the place of the first fault only, and the case of each.
TEST(Violations, OfSeveralFaultsAreShownEachWithItsOwnWitness) {
  report::Run run = violated_run();
  run.options.seed = 5;
  run.diagnoses[0] = {restitution,
                      20,
                      18,
                      {{"It bounces.", "the bounce", "unless it rests", 12,
                        properties::diagnosis::FaultWitness{slow_family, 7, restitution}},
                       {"It turns.", "the turn", "if it spins", 8,
                        properties::diagnosis::FaultWitness{slow_family, 9, properties::invariant_named("energy")}}}};
  const std::string text = run_text(run, "");
  unit::expect_in(text, {"\nIt bounces, unless it rests.\n", "\nLook at: the bounce\n",
                         "\nReplay: carom replay --family slow --case 0 --seed 5 --subject solver\n",
                         "\nAlso: It turns if it spins. (case 9 of slow)\n"});
  EXPECT_EQ(text.find("the turn"), std::string::npos) << text;
  for (const std::string& form : {run_markdown(run, ""), run_html(run, "")}) {
    unit::expect_in(form, {"It bounces, unless it rests.", "the bounce", "It turns if it spins.", "the turn",
                           "carom replay --family slow --case 9 --seed 5 --subject solver"});
  }
  unit::expect_in(github_annotations(run, ""), {"It bounces, unless it rests.%0ALook at: the bounce\n",
                                                "It turns if it spins.%0ALook at: the turn\n"});
  const nlohmann::json faults = report_record(run).at("subjects").at(0).at("diagnosis").at("faults");
  EXPECT_EQ(faults.at(1).at("witness").at("case"), 9);
}

}  // namespace
}  // namespace carom::report
