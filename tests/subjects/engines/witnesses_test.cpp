// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/oracles/truths/coulomb.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/subjects/catalogue.hpp>

/// The collisions of docs/reference/engines that a reader can compute by hand. N is along y.
namespace carom {
namespace {

using oracles::Rational;

constexpr double some_roundings = 16 * 0x1p-53;  // 16 u for the unit roundoff u

Collision witness(const std::string& name) {
  std::ifstream file(CAROM_WITNESSES "/" + name + ".json");
  return collision_from_json(nlohmann::json::parse(file));
}

/// The velocity of A after the impulse by the engine, if the engine is installed.
std::optional<Vector3<double>> velocity_by(const std::string& subject_name, const Collision& collision) {
  const Subject subject = *subjects::subject_named(subject_name);
  if (!subject.absent.empty()) {
    return std::nullopt;
  }
  const std::vector<Answer> answers = subject.open()({&collision, 1});
  return std::get<ReportedOutcome>(answers[0]).a.velocity.cast<double>();
}

/// Checks the impulse on A, which has mass 1, if the engine is installed.
void expect_impulse(const std::string& subject_name, const Collision& collision, const Vector3<double>& impulse,
                    double rounding) {
  ASSERT_EQ(collision.a.mass, 1);
  if (const auto velocity = velocity_by(subject_name, collision)) {
    EXPECT_LE((*velocity - collision.a.velocity - impulse).norm(), rounding) << subject_name;
  }
}

Vector3<Rational> coulomb_impulse(const Collision& collision) {
  const auto answers = oracles::coulomb_answers(oracles::lift(collision));
  EXPECT_EQ(answers.size(), 1U);
  return answers[0].truth.impulse;
}

void expect_lawful_impulse(const Collision& collision, const Vector3<double>& impulse, double rounding) {
  const Vector3<double> lawful =
      coulomb_impulse(collision).unaryExpr([](const Rational& x) { return oracles::to_double(x); });
  EXPECT_LE((lawful - impulse).norm(), rounding);
}

/// K = (3, 1, −1; 1, 3, 1; −1, 1, 3), V⁻ = (1, −3, 0). Bullet's friction acts only along x. F converges to the solution
/// of 3 F_x + F_y = −1 and F_x + 3 F_y = 3. Each of ten iterations divides the error by nine. The contact point still
/// slips along z.
TEST(EngineWitnesses, BulletDoesNotStopASlipAcross) {
  const Collision c = witness("across_the_slip");
  EXPECT_EQ(coulomb_impulse(c), Vector3<Rational>(Rational(-5) / 4, Rational(7) / 4, -1));
  expect_impulse("bullet-double-coulomb-as-shipped", c, {-0.75, 1.25, 0}, std::pow(9, -9));
}

/// K = (2, 1; 1, 2), V⁻ = (−3, −1). The first iteration gives F_y = 1/2, then F_x = 5/4. In the second iteration F_y
/// falls to 0. The solver does not change friction if F_y = 0, so F_x stays.
TEST(EngineWitnesses, BulletKeepsFrictionWithoutPressure) {
  const Collision c = witness("friction_without_pressure");
  expect_lawful_impulse(c, {0.6, 0.2, 0}, 0x1p-50);
  expect_impulse("bullet-double-coulomb-as-shipped", c, {1.25, 0, 0}, some_roundings);
}

/// K = (2, 1; 1, 2), V⁻ = (1, −2), μ = 1/2. Without friction F_y = 1, so ODE limits F_x to [−1/2, 1/2]. F_x = −1/2 then
/// gives F_y = 5/4.
TEST(EngineWitnesses, OdeTakesTheLimitFromThePressureWithoutFriction) {
  const Collision c = witness("raised_pressure");
  expect_lawful_impulse(c, {-2.0 / 3, 4.0 / 3, 0}, 0x1p-50);
  expect_impulse("ode-double-coulomb", c, {-0.5, 1.25, 0}, some_roundings);
}

/// r × N = (1, −3/4, 0) is orthogonal to the rod, so N·KN = 1 + (25/16) / (25/16) = 2, F = N and w⁺ = (16, −12, 0)/25.
/// In world axes, the greatest entry of J⁻¹ is about 2²⁶ · 16/25, with a rounding error of up to 4 · 10⁻⁹.
TEST(EngineWitnesses, ASlenderRodLosesHalfOfItsDigitsByAnInverseInertiaInWorldAxes) {
  const Collision rod = witness("slender_rod");
  const Vector3<double> spin{16.0 / 25, -12.0 / 25, 0};
  for (const char* name : {"bullet-double", "ode-double", "frictionless-world-double", "frictionless-double"}) {
    const Subject subject = *subjects::subject_named(name);
    if (!subject.absent.empty()) {
      continue;
    }
    properties::Claim claim = properties::claim_of(subject, {});
    claim.invariants = {properties::invariant_named("angular_momentum")};
    const properties::AnswerAndJudgement judged = properties::judge_one(subject, claim, {rod, false});
    const auto& answered = std::get<ReportedOutcome>(judged.answer).a.angular_velocity;
    EXPECT_LE((answered.cast<double>() - spin).norm(), 1e-7) << name;
    const properties::Verdict& verdict = judged.judgement.verdicts.at(0).verdict;
    if (name == std::string("frictionless-double")) {
      EXPECT_EQ(verdict.status, properties::Status::holds);
    } else {
      EXPECT_EQ(verdict.status, properties::Status::violated) << name;
      EXPECT_GT(verdict.residual, 1e-10) << name;
    }
  }
}

struct ByHand {
  const char* witness;
  const char* subject;
  Vector3<double> lawful;    // the velocity of A after the impulse by the law `coulomb`, computed by hand
  Vector3<double> velocity;  // the velocity of A after the impulse by the engine, computed by hand
  double rounding;           // the allowed error, from the engine's precision [m/s]
};

/// The law and each installed engine give the values of docs/reference/engines. The speeds are below 16 m/s, or below
/// 256 m/s in the rows with a factor 16. An answer has a few dozen roundings.
TEST(EngineWitnesses, AreAnsweredAsWorkedOutByHand) {
  constexpr double single = 16 * 0x1p-20;
  constexpr double binary = 16 * 0x1p-48;
  const double half_root = std::sqrt(0.5);
  for (const ByHand& by_hand : {
           ByHand{"half_the_friction", "rapier-coulomb", {6, 1, 0}, {6.5, 1, 0}, single},
           ByHand{"friction_last", "rapier-coulomb", {2.0 / 3, -2.0 / 3, 0}, {0.75, -0.5, 0}, single},
           ByHand{"two_axes", "jolt-coulomb", {4.70080, 0, 9.86410}, {4.5, 0, 10}, single},
           ByHand{"a_square", "cannon-coulomb", {7 - half_root, 1, 7 - half_root}, {6, 1, 6}, binary},
           ByHand{"a_shorter_side", "cannon-coulomb", {0.8, 0.6, 6}, {0.8, 0.6, 6.4}, binary},
           ByHand{"mobility_for_slip", "oimo-coulomb", {-45, 0, -68}, {-44, 0, -69}, 16 * binary},
           ByHand{"spin_across", "physx-coulomb", {-27, 0, 4}, {-25, 0, 5}, 16 * single},
           // MuJoCo's softness R_N is 1e-4 of N·K N.
           ByHand{"faster_by_the_slip", "mujoco-coulomb", {2.25, 0.5, 0}, {2.2, 0.6, 0}, 1e-4},
       }) {
    const Collision c = witness(by_hand.witness);
    ASSERT_EQ(c.a.mass, 1);
    SCOPED_TRACE(by_hand.witness);
    expect_lawful_impulse(c, by_hand.lawful - c.a.velocity, 1e-5);  // the pages have five digits after the point
    expect_impulse(by_hand.subject, c, by_hand.velocity - c.a.velocity, by_hand.rounding);
  }
}

}  // namespace
}  // namespace carom
