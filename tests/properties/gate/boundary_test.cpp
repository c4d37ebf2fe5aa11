// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/changed_subject.hpp"

/// In families beyond the claimed domain, the gate finds the least value of a quantity at which a subject fails. By
/// default, this boundary affects no verdict.
namespace carom::properties {
namespace {

constexpr double stops_at = 1e6;

/// Adds 1 to A's velocity along x if `condition_number_at_most` is at least 10⁶.
Subject stopping() {
  return unit::with_outcomes(unit::subject_of("frictionless-double"), [](const Collision& c, ReportedOutcome& outcome) {
    outcome.a.velocity[0] += condition_number_at_most(c) >= stops_at ? 1 : 0;
  });
}

GateOptions options_of(const char* family) {
  GateOptions options;
  options.cases = 200;
  options.is_part = true;
  options.families = {family_named(family)};
  options.beyond_domain = {family_named("impossible_moments"), family_named("far_contacts")};
  return options;
}

TEST(Boundary, IsTheLeastOfTheQuantityAtWhichSomethingIsViolated) {
  const GateOptions options = options_of("generic");
  const SubjectResult result = run_gate({unit::subject_of("frictionless-double"), stopping()}, options).results.at(1);
  // The condition numbers of `generic` are far below 10⁶.
  EXPECT_TRUE(result.is_sound()) << result.not_judged;
  EXPECT_EQ(result.cases(), 200U);
  ASSERT_EQ(result.beyond_domain.size(), 2U);
  const FamilyResult& far = result.beyond_domain[1];
  EXPECT_EQ(far.cases, 200U);
  double expected = HUGE_VAL;
  std::uint64_t violated = 0;
  for (std::uint64_t i = 0; i < far.cases; ++i) {
    const double condition = condition_number_at_most(drawn_case(*family_named("far_contacts"), 1, i).collision);
    if (condition >= stops_at) {
      expected = std::min(expected, condition);
      ++violated;
    }
  }
  ASSERT_TRUE(far.boundary);
  EXPECT_EQ(far.boundary->quantity, expected);
  EXPECT_EQ(far.violated, violated);
  EXPECT_EQ(condition_number_at_most(drawn_case(*family_named("far_contacts"), 1, far.boundary->index).collision),
            expected);
  EXPECT_NE(far.boundary->invariant, nullptr);
}

TEST(Boundary, IsAViolationIfItsFamilyIsNamed) {
  GateOptions options = options_of("far_contacts");
  options.beyond_domain = {};
  options.shrinks = false;
  const SubjectResult result = run_gate({stopping()}, options).results.at(0);
  EXPECT_FALSE(result.is_sound());
  EXPECT_FALSE(result.violated_invariants().empty());
  EXPECT_TRUE(result.families.at(0).boundary);
  EXPECT_TRUE(result.beyond_domain.empty());
}

TEST(Boundary, IsNotLookedForWithABudgetOrToTheFirstViolation) {
  GateOptions to_the_first = options_of("generic");
  to_the_first.fail_fast = true;
  EXPECT_TRUE(run_gate({unit::subject_of("frictionless-double")}, to_the_first).results.at(0).beyond_domain.empty());
  GateOptions with_budget = options_of("generic");
  with_budget.budget = std::chrono::milliseconds(20);
  EXPECT_TRUE(run_gate({unit::subject_of("frictionless-double")}, with_budget).results.at(0).beyond_domain.empty());
}

TEST(Boundary, IsTheLeastOfTwo) {
  std::optional<Boundary> kept;
  keep_if_least(kept, std::nullopt);
  EXPECT_FALSE(kept);
  keep_if_least(kept, Boundary{3, 7});
  keep_if_least(kept, Boundary{4, 1});
  EXPECT_EQ(kept->index, 7U);
  keep_if_least(kept, Boundary{3, 5});
  EXPECT_EQ(kept->index, 5U);
  keep_if_least(kept, Boundary{2, 9});
  EXPECT_EQ(kept->index, 9U);
}

}  // namespace
}  // namespace carom::properties
