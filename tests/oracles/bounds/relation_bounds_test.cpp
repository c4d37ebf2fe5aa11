// SPDX-License-Identifier: BSL-1.0
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/invariants/invariant.hpp>

#include "support/exact.hpp"

/// Relations (properties/invariants/relations.cpp) round the numbers of a collision to fewer bits, so that the related
/// collision is exact.
namespace carom::bounds {
namespace {

std::vector<Collision> asked_by(std::string_view relation, const Collision& collision) {
  const auto& about = std::get<properties::AboutRelation>(properties::invariant_named(relation)->about);
  return std::get<properties::AboutRelation::OfCollision>(about.ask)(collision);
}

using oracles::Rational;

Vector3<Rational> exactly(const Vector3<double>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

Vector3<Rational> exact_difference(const Vector3<double>& x, const Vector3<double>& y) {
  return exactly(x) - exactly(y);
}

/// Numbers below 2^e are rounded to multiples of 2^(e − 48), and the added offset is at most 2^e. So sums have at most
/// 49 bits.
TEST(RelationBounds, AddTheSameToEachVelocityAndPlace) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    const std::vector<Collision> moving = asked_by("galilean", one.collision);
    const Vector3<Rational> added = exact_difference(moving[1].a.velocity, moving[0].a.velocity);
    EXPECT_EQ(exact_difference(moving[1].b.velocity, moving[0].b.velocity), added) << family;
    EXPECT_NE(added[0], 0) << family;
    const std::vector<Collision> moved = asked_by("translation", one.collision);
    const Vector3<Rational> step = exact_difference(moved[1].point, moved[0].point);
    EXPECT_EQ(exact_difference(moved[1].a.position, moved[0].a.position), step) << family;
    EXPECT_EQ(exact_difference(moved[1].b.position, moved[0].b.position), step) << family;
    EXPECT_NE(step[0], 0) << family;
  }
}

/// Three times a velocity of 50 bits has at most 52 bits.
TEST(RelationBounds, MultiplyVelocitiesByThree) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    const std::vector<Collision> asked = asked_by("homogeneous", one.collision);
    const Outcome<double> slow = unchanged(asked[0]);
    const Outcome<double> fast = unchanged(asked[1]);
    for (const OutcomeVector k : all_outcome_vectors) {
      EXPECT_EQ(exactly(*vectors(fast)[k]), Vector3<Rational>(exactly(*vectors(slow)[k]) * Rational(3))) << family;
    }
  }
}

/// The approach and the added velocity have 20 bits each, thirty places apart. So their sum has 50 bits.
TEST(RelationBounds, AddATangentialVelocity) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    if (one.collision.a.immovable && one.collision.b.immovable) {
      continue;
    }
    const std::vector<Collision> asked = asked_by("continuous", one.collision);
    const bool of_b = one.collision.a.immovable;
    const Vector3<Rational> added =
        exact_difference((of_b ? asked[1].b : asked[1].a).velocity, (of_b ? asked[0].b : asked[0].a).velocity);
    EXPECT_EQ(added.dot(exactly(asked[0].normal)), 0) << family;
    EXPECT_NE(added.dot(added), 0) << family;
  }
}

}  // namespace
}  // namespace carom::bounds
