// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/properties/trial/trial.hpp>

#include "support/known_collisions.hpp"
#include "support/outcome_of_law.hpp"

namespace carom::properties {
namespace {

ExactAnswer answer_of_reflection(const Collision& c) {
  return oracles::LiftedOutcome(unit::reported_outcome(oracles::ExactCase(c), Law::reflection));
}

/// The verdict of `swap`, if the subject answers the collision rightly, and the swapped collision with
/// `answer_to_swapped`.
template <class Answer>
Verdict verdict_of_swap(const Answer& answer_to_swapped) {
  const Collision c = unit::plain_collision();
  Claim claim;
  claim.law = Law::reflection;
  claim.yardstick = oracles::Yardstick::of(Precision::binary64);
  claim.invariants = {invariant_named("swap")};
  const auto solve = [&](const Collision& asked) -> ExactAnswer {
    return asked.normal == c.normal ? answer_of_reflection(asked) : ExactAnswer(answer_to_swapped(asked));
  };
  return try_case(JudgedCase({c}), claim, solve).verdicts.at(0).verdict;
}

TEST(Relations, HoldForRightAnswers) { EXPECT_EQ(verdict_of_swap(answer_of_reflection).status, Status::holds); }

TEST(Relations, AreSkippedIfTheSubjectSkipsOrDoesNotAnswer) {
  const Verdict skipped = verdict_of_swap([](const Collision&) { return Skipped{"too heavy"}; });
  EXPECT_EQ(skipped.status, Status::skipped);
  EXPECT_EQ(skipped.detail, "the subject skipped the related collision: too heavy");
  const Verdict failed = verdict_of_swap([](const Collision&) { return Failed{"it ended"}; });
  EXPECT_EQ(failed.status, Status::skipped);
  EXPECT_EQ(failed.detail, "the subject did not answer the related collision; `finite` judges this");
}

TEST(Relations, AreViolatedIfTheSubjectRefusesOrAnswersInfinity) {
  const Verdict refused = verdict_of_swap([](const Collision&) { return Refused{"too heavy"}; });
  EXPECT_EQ(refused.status, Status::violated);
  EXPECT_EQ(refused.detail, "the subject refused the related collision: too heavy");
  const Verdict infinite = verdict_of_swap([](const Collision&) { return NotFinite{}; });
  EXPECT_EQ(infinite.status, Status::violated);
  EXPECT_EQ(infinite.detail, "the outcome of the related collision contains infinities or NaN");
}

}  // namespace
}  // namespace carom::properties
