// SPDX-License-Identifier: BSL-1.0
#include "features/triples.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/families/body_pairs.hpp>
#include <carom/properties/features/coverage.hpp>

namespace carom::properties {
namespace {

TEST(Triples, AreThoseOfTheFeaturesThatACollisionHas) {
  Stream stream = stream_from(3);
  const Collision c = general_bodies(stream).collision;
  TripleCoverage coverage;
  EXPECT_EQ(coverage.met(), 0U);
  EXPECT_EQ(coverage.missing().size(), TripleCoverage::feasible());
  coverage.add(c);
  const std::uint64_t features = features_of(c).size();
  EXPECT_EQ(coverage.met(), features * (features - 1) * (features - 2) / 6);
  const auto has = [&](const Feature* feature) { return feature->is_present(c); };
  for (const auto& [x, y, z] : coverage.missing()) {
    ASSERT_FALSE(has(x) && has(y) && has(z)) << x->name << ' ' << y->name << ' ' << z->name;
  }
}

TEST(Triples, AreTheUnionOfWhatPartsMet) {
  TripleCoverage both;
  TripleCoverage one;
  TripleCoverage other;
  for (std::uint64_t i = 0; i < 4; ++i) {
    Stream stream = stream_from(i);
    const Collision c = general_bodies(stream).collision;
    both.add(c);
    (i % 2 == 0 ? one : other).add(c);
  }
  EXPECT_LT(one.met(), both.met());
  one |= other;
  EXPECT_EQ(one.met(), both.met());
}

}  // namespace
}  // namespace carom::properties
