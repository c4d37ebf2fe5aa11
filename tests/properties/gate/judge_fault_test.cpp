// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/witness.hpp>

#include "support/changed_subject.hpp"
#include "support/planted_formula.hpp"

/// A fault of the judge ends a run. It is kept apart from the verdicts on subjects.
namespace carom::properties {
namespace {

/// A formula that fails for inelastic contacts.
Verdict fails_if_inelastic(const Evidence& e) {
  if (e.exact_case.collision().restitution == 0) {
    throw std::logic_error("a wrong formula");
  }
  return {};
}

GateOptions options_of(const std::vector<std::string_view>& families) {
  GateOptions options = unit::gate_options(30, families);
  options.is_part = true;
  return options;
}

Subject frictionless() { return unit::subject_of("frictionless-double"); }

TEST(JudgeFault, EndsTheRunAndNamesTheCollisionAndNoSubject) {
  const unit::PlantedFormula planted("restitution", fails_if_inelastic);
  const GateReport report = run_gate({frictionless()}, options_of({"elastic", "inelastic"}));
  ASSERT_TRUE(report.judge_error);
  EXPECT_STREQ(report.judge_error->what(), "a wrong formula");
  EXPECT_EQ(report.judge_error->collision().restitution, 0);
  const SubjectResult& result = report.results.at(0);
  EXPECT_EQ(result.error, "");
  EXPECT_TRUE(result.violated_invariants().empty());
  EXPECT_FALSE(result.is_sound());
  EXPECT_EQ(result.not_judged, "the judge failed, and ended the run");
}

TEST(JudgeFault, KeepsWhatWasJudgedBefore) {
  const unit::PlantedFormula planted("restitution", fails_if_inelastic);
  const GateReport report = run_gate({unit::idle_subject()}, options_of({"elastic", "inelastic"}));
  ASSERT_TRUE(report.judge_error);
  const SubjectResult& result = report.results.at(0);
  EXPECT_GT(result.families.at(0).cases, 0U);
  EXPECT_GT(result.count(*invariant_named("non_penetration")).violated, 0U);
  EXPECT_FALSE(result.witnesses.empty());
}

TEST(JudgeFault, DoesNotCostAnswersToOtherFamilies) {
  const unit::PlantedFormula planted("restitution", fails_if_inelastic);
  const GateReport report = run_gate({frictionless()}, options_of({"elastic"}));
  EXPECT_FALSE(report.judge_error);
  EXPECT_TRUE(report.results.at(0).is_sound()) << report.results.at(0).not_judged;
}

/// The formula fails in the search for a simpler violation alone.
TEST(JudgeFault, InTheSearchForASimplerViolationCostsThatSearch) {
  static bool is_judging;
  is_judging = true;
  const unit::PlantedFormula planted("restitution", [](const Evidence&) -> Verdict {
    if (!is_judging) {
      throw std::logic_error("a wrong formula");
    }
    return {Status::violated, "planted", 1, 0, {}, {}};
  });
  GateOptions options = options_of({"inelastic"});
  options.shrinks = false;
  GateReport report = run_gate({frictionless()}, options);
  ASSERT_EQ(report.results.at(0).witnesses.size(), 1U);
  is_judging = false;
  report.options.shrinks = true;
  report.results.at(0).witnesses.clear();
  add_witnesses(report);
  const Witness& witness = report.results.at(0).witnesses.at(0);
  EXPECT_EQ(witness.not_shrunk, "a wrong formula");
  EXPECT_EQ(witness.verdict.status, Status::violated);
}

TEST(NeverJudged, InvariantsLeaveASubjectNotSoundExceptInAPartOfARun) {
  const unit::PlantedFormula planted(
      "restitution", [](const Evidence&) -> Verdict { return {.status = Status::skipped, .detail = "planted"}; });
  const GateOptions whole = unit::gate_options(50);
  const SubjectResult result = run_gate({frictionless()}, whole).results.at(0);
  EXPECT_FALSE(result.is_sound());
  EXPECT_EQ(result.not_judged,
            "no case judged restitution. Choose other families, more cases or a wider domain, or leave them out: "
            "--deviates restitution");
  Subject deviating = frictionless();
  deviating.deviates = {"restitution"};
  EXPECT_EQ(run_gate({deviating}, whole).results.at(0).not_judged, "");
  GateOptions part = whole;
  part.is_part = true;
  GateOptions shard = whole;
  shard.shard = {1, 2};
  for (const GateOptions& options : {part, shard}) {
    const SubjectResult of_part = run_gate({frictionless()}, options).results.at(0);
    EXPECT_TRUE(of_part.is_sound()) << of_part.not_judged;
    EXPECT_EQ(of_part.never_judged(options), std::vector{invariant_named("restitution")});
  }
}

/// A `rough` solver that takes μ = 0 for a contact without a limit of friction. The law's formulas hold for no such
/// contact, and the diagnosis asks them for none.
TEST(JudgeFault, IsNoneForASolverThatTakesNoFrictionForNoLimit) {
  const Subject subject = unit::misreading(unit::subject_of("rough-double"), [](Collision& collision) {
    collision.friction = collision.friction == 0 ? 1e6 : collision.friction;
  });
  GateOptions options = unit::gate_options(100);
  options.shrinks = false;
  const GateReport report = run_gate({subject}, options);
  EXPECT_FALSE(report.judge_error);
  EXPECT_GT(report.results.at(0).count(*invariant_named("friction_cone")).violated, 0U);
  const diagnosis::Diagnosis diagnosis = diagnosis::diagnose_all(report).at(0);
  EXPECT_EQ(diagnosis.missing, "");
  EXPECT_FALSE(diagnosis.faults.empty());
}

}  // namespace
}  // namespace carom::properties
