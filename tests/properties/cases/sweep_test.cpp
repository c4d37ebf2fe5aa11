// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

const Sweep& sweep_named(std::string_view name) {
  return *std::find_if(all_sweeps().begin(), all_sweeps().end(),
                       [&](const Sweep& sweep) { return sweep.name == name; });
}

Collision at(std::string_view sweep, double quantity) {
  Stream stream = stream_from(5);
  return sweep_named(sweep).generate(stream, quantity);
}

TEST(Sweeps, GiveValidCollisionsAtEveryDecade) {
  for (const Sweep& sweep : all_sweeps()) {
    const int step = sweep.last_exponent > sweep.first_exponent ? 1 : -1;
    for (int k = sweep.first_exponent; k != sweep.last_exponent + step; k += step) {
      for (std::uint64_t i = 0; i < 20; ++i) {
        Stream stream = stream_from(i);
        EXPECT_TRUE(validate(sweep.generate(stream, std::pow(10, k))).empty()) << sweep.name << " 1e" << k;
      }
    }
  }
}

TEST(Sweeps, SetTheQuantityThatTheyAreNamedAfter) {
  for (const double quantity : {1e2, 1e6}) {
    // The ratios have at most ten roundings.
    const double rounding = 10 * 0x1p-53 * quantity;
    const Vector3<double> rod = at("slenderness", quantity).a.principal_inertia;
    EXPECT_NEAR(rod.maxCoeff() / rod.minCoeff(), quantity, rounding);
    const auto size_of_a = [](const Collision& c) { return features::radius_of_gyration(c.a); };
    EXPECT_NEAR(size_of_a(at("large_size", quantity)) / size_of_a(at("large_size", 1)), quantity, rounding);
    EXPECT_NEAR(size_of_a(at("size_ratio", quantity)) / size_of_a(at("size_ratio", 1)), quantity, rounding);
    EXPECT_EQ(at("small_restitution", 1 / quantity).restitution, 1 / quantity);
  }
}

}  // namespace
}  // namespace carom::properties
