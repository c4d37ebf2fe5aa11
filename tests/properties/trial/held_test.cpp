// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <carom/collision/precision.hpp>
#include <carom/properties/trial/held.hpp>

namespace carom::properties {
namespace {

bool is_held(const Collision& collision, Precision precision) {
  return why_not_held(collision, unit_roundoff(precision)).empty();
}

Collision ball_on_floor() {
  Collision c;
  c.a.position = {0.5, 1, 0.25};
  c.a.velocity = {0, -1, 0};
  c.b.immovable = true;
  return c;
}

TEST(Held, IsWhatABallOnAFloorIs) {
  EXPECT_TRUE(is_held(ball_on_floor(), Precision::binary32));
  EXPECT_TRUE(is_held(ball_on_floor(), Precision::binary64));
}

/// 10⁶ m from the origin 1024 u are 61 m in binary32, and 10⁻⁷ m in binary64.
TEST(Held, IsNoLeverArmThatItsPlacesLose) {
  Collision c = ball_on_floor();
  for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
    (*place)[0] += 1e6;
  }
  EXPECT_FALSE(is_held(c, Precision::binary32));
  EXPECT_TRUE(is_held(c, Precision::binary64));
  c.a.position = c.point;
  EXPECT_TRUE(is_held(c, Precision::binary32));
}

TEST(Held, IsNoSpinAlongNormalAndLeverArmThatDwarfsTheApproach) {
  Collision c = ball_on_floor();
  c.normal = {1, 2, 3};
  c.a.position = {1, 2, 3};
  c.a.velocity = {-1, -2, -3};
  EXPECT_TRUE(is_held(c, Precision::binary64));
  c.a.angular_velocity = {1e6, 2e6, 3e6};
  EXPECT_FALSE(is_held(c, Precision::binary64));
  c.a.angular_velocity = {3e6, 2e6, 1e6};  // inputs account for the rounding of what does not vanish
  EXPECT_TRUE(is_held(c, Precision::binary64));
}

/// A rod of 1 m and 10⁻⁴ m, 50 m from the origin, where binary32 rounds by 3 × 10⁻⁶ m.
TEST(Held, IsNoRodThinnerThanItsPlacesAreRounded) {
  Collision c = ball_on_floor();
  c.a.principal_inertia = {1e-8, 1, 1};
  EXPECT_TRUE(is_held(c, Precision::binary32));
  for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
    (*place)[0] += 50;
  }
  EXPECT_FALSE(is_held(c, Precision::binary32));
  EXPECT_TRUE(is_held(c, Precision::binary64));
}

TEST(Held, IsNothingWhoseChangeOfSpinLeavesBinary32InBinary32) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-15, 0};
  c.a.mass = 1e-9;
  EXPECT_TRUE(is_held(c, Precision::binary32));
  c.a.principal_inertia.setConstant(1e15);
  EXPECT_FALSE(is_held(c, Precision::binary32));
  EXPECT_TRUE(is_held(c, Precision::binary64));
}

/// Each body is turned by its own lever arm: that of the other may be 10⁹ times as long.
TEST(Held, IsNothingWhereOneBodyTurnsLessThanBinary32Holds) {
  Collision c = ball_on_floor();
  c.a.velocity = {0, -1e-5, 0};
  c.a.position = c.point + Vector3<double>{1e-6, 1e-6, 0};
  c.a.principal_inertia.setConstant(1e26);
  c.b = c.a;
  c.b.velocity = {0, 0, 0};
  EXPECT_FALSE(is_held(c, Precision::binary32));
  c.b.position = c.point + Vector3<double>{1e3, 1e3, 0};
  c.b.principal_inertia.setConstant(1e6);
  EXPECT_FALSE(is_held(c, Precision::binary32));
  c.a = c.b;
  EXPECT_TRUE(is_held(c, Precision::binary32));
}

TEST(Held, IsNothingAtTheEndsOfBinary32InBinary32) {
  Collision c = ball_on_floor();
  c.a.principal_inertia.setConstant(1e37);
  EXPECT_FALSE(is_held(c, Precision::binary32));
  EXPECT_TRUE(is_held(c, Precision::binary64));
}

}  // namespace
}  // namespace carom::properties
