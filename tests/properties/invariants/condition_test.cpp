// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/trial/trial.hpp>

#include "support/exact.hpp"

/// `well_conditioned` judges the reported matrix, not only the exact one.
namespace carom::properties {
namespace {

Status status_of(const Case& one, const Matrix3<long double>& shown, bool filtered) {
  Subject subject;
  subject.law = Law::reflection;
  subject.precision = Precision::binary64;
  subject.shows_collision_matrix = true;
  oracles::Yardstick yardstick;
  yardstick.filtered = filtered;
  Claim claim = claim_of(subject, yardstick);
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return invariant->name != "well_conditioned"; });
  const JudgedCase judged(one, filtered);
  ReportedOutcome outcome = map_outcome<long double>(judged.exact().nearest_truth(subject.law),
                                                     [](double x) { return static_cast<long double>(x); });
  outcome.collision_matrix = shown;
  const auto verdicts = try_case(judged, claim, [&](const Collision&) { return lift(outcome); }).verdicts;
  return verdicts.at(0).verdict.status;
}

TEST(WellConditioned, IsAskedOfTheMatrixThatIsShown) {
  int judged = 0;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Case one = unit::case_of("physical", i);
    ASSERT_TRUE(one.convex_uniform);
    if (oracles::ExactCase(one.collision).approach() != oracles::Approach::colliding) {
      continue;
    }
    ++judged;
    const Matrix3<long double> exact =
        impulse::collision_matrix(unit::exact_contact(one.collision))
            .unaryExpr([](const oracles::Rational& x) -> long double { return oracles::to_double(x); });
    double lambda = 0;
    for (const Body* body : {&one.collision.a, &one.collision.b}) {
      lambda += body->immovable ? 0 : 1 / body->mass;
    }
    const Matrix3<long double> too_large = exact + Matrix3<long double>::Identity() * (17 * lambda);
    for (const bool filtered : {true, false}) {
      EXPECT_EQ(status_of(one, exact, filtered), Status::holds) << i;
      EXPECT_EQ(status_of(one, too_large, filtered), Status::violated) << i;
    }
  }
  EXPECT_GT(judged, 5);
}

}  // namespace
}  // namespace carom::properties
