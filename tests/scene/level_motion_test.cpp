// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/scene/crossing.hpp>
#include <carom/scene/level_motion.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

constexpr double gravity = 9.81;
constexpr double ball_radius = 0.375;
const Level floor_level{2, 1, gravity};
const MaterialPair cloth{0.5, 0.25, 0, 0.0625, 0.125};
const MaterialPair without_resistance{0.5, 0.25, 0, 0, 0};

Arc arc_of(const Vector& v, const Vector& w, const MaterialPair& pair, double start = 0) {
  return level_arc(floor_level, 3, pair, true, ball_radius, start, {1, 2, ball_radius}, v, w);
}

Arc next(const Arc& arc, const MaterialPair& pair) {
  return after_end(floor_level, pair, true, arc, arc.path.end, position_at(arc.path, arc.path.end));
}

Vector slip(const Vector& v, const Vector& w) { return v - ball_radius * w.cross(Vector(0, 0, 1)); }

/// ½ v² + ½ (2/5) R² w² of a unit mass.
double energy(const Vector& v, const Vector& w) {
  return 0.5 * v.squaredNorm() + 0.2 * ball_radius * ball_radius * w.squaredNorm();
}

/// The rounding error of a few operations on numbers of size 1 to 10.
constexpr double few_roundings = 1e-14;

TEST(LevelMotion, EndsASlipInRollingAtFiveSeventhsOfTheVelocityAndTwoSeventhsOfTheSpin) {
  properties::Stream stream = properties::stream_from(1);
  for (int i = 0; i < 200; ++i) {
    const Vector v{3 * stream.signed_unit(), 3 * stream.signed_unit(), 0};
    const Vector w = 5 * stream.vector();
    const Arc sliding = arc_of(v, w, without_resistance, stream.unit());
    const Vector u = slip(v, w);
    if (u.norm() < 0.01) {
      continue;
    }
    ASSERT_EQ(sliding.turning.phase, Phase::sliding);
    EXPECT_EQ(sliding.turning.plane, 3U);
    EXPECT_EQ(sliding.path.acceleration.z(), 0);
    EXPECT_NEAR(sliding.path.acceleration.norm(), without_resistance.friction * gravity, few_roundings);
    EXPECT_NEAR(sliding.path.acceleration.dot(u), -without_resistance.friction * gravity * u.norm(), 8 * few_roundings);
    EXPECT_NEAR(sliding.path.end - sliding.path.start, 2 * u.norm() / (7 * without_resistance.friction * gravity),
                8 * few_roundings);
    EXPECT_EQ(sliding.turning.ending, Ending::slip);
    const Arc rolling = next(sliding, without_resistance);
    // Friction has no moment about the contact point, so the ball rolls with (5/7) v + (2/7) R w × n.
    const Vector rolls = (5.0 / 7) * v + (2.0 / 7) * ball_radius * w.cross(Vector(0, 0, 1));
    EXPECT_LE((rolling.path.velocity - rolls).norm(), 8 * few_roundings);
    ASSERT_EQ(rolling.turning.phase, Phase::rolling);
    EXPECT_LE(slip(rolling.path.velocity, rolling.turning.angular_velocity).norm(), few_roundings);
    EXPECT_EQ(rolling.turning.angular_velocity.z(), w.z());
    EXPECT_EQ(rolling.path.acceleration, Vector(0, 0, 0));
    EXPECT_EQ(rolling.path.end, never);
    // Friction takes the energy u²/7 of a unit mass.
    EXPECT_NEAR(energy(v, w) - energy(rolling.path.velocity, rolling.turning.angular_velocity), u.squaredNorm() / 7,
                32 * few_roundings);
  }
}

TEST(LevelMotion, EndsARollAfterTheDistanceThatRollingResistanceTakes) {
  const double v = 1.5;
  const Arc rolling = arc_of({0, v, 0}, Vector(-v / ball_radius, 0, 0), cloth);
  ASSERT_EQ(rolling.turning.phase, Phase::rolling);
  EXPECT_EQ(rolling.turning.ending, Ending::roll);
  EXPECT_NEAR(rolling.path.end, v / (cloth.rolling_resistance * gravity), few_roundings);
  EXPECT_NEAR(position_at(rolling.path, rolling.path.end).y() - 2, v * v / (2 * cloth.rolling_resistance * gravity),
              8 * few_roundings);
  const double middle = 0.5 * rolling.path.end;
  EXPECT_LE(slip(velocity_at(rolling.path, middle), angular_velocity_at(rolling, middle)).norm(), few_roundings);
  const Arc rests = next(rolling, cloth);
  EXPECT_EQ(rests.turning.phase, Phase::resting);
  EXPECT_EQ(rests.path.velocity, Vector(0, 0, 0));
  EXPECT_EQ(rests.path.acceleration, Vector(0, 0, 0));
  EXPECT_EQ(rests.turning.angular_velocity, Vector(0, 0, 0));
  EXPECT_EQ(rests.turning.angular_acceleration, Vector(0, 0, 0));
  EXPECT_EQ(rests.path.end, never);
}

TEST(LevelMotion, EndsASpinAfterTheTimeThatSpinningResistanceTakes) {
  for (const double spin : {4.0, -4.0}) {
    const Arc arc = arc_of({0, 0, 0}, {0, 0, spin}, cloth);
    ASSERT_EQ(arc.turning.phase, Phase::resting);
    EXPECT_EQ(arc.turning.ending, Ending::spin);
    EXPECT_NEAR(arc.path.end, 4 / (2.5 * cloth.spinning_resistance * gravity / ball_radius), few_roundings);
    EXPECT_NEAR(angular_velocity_at(arc, 0.5 * arc.path.end).z(), 0.5 * spin, few_roundings);
    const Arc still = next(arc, cloth);
    EXPECT_EQ(still.turning.angular_velocity, Vector(0, 0, 0));
    EXPECT_EQ(still.turning.ending, Ending::none);
    EXPECT_EQ(still.path.end, never);
  }
}

TEST(LevelMotion, LosesEnergyInEachPhaseUntilTheSphereRests) {
  properties::Stream stream = properties::stream_from(5);
  for (int i = 0; i < 100; ++i) {
    Arc arc = arc_of({stream.signed_unit(), stream.signed_unit(), 0}, 5 * stream.vector(), cloth);
    double before = energy(arc.path.velocity, arc.turning.angular_velocity);
    int phases = 0;
    while (arc.path.end < never) {
      ASSERT_LE(++phases, 8);
      const Ending ending = arc.turning.ending;
      arc = next(arc, cloth);
      const double after = energy(arc.path.velocity, arc.turning.angular_velocity);
      EXPECT_LE(after, before * (1 + 16 * roundoff));
      before = after;
      if (ending == Ending::spin) {
        EXPECT_EQ(arc.turning.angular_velocity.z(), 0);
      } else if (ending == Ending::slip) {
        EXPECT_TRUE(arc.turning.phase == Phase::rolling || arc.turning.phase == Phase::resting);
      } else {
        EXPECT_EQ(arc.path.velocity, Vector(0, 0, 0));
      }
    }
    EXPECT_EQ(before, 0);
    EXPECT_EQ(arc.turning.phase, Phase::resting);
  }
}

TEST(LevelMotion, WithoutFrictionSlidesForever) {
  const Vector v{1, 2, 0};
  const Vector w{3, 4, 5};
  const Arc arc = level_arc(floor_level, 0, cloth, false, ball_radius, 0, {0, 0, ball_radius}, v, w);
  EXPECT_EQ(arc.turning.phase, Phase::sliding);
  EXPECT_EQ(arc.path.velocity, v);
  EXPECT_EQ(arc.turning.angular_velocity, w);
  EXPECT_EQ(arc.path.acceleration, Vector(0, 0, 0));
  EXPECT_EQ(arc.path.end, never);
  MaterialPair smooth = cloth;
  smooth.friction = 0;
  const Arc also = arc_of(v, {3, 4, 0}, smooth);
  EXPECT_EQ(also.turning.phase, Phase::sliding);
  EXPECT_EQ(also.path.end, never);
}

/// If gravity presses a ball against a wall or a ceiling, the motion is the same, rotated.
TEST(LevelMotion, IsTheSameOnEveryAxis) {
  const Arc arc = arc_of({1, 0.5, 0}, {2, -3, 4}, cloth);
  // x → y → z → x
  const auto turned = [](const Vector& x) { return Vector(x.z(), x.x(), x.y()); };
  const Arc other = level_arc({0, 1, gravity}, 3, cloth, true, ball_radius, 0, turned({1, 2, ball_radius}),
                              turned({1, 0.5, 0}), turned({2, -3, 4}));
  EXPECT_LE((other.path.acceleration - turned(arc.path.acceleration)).norm(), few_roundings);
  EXPECT_LE((other.turning.angular_acceleration - turned(arc.turning.angular_acceleration)).norm(), 8 * few_roundings);
  EXPECT_NEAR(other.path.end, arc.path.end, few_roundings);
  const auto over = [](const Vector& x) { return Vector(x.x(), -x.y(), -x.z()); };
  const Arc below = level_arc({2, -1, gravity}, 3, cloth, true, ball_radius, 0, over({1, 2, ball_radius}),
                              over({1, 0.5, 0}), over({2, -3, 4}));
  EXPECT_LE((below.path.acceleration - over(arc.path.acceleration)).norm(), few_roundings);
  EXPECT_LE((below.turning.angular_acceleration - over(arc.turning.angular_acceleration)).norm(), 8 * few_roundings);
}

}  // namespace
}  // namespace carom::scene
