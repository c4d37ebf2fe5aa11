// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/properties/invariants/theorems.hpp>

namespace carom::properties {
namespace {

TEST(Theorems, ProveInvariantsOfTheLawsThatClaimThem) {
  for (const Proved& proved : proved_invariants()) {
    const Invariant* invariant = invariant_named(proved.invariant);
    ASSERT_NE(invariant, nullptr) << proved.invariant;
    EXPECT_FALSE(theorems_of(proved.invariant).empty()) << proved.invariant;
    const std::vector<Model> models = proved_models(*invariant);
    EXPECT_FALSE(models.empty()) << proved.invariant;
    for (const Model model : models) {
      EXPECT_TRUE(invariant->claimed_for(model)) << proved.invariant;
      EXPECT_TRUE(proved.of == ProvedOf::every_impulse || determines_outcome(model)) << proved.invariant;
    }
  }
  EXPECT_TRUE(theorems_of("finite").empty());
  EXPECT_TRUE(proved_models(*invariant_named("finite")).empty());
  // Whatever the law, momentum is kept; `coulomb` may have several answers or none, and the proofs leave it out.
  const std::vector<Model> of_momentum = proved_models(*invariant_named("linear_momentum"));
  EXPECT_NE(std::ranges::find(of_momentum, Model::coulomb), of_momentum.end());
  const std::vector<Model> of_restitution = proved_models(*invariant_named("restitution"));
  EXPECT_EQ(std::ranges::find(of_restitution, Model::coulomb), of_restitution.end());
}

}  // namespace
}  // namespace carom::properties
