// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/impulse/numbers/exact_sum.hpp>
#include <carom/scene/crossing.hpp>
#include <carom/scene/supported_motion.hpp>

#include "paths.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

constexpr double gravity = 9.81;
constexpr double ball_radius = 0.375;
const Support ground = *support_of({0, 0, 1}, {0, 0, -gravity});
const MaterialPair cloth{0.5, 0.25, 0, 0.0625, 0.125};
const MaterialPair without_resistance{0.5, 0.25, 0, 0, 0};

Arc arc_of(const Vector& v, const Vector& w, const MaterialPair& pair, double start = 0) {
  return supported_arc(ground, 3, pair, true, ball_radius, start, {1, 2, ball_radius}, v, w);
}

Arc next(const Arc& arc, const MaterialPair& pair) {
  return after_end(ground, pair, true, arc, arc.path.end, position_at(arc.path, arc.path.end));
}

Vector slip(const Vector& v, const Vector& w) { return v - ball_radius * w.cross(Vector(0, 0, 1)); }

/// ½ v² + ½ (2/5) R² w² of a unit mass.
double energy(const Vector& v, const Vector& w) {
  return 0.5 * v.squaredNorm() + 0.2 * ball_radius * ball_radius * w.squaredNorm();
}

/// The rounding error of a few operations on numbers of size 1 to 10.
constexpr double few_roundings = 1e-14;

TEST(SupportedMotion, EndsASlipInRollingAtFiveSeventhsOfTheVelocityAndTwoSeventhsOfTheSpin) {
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

TEST(SupportedMotion, EndsARollAfterTheDistanceThatRollingResistanceTakes) {
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

TEST(SupportedMotion, EndsASpinAfterTheTimeThatSpinningResistanceTakes) {
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

TEST(SupportedMotion, LosesEnergyInEachPhaseUntilTheSphereRests) {
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

TEST(SupportedMotion, WithoutFrictionSlidesForever) {
  const Vector v{1, 2, 0};
  const Vector w{3, 4, 5};
  const Arc arc = supported_arc(ground, 0, cloth, false, ball_radius, 0, {0, 0, ball_radius}, v, w);
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
TEST(SupportedMotion, IsTheSameOnEveryAxis) {
  const Arc arc = arc_of({1, 0.5, 0}, {2, -3, 4}, cloth);
  // x → y → z → x
  const auto turned = [](const Vector& x) { return Vector(x.z(), x.x(), x.y()); };
  const Arc other = supported_arc(*support_of({1, 0, 0}, {-gravity, 0, 0}), 3, cloth, true, ball_radius, 0,
                                  turned({1, 2, ball_radius}), turned({1, 0.5, 0}), turned({2, -3, 4}));
  EXPECT_LE((other.path.acceleration - turned(arc.path.acceleration)).norm(), few_roundings);
  EXPECT_LE((other.turning.angular_acceleration - turned(arc.turning.angular_acceleration)).norm(), 8 * few_roundings);
  EXPECT_NEAR(other.path.end, arc.path.end, few_roundings);
  const auto over = [](const Vector& x) { return Vector(x.x(), -x.y(), -x.z()); };
  const Arc below = supported_arc(*support_of({0, 0, -1}, {0, 0, gravity}), 3, cloth, true, ball_radius, 0,
                                  over({1, 2, ball_radius}), over({1, 0.5, 0}), over({2, -3, 4}));
  EXPECT_LE((below.path.acceleration - over(arc.path.acceleration)).norm(), few_roundings);
  EXPECT_LE((below.turning.angular_acceleration - over(arc.turning.angular_acceleration)).norm(), 8 * few_roundings);
}

/// A plane with this slope [rad] down towards +x.
Support slope(double angle) { return *support_of({std::sin(angle), 0, std::cos(angle)}, {0, 0, -gravity}); }

struct Motion {
  Arc arc;
  double time = 0;
  int arcs = 1;
};

/// Follows a sphere up to a time.
Motion followed(const Support& support, const MaterialPair& pair, const Vector& v, const Vector& w, double until) {
  Motion motion;
  motion.arc = supported_arc(support, 0, pair, true, ball_radius, 0, {0, 0, 0}, v, w);
  while (motion.arc.path.end < until) {
    EXPECT_LT(++motion.arcs, 3000);
    const double end = motion.arc.path.end;
    motion.arc = after_end(support, pair, true, motion.arc, end, position_at(motion.arc.path, end));
  }
  motion.time = until;
  return motion;
}

TEST(SupportedMotion, RollsDownASlopeInClosedForm) {
  const double angle = 0.3;
  const Support support = slope(angle);
  const Vector down{std::cos(angle), 0, -std::sin(angle)};
  // Rolling resistance slows the ball by μ_r g cos θ, as it does on a level plane.
  const double acceleration = gravity * (5.0 / 7 * std::sin(angle) - cloth.rolling_resistance * std::cos(angle));
  const Motion motion = followed(support, cloth, {0, 0, 0}, {0, 0, 0}, 2);
  EXPECT_EQ(motion.arcs, 1);
  EXPECT_EQ(motion.arc.turning.phase, Phase::rolling);
  EXPECT_LE((position_at(motion.arc.path, 2) - 2 * acceleration * down).norm(), 8 * few_roundings);
  EXPECT_NEAR(angular_velocity_at(motion.arc, 2).y(), 2 * acceleration / ball_radius, 8 * few_roundings);
  // A ball that is rolled up the slope stops after v/a', and comes back.
  const double slowing = gravity * (5.0 / 7 * std::sin(angle) + cloth.rolling_resistance * std::cos(angle));
  const Motion back = followed(support, cloth, -3 * down, Vector(0, -3 / ball_radius, 0), 2);
  EXPECT_EQ(back.arcs, 2);
  EXPECT_NEAR(velocity_at(back.arc.path, 2).dot(down), acceleration * (2 - 3 / slowing), 8 * few_roundings);
}

TEST(SupportedMotion, SlidesDownASteepSlopeAndRestsOnAFlatOne) {
  const double steep = 1.0;  // tan θ > (7/2) μ
  const Arc sliding = followed(slope(steep), cloth, {0, 0, 0}, {0, 0, 0}, 1).arc;
  EXPECT_EQ(sliding.turning.phase, Phase::sliding);
  EXPECT_EQ(sliding.path.end, never);
  const double slowing = cloth.friction * gravity * std::cos(steep);
  EXPECT_NEAR(velocity_at(sliding.path, 1).norm(), gravity * std::sin(steep) - slowing, few_roundings);
  EXPECT_NEAR(angular_velocity_at(sliding, 1).norm(), 2.5 * slowing / ball_radius, 8 * few_roundings);
  const double flat = 0.08;  // tan θ < (7/5) μ_r
  const Motion rests = followed(slope(flat), cloth, {1, 2, 0}, {3, 4, 5}, 100);
  EXPECT_EQ(rests.arc.turning.phase, Phase::resting);
  EXPECT_EQ(rests.arc.path.velocity, Vector(0, 0, 0));
  EXPECT_EQ(rests.arc.turning.angular_velocity.dot(Vector(1, 2, 3)), 0);
  const Arc smooth = supported_arc(slope(flat), 0, cloth, false, ball_radius, 0, {0, 0, 0}, {0, 1, 0}, {1, 2, 3});
  EXPECT_EQ(smooth.turning.phase, Phase::sliding);
  EXPECT_NEAR(smooth.path.acceleration.norm(), gravity * std::sin(flat), few_roundings);
  EXPECT_EQ(smooth.turning.angular_acceleration, Vector(0, 0, 0));
}

/// v' and w' by Newton's and Euler's equations, integrated with Heun's method in steps of 10 µs.
TEST(SupportedMotion, FollowsFrictionThatTurns) {
  for (const double angle : {0.2, 1.0}) {
    const Support support = slope(angle);
    const Vector& n = support.normal;
    const double p = gravity * std::cos(angle);
    const Vector along = Vector(0, 0, -gravity) + p * n;
    const Vector start = Vector(0, 2, 0) - Vector(std::cos(angle), 0, -std::sin(angle));
    Vector v = start;
    Vector w{0, 0, 0};
    const double step = 1e-5;
    const double until = 0.2;
    const auto friction = [&](const Vector& velocity, const Vector& turning) -> Vector {
      return -cloth.friction * p * (velocity - ball_radius * turning.cross(n)).normalized();
    };
    for (int k = 0; k < 20'000; ++k) {
      const Vector first = friction(v, w);
      const Vector v_next = v + step * (along + first);
      const Vector w_next = w - step * 2.5 / ball_radius * n.cross(first);
      const Vector mean = 0.5 * (first + friction(v_next, w_next));
      v += step * (along + mean);
      w -= step * 2.5 / ball_radius * n.cross(mean);
    }
    const Motion motion = followed(support, cloth, start, {0, 0, 0}, until);
    EXPECT_GT(motion.arcs, 1);
    EXPECT_LT(motion.arcs, 300);
    ASSERT_EQ(motion.arc.turning.phase, Phase::sliding);
    // The direction of an arc is that of its middle, so it is wrong by 2⁻⁸ rad at most, and in the mean by its square.
    EXPECT_LE((velocity_at(motion.arc.path, until) - v).norm(), 0x1p-14 * v.norm()) << angle;
    EXPECT_LE((angular_velocity_at(motion.arc, until) - w).norm(), 0x1p-14 * w.norm()) << angle;
  }
}

TEST(SupportedMotion, NeverGoesBelowThePlane) {
  properties::Stream stream = properties::stream_from(9);
  for (int i = 0; i < 200; ++i) {
    const Vector normal = stream.vector();
    const std::optional<Support> support = support_of(normal, 5 * stream.vector());
    if (!support) {
      continue;
    }
    const Arc arc =
        supported_arc(*support, 0, cloth, i % 2 == 0, ball_radius, 0, {0, 0, 0}, stream.vector(), stream.vector());
    for (const Vector& vector : {arc.path.velocity, arc.path.acceleration}) {
      impulse::ExactSum sum;
      for (int k = 0; k < 3; ++k) {
        sum.add(normal[k], vector[k]);
      }
      EXPECT_GE(sum.sign(), 0);
      EXPECT_LE(normal.dot(vector), 16 * roundoff * normal.norm() * vector.norm());
    }
  }
  EXPECT_FALSE(support_of({1, 0, 0}, {0, 0, -gravity}));
  EXPECT_FALSE(support_of({0, 0, -1}, {0, 0, -gravity}));
  // The rounding of these numbers is no slope.
  EXPECT_EQ(support_of({0.1, 0.2, 0.7}, {-0.3, -0.6, -2.1})->along, Vector(0, 0, 0));
}

}  // namespace
}  // namespace carom::scene
