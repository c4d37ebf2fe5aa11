// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/witness.hpp>

#include "catalogue.hpp"

namespace carom::mutants {
namespace {

using properties::GateOptions;
using properties::GateReport;
using properties::SubjectResult;
using properties::Witness;

const Mutant& mutant_named(std::string_view name) {
  return *std::find_if(all_mutants().begin(), all_mutants().end(), [&](const Mutant& one) { return one.name == name; });
}

GateOptions options_with(std::initializer_list<std::string_view> families) {
  GateOptions options;
  options.seed = 1;
  options.cases = 50;
  options.is_part = true;
  for (const std::string_view family : families) {
    options.families.push_back(properties::family_named(family));
  }
  return options;
}

properties::Status status_of(const SubjectResult& result, const properties::Invariant* invariant,
                             const properties::Case& one) {
  properties::Claim claim = properties::claim_of(result.subject, {});
  claim.invariants = {invariant};
  const properties::Judgement judgement = properties::judge_one(result.subject, claim, one).judgement;
  return judgement.verdicts.empty() ? properties::Status::skipped : judgement.verdicts.front().verdict.status;
}

class Witnesses : public testing::TestWithParam<std::string_view> {};

TEST_P(Witnesses, AreSimplerAndStillViolateTheirInvariant) {
  const Mutant& mutant = mutant_named(GetParam());
  const GateReport report = run_gate({subject_of(mutant), repaired(mutant)}, options_with({"generic"}));
  const SubjectResult& rejected = report.results.at(0);
  EXPECT_EQ(rejected.error, "");
  EXPECT_FALSE(rejected.is_sound());
  EXPECT_TRUE(report.results.at(1).is_sound());
  EXPECT_EQ(rejected.witnesses.size(), rejected.violated_invariants().size());
  ASSERT_FALSE(rejected.witnesses.empty());
  for (const Witness& witness : rejected.witnesses) {
    SCOPED_TRACE(witness.invariant->name);
    const properties::Verdict& verdict = witness.verdict;
    EXPECT_EQ(verdict.status, properties::Status::violated);
    EXPECT_GT(verdict.residual, verdict.allowed);
    EXPECT_TRUE(validate(witness.shrunk.collision).empty());
    EXPECT_EQ(status_of(rejected, witness.invariant, witness.original), properties::Status::violated);
    EXPECT_EQ(status_of(rejected, witness.invariant, witness.shrunk), properties::Status::violated);
    EXPECT_LT(properties::complexity(witness.shrunk.collision), properties::complexity(witness.original.collision));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Witnesses, testing::Values("separating_pulled", "wrong_mass_in_reaction"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Witness, OfAPullIsSmall) {
  const GateReport report = run_gate({subject_of(mutant_named("separating_pulled"))}, options_with({"separating"}));
  const auto& witnesses = report.results.at(0).witnesses;
  const auto push =
      std::find_if(witnesses.begin(), witnesses.end(), [](const Witness& w) { return w.invariant->name == "push"; });
  ASSERT_NE(push, witnesses.end());
  // The simplest collisions (at the origin with r_A = r_B = 0, unit masses, one velocity) have a complexity below 40. A
  // general collision has thousands.
  constexpr long textbook = 40;
  EXPECT_LT(properties::complexity(push->shrunk.collision), textbook);
}

}  // namespace
}  // namespace carom::mutants
