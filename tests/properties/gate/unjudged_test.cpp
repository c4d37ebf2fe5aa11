// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/collision/precision.hpp>
#include <carom/properties/gate/unjudged.hpp>

namespace carom::properties {
namespace {

std::optional<Unjudged> reason(const Collision& collision, Precision precision) {
  return reason_unjudged(oracles::ExactCase(collision), oracles::Yardstick::of(precision));
}

bool is_judged(const Collision& collision, Precision precision) { return !reason(collision, precision); }

Collision ball_on_floor() {
  Collision c;
  c.a.position = {0.5, 1, 0.25};
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  return c;
}

TEST(Unjudged, DoesNotIncludeABallOnAFloor) {
  EXPECT_TRUE(is_judged(ball_on_floor(), Precision::binary32));
  EXPECT_TRUE(is_judged(ball_on_floor(), Precision::binary64));
}

TEST(Unjudged, IsAChangeOfSpinThatLeavesTheRangeOfBinary32) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-15, 0};
  c.a.mass = 1e-9;
  EXPECT_TRUE(is_judged(c, Precision::binary32));
  c.a.principal_inertia.setConstant(1e15);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  EXPECT_TRUE(is_judged(c, Precision::binary64));
}

/// The numbers of each body must stay in the range. The lever arm of the other body does not matter.
TEST(Unjudged, IsABodyThatTurnsLessThanBinary32Holds) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-5, 0};
  c.a.position = c.point + Vector3<double>{1e-6, 1e-6, 0};
  c.a.principal_inertia.setConstant(1e26);
  c.b = c.a;
  c.b.velocity = {0, 0, 0};
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  c.b.position = c.point + Vector3<double>{1e3, 1e3, 0};
  c.b.principal_inertia.setConstant(1e6);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  c.a = c.b;
  EXPECT_TRUE(is_judged(c, Precision::binary32));
}

TEST(Unjudged, IsAMomentAtTheEndOfTheRangeOfBinary32) {
  Collision c = ball_on_floor();
  c.a.principal_inertia.setConstant(1e37);
  EXPECT_EQ(reason(c, Precision::binary32), Unjudged::leaves_range);
  EXPECT_TRUE(is_judged(c, Precision::binary64));
}

/// At 10²⁰⁰ m from the origin, the allowance moves the lever arm by 10¹⁸⁵ m. The square of this distance overflows.
TEST(Unjudged, IsAnEnclosureThatIsNotFinite) {
  Collision c = ball_on_floor();
  c.a.position = {1e200, 1, 0};
  c.point = {1e200, 0, 0};
  EXPECT_EQ(reason(c, Precision::binary64), Unjudged::no_finite_enclosure);
}

}  // namespace
}  // namespace carom::properties
