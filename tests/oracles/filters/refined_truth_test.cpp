// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/filters/refined_truth.hpp>

namespace carom::oracles {
namespace {

TEST(RefinedTruth, IsBoundedIfEachRadiusIsFinite) {
  const Enclosure unbounded = Enclosure(0x1p+1000) * Enclosure(0x1p+1000);
  Truth<Enclosure> truth;
  EXPECT_TRUE(is_bounded(truth));
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      Truth<Enclosure> of_one = truth;
      (*vectors(of_one.outcome)[k])[i] = unbounded;
      EXPECT_FALSE(is_bounded(of_one)) << i;
    }
  }
}

}  // namespace
}  // namespace carom::oracles
