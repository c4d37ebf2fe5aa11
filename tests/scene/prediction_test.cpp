// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/prediction.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::path_of;
using unit::Vector;

/// The fault of the bounds on the time of contact up to a horizon; empty if the bounds are right.
std::string wrong_with(const TimeBounds& found, const std::optional<ExactTime>& truth, double horizon) {
  const bool in_time = truth && *truth <= ExactTime::at(horizon);
  if (found.earliest == never) {
    return in_time ? "a contact is lost" : "";
  }
  if (!truth) {
    return "a contact that is not";
  }
  if (found.earliest > horizon) {
    return "a contact beyond the horizon";
  }
  return ExactTime::at(found.earliest) <= *truth && *truth <= ExactTime::at(found.latest) ? ""
                                                                                          : "not within the bounds";
}

struct Pair {
  Path a, b;
};

/// Two spheres that do not overlap at 0, with different accelerations. The second sphere is thrown at or near the
/// first.
Pair random_pair(properties::Stream& stream) {
  const double size = stream.power_of_ten(-1, 1);
  const Path a = path_of(stream.vector() * size, stream.vector(), stream.vector(), stream.between(0.05, 0.5),
                         stream.chance(2) ? 0 : -stream.unit());
  for (;;) {
    const double time = stream.between(0.1, 2);
    const double radius = stream.between(0.05, 0.5);
    const Vector acceleration = stream.chance(3) ? Vector(0, 0, 0) : Vector(stream.vector());
    const Vector position = position_at(a, 0) + stream.vector() * 3;
    const Vector target = position_at(a, time) + stream.vector() * (a.radius + radius);
    const Vector velocity = (target - position) / time - 0.5 * time * acceleration;
    const Path b = path_of(position, velocity, acceleration, radius);
    if (sign_of_gap(a, b, 0) >= 0) {
      return {a, b};
    }
  }
}

TEST(ContactBetween, TwoPathsHasBoundsThatContainTheExactTime) {
  for (const bool is_quadratic : {false, true}) {
    int contacts = 0;
    int misses = 0;
    ExactCounts counts;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      properties::Stream stream = properties::stream_from(seed);
      Pair pair = random_pair(stream);
      if (is_quadratic) {
        pair.b.velocity += 0.5 * (pair.b.acceleration - pair.a.acceleration);
        pair.b.acceleration = pair.a.acceleration;
        measure(pair.b);
      }
      const double horizon = stream.integer(1, 32) / 8.0;
      const RelativeState relative(state_at(pair.a, 0), state_at(pair.b, 0), pair.a.radius + pair.b.radius);
      const TimeBounds found = contact_between(pair.a, pair.b, relative, 0, horizon, counts);
      ++(found.earliest < never ? contacts : misses);
      ASSERT_EQ(wrong_with(found, exact_contact(pair.a, pair.b, 0), horizon), "");
      const bool is_apart = stay_apart(pair.a, pair.b, relative, 0, horizon);
      ASSERT_TRUE(!is_apart || found.earliest == never);
      // Speeds are near 1 and distances near 3, so all bounds are narrower than a millionth.
      ASSERT_TRUE(found.earliest == never || found.latest - found.earliest <= 1e-6);
    }
    EXPECT_GT(contacts, is_quadratic ? 50 : 100);
    EXPECT_GT(misses, 50);
    EXPECT_LT(counts.predictions, 40U);  // bounds decide nearly all
  }
}

TEST(ContactBetween, APathAndAPlaneHasBoundsThatContainTheExactTime) {
  int contacts = 0;
  ExactCounts counts;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Vector normal = stream.direction();
    const Path path = path_of(3 * stream.vector(), stream.vector(), stream.vector(), 0.25, -stream.unit());
    Reach reach{normal, reach_of(normal, stream.vector(), path.radius)};
    if (sign_of_gap(path, reach, 0) < 0) {
      reach = {-normal, reach_of(-normal, stream.vector(), path.radius)};
      if (sign_of_gap(path, reach, 0) < 0) {
        continue;
      }
    }
    const TimeBounds found = contact_between(path, reach, 0, 4, counts);
    contacts += found.earliest < never ? 1 : 0;
    ASSERT_EQ(wrong_with(found, exact_contact(path, reach, 0), 4), "") << seed;
  }
  EXPECT_GT(contacts, 100);
}

TEST(Quartic, IsUndecidedIfItTouchesZero) {
  // (t − 1/2)⁴ touches 0, and (t − 1/2)⁴ + 2⁻⁴⁰ does not.
  const UncertainQuartic touching{{1.0 / 16, -1.0 / 16, 1.0 / 16, -1.0 / 16, 1.0 / 16}, 0x1p-50, 1};
  EXPECT_EQ(first_crossing(touching).decision, Decision::undecided);
  UncertainQuartic above = touching;
  for (double& coefficient : above.bernstein) {
    coefficient += 0x1p-40;
  }
  EXPECT_EQ(first_crossing(above).decision, Decision::none);
}

/// (x² − 1/64)(x² − 9/64) with x = t − 1/2, on the interval of length 1 from t = `begin`. The roots are t = 1/8, 3/8,
/// 5/8 and 7/8.
UncertainQuartic with_four_roots(double begin) {
  const double x = begin - 0.5;
  // The Taylor coefficients at x.
  const double c0 = (x * x - 1.0 / 64) * (x * x - 9.0 / 64);
  const double c1 = 4 * x * x * x - 20.0 / 64 * x;
  const double c2 = 6 * x * x - 10.0 / 64;
  const double c3 = 4 * x;
  return {
      {c0, c0 + c1 / 4, c0 + c1 / 2 + c2 / 6, c0 + 3 * c1 / 4 + c2 / 2 + c3 / 4, c0 + c1 + c2 + c3 + 1}, 0x1p-48, 1};
}

/// From 0 on, the root is a point of subdivision. An event takes place at the earlier bound, so the bounds must be
/// narrow.
TEST(Quartic, HasNarrowBoundsOfTheFirstOfFourRoots) {
  for (const double begin : {0.03, 0.0}) {
    const Crossing found = first_crossing(with_four_roots(begin));
    ASSERT_EQ(found.decision, Decision::bounded);
    EXPECT_NEAR(found.s, 0.125 - begin, found.error);
    // The slope at the root is −3/32, so an error of 2⁻⁴⁸ in height is 11 · 2⁻⁴⁸ in time. Bisection reaches this error
    // within a factor of 8.
    EXPECT_LE(found.error, 128 * 0x1p-48);
  }
}

}  // namespace
}  // namespace carom::scene
