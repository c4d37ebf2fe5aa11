// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/polyhedra/time_of_contact.hpp>

#include "distance_by_features.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

constexpr double contact_tolerance = 1e-9;
const HalfSpace floor_at_0{{0, 0, 1}, 0};

FreeFlight resting(const Quaternion<double>& orientation, const Vector& position) {
  return {position, Vector::Zero(), Vector::Zero(), RotationPath(orientation)};
}

double least_height(const ConvexShape& shape, const Quaternion<double>& orientation) {
  const Matrix3<double> turn = unit::matrix_of(orientation);
  double least = 0;
  for (const Vector& vertex : shape.core.vertices) {
    least = std::min(least, (turn * vertex).z());
  }
  return least;
}

TEST(TimeOfContact, OfAFallingCubeIsThatOfItsLowestCorner) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({1, 1, 1})));
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    FreeFlight motion = resting(unit::unit_quaternion(stream), {stream.signed_unit(), 0, 3});
    motion.velocity = {1, 2, stream.signed_unit()};
    motion.acceleration = {0, 0, -9.81};
    const TimeOfContact found = time_of_contact(cube, motion, floor_at_0, 0, 2, contact_tolerance);
    ASSERT_EQ(found.status, ContactStatus::touches);
    // height + v t − g t²/2 = gap.
    const double height = 3 + least_height(cube, motion.rotation.at(0).state.orientation);
    const auto time_of_gap = [&](double gap) {
      const double v = motion.velocity.z();
      return (v + std::sqrt(v * v + 2 * 9.81 * (height - gap))) / 9.81;
    };
    EXPECT_LE(found.time, time_of_gap(0));
    EXPECT_GE(found.time, time_of_gap(1.01 * contact_tolerance));
    EXPECT_GT(found.separation.certified, 0);
    EXPECT_LE(found.advances, 4);
  }
}

TEST(TimeOfContact, OfABallAndACubeIsThatOfTheirFaces) {
  const ShapePair pair(ball_shape(0.5), convex_shape(unit::body_of(unit::box_points({2, 2, 2}))));
  FreeFlight ball = resting({1, 0, 0, 0}, {0.25, -0.5, 6});
  ball.velocity = {0.125, 0.25, -3};
  const TimeOfContact found = time_of_contact(pair, ball, resting({1, 0, 0, 0}, {0, 0, 0}), 0, 10, contact_tolerance);
  ASSERT_EQ(found.status, ContactStatus::touches);
  EXPECT_NEAR(found.time, 1.5, contact_tolerance);
  EXPECT_LT(found.time, 1.5);
  EXPECT_LE((found.separation.normal - Vector(0, 0, 1)).norm(), 1e-15);
}

TEST(TimeOfContact, OfATurningCubeIsThatOfItsEdge) {
  const PolyhedralBody cube = unit::body_of(unit::box_points({2, 2, 2}));
  const ShapePair pair(ball_shape(0.25), convex_shape(cube));
  FreeFlight turning = resting({1, 0, 0, 0}, {0, 0, 0});
  turning.rotation = RotationPath(cube.properties.principal_inertia, {{1, 0, 0, 0}, {0, 0, 2}}, 10);
  const FreeFlight ball = resting({1, 0, 0, 0}, {1.5, 0, 0});
  const TimeOfContact found = time_of_contact(pair, ball, turning, 0, 10, contact_tolerance);
  ASSERT_EQ(found.status, ContactStatus::touches);
  // The face rotated by φ is at the distance 1.5 cos φ − 1 from the ball's centre, as long as the foot of the
  // perpendicular, at 1.5 sin φ, lies on the face: 1.5 sin φ < 1. The ball's radius is 1/4, so cos φ = 5/6.
  EXPECT_NEAR(found.time, std::acos(5.0 / 6) / 2, 2 * contact_tolerance);
}

struct Flight {
  PolyhedralBody body;
  ConvexShape shape;
  FreeFlight motion;
};

Flight random_flight(properties::Stream& stream, const Vector& position, const Vector& velocity, double duration) {
  const PolyhedralBody body = unit::random_body(stream);
  const RotationState state{unit::unit_quaternion(stream), stream.between(0, 8) * unit::unit_vector(stream)};
  return {body,
          convex_shape(body),
          {position, velocity, stream.signed_unit() * unit::unit_vector(stream),
           RotationPath(body.properties.principal_inertia, state, duration)}};
}

struct Meeting {
  Flight a;
  Flight b;
  double duration = 4;
};

Meeting random_meeting(properties::Stream& stream) {
  constexpr double duration = 4;
  const Vector apart = 8 * unit::unit_vector(stream);
  const Vector velocity = -0.4 * apart + 0.5 * stream.vector();
  Flight a = random_flight(stream, apart, velocity, duration);
  Flight b = random_flight(stream, Vector::Zero(), Vector::Zero(), duration);
  return {std::move(a), std::move(b), duration};
}

double true_distance(const Meeting& m, double time) {
  return static_cast<double>(
      unit::distance_by_features(m.a.shape, placement_at(m.a.motion, time), m.b.shape, placement_at(m.b.motion, time)));
}

/// The fault of the result; empty if the result is right.
std::string wrong_with(const Meeting& m, const TimeOfContact& found) {
  const double end = found.status == ContactStatus::misses ? m.duration : found.time;
  if (found.status == ContactStatus::overlaps || found.status == ContactStatus::undecided) {
    return "neither touches nor misses";
  }
  for (int i = 0; i <= 60; ++i) {
    const double time = i % 2 == 0 ? end * i / 60 : end * (1 - std::ldexp(1.0, -i));
    const double distance = true_distance(m, time);
    if (!(distance >= 0.4 * contact_tolerance)) {
      return "are " + std::to_string(distance) + " apart at " + std::to_string(time) + " of " + std::to_string(end);
    }
  }
  if (found.status == ContactStatus::touches) {
    const double distance = true_distance(m, found.time);
    if (!(distance > 0 && distance <= 1.01 * contact_tolerance)) {
      return "touches at " + std::to_string(distance / contact_tolerance) + " tolerances";
    }
    if (found.separation.certified > distance) {
      return "certifies too much";
    }
  }
  return "";
}

TimeOfContact found_of(const Meeting& m) {
  return time_of_contact(ShapePair(m.a.shape, m.b.shape), m.a.motion, m.b.motion, 0, m.duration, contact_tolerance);
}

TEST(TimeOfContact, OfTumblingBodiesIsTheFirstByTheDistanceOfTheirFeatures) {
  int touching = 0;
  int advances = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Meeting meeting = random_meeting(stream);
    const TimeOfContact found = found_of(meeting);
    EXPECT_EQ(wrong_with(meeting, found), "") << seed;
    touching += found.status == ContactStatus::touches ? 1 : 0;
    advances += found.advances;
    EXPECT_LE(found.advances, 100) << seed;
  }
  EXPECT_GT(touching, 30);
  EXPECT_LT(touching, 90);
  EXPECT_LE(advances, 2500);  // about 20 for each meeting of these fast bodies
}

TEST(TimeOfContact, OfATumblingBodyAndAFloorIsTheFirst) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Flight flight = random_flight(stream, {0, 0, 4}, stream.vector(), 3);
    flight.motion.acceleration = {0, 0, -9.81};
    const TimeOfContact found = time_of_contact(flight.shape, flight.motion, floor_at_0, 0, 3, contact_tolerance);
    ASSERT_EQ(found.status, ContactStatus::touches) << seed;
    const auto height_at = [&](double time) {
      const Placement placement = placement_at(flight.motion, time);
      return placement.position.z() + least_height(flight.shape, placement.orientation);
    };
    for (int i = 0; i < 100; ++i) {
      EXPECT_GT(height_at(found.time * i / 100), 0.99 * contact_tolerance) << seed;
    }
    EXPECT_GT(height_at(found.time), 0) << seed;
    EXPECT_LE(height_at(found.time), 1.01 * contact_tolerance) << seed;
    EXPECT_LE(found.advances, 100) << seed;
  }
}

/// A ball flies along an edge of a box. A thousandth of the tolerance decides whether they touch.
TEST(TimeOfContact, TellsABallThatGrazesAnEdgeFromOneThatMissesIt) {
  const ShapePair pair(ball_shape(0.5), convex_shape(unit::body_of(unit::box_points({2, 2, 2}))));
  const Vector away = Vector(1, 1, 0).normalized();
  for (const double miss : {1e-2, 1e-6, 1.001e-9, 0.999e-9, 1e-10, -1e-6}) {
    FreeFlight ball = resting({1, 0, 0, 0}, Vector(1, 1, -4) + (0.5 + miss) * away);
    ball.velocity = {0, 0, 2};
    const TimeOfContact found = time_of_contact(pair, ball, resting({1, 0, 0, 0}, {0, 0, 0}), 0, 4, contact_tolerance);
    EXPECT_EQ(found.status, miss > contact_tolerance ? ContactStatus::misses : ContactStatus::touches) << miss;
  }
}

TEST(TimeOfContact, TellsEdgesThatCrossWithinTheToleranceFromOthers) {
  const ShapePair pair(convex_shape(unit::body_of(unit::box_points({2, 2, 2}))),
                       convex_shape(unit::body_of(unit::box_points({2, 2, 2}))));
  const double half = std::sqrt(0.5);
  const Quaternion<double> about_x(std::cos(std::numbers::pi / 8), std::sin(std::numbers::pi / 8), 0, 0);
  const Quaternion<double> about_y(std::cos(std::numbers::pi / 8), 0, std::sin(std::numbers::pi / 8), 0);
  for (const double miss : {1e-3, 1e-6, 1.1e-9, 0.9e-9, 1e-12}) {
    FreeFlight above = resting(about_x, {0, -4, 4 * half + miss});
    above.velocity = {0, 2, 0};
    const TimeOfContact found = time_of_contact(pair, above, resting(about_y, {0, 0, 0}), 0, 4, contact_tolerance);
    EXPECT_EQ(found.status, miss > contact_tolerance ? ContactStatus::misses : ContactStatus::touches) << miss;
  }
}

/// After an impact, bodies are within the tolerance, but draw apart. So they are not in contact.
TEST(TimeOfContact, AfterAnImpactIsTheNextOne) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({1, 1, 1})));
  for (const double speed : {1e-6, 1e-3, 1.0}) {
    FreeFlight motion = resting({1, 0, 0, 0}, {0, 0, 0.5 + 0.7 * contact_tolerance});
    motion.velocity = {0, 0, speed};
    motion.acceleration = {0, 0, -10};
    const TimeOfContact found = time_of_contact(cube, motion, floor_at_0, 0, 2, contact_tolerance);
    ASSERT_EQ(found.status, ContactStatus::touches) << speed;
    // The cube hops. The contact is on the way down.
    EXPECT_LE(found.time, speed / 5 * (1 + 1e-4) + 1e-9 / speed) << speed;
    EXPECT_GE(found.time, speed / 10 * 0.99) << speed;
  }
  FreeFlight falling = resting({1, 0, 0, 0}, {0, 0, 0.5 + 0.7 * contact_tolerance});
  falling.velocity = {0, 0, -1e-9};
  EXPECT_EQ(time_of_contact(cube, falling, floor_at_0, 0, 2, contact_tolerance).status, ContactStatus::touches);
  EXPECT_EQ(time_of_contact(cube, falling, floor_at_0, 0, 2, contact_tolerance).time, 0);
}

/// The same flight with a later start.
FreeFlight told_from(const FreeFlight& motion, const Vector& inertia, double start, double duration) {
  const RotationState state = rotation_at(motion, start).state;
  return {motion.position + start * (motion.velocity + start / 2 * motion.acceleration),
          motion.velocity + start * motion.acceleration, motion.acceleration,
          RotationPath(inertia, rotation_state(state.orientation, world_rate(state)), duration - start), start};
}

TEST(TimeOfContact, OfBodiesThatSlideAndRiseDoesNotExist) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({1, 1, 1})));
  const Vector inertia = unit::body_of(unit::box_points({1, 1, 1})).properties.principal_inertia;
  const ShapePair pair(cube, cube);
  const double gap = 0.5 * contact_tolerance;
  const FreeFlight below = resting({1, 0, 0, 0}, {0, 0, 0});
  for (const Vector& slide : {Vector(1, 0, 0), Vector(0, -1, 0), Vector(1, 1, 0)}) {
    for (const double rise : {1e-6, 1e-3, 0.5}) {
      for (const double overlap : {0.0, 0.5, 0.999}) {
        FreeFlight above = resting({1, 0, 0, 0}, Vector(overlap, 0, 1 + gap));
        above.velocity = slide + Vector(0, 0, rise);
        const TimeOfContact found = time_of_contact(pair, above, below, 0, 3, contact_tolerance);
        EXPECT_EQ(found.status, ContactStatus::misses) << slide.transpose() << ", " << rise << ", " << overlap;
      }
    }
  }
  // Edge on edge within the tolerance: one body rotates away about the edge, and slides along the edge.
  for (const double turning : {0.125, 1.0, 4.0}) {
    FreeFlight above = resting({1, 0, 0, 0}, {1, 0, 1 + gap});
    above.velocity = Vector(turning / 2, 1, turning / 2);
    above.rotation = RotationPath(inertia, {{1, 0, 0, 0}, {0, turning, 0}}, 3);
    const TimeOfContact found = time_of_contact(pair, above, below, 0, 0.25, contact_tolerance);
    EXPECT_TRUE(found.status == ContactStatus::misses || found.time > 0) << turning;
    EXPECT_NE(found.status, ContactStatus::undecided) << turning;
    EXPECT_NE(found.status, ContactStatus::overlaps) << turning;
  }
}

/// After an impact, edges touch along a part of themselves, and the bodies rotate apart. Neither a face's normal nor
/// the normal of both edges shows that the gap opens. A search that misses the opening finds the same contact forever.
TEST(TimeOfContact, OfBodiesJustStruckApartIsLater) {
  int struck = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Meeting m = random_meeting(stream);
    const TimeOfContact first = found_of(m);
    if (first.status != ContactStatus::touches) {
      continue;
    }
    ++struck;
    // As after an impact, one body gets a relative velocity along the normal.
    const ShapePair pair(m.a.shape, m.b.shape);
    for (const double away : {16.0, 64.0}) {
      FreeFlight a = told_from(m.a.motion, m.a.body.properties.principal_inertia, first.time, m.duration);
      const FreeFlight b = told_from(m.b.motion, m.b.body.properties.principal_inertia, first.time, m.duration);
      a.velocity += away * first.separation.normal;
      const TimeOfContact next = time_of_contact(pair, a, b, first.time, a.end(), contact_tolerance);
      // By rotation, corners move at no more than about 2 m · 8 rad/s = 16 m/s. So 64 m/s is faster than every corner.
      if (away == 64) {
        EXPECT_EQ(next.status, ContactStatus::misses) << "seed " << seed;
      } else {
        EXPECT_TRUE(next.status == ContactStatus::misses || next.time > first.time) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(struck, 30);
}

TEST(TimeOfContact, IsAnOverlapOrUndecidedWhereItCannotBeTold) {
  const ConvexShape cube = convex_shape(unit::body_of(unit::box_points({1, 1, 1})));
  EXPECT_EQ(time_of_contact(cube, resting({1, 0, 0, 0}, {0, 0, 0.25}), floor_at_0, 0, 1, contact_tolerance).status,
            ContactStatus::overlaps);
  EXPECT_EQ(time_of_contact(cube, resting({1, 0, 0, 0}, {0, 0, 0.5}), floor_at_0, 0, 1, contact_tolerance).status,
            ContactStatus::overlaps);  // in exact contact: not certain to be apart
  EXPECT_EQ(time_of_contact(cube, resting({1, 0, 0, 0}, {0, 0, 1}), floor_at_0, 0, 1, contact_tolerance).status,
            ContactStatus::misses);
  FreeFlight falling = resting({1, 0, 0, 0}, {0, 0, 1});
  falling.velocity = {0, 0, -1};
  const TimeOfContact finest = time_of_contact(cube, falling, floor_at_0, 0, 1, 1e-18);
  EXPECT_EQ(finest.status, ContactStatus::undecided);
  EXPECT_LT(finest.time, 0.5);
}

}  // namespace
}  // namespace carom::scene
