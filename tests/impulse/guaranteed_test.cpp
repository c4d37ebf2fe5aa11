// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/guaranteed.hpp>
#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

using unit::Rational;
using unit::sign_of;

constexpr std::uint64_t cases_of_each = 200;

Rational normal_velocity(const Collision& collision, const Outcome<Rational>& motion) {
  const auto exact = oracles::lift(collision);
  return exact.normal.dot(oracles::relative_velocity<Rational>(exact, motion));
}

Outcome<Rational> lifted(const Outcome<double>& motion) {
  return map_outcome<Rational>(motion, [](double x) { return Rational(x); });
}

Outcome<double> outcome_of(Session& session, const Collision& collision) {
  const std::vector<Answer> answers = session(std::span(&collision, 1));
  return map_outcome<double>(std::get<ReportedOutcome>(answers.at(0)),
                             [](long double x) { return static_cast<double>(x); });
}

/// The number of valid collisions with a movable body for which the subject's outcome has N·V⁺ < 0, by exact
/// arithmetic.
int approaching_outcomes(const std::string& subject) {
  Session session = subjects::subject_named(subject)->open();
  int approaching = 0;
  for (const auto& [family, one] : unit::valid_cases(cases_of_each)) {
    const Collision& c = one.collision;
    if (!c.a.immovable || !c.b.immovable) {
      approaching += normal_velocity(c, lifted(outcome_of(session, c))) < 0 ? 1 : 0;
    }
  }
  return approaching;
}

TEST(Guaranteed, NeverLeavesAnApproachThoughThePlainSolversDo) {
  EXPECT_EQ(approaching_outcomes("frictionless-guaranteed-double"), 0);
  EXPECT_EQ(approaching_outcomes("reflection-guaranteed-double"), 0);
  EXPECT_GT(approaching_outcomes("frictionless-double"), 50);
  EXPECT_GT(approaching_outcomes("reflection-double"), 50);
}

TEST(Guaranteed, ChangesOnlyOutcomesThatApproach) {
  Session plain = subjects::subject_named("reflection-double")->open();
  int changed = 0;
  for (const auto& [family, one] : unit::valid_cases(20)) {
    const Outcome<double> outcome = outcome_of(plain, one.collision);
    const Outcome<double> mended = without_approach(one.collision, outcome);
    const bool same = unit::same(mended, outcome);
    const bool penetrates = normal_velocity(one.collision, lifted(outcome)) < 0;
    const bool movable = !one.collision.a.immovable || !one.collision.b.immovable;
    EXPECT_EQ(!same, penetrates && movable) << family;
    changed += same ? 0 : 1;
  }
  EXPECT_GT(changed, 5);
}

TEST(Guaranteed, StopsTheApproachOfAnOutcomeThatIsFarOff) {
  for (const auto& [family, one] : unit::valid_cases(20)) {
    const Outcome<double> idle = unchanged(one.collision);
    if (!one.collision.a.immovable || !one.collision.b.immovable) {
      EXPECT_GE(normal_velocity(one.collision, lifted(without_approach(one.collision, idle))), 0) << family;
    }
  }
}

TEST(NormalVelocitySign, EqualsTheSignInRationalArithmetic) {
  int zeros = 0;
  for (const auto& [family, one] : unit::valid_cases(cases_of_each)) {
    const Outcome<double> before = unchanged(one.collision);
    const int sign = sign_of(normal_velocity(one.collision, lifted(before)));
    EXPECT_EQ(normal_velocity_sign(one.collision, before), sign) << family;
    EXPECT_EQ(exact_normal_velocity(one.collision, before).sign(), sign) << family;
    zeros += sign == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 50);
}

/// N·V rounds to zero in binary64, so the size of the needed correction is unknown.
TEST(Guaranteed, EndsWhereTheNormalVelocityUnderflows) {
  Collision collision;
  collision.b.immovable = true;
  collision.normal = {0, 1e-320, 0};
  collision.a.velocity = {0, -1e-100, 0};
  EXPECT_EQ(known_normal_velocity(collision, unchanged(collision)).value, 0);
  EXPECT_LT(normal_velocity_sign(collision, unchanged(collision)), 0);
  EXPECT_GE(normal_velocity_sign(collision, without_approach(collision, unchanged(collision))), 0);
}

}  // namespace
}  // namespace carom::impulse
