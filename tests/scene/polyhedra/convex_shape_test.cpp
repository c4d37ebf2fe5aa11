// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include <carom/oracles/exact/rational.hpp>
#include <carom/scene/polyhedra/convex_shape.hpp>

#include "bodies.hpp"

namespace carom::scene {
namespace {

using oracles::Rational;
using unit::Points;
using unit::Vector;

std::map<std::size_t, int> faces_by_corners(const ConvexPolyhedron& polyhedron) {
  std::map<std::size_t, int> counts;
  for (const auto& face : polyhedron.faces) {
    ++counts[face.size()];
  }
  return counts;
}

/// Checks exactly that faces, edges and vertices form a convex polyhedron.
void expect_convex(const ConvexPolyhedron& hull) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& face : hull.faces) {
    ASSERT_GE(face.size(), 3U);
    for (std::size_t i = 0; i < face.size(); ++i) {
      ++sides[{face[i], face[(i + 1) % face.size()]}];
      for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
        const int side = side_of_plane(hull.vertices[face[i]], hull.vertices[face[(i + 1) % face.size()]],
                                       hull.vertices[face[(i + 2) % face.size()]], hull.vertices[v]);
        const bool on_face = std::find(face.begin(), face.end(), v) != face.end();
        ASSERT_EQ(side, on_face ? 0 : -1);
      }
    }
  }
  for (const auto& [side, count] : sides) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(sides.contains({side.second, side.first}));
  }
  EXPECT_EQ(hull.edges.size() * 2, sides.size());
  EXPECT_EQ(hull.vertices.size() + hull.faces.size(), hull.edges.size() + 2);  // Euler
}

TEST(ConvexPolyhedron, MergesTrianglesThatShareAPlane) {
  const ConvexPolyhedron box = unit::hull_of(unit::box_points({0.1, 0.2, 0.3}));
  expect_convex(box);
  EXPECT_EQ(faces_by_corners(box), (std::map<std::size_t, int>{{4, 6}}));

  Points cut = unit::box_points({2, 2, 2});  // the corner (2, 2, 2) cut off
  cut.pop_back();
  cut.insert(cut.end(), {{1, 2, 2}, {2, 1, 2}, {2, 2, 1}});
  const ConvexPolyhedron prism = unit::hull_of(cut);
  expect_convex(prism);
  EXPECT_EQ(faces_by_corners(prism), (std::map<std::size_t, int>{{3, 1}, {4, 3}, {5, 3}}));
}

TEST(ConvexPolyhedron, FindsFacesWithManyCorners) {
  Points points;
  for (int i = -6; i <= 6; ++i) {
    for (const double z : {0.0, 1.0}) {
      points.emplace_back(i, i * i, z);  // exact points of a parabola
    }
  }
  const ConvexPolyhedron prism = unit::hull_of(points);
  expect_convex(prism);
  EXPECT_EQ(faces_by_corners(prism), (std::map<std::size_t, int>{{4, 13}, {13, 2}}));
}

TEST(ConvexPolyhedron, OfRandomPointsIsExactlyConvex) {
  int hulls = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const Points points = unit::ellipsoid_points(stream, stream.integer(4, 40));
    if (unit::defect_of(points).empty()) {
      expect_convex(unit::hull_of(points));
      ++hulls;
    }
  }
  EXPECT_GT(hulls, 50);
}

/// A point one ulp above a face is a corner.
TEST(ConvexPolyhedron, HasACornerOneUlpAboveAFace) {
  Points points = unit::box_points({1, 1, 1});
  points.emplace_back(0.3, 0.7, std::nextafter(1.0, 2.0));
  EXPECT_EQ(unit::hull_of(points).faces.size(), 9U);
  points.back().z() = 1;
  EXPECT_NE(unit::defect_of(points).find("vertex 8 is not a corner"), std::string::npos);
}

TEST(ConvexPolyhedron, IsRefusedWithTheReasonIfAPointIsNoCorner) {
  const Points cube = unit::box_points({1, 1, 1});
  const auto with = [&](const Vector& point) {
    Points points = cube;
    points.push_back(point);
    return unit::defect_of(points);
  };
  EXPECT_NE(with({0.5, 0.5, 0.5}).find("vertex 8 is not a corner"), std::string::npos);
  EXPECT_NE(with({0.5, 0, 0}).find("vertex 8 is not a corner"), std::string::npos);
  EXPECT_NE(with({0.5, 0.25, 0}).find("vertex 8 is not a corner"), std::string::npos);
  EXPECT_EQ(with({1, 0, 0}), "vertex 8 equals vertex 1; remove one of them");
  EXPECT_EQ(with({1, -0.0, 0}), "vertex 8 equals vertex 1; remove one of them");
  EXPECT_EQ(with({1, std::numeric_limits<double>::quiet_NaN(), 0}),
            "vertex 8 has a coordinate that is not a finite number");
  EXPECT_EQ(unit::defect_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "a polyhedron needs at least 4 vertices, not 3");
  EXPECT_EQ(unit::defect_of({}), "a polyhedron needs at least 4 vertices, not 0");
  EXPECT_EQ(unit::defect_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
            "all vertices lie in one plane; a polyhedron needs a volume");
  EXPECT_EQ(unit::defect_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {5, 5, 5}}),
            "all vertices lie in one plane; a polyhedron needs a volume");
}

TEST(ConvexPolyhedron, MayHaveTheSmallestAndTheGreatestCoordinates) {
  for (const double scale : {0x1p-1074, 0x1p-500, 0x1p500, 0x1p1023}) {
    const ConvexPolyhedron box = unit::hull_of(unit::box_points({scale, scale, scale}));
    EXPECT_EQ(box.faces.size(), 6U) << scale;
  }
}

/// The sign of ((b − a) × (c − a)) · (d − a) in ℚ.
int exact_sign(const std::array<Vector3<double>, 4>& points) {
  const auto side = [&](std::size_t i) {
    Vector3<Rational> result;
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] = Rational(points[i][axis]) - Rational(points[0][axis]);
    }
    return result;
  };
  return oracles::sign_of(side(1).cross(side(2)).dot(side(3)));
}

/// 2³⁰⁰ · 2⁻⁵⁴⁰ · 2⁻⁵⁴⁰ − 2⁻²⁶⁰ · 2⁻⁵⁴⁰ is positive. In binary64 the first product underflows.
TEST(SideOfPlane, IsExactIfAProductUnderflows) {
  EXPECT_EQ(side_of_plane({0, 0, 0}, {0x1p-260, 0x1p-540, 0}, {0, 0, 0x1p-540}, {0x1p+300, 1, 0}), 1);
}

/// Numbers of like and of very unlike sizes; often the four points nearly lie in a plane.
TEST(SideOfPlane, IsExactForNumbersOfAnySize) {
  properties::Stream stream = properties::stream_from(17);
  int decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const int spread = stream.chance(2) ? 3 : 400;
    std::array<Vector3<double>, 4> p;
    for (Vector3<double>& point : p) {
      for (double& number : point) {
        number = stream.chance(4) ? 0 : std::ldexp(stream.integer(-3, 3), stream.integer(-spread, spread));
      }
    }
    const int expected = exact_sign(p);
    decided += expected != 0 ? 1 : 0;
    ASSERT_EQ(side_of_plane(p[0], p[1], p[2], p[3]), expected) << i;
  }
  EXPECT_GT(decided, 5000);
}

}  // namespace
}  // namespace carom::scene
