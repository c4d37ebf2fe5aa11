// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/precision.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/unjudged.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

/// A valid collision whose fields are multiplied by different powers of two, with exponents up to ±`most`.
Case extreme_case(Stream& stream, int most) {
  Case one = unit::case_of("physical", stream.bits() % 100);
  const auto factor = [&] { return std::ldexp(1.0, stream.integer(-most, most)); };
  for (Body* body : {&one.collision.a, &one.collision.b}) {
    body->mass *= factor();
    body->principal_inertia *= factor();
    body->orientation *= factor();
    body->velocity *= factor();
    body->angular_velocity *= factor();
  }
  one.collision.normal *= factor();
  return one;
}

/// Judges solvers on extreme cases. Exits with 0 if every judgement ends with verdicts or a reason for none.
void judge_to_the_end(int most) {
  Stream stream = stream_from(static_cast<std::uint64_t>(most));
  for (int i = 0; i < unit::effort(20); ++i) {
    const Case one = extreme_case(stream, most);
    for (const char* name :
         {"frictionless-float", "reflection-double", "reflection-in-basis-long-double", "coulomb-double"}) {
      const Subject subject = subjects::subject_named(name).value();
      const Judgement judgement = judge_one(subject, claim_of(subject, {}), one).judgement;
      if (judgement.verdicts.empty() && !judgement.unjudged) {
        std::exit(1);
      }
    }
  }
  std::exit(0);
}

/// Judges solvers as if they computed in binary32. The limit is so large that a permitted residual can overflow. Exits
/// with 0 if the judges with and without filters agree. Relations are left out, because their rationals would be long.
void judge_at_the_largest_limit(int most) {
  Stream stream = stream_from(static_cast<std::uint64_t>(most));
  for (int i = 0; i < unit::effort(4); ++i) {
    const Case one = extreme_case(stream, most);
    for (const char* name : {"frictionless-double", "reflection-double"}) {
      Subject subject = subjects::subject_named(name).value();
      subject.precision = Precision::binary32;
      Claim claim = claim_of(subject, {1e15});
      std::erase_if(claim.invariants, [](const Invariant* invariant) { return invariant->asks(); });
      const std::vector<NamedVerdict> filtered = judge_one(subject, claim, one).judgement.verdicts;
      claim.yardstick = claim.yardstick.with_filters(false);
      const std::vector<NamedVerdict> exact = judge_one(subject, claim, one).judgement.verdicts;
      const auto agree = [](const NamedVerdict& x, const NamedVerdict& y) {
        return x.verdict.status == y.verdict.status && x.verdict.is_undecided == y.verdict.is_undecided;
      };
      if (!std::equal(filtered.begin(), filtered.end(), exact.begin(), exact.end(), agree)) {
        std::exit(1);
      }
    }
  }
  std::exit(0);
}

/// An impulse with N·F < 0 pulls. At a resting contact, a pull passes if the rounding of the inputs explains it.
TEST(Trial, PushAllowsWhatTheInputsRoundTo) {
  Case resting;
  Collision& c = resting.collision;
  c.a.mass = 2;
  c.a.position = {1, 1, 0};
  c.a.velocity = {1, -1, 0};
  c.b.position = {-1, -1, 0};
  c.normal = {1, 1, 0};
  const auto push_of = [&](double pull) {
    const Claim claim{Law::frictionless, oracles::Yardstick::of(Precision::binary64), {invariant_named("push")}};
    const auto pulled = [&](const Collision& collision) -> ExactAnswer {
      ReportedOutcome outcome = reported(unchanged(collision));
      outcome.b.velocity += Vector3<long double>{pull, pull, 0};
      return oracles::LiftedOutcome(outcome);
    };
    return try_case(JudgedCase(resting), claim, pulled).verdicts.at(0).verdict.status;
  };
  // The components of the velocities are ±1, so a pull of about 32 × `rounding` is permitted.
  const double rounding = unit_roundoff(Precision::binary64);
  EXPECT_EQ(push_of(rounding / 100), Status::holds);
  EXPECT_EQ(push_of(10'000 * rounding), Status::violated);
}

/// In this outcome, the slip is one ulp. The normal is so short that the scale of N × V⁺ underflows. A's mass is so
/// large that the scale of friction does not underflow. So the judge cannot decide whether the contact point slips, and
/// accepts friction inside the cone.
TEST(Trial, ASlipThatCannotBeToldFromStickingIsNoViolation) {
  const auto verdict_with = [](double normal, double mass) {
    Case one{unit::ball_on_a_plane(mass / 2, 10), false};
    one.collision.a.mass = mass;
    one.collision.normal *= normal;
    const Claim claim{Law::coulomb, oracles::Yardstick::of(Precision::binary64), {invariant_named("slip_opposed")}};
    const auto stuck = [](const Collision& collision) -> ExactAnswer {
      ReportedOutcome outcome = reported(unchanged(collision));
      outcome.a = {{-2 + 0x1p-52L, 2, 0}, {0, 0, 2}};
      return oracles::LiftedOutcome(outcome);
    };
    return try_case(JudgedCase(one), claim, stuck).verdicts.at(0).verdict;
  };
  EXPECT_EQ(verdict_with(1, 1).status, Status::holds);
  const Verdict undecided = verdict_with(0x1p-950, 0x1p+520);
  EXPECT_EQ(undecided.status, Status::skipped);
  EXPECT_TRUE(undecided.is_undecided);
}

/// Runs in another process, because CGAL aborts its process if an infinite double becomes a rational.
TEST(Trial, JudgesEveryValidCollisionToTheEnd) {
  for (const int most : {50, 100, 200, 400, 900}) {
    Stream stream = stream_from(static_cast<std::uint64_t>(most));
    for (int i = 0; i < 20; ++i) {
      ASSERT_EQ(describe(validate(extreme_case(stream, most).collision)), "");
    }
    EXPECT_EXIT(judge_to_the_end(most), testing::ExitedWithCode(0), "") << "exponents up to " << most;
    EXPECT_EXIT(judge_at_the_largest_limit(most), testing::ExitedWithCode(0), "") << "exponents up to " << most;
  }
}

Verdict verdict_on(const Case& one, const char* invariant, double limit_ulps, bool filtered) {
  const Subject subject = subjects::subject_named("frictionless-double").value();
  Claim claim = claim_of(subject, {limit_ulps, {}, filtered});
  claim.invariants = {invariant_named(invariant)};
  return judge_one(subject, claim, one).judgement.verdicts.at(0).verdict;
}

/// A has a mass of 10⁻²⁹⁰ kg. Only the scale of A's own angular momentum leaves the range of numbers.
TEST(Trial, AngularMomentumIsNotDecidedWhereThatOfOneBodyIsNot) {
  const Case one = unit::case_of("physical", 3);
  ASSERT_FALSE(one.collision.a.immovable || one.collision.b.immovable);
  for (const bool filtered : {true, false}) {
    EXPECT_EQ(verdict_on(one, "angular_momentum", oracles::default_limit_ulps, filtered).status, Status::holds);
  }
  Case feather = one;
  feather.collision.a.mass = 1e-290;
  feather.collision.a.principal_inertia *= 1e-290;
  for (const bool filtered : {true, false}) {
    const Verdict verdict = verdict_on(feather, "angular_momentum", oracles::default_limit_ulps, filtered);
    EXPECT_EQ(verdict.status, Status::skipped) << filtered;
    EXPECT_TRUE(verdict.is_undecided);
  }
}

/// At velocities of 10³⁰⁰ and a limit of 10²⁵ ulps, the permitted error overflows. Even a sound outcome is then
/// undecided.
TEST(Trial, ALimitBeyondRangeIsNoPass) {
  Case one = unit::case_of("elastic", 1);
  for (Body* body : {&one.collision.a, &one.collision.b}) {
    body->velocity *= 1e300;
    body->angular_velocity *= 1e300;
  }
  for (const bool filtered : {true, false}) {
    for (const char* invariant : {"backward_error", "linear_momentum", "restitution"}) {
      EXPECT_NE(verdict_on(one, invariant, 1e15, filtered).status, Status::violated);
    }
    const Verdict verdict = verdict_on(one, "backward_error", 1e25, filtered);
    EXPECT_EQ(verdict.status, Status::skipped);
    EXPECT_TRUE(verdict.is_undecided);
  }
}

std::optional<Unjudged> reason(const Collision& collision, Precision precision) {
  return reason_unjudged(oracles::ExactCase(collision), oracles::Yardstick::of(precision));
}

bool is_judged(const Collision& collision, Precision precision) { return !reason(collision, precision); }

Collision ball_on_floor() {
  Collision c;
  c.a.position = {0.5, 1, 0.25};
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  return c;
}

TEST(Unjudged, DoesNotIncludeABallOnAFloor) {
  EXPECT_TRUE(is_judged(ball_on_floor(), Precision::binary32));
  EXPECT_TRUE(is_judged(ball_on_floor(), Precision::binary64));
}

TEST(Unjudged, IsAChangeOfSpinThatLeavesTheRangeOfBinary32) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-15, 0};
  c.a.mass = 1e-9;
  EXPECT_TRUE(is_judged(c, Precision::binary32));
  c.a.principal_inertia.setConstant(1e15);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  EXPECT_TRUE(is_judged(c, Precision::binary64));
}

/// The numbers of each body must stay in the range. The lever arm of the other body does not matter.
TEST(Unjudged, IsABodyThatTurnsLessThanBinary32Holds) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-5, 0};
  c.a.position = c.point + Vector3<double>{1e-6, 1e-6, 0};
  c.a.principal_inertia.setConstant(1e26);
  c.b = c.a;
  c.b.velocity = {0, 0, 0};
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  c.b.position = c.point + Vector3<double>{1e3, 1e3, 0};
  c.b.principal_inertia.setConstant(1e6);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  c.a = c.b;
  EXPECT_TRUE(is_judged(c, Precision::binary32));
}

TEST(Unjudged, IsAMomentAtTheEndOfTheRangeOfBinary32) {
  Collision c = ball_on_floor();
  c.a.principal_inertia.setConstant(1e37);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  EXPECT_TRUE(is_judged(c, Precision::binary64));
}

/// At 10²⁰⁰ m from the origin, the allowance moves the lever arm by 10¹⁸⁵ m. The square of this distance overflows.
TEST(Unjudged, IsAnEnclosureThatIsNotFinite) {
  Collision c = ball_on_floor();
  c.a.position = {1e200, 1, 0};
  c.point = {1e200, 0, 0};
  EXPECT_EQ(reason(c, Precision::binary64), Unjudged::no_finite_enclosure);
}

}  // namespace
}  // namespace carom::properties
