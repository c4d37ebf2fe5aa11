// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <gtest/gtest.h>

#include <carom/scene/polyhedra/rigid_body.hpp>

#include "bodies.hpp"

namespace carom::scene {
namespace {

using unit::Points;
using unit::Vector;

RigidBody made_of(const Polyhedron& polyhedron) { return std::get<RigidBody>(rigid_body(polyhedron)); }

/// The corners are at position + R x, with R the rotation of `orientation`. The vertices x may be given in any frame.
TEST(RigidBody, HasItsCornersWhereTheSceneSays) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Polyhedron polyhedron;
    do {
      polyhedron.vertices = unit::ellipsoid_points(stream, stream.integer(4, 12));
      polyhedron.vertices =
          unit::moved(polyhedron.vertices, unit::matrix_of(unit::unit_quaternion(stream)), 4 * stream.vector());
    } while (!unit::defect_of(polyhedron.vertices).empty());
    polyhedron.density = stream.between(0.5, 2);
    polyhedron.position = 8 * stream.vector();
    polyhedron.orientation = stream.quaternion();
    polyhedron.velocity = stream.vector();
    polyhedron.angular_velocity = stream.vector();
    const RigidBody body = made_of(polyhedron);
    const Matrix3<double> turn = unit::matrix_of(polyhedron.orientation);
    const Matrix3<double> axes = unit::matrix_of(body.orientation);
    ASSERT_EQ(body.shape.core.vertices.size(), polyhedron.vertices.size()) << "seed " << seed;
    for (const Vector& vertex : body.shape.core.vertices) {
      const Vector corner = body.position + axes * vertex;
      double nearest = 1;
      for (const Vector& given : polyhedron.vertices) {
        nearest = std::min(nearest, (polyhedron.position + turn * given - corner).norm());
      }
      // The coordinates are up to 16, and have about twenty roundings of 2⁻⁵³.
      EXPECT_LE(nearest, 16 * 20 * 0x1p-53) << "seed " << seed;
      EXPECT_LE(vertex.norm(), body.radius()) << "seed " << seed;
    }
    EXPECT_NEAR(body.orientation.norm(), 1, 1e-15);
    EXPECT_EQ(body.velocity, polyhedron.velocity);
    EXPECT_EQ(body.angular_velocity, polyhedron.angular_velocity);
    // The same body, with its own frame equal to the world's frame.
    Polyhedron plain = polyhedron;
    plain.position = Vector::Zero();
    plain.orientation = {1, 0, 0, 0};
    EXPECT_EQ(made_of(plain).mass, body.mass);
    EXPECT_EQ(made_of(plain).principal_inertia, body.principal_inertia);
  }
}

TEST(RigidBody, OfABoxOffItsFrameIsByHand) {
  Polyhedron polyhedron;
  polyhedron.vertices = unit::box_points({2, 4, 8});
  polyhedron.density = 3;
  polyhedron.position = {10, 20, 30};
  // A quarter turn about z, by a quaternion of length 3: (x, y, z) maps to (−y, x, z).
  polyhedron.orientation = 3 * Quaternion<double>(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  const RigidBody body = made_of(polyhedron);
  EXPECT_LE((body.position - Vector(10 - 2, 20 + 1, 30 + 4)).norm(), 1e-14);
  EXPECT_EQ(body.mass, 192);
  EXPECT_EQ(body.principal_inertia, Vector(1280, 1088, 320));
  EXPECT_NEAR(body.radius(), std::sqrt(21), 1e-14);
  EXPECT_GE(body.radius(), std::sqrt(21));
  EXPECT_EQ(body.shape.margin, 0);
}

TEST(RigidBody, TakesOrientationsOfAnyLength) {
  Polyhedron polyhedron;
  polyhedron.vertices = unit::box_points({1, 2, 3});
  polyhedron.orientation = {1, 2, 3, 4};
  const RigidBody body = made_of(polyhedron);
  for (const double length : {1e-300, 1e-160, 1e160, 1e300}) {
    polyhedron.orientation = length * Quaternion<double>(1, 2, 3, 4);
    EXPECT_LE((made_of(polyhedron).orientation - body.orientation).norm(), 1e-15) << length;
    EXPECT_LE((made_of(polyhedron).position - body.position).norm(), 1e-14) << length;
  }
}

TEST(RigidBody, OfASphereIsItsBall) {
  Sphere sphere;
  sphere.radius = 0.25;
  sphere.density = 6;
  sphere.position = {1, 2, 3};
  sphere.velocity = {4, 5, 6};
  sphere.angular_velocity = {7, 8, 9};
  const RigidBody body = rigid_body(sphere);
  EXPECT_NEAR(body.mass, std::numbers::pi / 8, 1e-15);
  EXPECT_NEAR(body.principal_inertia[2], 0.4 * std::numbers::pi / 8 / 16, 1e-16);
  EXPECT_EQ(body.radius(), 0.25);
  EXPECT_EQ(body.shape.margin, 0.25);
  EXPECT_EQ(body.position, sphere.position);
  EXPECT_EQ(body.velocity, sphere.velocity);
  EXPECT_EQ(body.angular_velocity, sphere.angular_velocity);
}

TEST(RigidBody, SaysWhyPointsAreNone) {
  Polyhedron polyhedron;
  polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const auto body = rigid_body(polyhedron);
  ASSERT_TRUE(std::holds_alternative<ShapeDefect>(body));
  EXPECT_EQ(std::get<ShapeDefect>(body).text, unit::defect_of(polyhedron.vertices));
}

}  // namespace
}  // namespace carom::scene
