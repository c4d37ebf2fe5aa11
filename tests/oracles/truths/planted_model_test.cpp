// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/solved_outcome.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/laws/judge_error.hpp>

/// The build plants a wrong formula in truths/linear_laws.hpp: ε is halved. Only this program is compiled with it.
namespace carom::oracles {
namespace {

/// B is at rest, and A of the same mass meets it with (0, −1, 0) m/s and ε = ½.
Collision central_contact() {
  Collision c;
  c.restitution = 0.5;
  c.a.velocity = {0, -1, 0};
  return c;
}

Outcome<double> with_normal_velocities(double of_a, double of_b) {
  Outcome<double> outcome = unchanged(central_contact());
  outcome.a.velocity = {0, of_a, 0};
  outcome.b.velocity = {0, of_b, 0};
  return outcome;
}

Accuracy accuracy_of(const Outcome<double>& outcome, bool filtered) {
  const Yardstick yardstick = Yardstick::of(Precision::binary64, {.filtered = filtered});
  const ExactCase exact_case(central_contact(), filtered);
  return accuracy(exact_case, Law::frictionless, LiftedOutcome(reported(outcome)), yardstick);
}

/// Momentum is conserved, and the bodies part at ½ m/s: −¼ and −¾ m/s.
TEST(PlantedModel, IsFoundBeforeItRejectsARightAnswer) {
  for (const bool filtered : {true, false}) {
    try {
      accuracy_of(with_normal_velocities(-0.25, -0.75), filtered);
      FAIL() << "filtered: " << filtered;
    } catch (const JudgeError& error) {
      EXPECT_NE(std::string(error.what()).find("restitution"), std::string::npos) << error.what();
      EXPECT_EQ(error.collision().a.velocity, central_contact().a.velocity);
    }
  }
}

/// The answer of the wrong formula passes if bounds decide, and ℚ finds the fault. So the formula is planted.
TEST(PlantedModel, AcceptsItsOwnAnswerByBounds) {
  const Outcome<double> planted = with_normal_velocities(-0.375, -0.625);
  EXPECT_TRUE(accuracy_of(planted, true).is_allowed());
  EXPECT_THROW(accuracy_of(planted, false), JudgeError);
}

}  // namespace
}  // namespace carom::oracles
