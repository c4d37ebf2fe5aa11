// SPDX-License-Identifier: BSL-1.0
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/properties/gate/trial.hpp>

#include "support/cases.hpp"
#include "support/exact.hpp"
#include "support/known_collisions.hpp"

namespace carom::properties {
namespace {

ExactAnswer answer_of(Law law, const Collision& c) {
  return oracles::LiftedOutcome(unit::reported_outcome(oracles::ExactCase(c), law));
}

ExactAnswer answer_of_reflection(const Collision& c) { return answer_of(Law::reflection, c); }

/// The verdict of `swap`, if the subject answers the collision rightly, and the swapped collision with
/// `answer_to_swapped`.
template <class Answer>
Verdict verdict_of_swap(const Answer& answer_to_swapped) {
  const Collision c = unit::plain_collision();
  const Claim claim{Law::reflection, oracles::Yardstick::of(Precision::binary64), {invariant_named("swap")}};
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

/// Expects that the relations hold if all answers are right, and are violated if all velocities of the last answer have
/// this error.
void expect_right_answers_only(Law law, const Collision& collision, long double error) {
  for (const Invariant& invariant : all_invariants()) {
    if (!invariant.asks() || !invariant.claimed_for(law)) {
      continue;
    }
    const Claim claim{law, oracles::Yardstick::of(Precision::binary64), {&invariant}};
    const auto status_if = [&](bool is_right) {
      const JudgedCase one({collision});
      const std::size_t questions = Trial(one, claim, answer_of(law, collision)).question_count();
      std::size_t asked = 0;
      const auto solve = [&](const Collision& c) -> ExactAnswer {
        ReportedOutcome outcome = unit::reported_outcome(oracles::ExactCase(c), law);
        if (asked++ == questions && !is_right) {
          outcome = map_outcome<long double>(outcome, [&](long double x) { return x + error; });
        }
        return oracles::LiftedOutcome(outcome);
      };
      return try_case(one, claim, solve).verdicts.at(0).verdict.status;
    };
    EXPECT_EQ(status_if(true), Status::holds) << invariant.name << " of " << name_of(law);
    EXPECT_EQ(status_if(false), Status::violated) << invariant.name << " of " << name_of(law);
  }
}

TEST(Relations, HoldForRightAnswersOnly) { expect_right_answers_only(Law::reflection, unit::plain_collision(), 1); }

/// The ball slips, sticks, or is between both.
TEST(Relations, OfCoulombHoldForRightAnswersOnly) {
  for (const double friction : {0.125, 0.25, 1.0 / 6, 1.0 / 6 + 0x1p-52}) {
    expect_right_answers_only(Law::coulomb, unit::ball_on_a_plane(0.5, friction), 1e-12L);
  }
}

/// A right solver may give another of the answers to the related collision.
TEST(Relations, OfCoulombAreNotJudgedIfThereAreSeveralAnswers) {
  const Collision c = unit::case_with_three_answers();
  const Claim claim{Law::coulomb, oracles::Yardstick::of(Precision::binary64), {invariant_named("swap")}};
  const auto solve = [&](const Collision& asked) -> ExactAnswer {
    const auto answers = oracles::coulomb_answers(oracles::ExactCase(asked));
    return oracles::LiftedOutcome(map_outcome<long double>(answers.at(asked.normal == c.normal ? 0 : 1).truth.outcome,
                                                           unit::rounded_to_binary64));
  };
  EXPECT_EQ(try_case(JudgedCase({c}), claim, solve).verdicts.at(0).verdict.status, Status::skipped);
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
  // In binary32, the rounding of answers to binary64 is negligible.
  const Claim claim{Law::reflection, oracles::Yardstick::of(Precision::binary32, {.filtered = filtered}), {&invariant}};
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

// Relations (properties/invariants/relations.cpp) round the numbers of a collision to fewer bits, so that the related
// collision is exact.

using oracles::Rational;

std::vector<Collision> asked_by(std::string_view relation, const Collision& collision) {
  const auto& about = std::get<AboutRelation>(invariant_named(relation)->about);
  return std::get<AboutRelation::OfCollision>(about.ask)(collision, {});
}

Vector3<Rational> exactly(const Vector3<double>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

Vector3<Rational> exact_difference(const Vector3<double>& x, const Vector3<double>& y) {
  return exactly(x) - exactly(y);
}

/// Numbers below 2^e are rounded to multiples of 2^(e − 48), and the added offset is at most 2^e. So sums have at most
/// 49 bits.
TEST(RelationBounds, AddTheSameToEachVelocityAndPlace) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    const std::vector<Collision> moving = asked_by("galilean", one.collision);
    const Vector3<Rational> added = exact_difference(moving[1].a.velocity, moving[0].a.velocity);
    EXPECT_EQ(exact_difference(moving[1].b.velocity, moving[0].b.velocity), added) << family;
    EXPECT_NE(added[0], 0) << family;
    const std::vector<Collision> moved = asked_by("translation", one.collision);
    const Vector3<Rational> step = exact_difference(moved[1].point, moved[0].point);
    EXPECT_EQ(exact_difference(moved[1].a.position, moved[0].a.position), step) << family;
    EXPECT_EQ(exact_difference(moved[1].b.position, moved[0].b.position), step) << family;
    EXPECT_NE(step[0], 0) << family;
  }
}

/// Three times a velocity of 50 bits has at most 52 bits.
TEST(RelationBounds, MultiplyVelocitiesByThree) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    const std::vector<Collision> asked = asked_by("homogeneous", one.collision);
    const Outcome<double> slow = unchanged(asked[0]);
    const Outcome<double> fast = unchanged(asked[1]);
    for (const OutcomeVector k : all_outcome_vectors) {
      EXPECT_EQ(exactly(*vectors(fast)[k]), Vector3<Rational>(exactly(*vectors(slow)[k]) * Rational(3))) << family;
    }
  }
}

/// The approach and the added velocity have 20 bits each, thirty places apart. So their sum has 50 bits.
TEST(RelationBounds, AddATangentialVelocity) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    if (one.collision.a.immovable && one.collision.b.immovable) {
      continue;
    }
    const std::vector<Collision> asked = asked_by("continuous", one.collision);
    const bool of_b = one.collision.a.immovable;
    const Vector3<Rational> added =
        exact_difference((of_b ? asked[1].b : asked[1].a).velocity, (of_b ? asked[0].b : asked[0].a).velocity);
    EXPECT_EQ(added.dot(exactly(asked[0].normal)), 0) << family;
    EXPECT_NE(added.dot(added), 0) << family;
  }
}

}  // namespace
}  // namespace carom::properties
