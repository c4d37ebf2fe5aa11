// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <carom/scene/polyhedra/rigid_body.hpp>

#include "bodies.hpp"

namespace carom::scene {
namespace {

using impulse::DoubleDouble;
using unit::Points;
using unit::Vector;

Matrix3<double> about_centre_of_box(const Vector& size, double mass) {
  const Vector squares = size.cwiseAbs2();
  return (mass / 12 * Vector(squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y()))
      .asDiagonal();
}

/// The inertia of a point mass, for the parallel axis theorem.
Matrix3<double> of_point(double mass, const Vector& r) {
  return mass * (r.squaredNorm() * Matrix3<double>::Identity() - r * r.transpose());
}

TEST(MassProperties, OfABoxAreThoseOfATextbook) {
  const PolyhedralBody box = unit::body_of(unit::box_points({2, 4, 8}), 3);
  EXPECT_EQ(box.properties.volume, 64);
  EXPECT_EQ(box.properties.mass, 192);
  EXPECT_EQ(box.properties.centre, Vector(1, 2, 4));
  EXPECT_EQ(box.properties.inertia, about_centre_of_box({2, 4, 8}, 192));
  EXPECT_EQ(box.properties.principal_inertia, Vector(1280, 1088, 320));
  EXPECT_EQ(box.properties.orientation, Quaternion<double>(1, 0, 0, 0));  // the axes do not change
  EXPECT_EQ(box.shape.vertices.front(), Vector(-1, -2, -4));
}

TEST(MassProperties, OfARegularTetrahedronAreCorrectlyRounded) {
  const PolyhedralBody body = unit::body_of(unit::tetrahedron_points());
  EXPECT_EQ(body.properties.volume, 8.0 / 3);
  EXPECT_EQ(body.properties.centre, Vector::Zero());
  EXPECT_EQ(body.properties.inertia, Matrix3<double>(Vector::Constant(16.0 / 15).asDiagonal()));
  EXPECT_EQ(body.properties.principal_inertia, Vector::Constant(16.0 / 15));
}

/// The inertia of a body is the sum over its tetrahedra.
TEST(MassProperties, AreTheSumOverTheTetrahedraOfABody) {
  properties::Stream stream = properties::stream_from(5);
  for (int i = 0; i < 30; ++i) {
    const Points points = unit::ellipsoid_points(stream, 12);
    if (!unit::defect_of(points).empty()) {
      continue;
    }
    const PolyhedralBody whole = unit::body_of(points);
    const Vector inner = whole.properties.centre;
    double volume = 0;
    Matrix3<double> inertia = Matrix3<double>::Zero();
    for (const auto& face : whole.shape.faces) {
      for (std::size_t k = 2; k < face.size(); ++k) {
        const PolyhedralBody part = unit::body_of({inner, points[face[0]], points[face[k - 1]], points[face[k]]});
        volume += part.properties.volume;
        inertia += part.properties.inertia + of_point(part.properties.mass, part.properties.centre - inner);
      }
    }
    EXPECT_NEAR(volume, whole.properties.volume, 0x1p-48 * volume);
    EXPECT_LE((inertia - whole.properties.inertia).norm(), 0x1p-47 * inertia.norm());
  }
}

TEST(MassProperties, HaveAxesThatMakeTheInertiaDiagonal) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const PolyhedralBody body = unit::random_body(stream);
    const MassProperties& p = body.properties;
    const Matrix3<double> r = unit::matrix_of(p.orientation);
    EXPECT_LE((r * p.principal_inertia.asDiagonal() * r.transpose() - p.inertia).norm(), 0x1p-50 * p.inertia.norm());
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(p.inertia);
    Vector sorted = p.principal_inertia;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_LE((eigen.eigenvalues() - sorted).norm(), 0x1p-48 * sorted.norm()) << seed;
    for (int i = 0; i < 3; ++i) {  // strictly, because the body has a volume
      EXPECT_LT(sorted[2], sorted[0] + sorted[1]);
    }
  }
}

TEST(MassProperties, KeepTheInertiaOfABodyFarFromItsOrigin) {
  Points points{{0, 0, 0}, {3, 0, 1}, {0, 5, 0}, {1, 1, 4}, {3, 4, 3}};
  const Vector shift(1e9, -7e8, 0x1p40);
  const MassProperties near = unit::body_of(points).properties;
  const MassProperties far = unit::body_of(unit::moved(points, Matrix3<double>::Identity(), shift)).properties;
  EXPECT_EQ(near.inertia, far.inertia);
  EXPECT_EQ(near.principal_inertia, far.principal_inertia);
  EXPECT_EQ(near.volume, far.volume);
}

TEST(MassProperties, OfANeedleKeepTheDigitsOfTheLeastMoment) {
  properties::Stream stream = properties::stream_from(1);
  for (int i = 0; i < 20; ++i) {
    const Vector size(1e-6, 2e-6, 1);
    const Matrix3<double> turn = unit::matrix_of(unit::unit_quaternion(stream));
    const Points points = unit::moved(unit::box_points(size), turn, {0, 0, 0});
    const std::string defect = unit::defect_of(points);
    ASSERT_EQ(defect, "");
    const MassProperties p = unit::body_of(points).properties;
    const double mass = 2e-12;
    const double least = mass / 12 * 5e-12;
    // The vertices are rounded by 2⁻⁵³ of the length, which is 10⁻¹⁰ of the width.
    EXPECT_NEAR(p.principal_inertia.minCoeff() / least, 1, 1e-8);
  }
}

TEST(PrincipalAxes, MakeAnInertiaDiagonalTo95Bits) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    Matrix3<DoubleDouble> j;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k <= i; ++k) {
        j(i, k) = j(k, i) = DoubleDouble(stream.signed_unit() * (seed % 3 == 0 && i != k ? 1e-12 : 1)) +
                            DoubleDouble(stream.signed_unit() * 0x1p-60);
      }
      j(i, i) += DoubleDouble(3);  // makes j definite
    }
    const PrincipalAxes p = principal_axes(j);
    Matrix3<DoubleDouble> diagonal = Matrix3<DoubleDouble>::Constant(DoubleDouble(0));
    for (int i = 0; i < 3; ++i) {
      diagonal(i, i) = p.moments[i];
    }
    const Matrix3<DoubleDouble> r = p.axes;
    const Matrix3<DoubleDouble> back = r * diagonal * r.transpose();
    const Matrix3<DoubleDouble> identity = r * r.transpose();
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(std::abs((back(i, k) - j(i, k)).high()), 0x1p-95 * 5);
        EXPECT_LE(std::abs((identity(i, k) - DoubleDouble(i == k ? 1 : 0)).high()), 0x1p-98);
      }
    }
  }
}

TEST(MassProperties, AreRefusedForDensitiesAndSizesOutOfRange) {
  const ConvexPolyhedron cube = unit::hull_of(unit::box_points({1, 1, 1}));
  for (const double density : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(std::get<ShapeDefect>(polyhedral_body(cube, density)).text,
              "the density is not a positive finite number");
    EXPECT_EQ(std::get<ShapeDefect>(sphere_mass_properties(1, density)).text,
              "the density is not a positive finite number");
  }
  for (const double scale : {1e-80, 1e80, 1e300, 1e-300}) {
    const auto result = polyhedral_body(unit::hull_of(unit::box_points({scale, scale, scale})), 1);
    EXPECT_TRUE(std::holds_alternative<ShapeDefect>(result)) << scale;
  }
  EXPECT_TRUE(std::holds_alternative<ShapeDefect>(sphere_mass_properties(1e-200, 1)));
  EXPECT_TRUE(std::holds_alternative<ShapeDefect>(sphere_mass_properties(-1, 1)));
}

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

TEST(RigidBody, OfABoxAwayFromItsOwnFrameIsAsByHand) {
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

TEST(RigidBody, IsTheSameForOrientationsOfAnyLength) {
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

TEST(RigidBody, OfASphereIsABallWithItsMassAndMotion) {
  Sphere sphere;
  sphere.radius = 0.25;
  sphere.density = 6;
  sphere.position = {1, 2, 3};
  sphere.velocity = {4, 5, 6};
  sphere.angular_velocity = {7, 8, 9};
  const RigidBody body = rigid_body(sphere);
  EXPECT_EQ(body.mass, std::numbers::pi / 8);
  EXPECT_NEAR(body.principal_inertia[2], 0.4 * std::numbers::pi / 8 / 16, 1e-16);
  EXPECT_EQ(body.radius(), 0.25);
  EXPECT_EQ(body.shape.margin, 0.25);
  EXPECT_EQ(body.position, sphere.position);
  EXPECT_EQ(body.velocity, sphere.velocity);
  EXPECT_EQ(body.angular_velocity, sphere.angular_velocity);
}

}  // namespace
}  // namespace carom::scene
