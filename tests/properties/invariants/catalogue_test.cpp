// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {
namespace {

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

/// If none of these holds in a run, no colliding contact was answered.
TEST(Invariants, OfCollidingContactsAreThese) {
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
