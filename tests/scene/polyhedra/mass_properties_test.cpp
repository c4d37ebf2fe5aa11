// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <carom/scene/polyhedra/principal_axes.hpp>

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

TEST(MassProperties, OfABoxAreTheTextbooks) {
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

/// A cube with a corner cut off is the cube minus a tetrahedron with three equal perpendicular edges.
TEST(MassProperties, OfACutCubeAreADifference) {
  Points cut = unit::box_points({2, 2, 2});
  cut.pop_back();
  cut.insert(cut.end(), {{1, 2, 2}, {2, 1, 2}, {2, 2, 1}});
  const PolyhedralBody body = unit::body_of(cut);
  const double volume = 8 - 1.0 / 6;
  const Vector corner_centre = Vector::Constant(1.75);
  const Vector centre = (8 * Vector::Ones() - corner_centre / 6) / volume;
  // About its own centre, the tetrahedron that is cut off (edge 1) has ∫x² = 1/160 and ∫xy = −1/480, both for the
  // volume 1/6.
  Matrix3<double> second = Matrix3<double>::Constant(-1.0 / 480);
  second.diagonal().setConstant(3.0 / 480);
  const Matrix3<double> corner =
      second.trace() * Matrix3<double>::Identity() - second + of_point(1.0 / 6, corner_centre - centre);
  const Matrix3<double> expected = about_centre_of_box({2, 2, 2}, 8) + of_point(8, Vector::Ones() - centre) - corner;
  EXPECT_DOUBLE_EQ(body.properties.volume, volume);
  EXPECT_LE((body.properties.centre - centre).norm(), 0x1p-51);
  EXPECT_LE((body.properties.inertia - expected).norm(), 0x1p-50 * expected.norm());
}

/// The inertia of a body is the sum over its tetrahedra.
TEST(MassProperties, AddUp) {
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

TEST(MassProperties, HaveAxesThatMakeTheTensorDiagonal) {
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
    // In its own frame, the body has its centre at 0 and a diagonal tensor, up to the rounding of its vertices.
    const PolyhedralBody again = unit::body_of(body.shape.vertices.size() == 8 && body.shape.faces.size() == 6
                                                   ? unit::box_points(2 * body.shape.vertices.back().cwiseAbs())
                                                   : body.shape.vertices);
    EXPECT_LE((again.properties.principal_inertia - p.principal_inertia).norm(), 0x1p-47 * p.inertia.norm());
    EXPECT_NEAR(again.properties.volume, p.volume, 0x1p-47 * p.volume);
  }
}

TEST(MassProperties, Scale) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const PolyhedralBody body = unit::random_body(stream);
    for (const int k : {-40, 40}) {
      Points scaled = body.shape.vertices;
      for (Vector& point : scaled) {
        point *= std::ldexp(1.0, k);
      }
      if (!unit::defect_of(body.shape.vertices).empty()) {
        continue;
      }
      const MassProperties one = unit::body_of(body.shape.vertices, 2).properties;
      const MassProperties other = unit::body_of(scaled, 2).properties;
      EXPECT_EQ(other.mass, std::ldexp(one.mass, 3 * k));
      EXPECT_EQ(other.inertia, one.inertia * std::ldexp(1.0, 5 * k));
      EXPECT_EQ(other.principal_inertia, one.principal_inertia * std::ldexp(1.0, 5 * k));
      EXPECT_EQ(other.orientation, one.orientation);
    }
  }
}

TEST(MassProperties, MoveWithTheBody) {
  Points points{{0, 0, 0}, {3, 0, 1}, {0, 5, 0}, {1, 1, 4}, {3, 4, 3}};
  const Vector shift(1e9, -7e8, 0x1p40);
  const MassProperties near = unit::body_of(points).properties;
  const MassProperties far = unit::body_of(unit::moved(points, Matrix3<double>::Identity(), shift)).properties;
  EXPECT_EQ(near.inertia, far.inertia);
  EXPECT_EQ(near.principal_inertia, far.principal_inertia);
  EXPECT_EQ(near.volume, far.volume);
}

TEST(MassProperties, TurnWithTheBody) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Points points = unit::ellipsoid_points(stream, 9);
    if (!unit::defect_of(points).empty()) {
      continue;
    }
    const Matrix3<double> turn = unit::matrix_of(unit::unit_quaternion(stream));
    const Points turned = unit::moved(points, turn, {1, 2, 3});
    const MassProperties one = unit::body_of(points).properties;
    const MassProperties other = unit::body_of(turned).properties;
    EXPECT_LE((turn * one.inertia * turn.transpose() - other.inertia).norm(), 0x1p-46 * one.inertia.norm());
  }
}

TEST(MassProperties, OfNeedlesKeepTheLeastMoment) {
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

TEST(PrincipalAxes, AreGoodToA106Bits) {
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

TEST(MassProperties, OfABallAreTheTextbooks) {
  const auto ball = std::get<MassProperties>(sphere_mass_properties(0.5, 6));
  EXPECT_EQ(ball.mass, 0x1.921fb54442d18p+1);  // 4/3 π / 8 · 6 = π
  EXPECT_DOUBLE_EQ(ball.principal_inertia[0], 0.1 * 0x1.921fb54442d18p+1);
}

TEST(MassProperties, SayWhatIsWrong) {
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

}  // namespace
}  // namespace carom::scene
