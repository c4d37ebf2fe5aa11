// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/moderate.hpp>

#include "support/known_collisions.hpp"

namespace carom::oracles {
namespace {

struct ModerateRange {
  double smallest;
  double largest;
};

ModerateRange moderate_range(const std::string& field) {
  if (field == "normal" || field == "orientation") {
    return {smallest_moderate_direction, largest_moderate_direction};
  }
  if (field == "principal_inertia") {
    return {smallest_moderate_moment, largest_moderate_moment};
  }
  return {smallest_moderate, field == "mass" ? largest_moderate_mass : largest_moderate};
}

/// Whether the collision is moderate if the number with this index becomes `number`.
bool is_moderate_with(int index, double number) {
  Collision c = unit::plain_collision();
  int next = 0;
  for_each_number(
      [&](const FieldPath& /*path*/, double& of) {
        if (next++ == index) {
          of = number;
        }
      },
      c);
  return is_moderate(c);
}

TEST(Moderate, EndsAtTheLimitsOfEachNumber) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Collision plain = unit::plain_collision();
  int index = 0;
  for_each_number(
      [&](const FieldPath& path, const double& /*number*/) {
        const ModerateRange range = moderate_range(std::string(path.field));
        for (const double sign : {1.0, path.field == "mass" ? 1.0 : -1.0}) {
          EXPECT_TRUE(is_moderate_with(index, sign * range.smallest)) << path.text();
          EXPECT_TRUE(is_moderate_with(index, sign * range.largest)) << path.text();
          EXPECT_FALSE(is_moderate_with(index, sign * std::nextafter(range.smallest, 0.0))) << path.text();
          EXPECT_FALSE(is_moderate_with(index, sign * std::nextafter(range.largest, infinity))) << path.text();
        }
        EXPECT_TRUE(path.field == "mass" || is_moderate_with(index, 0)) << path.text();
        ++index;
      },
      plain);
}

/// A body of equal moments J and mass m has the extent √(J / (2m)).
TEST(Moderate, EndsAtTheLimitsOfMomentsAndExtents) {
  for (const bool a : {true, false}) {
    Collision c = unit::plain_collision();
    Body& body = a ? c.a : c.b;
    body.mass = largest_moderate_mass;
    body.principal_inertia.setConstant(largest_moderate_moment);
    EXPECT_TRUE(is_moderate(c));
    body.mass = smallest_moderate;
    body.principal_inertia.setConstant(2 * smallest_moderate * largest_moderate * largest_moderate);
    EXPECT_EQ(extent_of(body), largest_moderate);
    EXPECT_TRUE(is_moderate(c));
    body.principal_inertia *= 1 + 0x1p-40;
    EXPECT_FALSE(is_moderate(c));
  }
}

}  // namespace
}  // namespace carom::oracles
