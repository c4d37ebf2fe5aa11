// SPDX-License-Identifier: BSL-1.0
#include <limits>

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

}  // namespace
}  // namespace carom::properties
