// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/solved_outcome.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/laws/judge_error.hpp>

/// The build plants wrong formulas. In truths/linear_laws.hpp, ε is halved. In truths/rough.hpp, the share of friction
/// is halved, inside the cone and on its surface. Only this program is compiled with them.
namespace carom::oracles {
namespace {

/// B is at rest, and A of the same mass meets it with (0, −1, 0) m/s and ε = ½.
Collision central_contact() {
  Collision c;
  c.restitution = 0.5;
  c.a.velocity = {0, -1, 0};
  return c;
}

Outcome<double> with_velocities(const Vector3<double>& of_a, const Vector3<double>& of_b) {
  Outcome<double> outcome = unchanged(central_contact());
  outcome.a.velocity = of_a;
  outcome.b.velocity = of_b;
  return outcome;
}

Accuracy accuracy_of(const Collision& collision, Law law, const Outcome<double>& outcome, bool filtered) {
  const Yardstick yardstick = Yardstick::of(Precision::binary64, {.filtered = filtered});
  return accuracy(ExactCase(collision, filtered), law, LiftedOutcome(reported(outcome)), yardstick);
}

void expect_found(const char* what, const Collision& collision, Law law, const Outcome<double>& right) {
  for (const bool filtered : {true, false}) {
    try {
      accuracy_of(collision, law, right, filtered);
      FAIL() << "filtered: " << filtered;
    } catch (const JudgeError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
      EXPECT_EQ(error.collision().a.velocity, collision.a.velocity);
    }
  }
}

/// Momentum is conserved, and the bodies part at ½ m/s: −¼ and −¾ m/s.
TEST(PlantedModel, IsFoundBeforeItRejectsARightAnswer) {
  expect_found("restitution", central_contact(), Law::frictionless, with_velocities({0, -0.25, 0}, {0, -0.75, 0}));
}

/// A also slides with 1 m/s. K = 2, so P_I = (0, ½, 0) and P_II = (−½, ½, 0). F is (−½, ¾, 0) inside the cone, and
/// (−3/16, ¾, 0) on its surface for μ = ¼.
TEST(PlantedModel, OfRoughIsFoundBeforeItRejectsARightAnswer) {
  Collision sliding = central_contact();
  sliding.a.velocity[0] = 1;
  sliding.friction = 1;
  expect_found("its share of friction", sliding, Law::rough, with_velocities({0.5, -0.25, 0}, {0.5, -0.75, 0}));
  sliding.friction = 0.25;
  expect_found("its share of friction", sliding, Law::rough, with_velocities({0.8125, -0.25, 0}, {0.1875, -0.75, 0}));
}

/// The answer of the wrong formula passes if bounds decide, and ℚ finds the fault. So the formula is planted.
TEST(PlantedModel, AcceptsItsOwnAnswerByBounds) {
  const Outcome<double> planted = with_velocities({0, -0.375, 0}, {0, -0.625, 0});
  EXPECT_TRUE(accuracy_of(central_contact(), Law::frictionless, planted, true).is_allowed());
  EXPECT_THROW(accuracy_of(central_contact(), Law::frictionless, planted, false), JudgeError);
}

}  // namespace
}  // namespace carom::oracles
