// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/polyhedra/distance.hpp>

#include "distance_by_features.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

Placement placed(properties::Stream& stream, const Vector& position) {
  return {unit::unit_quaternion(stream), position, 0, 0};
}

/// A pose that sometimes makes faces and edges of two boxes parallel: a quarter turn, or a rotation about z.
Placement plain_pose(properties::Stream& stream, const Vector& position) {
  Placement placement{{1, 0, 0, 0}, position, 0, 0};
  if (stream.chance(2)) {
    placement.orientation = {1, 0, 0, stream.signed_unit()};
  }
  if (stream.chance(4)) {
    placement.orientation = {1, 1, 0, 0};
  }
  return placement;
}

ConvexShape random_shape(properties::Stream& stream) {
  return stream.chance(6) ? ball_shape(stream.between(0.1, 1)) : convex_shape(unit::random_body(stream));
}

struct Posed {
  ConvexShape a;
  ConvexShape b;
  Placement at_a;
  Placement at_b;
};

/// Two bodies at a distance of about `gap`, moved towards each other along the normal of their separation.
Posed posed(properties::Stream& stream, double gap) {
  const bool plain = stream.chance(4);
  const auto shape = [&] {
    return plain ? convex_shape(unit::body_of(unit::box_points({stream.between(0.25, 2), stream.between(0.25, 2), 1})))
                 : random_shape(stream);
  };
  Posed p{shape(), shape(), {}, {}};
  const auto pose = [&](const Vector& at) { return plain ? plain_pose(stream, at) : placed(stream, at); };
  p.at_b = pose(stream.vector());
  p.at_a = pose(p.at_b.position + 6 * unit::unit_vector(stream));
  const ShapePair pair(p.a, p.b);
  for (int i = 0; i < 30; ++i) {  // each step moves A by the excess of the gap
    const Separation now = pair.separation(p.at_a, p.at_b);
    p.at_a.position -= (now.gap - gap) * now.normal;
  }
  return p;
}

TEST(ShapePair, FindsTheDistanceAndCertifiesNoMoreAtEveryScaleOfTheGap) {
  for (const double gap : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      properties::Stream stream = properties::stream_from(seed);
      const Posed p = posed(stream, gap);
      const Separation found = ShapePair(p.a, p.b).separation(p.at_a, p.at_b);
      const auto truth = static_cast<double>(unit::distance_by_features(p.a, p.at_a, p.b, p.at_b));
      ASSERT_LE(found.certified, truth) << seed;
      EXPECT_NEAR(found.gap, truth, 1e-14) << "seed " << seed << ", gap " << gap;
      EXPECT_NEAR(found.certified, found.gap, 1e-12);
      EXPECT_NEAR(found.normal.norm(), 1, 0x1p-51);
    }
  }
}

TEST(ShapePair, CertifiesLessByTheErrorsOfThePlacements) {
  properties::Stream stream = properties::stream_from(1);
  Posed p = posed(stream, 0.5);
  const ShapePair pair(p.a, p.b);
  const Separation exact = pair.separation(p.at_a, p.at_b);
  p.at_a.position_error = 0.01;
  p.at_b.angle_error = 0.02;
  const Separation found = pair.separation(p.at_a, p.at_b);
  EXPECT_EQ(found.gap, exact.gap);
  EXPECT_NEAR(found.certified, exact.certified - 0.01 - 0.02 * p.b.core_radius, 1e-15);
}

/// The distance depends only on the difference of the positions, also far from the origin.
TEST(ShapePair, CertifiesTheDistanceFarFromTheOrigin) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Posed p = posed(stream, 1e-6);
    const Vector shift = std::ldexp(1.0, 20) * stream.vector();
    p.at_a.position += shift;
    p.at_b.position += shift;
    const Separation found = ShapePair(p.a, p.b).separation(p.at_a, p.at_b);
    // The difference of doubles so close to each other is exact.
    p.at_a.position -= p.at_b.position;
    p.at_b.position.setZero();
    const auto truth = static_cast<double>(unit::distance_by_features(p.a, p.at_a, p.b, p.at_b));
    EXPECT_LE(found.certified, truth) << seed;
    EXPECT_NEAR(found.certified, truth, 1e-12) << seed;
  }
}

Posed scaled(const Posed& posed, double scale) {
  Posed p = posed;
  for (auto* shape : {&p.a, &p.b}) {
    for (Vector& vertex : shape->core.vertices) {
      vertex *= scale;
    }
    shape->core_radius *= scale;
    shape->margin *= scale;
  }
  p.at_a.position *= scale;
  p.at_b.position *= scale;
  return p;
}

TEST(ShapePair, FindsTheSameDistanceInEveryUnitOfLength) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Posed p = posed(stream, stream.power_of_ten(-9, 0));
    const Separation one = ShapePair(p.a, p.b).separation(p.at_a, p.at_b);
    for (const double scale : {0x1p-30, 0x1p30}) {
      const Posed q = scaled(p, scale);
      const Separation other = ShapePair(q.a, q.b).separation(q.at_a, q.at_b);
      EXPECT_EQ(other.gap, one.gap * scale) << seed;
      EXPECT_EQ(other.normal, one.normal) << seed;
    }
  }
}

TEST(ShapePair, FindsTheDistanceOfBodiesOfUnequalSizes) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Posed p{convex_shape(unit::random_body(stream)), convex_shape(unit::random_body(stream)), {}, {}};
    p = scaled(p, 1e-4);
    p.b = convex_shape(unit::random_body(stream));
    p.at_b = placed(stream, {0, 0, 0});
    p.at_a = placed(stream, 6 * unit::unit_vector(stream));
    const ShapePair pair(p.a, p.b);
    for (int i = 0; i < 30; ++i) {
      const Separation now = pair.separation(p.at_a, p.at_b);
      p.at_a.position -= (now.gap - 1e-7) * now.normal;
    }
    const Separation found = pair.separation(p.at_a, p.at_b);
    const auto truth = static_cast<double>(unit::distance_by_features(p.a, p.at_a, p.b, p.at_b));
    EXPECT_LE(found.certified, truth) << seed;
    EXPECT_NEAR(found.gap, truth, 1e-14) << seed;
  }
}

TEST(ShapePair, FindsTheDepthOfAnOverlap) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({2, 2, 2})));
  const ShapePair cubes(cube, cube);
  const Separation found = cubes.separation({{1, 0, 0, 0}, {0.25, 0.5, 1.9}, 0, 0}, {});
  EXPECT_NEAR(found.gap, -0.1, 1e-15);
  EXPECT_EQ(found.normal, Vector(0, 0, 1));
  EXPECT_LT(found.certified, 0);
  EXPECT_NEAR(cubes.separation({}, {}).gap, -2, 1e-15);

  const Separation ball = ShapePair(ball_shape(0.5), cube).separation({{1, 0, 0, 0}, {0, 0, 0.75}, 0, 0}, {});
  EXPECT_NEAR(ball.gap, -0.75, 1e-15);
  EXPECT_EQ(ball.normal, Vector(0, 0, 1));
  EXPECT_EQ(ShapePair(ball_shape(1), ball_shape(2)).separation({}, {}).gap, -3);
}

TEST(Separation, FromAHalfSpaceIsThatOfTheLowestPoint) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({2, 2, 2})));
  const HalfSpace slope{Vector(0, 3, 4) / 5, 1};
  const Separation found = separation(cube, {{1, 0, 0, 0}, {7, 0, 5}, 0, 0}, slope);
  EXPECT_NEAR(found.gap, (4.0 * 4 - 3) / 5 - 1, 1e-15);
  EXPECT_LE(found.certified, found.gap);
  EXPECT_NEAR(found.certified, found.gap, 1e-12);
  const Separation ball = separation(ball_shape(0.5), {{1, 0, 0, 0}, {0, 0, 2}, 0, 0}, {{0, 0, 1}, 1});
  EXPECT_EQ(ball.gap, 0.5);
}

}  // namespace
}  // namespace carom::scene
