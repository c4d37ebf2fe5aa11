// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/report/pages/pages.hpp>
#include <carom/report/results/run_json.hpp>

/// All forms of a report count violations out of the judged cases.
namespace carom::report {
namespace {

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

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin: " << text;
}

TEST(Violations, AreCountedOutOfTheJudgedCasesInEachForm) {
  const report::Run run = violated_run();
  for (const std::string& text : {run_text(run, ""), run_markdown(run, "")}) {
    expect_in("12 of 60 judged cases", text);
    expect_in("slow (12 of 60 judged cases)", text);
  }
  expect_in("12 of 60 judged cases, most often in slow.", github_annotations(run, ""));
  expect_in("12 of 60 judged cases violate it", junit_xml(run));
  expect_in("The subject violates this in 12 of 60 judged cases.", run_html(run, ""));
}

TEST(Violations, AreListedByFamilyWithTheirShareAndTheBackwardErrorInUlps) {
  for (const std::string& text : {run_text(violated_run(), ""), run_markdown(violated_run(), "")}) {
    expect_in("in: 78 % of the judged cases of invalid, 25 % of slow (backward error up to 1.9e+03 ulps)\n", text);
  }
}

/// If too few cases are violated, their diagnosis has no `where` and no `look at`.
TEST(Violations, AreAnnotatedWithWhatTheDiagnosisSays) {
  report::Run run = violated_run();
  run.diagnoses[0] = {restitution, 2, 2, {{"Only 2 were examined.", ""}}};
  expect_in("::notice title=diagnosis of solver::Only 2 were examined.\n", github_annotations(run, ""));
  run.diagnoses[0].faults[0].where = "Nearly all cases fail.";
  run.diagnoses[0].faults[0].look_at = "the test";
  expect_in("examined.%0ANearly all cases fail.%0ALook at: the test\n", github_annotations(run, ""));
}

/// Each of several faults has a number, its place and its own witness.
TEST(Violations, OfSeveralFaultsAreShownEachWithItsOwnWitness) {
  report::Run run = violated_run();
  run.options.seed = 5;
  run.diagnoses[0] = {restitution,
                      20,
                      18,
                      {{"It bounces.", "the bounce", "Where it bounces.", 12,
                        properties::diagnosis::FaultWitness{slow_family, 7, restitution}},
                       {"It turns.", "the turn", "Where it turns.", 8,
                        properties::diagnosis::FaultWitness{slow_family, 9, properties::invariant_named("energy")}}}};
  for (const std::string& text : {run_text(run, ""), run_markdown(run, ""), run_html(run, "")}) {
    for (const char* part : {"what is wrong, 1 of 2", "It bounces.", "Where it bounces.", "the bounce",
                             "carom replay --family slow --case 7 --seed 5 --subject solver violates restitution",
                             "what is wrong, 2 of 2", "It turns.", "Where it turns.", "the turn",
                             "carom replay --family slow --case 9 --seed 5 --subject solver violates energy"}) {
      expect_in(part, text);
    }
  }
  expect_in("It bounces.%0AWhere it bounces.%0ALook at: the bounce\n", github_annotations(run, ""));
  expect_in("It turns.%0AWhere it turns.%0ALook at: the turn\n", github_annotations(run, ""));
  const nlohmann::json faults = report_record(run).at("subjects").at(0).at("diagnosis").at("faults");
  EXPECT_EQ(faults.at(1).at("witness").at("case"), 9);
}

}  // namespace
}  // namespace carom::report
