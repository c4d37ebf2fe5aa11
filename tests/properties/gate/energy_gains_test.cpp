// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/properties/gate/gate.hpp>

#include "io/threads.hpp"
#include "support/cases.hpp"
#include "support/changed_subject.hpp"

namespace carom::properties {
namespace {

EnergyGains gains_of(const Collision& collision, const Outcome<long double>& outcome, Law law = Law::any) {
  Subject subject = unit::subject_of("frictionless-double");
  subject.law = law;
  const Claim claim = claim_of(subject, {});
  const JudgedCase judged_case({collision});
  const Answer answer = ReportedOutcome{outcome};
  return energy_gains_of(7, judged_case, claim, answer, judge_answer(judged_case, claim, lift(answer)));
}

Outcome<long double> outcome_of(const Collision& c) { return reported(unchanged(c)); }

TEST(EnergyGains, AreJoulesAndAShareOfTheEnergyBefore) {
  const Collision ball = unit::ball_on_a_plane(0.5, 0);  // at (−3, −4, 0) m/s: 12.5 J
  Outcome<long double> after = outcome_of(ball);
  after.a.velocity = {-3, 6, 0};  // 22.5 J
  const EnergyGains gains = gains_of(ball, after);
  EXPECT_EQ(gains.colliding, 1U);
  EXPECT_EQ(gains.gaining, 1U);
  ASSERT_TRUE(gains.greatest && gains.greatest_share);
  EXPECT_DOUBLE_EQ(gains.greatest->joules, 10);
  EXPECT_DOUBLE_EQ(gains.greatest_share->share, 0.8);
  EXPECT_EQ(gains.greatest->index, 7U);
  after.a.velocity = {-3, 4, 0};
  EXPECT_EQ(gains_of(ball, after).gaining, 0U);
  after.a.velocity[1] += 1e-15L;
  EXPECT_EQ(gains_of(ball, after).gaining, 0U) << "rounding";
}

TEST(EnergyGains, LeaveOutTheWorkOfADrivenWall) {
  Collision ball = unit::ball_on_a_plane(0.5, 0);
  ball.restitution = 1;
  ball.a.velocity = {0, 0, 0};
  ball.b.velocity = {0, 2, 0};
  Outcome<long double> after = outcome_of(ball);
  after.a.velocity = {0, 4, 0};
  EXPECT_EQ(gains_of(ball, after).gaining, 0U);
  after.a.velocity = {0, 5, 0};  // 3 m/s in the frame of the wall, where it had 2 m/s
  const EnergyGains gains = gains_of(ball, after);
  ASSERT_EQ(gains.gaining, 1U);
  EXPECT_DOUBLE_EQ(gains.greatest->joules, 2.5);
  EXPECT_DOUBLE_EQ(gains.greatest->share, 1.25);
}

TEST(EnergyGains, KeepTheGreatestOfEachSizeAndTheFirstOfEqualOnes) {
  const auto of = [](double joules, double share, std::uint64_t index) {
    const EnergyGain gain{joules, share, index};
    return EnergyGains{1, 1, 0, gain, gain};
  };
  for (const bool is_reversed : {false, true}) {
    EnergyGains sum = is_reversed ? of(10, 0.5, 3) : of(2, 0.8, 2);
    sum += is_reversed ? of(2, 0.8, 2) : of(10, 0.5, 3);
    sum += of(10, 0.5, 4);
    EXPECT_EQ(sum.gaining, 3U);
    EXPECT_EQ(sum.greatest->index, 3U);
    EXPECT_EQ(sum.greatest_share->index, 2U);
  }
}

EnergyGains gains_of(const Subject& subject, const oracles::Limits& limits = {}, Shard shard = {}) {
  GateOptions options = unit::gate_options(60, {"generic", "driven_wall", "structured"});
  options.workers = tool::threads(2);
  options.limits = limits;
  options.shard = shard;
  options.shrinks = false;
  return run_gate({subject}, options).results.at(0).energy(options);
}

Subject with_stronger_impulses(const std::string& solver) {
  return unit::with_outcomes(unit::subject_of(solver), [](const Collision& collision, ReportedOutcome& outcome) {
    const Outcome<double> before = unchanged(collision);
    for (const OutcomeVector k : all_outcome_vectors) {
      const Vector3<long double> was = vectors(before)[k]->cast<long double>();
      *vectors(outcome)[k] = was + 1.5L * (*vectors(outcome)[k] - was);
    }
  });
}

TEST(EnergyGains, AreTheLawsOwnIfASoundSubjectGains) {
  for (const char* solver : {"sticking-double", "reflection-double", "coulomb-double"}) {
    const EnergyGains gains = gains_of(unit::subject_of(solver));
    EXPECT_GT(gains.gaining, 0U) << solver;
    EXPECT_EQ(gains.by_law, gains.gaining) << solver;
  }
  for (const char* solver : {"frictionless-double", "rough-double"}) {
    const EnergyGains gains = gains_of(unit::subject_of(solver));
    EXPECT_GT(gains.colliding, 0U) << solver;
    EXPECT_EQ(gains.gaining, 0U) << solver;
  }
  const EnergyGains of_defect = gains_of(with_stronger_impulses("coulomb-double"));
  EXPECT_LT(of_defect.by_law, of_defect.gaining);
  EXPECT_EQ(gains_of(with_stronger_impulses("frictionless-double")).by_law, 0U);
}

void expect_same(const EnergyGains& x, const EnergyGains& y) {
  EXPECT_EQ(x.colliding, y.colliding);
  EXPECT_EQ(x.gaining, y.gaining);
  EXPECT_EQ(x.by_law, y.by_law);
  ASSERT_TRUE(x.greatest && y.greatest && x.greatest_share && y.greatest_share);
  EXPECT_EQ(x.greatest->index, y.greatest->index);
  EXPECT_EQ(x.greatest->family, y.greatest->family);
  EXPECT_EQ(x.greatest_share->index, y.greatest_share->index);
  EXPECT_EQ(x.greatest_share->family, y.greatest_share->family);
}

TEST(EnergyGains, AreTheSameInExactArithmeticAndInShards) {
  const Subject subject = with_stronger_impulses("coulomb-double");
  const EnergyGains whole = gains_of(subject);
  expect_same(whole, gains_of(subject, {.filtered = false}));
  EnergyGains sum = gains_of(subject, {}, {1, 2});
  sum += gains_of(subject, {}, {2, 2});
  expect_same(whole, sum);
}

}  // namespace
}  // namespace carom::properties
