// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/solved_outcome.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ratio;
using unit::same;

/// K = diag(3, 1, 3), V⁻ = (−3, −4, 0).
Collision ball_on_a_plane(double friction) { return unit::ball_on_a_plane(0.5, friction); }

TEST(CoulombAnswers, StickIfFrictionSuffices) {
  const auto answers = coulomb_answers(lift(ball_on_a_plane(0.25)));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].kind, AnswerKind::sticks);
  EXPECT_TRUE(answers[0].is_exact());
  EXPECT_TRUE(same(answers[0].truth.impulse, unit::ExactVector(1, 6, 0)));
}

/// F = (3/4, 6, 0) and V⁺ = V⁻ + K F = (−3/4, 2, 0), so F_T opposes V_T⁺.
TEST(CoulombAnswers, SlideIfFrictionDoesNotSuffice) {
  const auto answers = coulomb_answers(lift(ball_on_a_plane(0.125)));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].kind, AnswerKind::slips);
  EXPECT_FALSE(answers[0].is_exact());
  EXPECT_TRUE(same(answers[0].truth.impulse, unit::ExactVector(ratio(3, 4), 6, 0)));
}

TEST(CoulombAnswers, AreFrictionlessWithoutFriction) {
  const auto answers = coulomb_answers(lift(ball_on_a_plane(0)));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_TRUE(same(answers[0].truth.impulse, unit::ExactVector(0, 6, 0)));
}

/// Expects that the answer satisfies the law. An answer that slips comes from a root of a polynomial, so its ‖N × F‖ is
/// rounded.
void expect_lawful(const Collision& collision, const CoulombAnswer& answer) {
  const BasicCollision<Rational> c = lift(collision);
  const Vector3<Rational>& f = answer.truth.impulse;
  const Vector3<Rational> after = relative_velocity<Rational>(c, answer.truth.outcome);
  EXPECT_EQ(c.normal.dot(after), -c.restitution * normal_velocity_before(c));
  const Vector3<Rational> friction = c.normal.cross(f);
  const Vector3<Rational> slip = c.normal.cross(after);
  const Rational limit = c.friction * c.normal.dot(f);
  EXPECT_GE(limit, 0);
  if (answer.kind == AnswerKind::sticks) {
    EXPECT_TRUE(slip.isZero(0));
    EXPECT_LE(friction.dot(friction), limit * limit);
    return;
  }
  EXPECT_TRUE(friction.cross(slip).isZero(0));
  EXPECT_LE(friction.dot(slip), 0);
  EXPECT_LE(abs(Rational(friction.dot(friction) - limit * limit)), (limit * limit).times_power_of_two(-100));
}

constexpr double allowance_of_binary64 = 32 * 0x1p-53;

/// Every collision has an answer, by a theorem (docs/guide/laws.md#coulomb).
TEST(CoulombAnswers, ExistAndSatisfyTheLaw) {
  int slides = 0;
  int several = 0;
  int certain = 0;
  for (const auto& [family, one] : unit::valid_cases(6)) {
    const ExactCase exact_case(one.collision);
    if (exact_case.state() != ContactState::colliding) {
      continue;
    }
    const std::vector<CoulombAnswer> answers = coulomb_answers(lift(one.collision));
    EXPECT_GE(answers.size(), 1U) << family;
    if (has_one_coulomb_answer(exact_case, allowance_of_binary64)) {
      EXPECT_EQ(answers.size(), 1U) << family;
      ++certain;
    }
    EXPECT_TRUE(!one.convex_uniform || answers.size() == 1) << family;
    several += answers.size() > 1 ? 1 : 0;
    for (const CoulombAnswer& answer : answers) {
      expect_lawful(one.collision, answer);
      slides += answer.kind == AnswerKind::slips ? 1 : 0;
    }
  }
  EXPECT_GT(slides, 30);
  EXPECT_GT(certain, 60);
  RecordProperty("several", several);
  RecordProperty("certain", certain);
}

/// If r × N = 0 for both bodies, friction does not change F_N.
TEST(CoulombAnswers, AreCertainlyOneForCentralContactsAndNotIfThereAreThree) {
  Collision central = ball_on_a_plane(100);
  central.a.principal_inertia = {0.5, 0.25, 0.375};
  for (const Collision& c : {ball_on_a_plane(100), central}) {
    EXPECT_TRUE(has_one_coulomb_answer(ExactCase(c), allowance_of_binary64));
  }
  EXPECT_FALSE(has_one_coulomb_answer(ExactCase(unit::case_with_three_answers()), allowance_of_binary64));
}

TEST(CoulombAnswersDeathTest, NeedAContactThatApproaches) {
  if constexpr (CAROM_CHECK_PRECONDITIONS == 1) {
    for (const double separating : {0.0, 0.25}) {
      Collision c = ball_on_a_plane(0.25);
      c.a.velocity = {0, separating, 0};
      EXPECT_DEATH((void)coulomb_answers(lift(c)), "normal_velocity_before");
    }
  }
}

TEST(CoulombAnswers, MayBeThree) {
  const Collision c = unit::case_with_three_answers();
  const std::vector<CoulombAnswer> answers = coulomb_answers(lift(c));
  ASSERT_EQ(answers.size(), 3U);
  for (const CoulombAnswer& answer : answers) {
    expect_lawful(c, answer);
  }
  EXPECT_EQ(answers[0].kind, AnswerKind::sticks);
  EXPECT_EQ(answers[1].kind, AnswerKind::slips);
  EXPECT_EQ(answers[2].kind, AnswerKind::slips);
  EXPECT_FALSE(same(answers[1].truth.impulse, answers[2].truth.impulse));
}

ReportedOutcome reported(const Outcome<Rational>& outcome) {
  return map_outcome<long double>(outcome,
                                  [](const Rational& x) { return static_cast<long double>(nearest_double(x)); });
}

TEST(CoulombCase, IsUnchangedIfTheContactDoesNotCollide) {
  Collision parting = unit::ball_on_a_plane(0.5, 1);
  parting.a.velocity = {1, 2, 0};
  Collision inert = parting;
  inert.a.immovable = true;
  for (const Collision& c : {parting, inert}) {
    const ExactCase exact_case(c);
    const auto answers = coulomb_answers(exact_case);
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers[0].kind, AnswerKind::untouched);
    ReportedOutcome outcome = reported(answers[0].truth.outcome);
    EXPECT_EQ(nearest_answer(exact_case, answers, outcome).digits, 40);  // exact
    outcome.a.velocity.x() += 1;
    const NearestAnswer nearest = nearest_answer(exact_case, answers, outcome);
    EXPECT_EQ(nearest.digits, c.a.immovable ? 40 : -HUGE_VAL) << "no change was asked for";
    EXPECT_EQ(nearest.number, 0U);
  }
}

TEST(CoulombCase, MeasuresTheNearestAnswer) {
  const ExactCase exact_case(unit::case_with_three_answers());
  const auto answers = coulomb_answers(exact_case);
  ASSERT_EQ(answers.size(), 3U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const NearestAnswer nearest = nearest_answer(exact_case, answers, reported(answers[i].truth.outcome));
    EXPECT_EQ(nearest.number, i);
    EXPECT_GT(nearest.digits, 3);  // the bodies move fast together
  }
}

TEST(CoulombCase, TakesTheFirstOfEquallyNearAnswers) {
  const ExactCase exact_case(unit::ball_on_a_plane(0.5, 0.25));
  const auto answers = coulomb_answers(exact_case);
  const auto twice = std::vector{answers[0], answers[0]};
  EXPECT_EQ(nearest_answer(exact_case, twice, reported(answers[0].truth.outcome)).number, 0U);
}

TEST(CoulombCase, CountsDigitsByEnergy) {
  const ExactCase exact_case(unit::ball_on_a_plane(0.5, 0.25));
  const auto answers = coulomb_answers(exact_case);
  ReportedOutcome outcome = reported(answers[0].truth.outcome);
  outcome.a.velocity.x() += 1;
  // F = (1, 6, 0) changes the velocities by m Δv² + J Δw² = 37 + 2. By the same formula, the error of the outcome is 1.
  EXPECT_NEAR(nearest_answer(exact_case, answers, outcome).digits, -std::log10(std::sqrt(1.0 / 39)), 1e-12);
}

}  // namespace
}  // namespace carom::oracles
