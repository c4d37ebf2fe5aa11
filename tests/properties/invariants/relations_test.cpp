// SPDX-License-Identifier: BSL-1.0
#include <utility>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/properties/gate/trial.hpp>

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

/// If the subject answers the related collision with the bits of the right answer, no number is compared.
TEST(Relations, HoldForTheSameBits) {
  const std::uint64_t before = oracles::decided_by_stage()[oracles::Stage::same_bits];
  EXPECT_EQ(verdict_of_swap(answer_of_reflection).status, Status::holds);
  EXPECT_EQ(oracles::decided_by_stage()[oracles::Stage::same_bits], before + 1);
}

/// The last answer is right, or all of its velocities are wrong.
TEST(Relations, HoldForRightAnswersOnly) {
  for (const Invariant& invariant : all_invariants()) {
    if (!invariant.asks()) {
      continue;
    }
    Claim claim;
    claim.law = Law::reflection;
    claim.yardstick = oracles::Yardstick::of(Precision::binary64);
    claim.invariants = {&invariant};
    const auto status_if = [&](bool is_right) {
      const JudgedCase one({unit::plain_collision()});
      const std::size_t questions = Trial(one, claim, answer_of_reflection(one.generated().collision)).question_count();
      std::size_t asked = 0;
      const auto solve = [&](const Collision& c) -> ExactAnswer {
        ReportedOutcome outcome = unit::reported_outcome(oracles::ExactCase(c), Law::reflection);
        if (asked++ == questions && !is_right) {
          outcome = map_outcome<long double>(outcome, [](long double x) { return x + 1; });
        }
        return oracles::LiftedOutcome(outcome);
      };
      return try_case(one, claim, solve).verdicts.at(0).verdict.status;
    };
    EXPECT_EQ(status_if(true), Status::holds) << invariant.name;
    EXPECT_EQ(status_if(false), Status::violated) << invariant.name;
  }
}

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

/// The status of the relation if the last answer is off by `share` of what the errors of both answers permit. An error
/// of the first answer grows by `factor`.
Status status_of(const char* relation, double factor, double share, bool filtered) {
  const Invariant& invariant = *invariant_named(relation);
  const JudgedCase judged_case({unit::plain_collision()}, filtered);
  const auto questions = judged_case.questions_of(invariant);
  Claim claim;
  claim.law = Law::reflection;
  // In binary32, the rounding of answers to binary64 is negligible.
  claim.yardstick = oracles::Yardstick::of(Precision::binary32, {.filtered = filtered});
  claim.invariants = {&invariant};
  const double allowance = claim.yardstick.allowance();
  const auto sensitivity = [&](const oracles::ExactCase& question) {
    return question.sensitivity(Law::reflection, allowance)[OutcomeVector::velocity_of_b];
  };
  std::size_t asked = 0;
  const auto solve = [&](const Collision& c) -> ExactAnswer {
    ReportedOutcome outcome = unit::reported_outcome(oracles::ExactCase(c), Law::reflection);
    if (asked++ == questions.size()) {
      outcome.b.velocity[1] +=
          share * allowance * (factor * sensitivity(questions.front()) + sensitivity(questions.back()));
    }
    return oracles::LiftedOutcome(outcome);
  };
  return try_case(judged_case, claim, solve).verdicts.at(0).verdict.status;
}

TEST(Relations, PermitTheErrorsOfBothAnswers) {
  for (const auto& [relation, factor] : {std::pair{"swap", 1.0}, {"translation", 1.0}, {"homogeneous", 3.0}}) {
    for (const bool filtered : {true, false}) {
      EXPECT_EQ(status_of(relation, factor, 0.99, filtered), Status::holds) << relation << filtered;
      EXPECT_EQ(status_of(relation, factor, 1.01, filtered), Status::violated) << relation << filtered;
    }
  }
}

}  // namespace
}  // namespace carom::properties
