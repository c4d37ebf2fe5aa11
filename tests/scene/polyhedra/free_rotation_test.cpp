// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

#include "bodies.hpp"

namespace carom::scene {
namespace {

using unit::Vector;
using Extended = Vector3<long double>;
using ExtendedQuaternion = Quaternion<long double>;

double angle_between(const Quaternion<double>& x, const ExtendedQuaternion& y) {
  const ExtendedQuaternion p = x.cast<long double>().normalized();
  const ExtendedQuaternion q = y.normalized();
  return static_cast<double>(2 * std::min((p - q).norm(), (p + q).norm()));
}

struct ExtendedState {
  ExtendedQuaternion orientation;
  Extended rate;
};

/// Euler's equations, I₁ ω₁' = (I₂ − I₃) ω₂ ω₃, and q' = ½ q ω. The form J ω' = (J ω) × ω loses digits for rods.
ExtendedState slope(const Extended& moments, const ExtendedState& s) {
  const Extended rate((moments[1] - moments[2]) / moments[0] * s.rate[1] * s.rate[2],
                      (moments[2] - moments[0]) / moments[1] * s.rate[2] * s.rate[0],
                      (moments[0] - moments[1]) / moments[2] * s.rate[0] * s.rate[1]);
  const Extended v = s.orientation.tail<3>();
  ExtendedQuaternion turn;
  turn << -v.dot(s.rate), s.orientation[0] * s.rate + v.cross(s.rate);
  return {turn / 2, rate};
}

ExtendedState plus(const ExtendedState& s, const ExtendedState& d, long double h) {
  return {s.orientation + h * d.orientation, s.rate + h * d.rate};
}

/// An independent integrator: extrapolated steps of the midpoint rule, in long double (W. Gragg, R. Bulirsch, J. Stoer;
/// E. Hairer, S. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", §II.9).
ExtendedState integrated(const Extended& moments, ExtendedState s, long double duration) {
  const int steps = static_cast<int>(std::ceil(8 * duration * s.rate.norm())) + 1;
  const long double length = duration / steps;
  for (int step = 0; step < steps; ++step) {
    constexpr std::size_t rows = 10;
    std::array<std::array<ExtendedState, rows>, rows> table;
    const auto parts_of = [](std::size_t row) { return 2 * (static_cast<int>(row) + 1); };
    for (std::size_t row = 0; row < rows; ++row) {
      const long double h = length / parts_of(row);
      ExtendedState before = s;
      ExtendedState now = plus(s, slope(moments, s), h);
      for (int i = 1; i < parts_of(row); ++i) {
        const ExtendedState next = plus(before, slope(moments, now), 2 * h);
        before = now;
        now = next;
      }
      table[row][0] = now;
      for (std::size_t k = 1; k <= row; ++k) {
        const long double ratio = static_cast<long double>(parts_of(row)) / parts_of(row - k);
        const ExtendedState& better = table[row][k - 1];
        const ExtendedState& worse = table[row - 1][k - 1];
        const ExtendedState difference{better.orientation - worse.orientation, better.rate - worse.rate};
        table[row][k] = plus(better, difference, 1 / (ratio * ratio - 1));
      }
    }
    s = table.back().back();
  }
  return s;
}

struct FreeMotion {
  Vector moments;
  RotationState start;
  double duration;
};

struct Comparison {
  double angle;
  double angle_bound;
  double rate;
  double rate_bound;
};

Comparison compare(const FreeMotion& motion) {
  const RotationPath path(motion.moments, motion.start, motion.duration);
  const BoundedRotation end = path.at(motion.duration);
  const ExtendedState truth =
      integrated(motion.moments.cast<long double>(),
                 {motion.start.orientation.cast<long double>(), motion.start.body_rate.cast<long double>()},
                 static_cast<long double>(motion.duration));
  return {angle_between(end.state.orientation, truth.orientation), end.angle_error,
          static_cast<double>((end.state.body_rate.cast<long double>() - truth.rate).norm()), end.rate_error};
}

RotationState turning(const Vector& body_rate) { return {{1, 0, 0, 0}, body_rate}; }

/// The moments come from positive second moments, so that a body can have them.
FreeMotion random_motion(properties::Stream& stream, double angle) {
  const Vector second = stream.vector().cwiseAbs() + Vector::Constant(stream.chance(4) ? 1e-4 : 0.1);
  const Vector moments = Vector::Constant(second.sum()) - second;
  FreeMotion motion{moments, {unit::unit_quaternion(stream), 10 * unit::unit_vector(stream)}, 0};
  motion.duration = angle / 10;
  return motion;
}

/// A symmetric top rotates about its angular momentum L at the rate ‖L‖/I₁, and about its axis at the rate (1 − I₃/I₁)
/// ω₃.
TEST(RotationPath, FollowsTheSymmetricTop) {
  for (const double axial : {0.25, 0.9, 1.1, 1.999}) {
    const Vector moments(1, 1, axial);
    const Vector rate(0.6, -0.3, 2);
    const double duration = 20;
    const BoundedRotation end = RotationPath(moments, turning(rate), duration).at(duration);
    const Extended momentum = moments.cwiseProduct(rate).cast<long double>();
    const long double time = duration;
    const Eigen::Quaternion<long double> about_momentum(
        Eigen::AngleAxis<long double>(momentum.norm() * time, momentum.normalized()));
    const Eigen::Quaternion<long double> about_axis(
        Eigen::AngleAxis<long double>((1 - static_cast<long double>(axial)) * 2 * time, Extended(0, 0, 1)));
    const Eigen::Quaternion<long double> expected = about_momentum * about_axis;
    const double angle = angle_between(end.state.orientation, {expected.w(), expected.x(), expected.y(), expected.z()});
    EXPECT_LE(angle, end.angle_error) << axial;
    EXPECT_LE(angle, 1e-13) << axial;
    EXPECT_LE(end.angle_error, 2e-11) << axial;
  }
}

/// A tennis racket that rotates about its intermediate axis flips over again and again, and initial errors grow by
/// orders of magnitude. Gronwall's bound becomes useless. The bound by derivatives (free_rotation.hpp) remains useful.
TEST(RotationPath, FollowsTheTennisRacket) {
  for (const double disturbance : {1e-1, 1e-3, 1e-6}) {
    const FreeMotion motion{{1, 2, 2.5}, turning({disturbance, 5, 0}), 10};
    const Comparison result = compare(motion);
    EXPECT_LE(result.angle, result.angle_bound) << disturbance;
    EXPECT_LE(result.rate, result.rate_bound) << disturbance;
    EXPECT_LE(result.angle, 1e-10) << disturbance;
    EXPECT_LE(result.angle_bound, 1e-6) << disturbance;
    const RotationPath path(motion.moments, motion.start, motion.duration);
    double least = 5;
    for (int i = 0; i <= 1000; ++i) {
      least = std::min(least, path.at(motion.duration * i / 1000).state.body_rate.y());
    }
    EXPECT_LT(least, -4.9) << disturbance;
  }
}

TEST(RotationPath, KeepsItsBounds) {
  std::vector<double> looseness;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const double angle = stream.between(0.01, 60);
    const Comparison result = compare(random_motion(stream, angle));
    ASSERT_LE(result.angle, result.angle_bound) << seed;
    ASSERT_LE(result.rate, result.rate_bound) << seed;
    ASSERT_LE(result.angle_bound, 1e-10 * std::max(1.0, angle)) << seed;
    looseness.push_back(result.angle_bound / std::max(result.angle, 0x1p-53));
  }
  std::sort(looseness.begin(), looseness.end());
  EXPECT_LE(looseness[looseness.size() / 2], 1000);  // the median is 600, because rounding errors rarely add up
}

TEST(RotationPath, KeepsItsBoundsOfAnyBody) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Comparison result = compare(random_motion(stream, stream.between(0, 10)));
    ASSERT_TRUE(result.angle <= result.angle_bound) << seed;
    ASSERT_TRUE(result.rate <= result.rate_bound) << seed;
  }
}

TEST(RotationPath, KeepsEnergyAndAngularMomentum) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const FreeMotion motion = random_motion(stream, 100);
    const auto momentum = [&](const RotationState& state) -> Vector {
      return unit::matrix_of(state.orientation) * motion.moments.cwiseProduct(state.body_rate);
    };
    const auto energy = [&](const RotationState& state) { return motion.moments.dot(state.body_rate.cwiseAbs2()) / 2; };
    const RotationState end = RotationPath(motion.moments, motion.start, motion.duration).at(motion.duration).state;
    const Vector first = momentum(motion.start);
    EXPECT_LE((momentum(end) - first).norm(), 1e-13 * first.norm()) << seed;
    EXPECT_NEAR(energy(end), energy(motion.start), 1e-13 * energy(motion.start)) << seed;
  }
}

/// A rod a thousand times as long as wide has moments 1 : 10⁶.
TEST(RotationPath, KeepsTheDigitsOfRods) {
  for (const Vector& rate : {Vector(10, 1e-3, 2e-3), Vector(1e-3, 5, 1), Vector(3, 4, 5)}) {
    const FreeMotion motion{{1e-6, 1, 1 + 1e-7}, turning(rate), 5};
    const Comparison result = compare(motion);
    EXPECT_LE(result.angle, 1e-13);
    EXPECT_LE(result.angle, result.angle_bound);
    EXPECT_LE(result.angle_bound, 1e-9);
  }
}

TEST(RotationPath, TurnsACubeAboutAFixedAxis) {
  const RotationPath path(Vector::Constant(2.0 / 3), turning({0, 0, 3}), 100);
  for (const double time : {0.0, 0.5, 100.0}) {
    const BoundedRotation at = path.at(time);
    const long double half = 1.5L * static_cast<long double>(time);
    EXPECT_LE(angle_between(at.state.orientation, {std::cos(half), 0, 0, std::sin(half)}), at.angle_error + 1e-18);
    EXPECT_LE(at.angle_error, 2e-13);
    EXPECT_EQ(at.state.body_rate, Vector(0, 0, 3));
    EXPECT_EQ(at.rate_error, 0);
  }
  const RotationPath at_rest(Vector(1, 2, 2.5), turning({0, 0, 0}), 100);
  EXPECT_LE(at_rest.at(70).angle_error, 0x1p-51);
  EXPECT_EQ(at_rest.at(70).state.orientation, Quaternion<double>(1, 0, 0, 0));
}

TEST(RotationPath, AnswersForAnyTimeWithinIt) {
  const Vector moments(1, 2, 2.5);
  const RotationState start = turning({1, 5, 0.5});
  const RotationPath whole(moments, start, 3);
  for (int i = 0; i <= 300; ++i) {
    const double time = 0.01 * i;
    const BoundedRotation one = whole.at(time);
    const BoundedRotation other = RotationPath(moments, start, time).at(time);
    EXPECT_LE(angle_between(one.state.orientation, other.state.orientation.cast<long double>()),
              one.angle_error + other.angle_error);
    EXPECT_LE((one.state.body_rate - other.state.body_rate).norm(), one.rate_error + other.rate_error);
  }
}

/// ‖ω‖ reaches 0.7 of its bound in each motion, and nearly the whole bound in some motion.
TEST(RotationPath, KnowsTheGreatestRate) {
  double closest = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const FreeMotion motion = random_motion(stream, 100);
    const RotationPath path(motion.moments, motion.start, motion.duration);
    double greatest = 0;
    for (int i = 0; i <= 1000; ++i) {
      greatest = std::max(greatest, path.at(motion.duration * i / 1000).state.body_rate.norm());
    }
    EXPECT_LE(greatest, path.greatest_rate()) << seed;
    EXPECT_GE(greatest, 0.7 * path.greatest_rate()) << seed;
    closest = std::max(closest, greatest / path.greatest_rate());
  }
  EXPECT_GE(closest, 0.9999);
}

TEST(RotationState, TurnsRatesIntoTheBodyAndBack) {
  properties::Stream stream = properties::stream_from(9);
  for (int i = 0; i < 100; ++i) {
    const Vector rate = stream.vector();
    const RotationState state = rotation_state(stream.quaternion(), rate);
    EXPECT_NEAR(state.orientation.norm(), 1, 0x1p-51);
    EXPECT_LE((world_rate(state) - rate).norm(), 0x1p-50);
  }
}

}  // namespace
}  // namespace carom::scene
