// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/trial.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

TEST(Both, IsTheWorseOfTwoVerdictsOfDifferentStatus) {
  const std::vector<Verdict> from_the_worst{
      {.status = Status::violated}, beyond_range(), Verdict{}, does_not_apply("why")};
  const auto same = [](const Verdict& x, const Verdict& y) {
    return x.status == y.status && x.is_undecided == y.is_undecided;
  };
  for (std::size_t i = 0; i < from_the_worst.size(); ++i) {
    for (std::size_t j = 0; j < from_the_worst.size(); ++j) {
      EXPECT_TRUE(same(both(from_the_worst[i], from_the_worst[j]), from_the_worst[std::min(i, j)])) << i << ' ' << j;
    }
  }
  EXPECT_EQ(beyond_range().status, Status::skipped);
}

TEST(Seriousness, OrdersViolations) {
  Collision c;
  c.a.velocity = {3, -4, 0};
  Verdict verdict;
  EXPECT_EQ(verdict.severity(), 0) << "what holds";
  EXPECT_EQ(verdict.relative_residual(), 0);
  EXPECT_EQ(seriousness(verdict, c), 0);
  verdict.status = Status::violated;
  EXPECT_TRUE(std::isinf(verdict.severity())) << "without numbers";
  EXPECT_TRUE(std::isinf(seriousness(verdict, c)));
  EXPECT_EQ(verdict.relative_residual(), 0);
  verdict.residual = 6;
  verdict.allowed = 2;
  EXPECT_EQ(verdict.severity(), 3);
  EXPECT_EQ(seriousness(verdict, c), 3);
  verdict.left = {1, -12};
  verdict.right = {5};
  EXPECT_EQ(verdict.relative_residual(), 0.5);
  verdict.left = {0.25};
  verdict.right = {};
  EXPECT_EQ(verdict.relative_residual(), 24);
  verdict.left = {1, -12};
  verdict.right = {5};
  // If the permitted residual is 0, `seriousness` divides the residual by 2⁻⁵³ times the largest number of `left`,
  // `right` and the collision's velocities. If these numbers are all zero, it divides by 2⁻⁵³.
  verdict.allowed = 0;
  EXPECT_TRUE(std::isinf(verdict.severity()));
  EXPECT_EQ(seriousness(verdict, c), 6 / 12.0 * 0x1p+53);
  verdict.left.clear();
  verdict.right.clear();
  EXPECT_EQ(seriousness(verdict, c), 6 / 4.0 * 0x1p+53);
  c.b.angular_velocity = {0, 0, -24};
  EXPECT_EQ(seriousness(verdict, c), 6 / 24.0 * 0x1p+53);
  EXPECT_EQ(seriousness(verdict, Collision{}), 6 * 0x1p+53);
  c = Collision{};
  c.a.velocity = {0, 0.5, 0};
  EXPECT_EQ(seriousness(verdict, c), 12 * 0x1p+53);
  verdict.residual = 0.25;
  EXPECT_EQ(seriousness(verdict, c), 0.5 * 0x1p+53);
}

TEST(ViolationKind, IsFoundInTheDetailOfAViolation) {
  for (int kind = 0; kind <= static_cast<int>(ViolationKind::subject_threw); ++kind) {
    EXPECT_EQ(static_cast<int>(kind_of_detail(violation(static_cast<ViolationKind>(kind), ": why").detail)), kind);
  }
}

TEST(Both, IsTheMoreSevereOfTwoViolations) {
  Verdict small{Status::violated, "small", 2, 1, {}, {}};
  Verdict large{Status::violated, "large", 9, 3, {}, {}};
  EXPECT_EQ(both(small, large).detail, "large");
  EXPECT_EQ(both(large, small).detail, "large");
  EXPECT_EQ(both(large, Verdict{}).detail, "large");
}

Outcome<oracles::Enclosure> enclosed(const Outcome<long double>& outcome) {
  return map_outcome<oracles::Enclosure>(outcome, [](long double x) { return oracles::Enclosure(x); });
}

TEST(SurelyNear, LooksAtEachVectorThatIsNamed) {
  const PerVector<double> scale{1, 1, 1, 1};
  for (const OutcomeVector moved : all_outcome_vectors) {
    const Outcome<long double> rest;
    Outcome<long double> other;
    (*vectors(other)[moved])[2] = 0x1p-20L;
    for (const OutcomeVector named : all_outcome_vectors) {
      EXPECT_EQ(surely_near(enclosed(rest), enclosed(other), 0x1p-30, scale, std::array{named}), named != moved);
    }
    EXPECT_FALSE(surely_near(enclosed(rest), enclosed(other), 0x1p-30, scale));
    EXPECT_TRUE(surely_near(enclosed(rest), enclosed(other), 0x1p-10, scale));
  }
}

TEST(SurelyNear, DoesNotTakeANaNForNear) {
  const PerVector<double> scale{1, 1, 1, 1};
  Outcome<long double> nothing;
  nothing.b.velocity[1] = std::numeric_limits<long double>::quiet_NaN();
  EXPECT_FALSE(surely_near(enclosed(nothing), enclosed({}), 1, scale));
  EXPECT_FALSE(surely_near(enclosed({}), enclosed(nothing), 1, scale));
}

/// The slender rod strikes with its tip, and its exact velocity after the impulse is zero. The enclosure of this
/// velocity is not exactly zero.
TEST(BackwardError, PrintsAnExactZeroAsZero) {
  Collision c;
  c.a = {false, 1, {0x1p-26, 1.5625, 1.5625}, {2, 0, 0, 1}, {-0.75, -1, 0}, {0, 0, -1}, {0, 0, 0}};
  c.b.immovable = true;
  c.normal = {0, 0, 1};
  c.restitution = 1;
  const JudgedCase judged_case({c, true});
  const Claim claim{
      Law::frictionless, oracles::Yardstick::of(Precision::binary64), {invariant_named("backward_error")}};
  const Judgement judgement =
      try_case(judged_case, claim, [](const Collision& at) { return oracles::LiftedOutcome(reported(unchanged(at))); });
  ASSERT_EQ(judgement.verdicts.size(), 1U);
  const Verdict& verdict = judgement.verdicts[0].verdict;
  ASSERT_EQ(verdict.status, Status::violated);
  EXPECT_EQ(verdict.right[2], 0) << "of both velocities";
}

bool is_proved_of(const char* invariant, Law law) {
  const std::vector<Law> laws = invariant_named(invariant)->proved_laws();
  return std::ranges::find(laws, law) != laws.end();
}

TEST(Theorems, ProveInvariantsOfTheLawsThatClaimThem) {
  for (const Invariant& invariant : all_invariants()) {
    const std::vector<Law> laws = invariant.proved_laws();
    EXPECT_EQ(laws.empty(), invariant.proof.theorems.empty()) << invariant.name;
    for (const Law law : laws) {
      EXPECT_TRUE(invariant.claimed_for(law)) << invariant.name;
      EXPECT_TRUE(invariant.proof.of == ProvedOf::every_impulse || determines_outcome(law)) << invariant.name;
    }
  }
  EXPECT_TRUE(invariant_named("finite")->proved_laws().empty());
  // Every law conserves momentum. Theorems about one answer do not cover `coulomb`, which may have several answers.
  EXPECT_TRUE(is_proved_of("linear_momentum", Law::coulomb));
  EXPECT_TRUE(is_proved_of("restitution", Law::rough));
  EXPECT_FALSE(is_proved_of("restitution", Law::coulomb));
}

TEST(Invariants, AreEachOfOneAnswerOfRelatedOnesOrOfASession) {
  for (const Invariant& invariant : all_invariants()) {
    const int kinds = static_cast<int>(invariant.is_of_one_answer()) + static_cast<int>(invariant.asks()) +
                      static_cast<int>(invariant.is_of_session());
    EXPECT_EQ(kinds, 1) << invariant.name;
    EXPECT_EQ(invariant.is_of_invalid(), invariant.name == "invalid_refused") << invariant.name;
  }
}

/// A subject that claims one of these alone shows that it solves collisions. The others hold for unchanged velocities
/// of many collisions, too.
TEST(Invariants, ThatSpeakOfCollidingContactsAreSix) {
  std::vector<std::string_view> names;
  for (const Invariant& invariant : all_invariants()) {
    const auto* const about = std::get_if<AboutOutcome>(&invariant.about);
    if (about != nullptr && about->is_of_colliding) {
      names.push_back(invariant.name);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string_view>{"backward_error", "linear_momentum", "angular_momentum",
                                                  "restitution", "non_penetration", "push"}));
}

TEST(Invariants, AreRankedAsCausesFromOneWithoutAGap) {
  std::vector<int> ranks;
  for (const Invariant& invariant : all_invariants()) {
    if (invariant.rank_as_cause != explains_none) {
      ranks.push_back(invariant.rank_as_cause);
    }
  }
  std::ranges::sort(ranks);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    EXPECT_EQ(ranks[i], static_cast<int>(i) + 1);
  }
}

}  // namespace
}  // namespace carom::properties
