// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/changed_subject.hpp"

namespace carom::properties {
namespace {

constexpr int one_in = 100;

/// frictionless-double, as a program that claims only the invariant `claimed`. In one of a hundred answers, drawn at
/// random, the impulse is a quarter too large.
Subject faulty(const std::string& claimed) {
  Subject subject = unit::with_outcomes(
      unit::subject_of("frictionless-double"),
      [stream = stream_from(1)](const Collision& collision, ReportedOutcome& outcome) mutable {
        if (stream.chance(one_in)) {
          const auto before = unchanged(collision);
          for (const OutcomeVector k : all_outcome_vectors) {
            *vectors(outcome)[k] += (*vectors(outcome)[k] - vectors(before)[k]->cast<long double>()) / 4;
          }
        }
      });
  subject.specification = "exec:faulty";  // the gate judges relations on fewer cases of a program
  for (const Invariant& invariant : all_invariants()) {
    if (invariant.name != claimed) {
      subject.deviates.emplace_back(invariant.name);
    }
  }
  return subject;
}

TEST(RareFault, IsFoundByDefaultByOneRelationInOneFamily) {
  GateOptions options;
  options.families = {family_named("generic")};
  std::size_t relations = 0;
  for (const Invariant& invariant : all_invariants()) {
    // A second impulse is zero, even if the first is too large. So `repeat` cannot find this fault.
    if (std::holds_alternative<AboutRelation>(invariant.about) && invariant.claimed_for(Law::frictionless) &&
        invariant.name != "repeat") {
      ++relations;
      const SubjectResult result = run_gate({faulty(std::string(invariant.name))}, options).results.at(0);
      EXPECT_EQ(result.error, "");
      EXPECT_GT(result.count(invariant).violated, 0U) << invariant.name;
    }
  }
  EXPECT_GE(relations, 8U);
}

}  // namespace
}  // namespace carom::properties
