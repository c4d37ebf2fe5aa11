// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <carom/scene/polyhedra/distance.hpp>

#include "distance_by_features.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

Placement placed(properties::Stream& stream, const Vector& position) {
  return {unit::unit_quaternion(stream), position, 0, 0};
}

/// A box at times in a pose that makes faces and edges of two boxes parallel: quarter turns, or a turn about z.
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

/// Two bodies that are about `gap` apart: far ones, brought nearer along the direction of their distance.
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
  for (int i = 0; i < 30; ++i) {  // each step brings them nearer by almost what they may be
    const Separation now = pair.separation(p.at_a, p.at_b);
    p.at_a.position -= (now.gap - gap) * now.normal;
  }
  return p;
}

TEST(ShapePair, FindsTheDistanceAtEveryScaleOfTheGap) {
  std::vector<double> errors;
  for (const double gap : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    double worst = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      properties::Stream stream = properties::stream_from(seed);
      const Posed p = posed(stream, gap);
      const Separation found = ShapePair(p.a, p.b).separation(p.at_a, p.at_b);
      const auto truth = static_cast<double>(unit::distance_by_features(p.a, p.at_a, p.b, p.at_b));
      ASSERT_LE(found.certified, truth) << seed;
      EXPECT_NEAR(found.gap, truth, 1e-14 + 1e-11 * gap) << "seed " << seed << ", gap " << gap;
      EXPECT_NEAR(found.certified, found.gap, 1e-12);
      EXPECT_NEAR(found.normal.norm(), 1, 0x1p-51);
      worst = std::max(worst, std::abs(found.gap - truth));
    }
    std::printf("gap %g: worst %g\n", gap, worst);
  }
}

TEST(ShapePair, Costs) {
  properties::Stream stream = properties::stream_from(1);
  for (const double gap : {1.0, 1e-3, 1e-6, 1e-9}) {
    double sum = 0;
    double worst = 0;
    int n = 0;
    for (int k = 0; k < 100; ++k) {
      Posed p = posed(stream, gap);
      if (p.a.margin > 0 || p.b.margin > 0) continue;
      const ShapePair pair(p.a, p.b);
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < 20; ++i) {
        (void)pair.separation(p.at_a, p.at_b);
      }
      const double us =
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / 20;
      sum += us;
      worst = std::max(worst, us);
      ++n;
    }
    std::printf("gap %g: %g us mean, worst %g\n", gap, sum / n, worst);
  }
}

}  // namespace
}  // namespace carom::scene
