// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/coulomb_answers.hpp>

#include "support/cases.hpp"

namespace carom::oracles {
namespace {

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
