// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {
namespace {

Status status_of(const char* invariant, const Collision& collision, const ExactAnswer& answer, Law law = Law::any) {
  return std::get<AboutAnswer>(invariant_named(invariant)->about).check(collision, answer, law).status;
}

const ExactAnswer an_outcome{oracles::LiftedOutcome(ReportedOutcome{})};

TEST(Finite, HoldsForOutcomesOfFiniteNumbersAlone) {
  const Collision valid;
  EXPECT_EQ(status_of("finite", valid, an_outcome), Status::holds);
  EXPECT_EQ(status_of("finite", valid, NotFinite{}), Status::violated);
  EXPECT_EQ(status_of("finite", valid, Refused{"no"}), Status::violated);
  EXPECT_EQ(status_of("finite", valid, Failed{"died"}), Status::violated);
}

TEST(Finite, SaysWhyThereIsNoAnswer) {
  const auto& finite = std::get<AboutAnswer>(invariant_named("finite")->about);
  for (const ExactAnswer& answer : {ExactAnswer(Refused{"no mass"}), ExactAnswer(Failed{"no mass"})}) {
    EXPECT_NE(finite.check(Collision(), answer, Law::any).detail.find("no mass"), std::string::npos);
  }
}

TEST(Lift, KeepsHugeOutcomesThatAreFinite) {
  ReportedOutcome outcome;
  outcome.a.velocity = {0x1p+200L, 0, 0};
  EXPECT_TRUE(std::holds_alternative<oracles::LiftedOutcome>(lift(outcome)));
  outcome.a.velocity[0] = std::numeric_limits<long double>::infinity();
  EXPECT_TRUE(std::holds_alternative<NotFinite>(lift(outcome)));
}

/// A field that the law does not read may be invalid.
TEST(InvalidRefused, AsksAboutTheFieldsThatTheLawReads) {
  Collision with_friction;
  with_friction.friction = -1;
  Collision with_tangential_restitution;
  with_tangential_restitution.tangential_restitution = 2;
  Collision without_mass;
  without_mass.a.mass = 0;
  const auto expected = [](bool is_read) { return is_read ? Status::violated : Status::skipped; };
  for (const Law law : all_laws) {
    const bool reads_friction = law == Law::rough || law == Law::coulomb;
    EXPECT_EQ(status_of("invalid_refused", with_friction, an_outcome, law), expected(reads_friction)) << name_of(law);
    EXPECT_EQ(status_of("invalid_refused", with_tangential_restitution, an_outcome, law), expected(law == Law::rough))
        << name_of(law);
    EXPECT_EQ(status_of("invalid_refused", without_mass, an_outcome, law), Status::violated) << name_of(law);
    EXPECT_EQ(status_of("invalid_refused", without_mass, Refused{"no"}, law), Status::holds) << name_of(law);
    EXPECT_EQ(status_of("invalid_refused", with_friction, Failed{"died"}, law), Status::violated) << name_of(law);
  }
}

Verdict verdict_of(const Answer& first, const Answer& again, Sameness sameness = Sameness::of_bits) {
  return std::get<AboutSession>(invariant_named("memoryless")->about).check(first, again, sameness);
}

ReportedOutcome some_outcome() {
  ReportedOutcome outcome;
  outcome.a.velocity = {1, 0, -2};
  outcome.b.angular_velocity = {0, 3, std::numeric_limits<long double>::quiet_NaN()};
  return outcome;
}

TEST(Memoryless, HoldsForTheSameAnswerAlone) {
  EXPECT_EQ(verdict_of(some_outcome(), some_outcome()).status, Status::holds);
  EXPECT_EQ(verdict_of(Refused{"no"}, Refused{"no"}).status, Status::holds);
  const Verdict of_kinds = verdict_of(some_outcome(), Refused{"no"});
  EXPECT_EQ(of_kinds.status, Status::violated);
  EXPECT_EQ(of_kinds.residual, 0);
  EXPECT_TRUE(std::isinf(of_kinds.severity())) << "no number tells";
}

TEST(Memoryless, ShowsBothAnswers) {
  ReportedOutcome again = some_outcome();
  again.a.velocity[2] = 6;
  const Verdict verdict = verdict_of(some_outcome(), again);
  EXPECT_EQ(verdict.status, Status::violated);
  EXPECT_EQ(verdict.detail, "a.velocity, first answer and repeated answer");
  EXPECT_EQ(verdict.residual, 8);
  EXPECT_EQ(verdict.allowed, 0);
  EXPECT_EQ(verdict.left, (std::vector<double>{1, 0, -2}));
  EXPECT_EQ(verdict.right, (std::vector<double>{1, 0, 6}));
}

TEST(Memoryless, ComparesEachNumber) {
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      ReportedOutcome again = some_outcome();
      (*vectors(again)[k])[i] = 7;
      EXPECT_EQ(verdict_of(some_outcome(), again).status, Status::violated) << name_of(k) << ' ' << i;
    }
  }
}

TEST(Memoryless, TakesZerosForTheSameOnlyAsNumbers) {
  ReportedOutcome again = some_outcome();
  again.a.velocity[1] = -0.0L;
  EXPECT_EQ(verdict_of(some_outcome(), again).status, Status::violated);
  EXPECT_EQ(verdict_of(some_outcome(), again, Sameness::of_numbers).status, Status::holds);
  again.a.velocity[1] = 0x1p-16000L;
  EXPECT_EQ(verdict_of(some_outcome(), again, Sameness::of_numbers).status, Status::violated);
}

/// NaN equals NaN regardless of its sign.
TEST(Memoryless, TakesNaNsForTheSame) {
  ReportedOutcome again = some_outcome();
  again.b.angular_velocity[2] = -again.b.angular_velocity[2];
  for (const Sameness sameness : {Sameness::of_bits, Sameness::of_numbers}) {
    EXPECT_EQ(verdict_of(some_outcome(), again, sameness).status, Status::holds);
  }
}

TEST(Memoryless, ComparesTheMatrixThatIsShown) {
  ReportedOutcome with = some_outcome();
  with.collision_matrix = Matrix3<long double>::Identity();
  EXPECT_EQ(verdict_of(with, with).status, Status::holds);
  const Verdict of_one = verdict_of(with, some_outcome());
  EXPECT_EQ(of_one.status, Status::violated);
  EXPECT_TRUE(std::isinf(of_one.severity()));
  ReportedOutcome other = with;
  (*other.collision_matrix)(2, 1) = 0.5L;
  EXPECT_EQ(verdict_of(with, other).status, Status::violated);
}

}  // namespace
}  // namespace carom::properties
