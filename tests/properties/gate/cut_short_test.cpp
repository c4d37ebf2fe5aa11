// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/gate/gate.hpp>

#include "io/threads.hpp"
#include "support/changed_subject.hpp"

/// Runs that end before all cases are judged. Families beyond the claimed domain, in which the gate finds the least
/// value of a quantity at which a subject fails; by default, this boundary affects no verdict.
namespace carom::properties {
namespace {

GateOptions options_of_all_families(std::uint64_t of_each, unsigned jobs = 1) {
  GateOptions options = unit::gate_options(of_each);
  options.workers = tool::threads(jobs);
  return options;
}

Subject right() { return unit::subject_of("frictionless-double"); }

/// Adds 1 to A's velocity along x if `is_wrong(collision, call)`. `call` is the number of earlier outcomes of the
/// session.
template <class IsWrong>
Subject wrong_where(IsWrong is_wrong) {
  return unit::with_outcomes(
      right(), [is_wrong, calls = std::uint64_t{0}](const Collision& collision, ReportedOutcome& outcome) mutable {
        outcome.a.velocity[0] += is_wrong(collision, calls++) ? 1 : 0;
      });
}

Subject always_wrong() {
  return wrong_where([](const Collision&, std::uint64_t) { return true; });
}

/// A subject that is wrong only in late cases, and in no case of the first family.
Subject wrong_at_times() {
  return wrong_where([](const Collision& c, std::uint64_t) {
    return !c.a.immovable && !c.b.immovable && c.a.mass > 0.5 * c.b.mass && c.restitution > 0.875;
  });
}

std::uint64_t violations_in(const SubjectResult& result) {
  std::uint64_t sum = 0;
  for (const Invariant& invariant : all_invariants()) {
    sum += result.count(invariant).violated;
  }
  return sum;
}

TEST(FailFast, EndsAtTheFirstViolation) {
  GateOptions options = options_of_all_families(1000);
  options.fail_fast = true;
  const GateReport report = run_gate({always_wrong()}, options);
  const SubjectResult& result = report.results.at(0);
  EXPECT_EQ(violations_in(result), 1U);
  EXPECT_EQ(result.witnesses.size(), 1U);
  EXPECT_EQ(result.not_judged, "") << "what was found is found";
  EXPECT_LT(result.cases(), 10U);
  std::uint64_t drawn = 0;
  for (const Coverage& coverage : report.coverage) {
    drawn += coverage.cases;
  }
  EXPECT_LT(drawn, 100U) << "the run went on without a subject to ask";
}

TEST(FailFast, FindsTheSameViolationOnAnyNumberOfThreads) {
  const auto witness_on = [](unsigned jobs) {
    GateOptions options = options_of_all_families(300, jobs);
    options.fail_fast = true;
    const SubjectResult result = run_gate({wrong_at_times()}, options).results.at(0);
    EXPECT_EQ(result.witnesses.size(), 1U);
    return result.witnesses.at(0);
  };
  const Witness alone = witness_on(1);
  for (const unsigned jobs : {2U, 5U}) {
    const Witness other = witness_on(jobs);
    EXPECT_EQ(other.invariant, alone.invariant);
    EXPECT_EQ(other.family, alone.family);
    EXPECT_EQ(other.index, alone.index);
    EXPECT_EQ(other.shrunk.collision.point, alone.shrunk.collision.point);
  }
}

TEST(FailFast, GoesOnWithTheOtherSubjects) {
  GateOptions options = options_of_all_families(20);
  options.fail_fast = true;
  const GateReport report = run_gate({always_wrong(), right()}, options);
  EXPECT_FALSE(report.results[0].is_sound());
  EXPECT_TRUE(report.results[1].is_sound()) << report.results[1].not_judged;
  EXPECT_EQ(report.results[1].cases(), run_gate({right()}, options_of_all_families(20)).results[0].cases());
}

/// The subject claims only `memoryless`, which needs a repeated collision. Its violation also ends the run.
TEST(FailFast, EndsAtAViolationOfMemoryless) {
  const Subject subject =
      unit::claiming_only("memoryless", wrong_where([](const Collision&, std::uint64_t call) { return call > 0; }));
  GateOptions options = options_of_all_families(1000);
  options.fail_fast = true;
  const SubjectResult result = run_gate({subject}, options).results.at(0);
  EXPECT_EQ(result.count(*invariant_named("memoryless")).violated, 1U);
  EXPECT_LT(result.cases(), 100U);
}

TEST(Budget, DrawsMoreCasesThanTheDefaultAndSaysNothingElse) {
  GateOptions options = options_of_all_families(1);
  options.families = {family_named("separating"), family_named("generic")};
  options.is_part = true;
  options.budget = std::chrono::milliseconds(200);
  const SubjectResult result = run_gate({right()}, options).results.at(0);
  EXPECT_GT(result.families[0].cases, 2U);
  EXPECT_GT(result.families[1].cases, 2U);
  EXPECT_TRUE(result.is_sound()) << result.not_judged;
}

/// Even with a budget, the seed, the family and the number determine the case.
TEST(Budget, FindsWitnessesThatTheSeedDrawsAgain) {
  GateOptions options = options_of_all_families(1);
  options.budget = std::chrono::milliseconds(100);
  const SubjectResult result = run_gate({always_wrong()}, options).results.at(0);
  ASSERT_FALSE(result.witnesses.empty());
  const Witness& witness = result.witnesses.front();
  Stream stream = case_stream(options.seed, witness.family->name, witness.index);
  const Collision again = witness.family->generate(stream).collision;
  EXPECT_EQ(again.a.velocity, witness.original.collision.a.velocity);
  EXPECT_EQ(again.normal, witness.original.collision.normal);
}

TEST(Budget, OfNoTimeLeavesTheSubjectNotJudged) {
  GateOptions options = options_of_all_families(1);
  options.budget = std::chrono::nanoseconds(0);
  const SubjectResult result = run_gate({right()}, options).results.at(0);
  EXPECT_FALSE(result.is_sound());
  EXPECT_EQ(result.not_judged, "no case of the family structured was judged");
}

TEST(Budget, ReportsItsProgressInMilliseconds) {
  GateOptions options = options_of_all_families(1);
  options.budget = std::chrono::milliseconds(50);
  std::uint64_t last = 0;
  options.progress = [&](std::uint64_t done, std::uint64_t all) {
    EXPECT_EQ(all, 50U);
    EXPECT_LE(last, done);
    EXPECT_LE(done, all);
    last = done;
  };
  (void)run_gate({right()}, options);
  EXPECT_GT(last, 0U);
}

constexpr double stops_at = 1e6;

/// Adds 1 to A's velocity along x if `condition_number_at_most` is at least 10⁶.
Subject stopping() {
  return unit::with_outcomes(unit::subject_of("frictionless-double"), [](const Collision& c, ReportedOutcome& outcome) {
    outcome.a.velocity[0] += condition_number_at_most(c) >= stops_at ? 1 : 0;
  });
}

GateOptions options_beyond_domain(const char* family) {
  GateOptions options;
  options.cases = 200;
  options.is_part = true;
  options.families = {family_named(family)};
  options.beyond_domain = {family_named("impossible_moments"), family_named("far_contacts")};
  return options;
}

TEST(Boundary, IsTheLeastOfTheQuantityAtWhichSomethingIsViolated) {
  const GateOptions options = options_beyond_domain("generic");
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
  GateOptions options = options_beyond_domain("far_contacts");
  options.beyond_domain = {};
  options.shrinks = false;
  const SubjectResult result = run_gate({stopping()}, options).results.at(0);
  EXPECT_FALSE(result.is_sound());
  EXPECT_FALSE(result.violated_invariants().empty());
  EXPECT_TRUE(result.families.at(0).boundary);
  EXPECT_TRUE(result.beyond_domain.empty());
}

TEST(Boundary, IsNotLookedForWithABudgetOrToTheFirstViolation) {
  GateOptions to_the_first = options_beyond_domain("generic");
  to_the_first.fail_fast = true;
  EXPECT_TRUE(run_gate({unit::subject_of("frictionless-double")}, to_the_first).results.at(0).beyond_domain.empty());
  GateOptions with_budget = options_beyond_domain("generic");
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
