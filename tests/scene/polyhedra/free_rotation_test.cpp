// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
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

/// An independent integrator of Euler's equations, I₁ ω₁' = (I₂ − I₃) ω₂ ω₃, and q' = ½ q ω: extrapolated steps of the
/// midpoint rule, in long double (W. Gragg, R. Bulirsch, J. Stoer). The form J ω' = (J ω) × ω loses digits for rods.
ExtendedState integrated(const Extended& moments, const ExtendedState& start, long double duration) {
  using State = std::array<long double, 7>;
  const auto equations = [&](const State& x, State& change, long double) {
    const Extended rate(x[4], x[5], x[6]);
    const Extended v(x[1], x[2], x[3]);
    const Extended turn = (x[0] * rate + v.cross(rate)) / 2;
    change = {-v.dot(rate) / 2,
              turn[0],
              turn[1],
              turn[2],
              (moments[1] - moments[2]) / moments[0] * rate[1] * rate[2],
              (moments[2] - moments[0]) / moments[1] * rate[2] * rate[0],
              (moments[0] - moments[1]) / moments[2] * rate[0] * rate[1]};
  };
  const ExtendedQuaternion& q = start.orientation;
  State x{q[0], q[1], q[2], q[3], start.rate[0], start.rate[1], start.rate[2]};
  namespace odeint = boost::numeric::odeint;
  if (duration > 0) {
    odeint::integrate_adaptive(odeint::bulirsch_stoer<State, long double>(1e-18L, 1e-18L), equations, x, 0.0L, duration,
                               std::min(duration, 0.125L / start.rate.norm()));
  }
  return {{x[0], x[1], x[2], x[3]}, {x[4], x[5], x[6]}};
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
TEST(RotationPath, FollowsTheClosedFormOfASymmetricTop) {
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
TEST(RotationPath, HasUsefulBoundsForATennisRacketThatFlipsOver) {
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

TEST(RotationPath, IsWithinItsBoundsOfAnIndependentIntegrator) {
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

/// A rod a thousand times as long as wide has moments 1 : 10⁶.
TEST(RotationPath, KeepsItsDigitsForARod) {
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

TEST(RotationPath, GivesAtAnyTimeTheEndOfAShorterPath) {
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
TEST(RotationPath, BoundsTheGreatestRate) {
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
