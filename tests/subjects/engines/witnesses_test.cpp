// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/oracles/models/coulomb.hpp>
#include <carom/subjects/catalogue.hpp>

#include "formulas/formulas.hpp"

/// The collisions of docs/findings/engines that a reader can follow by hand.
namespace carom {
namespace {

using oracles::Rational;

constexpr double some_roundings = 16 * 0x1p-53;  // of numbers up to 1

Collision witness(const std::string& name) {
  std::ifstream file(CAROM_WITNESSES "/" + name + ".json");
  return collision_from_json(nlohmann::json::parse(file));
}

/// The velocities of A by the formula of the subject, and by the subject itself where it is installed.
std::vector<Vector3<double>> velocities_by(const std::string& subject_name, const Collision& collision) {
  std::vector<Vector3<double>> velocities{(*formulas::formula_of(subject_name))(collision).a.velocity};
  const Subject subject = *subjects::subject_named(subject_name);
  if (subject.absent.empty()) {
    const std::vector<Answer> answers = subject.open()({&collision, 1});
    velocities.push_back(std::get<ReportedOutcome>(answers[0]).a.velocity.cast<double>());
  }
  return velocities;
}

/// F on a body of mass 1.
void expect_impulse(const std::string& subject_name, const Collision& collision, const Vector3<double>& impulse,
                    double rounding) {
  ASSERT_EQ(collision.a.mass, 1);
  for (const Vector3<double>& velocity : velocities_by(subject_name, collision)) {
    EXPECT_LE((velocity - collision.a.velocity - impulse).norm(), rounding) << subject_name;
  }
}

Vector3<Rational> coulomb_impulse(const Collision& collision) {
  const auto answers = oracles::coulomb_answers(oracles::lift(collision));
  EXPECT_EQ(answers.size(), 1U);
  return answers[0].truth.impulse;
}

/// K = (3, 1, −1; 1, 3, 1; −1, 1, 3), V⁻ = (1, −3, 0): friction along x alone ends at 3 F_x + F_y = −1, F_x + 3 F_y =
/// 3, which each of Bullet's ten iterations comes nine times nearer. Across, at V_z⁺ = −F_x + F_y, the point slips on.
TEST(EngineWitnesses, BulletDoesNotStopASlipAcross) {
  const Collision c = witness("across_the_slip");
  EXPECT_EQ(coulomb_impulse(c), Vector3<Rational>(Rational(-5) / 4, Rational(7) / 4, -1));
  expect_impulse("bullet-double-coulomb-as-shipped", c, {-0.75, 1.25, 0}, std::pow(9, -9));
}

/// K = (2, 1; 1, 2), V⁻ = (−3, −1): the first iteration makes F_y = 1/2, then F_x = 5/4; in the second F_y falls to 0,
/// and friction, which is left alone where there is no pressure, stays.
TEST(EngineWitnesses, BulletKeepsFrictionWithoutPressure) {
  const Collision c = witness("friction_without_pressure");
  EXPECT_LE((coulomb_impulse(c).unaryExpr([](const Rational& x) { return oracles::to_double(x); }) -
             Vector3<double>(0.6, 0.2, 0))
                .norm(),
            0x1p-50);
  expect_impulse("bullet-double-coulomb-as-shipped", c, {1.25, 0, 0}, some_roundings);
}

/// The same K, V⁻ = (1, −2), μ = 1/2: without friction F_y = 1, so ODE's box is [−1/2, 1/2]. With F_x = −1/2 the
/// pressure is 5/4, and friction 2/5 of it.
TEST(EngineWitnesses, OdeTakesTheLimitFromThePressureWithoutFriction) {
  const Collision c = witness("raised_pressure");
  EXPECT_LE((coulomb_impulse(c).unaryExpr([](const Rational& x) { return oracles::to_double(x); }) -
             Vector3<double>(-2.0 / 3, 4.0 / 3, 0))
                .norm(),
            0x1p-50);
  expect_impulse("ode-double-coulomb", c, {-0.5, 1.25, 0}, some_roundings);
}

struct ByHand {
  const char* witness;
  const char* subject;
  Vector3<double> velocity;  // of A after the impulse, worked out by hand
  double rounding;           // of the engine's precision, relative
};

/// By the formula always, and by the engine where it is installed: what docs/findings/engines says of each. The speeds
/// are below 16 (256 of the last two but one) and a few dozen roundings.
TEST(EngineWitnesses, AreAnsweredAsWorkedOutByHand) {
  constexpr double single = 16 * 0x1p-20;
  constexpr double binary = 16 * 0x1p-48;
  for (const ByHand& by_hand : {
           ByHand{"half_the_friction", "rapier-coulomb", {6.5, 1, 0}, single},
           ByHand{"friction_last", "rapier-coulomb", {0.75, -0.5, 0}, single},
           ByHand{"two_axes", "jolt-coulomb", {4.5, 0, 10}, single},
           ByHand{"a_square", "cannon-coulomb", {6, 1, 6}, binary},
           ByHand{"a_shorter_side", "cannon-coulomb", {0.8, 0.6, 6.4}, binary},
           ByHand{"mobility_for_slip", "oimo-coulomb", {-44, 0, -69}, 16 * binary},
           ByHand{"spin_across", "physx-coulomb", {-25, 0, 5}, 16 * single},
           // As far as MuJoCo's contact is soft: 1e-4.
           ByHand{"faster_by_the_slip", "mujoco-coulomb", {2.2, 0.6, 0}, 1e-4},
       }) {
    const Collision c = witness(by_hand.witness);
    for (const Vector3<double>& velocity : velocities_by(by_hand.subject, c)) {
      EXPECT_LE((velocity - by_hand.velocity).norm(), by_hand.rounding) << by_hand.witness;
    }
  }
}

}  // namespace
}  // namespace carom
