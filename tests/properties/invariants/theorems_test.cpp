// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/properties/invariants/invariant.hpp>

namespace carom::properties {
namespace {

bool is_proved_of(const char* invariant, Model model) {
  const std::vector<Model> models = invariant_named(invariant)->proved_models();
  return std::ranges::find(models, model) != models.end();
}

TEST(Theorems, ProveInvariantsOfTheLawsThatClaimThem) {
  for (const Invariant& invariant : all_invariants()) {
    const std::vector<Model> models = invariant.proved_models();
    EXPECT_EQ(models.empty(), invariant.proof.theorems.empty()) << invariant.name;
    for (const Model model : models) {
      EXPECT_TRUE(invariant.claimed_for(model)) << invariant.name;
      EXPECT_TRUE(invariant.proof.of == ProvedOf::every_impulse || determines_outcome(model)) << invariant.name;
    }
  }
  EXPECT_TRUE(invariant_named("finite")->proved_models().empty());
  // Momentum is conserved by any law. `coulomb` may have several answers or none, and the proofs do not cover it.
  EXPECT_TRUE(is_proved_of("linear_momentum", Model::coulomb));
  EXPECT_TRUE(is_proved_of("restitution", Model::rough));
  EXPECT_FALSE(is_proved_of("restitution", Model::coulomb));
}

}  // namespace
}  // namespace carom::properties
