// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <carom/scene/polyhedra/contact_patch.hpp>

#include "distance_by_features.hpp"

namespace carom::scene {
namespace {

using unit::Vector;

constexpr double small_gap = 1e-9;
constexpr double flatness = 1e-7;
const Quaternion<double> upright(1, 0, 0, 0);
const HalfSpace ground{{0, 0, 1}, 0};

ConvexShape box(const Vector& size) { return convex_shape(unit::body_of(unit::box_points(size))); }

/// A rotation by an angle about an axis: x (0), y (1) or z (2).
Quaternion<double> about(int axis, double angle) {
  Quaternion<double> q(std::cos(angle / 2), 0, 0, 0);
  q[axis + 1] = std::sin(angle / 2);
  return q;
}

void expect_points(const std::vector<Vector>& found, const std::vector<Vector>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  for (const Vector& point : expected) {
    const bool is_found =
        std::any_of(found.begin(), found.end(), [&](const Vector& other) { return (other - point).norm() <= 1e-6; });
    EXPECT_TRUE(is_found) << point.transpose();
  }
}

ContactPatch on_floor(const Quaternion<double>& orientation, double height) {
  return contact_patch(box({2, 2, 2}), {orientation, {5, 7, height + small_gap}, 0, 0}, ground, flatness);
}

TEST(ContactPatch, OfACubeOnAFloorIsItsFaceItsEdgeOrItsCorner) {
  const ContactPatch face = on_floor(upright, 1);
  expect_points(face.vertices, {{4, 6, 0}, {6, 6, 0}, {6, 8, 0}, {4, 8, 0}});
  EXPECT_LE((face.point - Vector(5, 7, small_gap / 2)).norm(), 1e-14);

  const ContactPatch edge = on_floor(about(0, std::numbers::pi / 4), std::numbers::sqrt2);
  expect_points(edge.vertices, {{4, 7, 0}, {6, 7, 0}});
  EXPECT_LE((edge.point - Vector(5, 7, small_gap / 2)).norm(), 1e-14);

  // The diagonal (1, 1, 1) points down.
  const auto diagonal = Eigen::Quaterniond::FromTwoVectors(Vector(1, 1, 1), Vector(0, 0, -1));
  const ContactPatch corner = on_floor({diagonal.w(), diagonal.x(), diagonal.y(), diagonal.z()}, std::numbers::sqrt3);
  expect_points(corner.vertices, {{5, 7, 0}});
}

ContactPatch between(const ConvexShape& a, const Placement& at_a, const ConvexShape& b, const Placement& at_b) {
  const ShapePair pair(a, b);
  return contact_patch(pair, at_a, at_b, pair.separation(at_a, at_b), flatness);
}

TEST(ContactPatch, OfTwoFacesIsTheirOverlap) {
  const ContactPatch patch =
      between(box({2, 2, 2}), {upright, {1.5, 1, 2 + small_gap}, 0, 0}, box({2, 4, 2}), {upright, {0, 0, 0}, 0, 0});
  expect_points(patch.vertices, {{0.5, 0, 1}, {1, 0, 1}, {1, 2, 1}, {0.5, 2, 1}});
  EXPECT_LE((patch.point - Vector(0.75, 1, 1)).norm(), flatness);
  // After an eighth of a turn, the overlap of two squares is an octagon.
  const ContactPatch octagon = between(box({2, 2, 2}), {about(2, std::numbers::pi / 4), {0, 0, 2 + small_gap}, 0, 0},
                                       box({2, 2, 2}), {upright, {0, 0, 0}, 0, 0});
  EXPECT_EQ(octagon.vertices.size(), 8U);
  EXPECT_LE((octagon.point - Vector(0, 0, 1)).norm(), 2 * small_gap);
}

TEST(ContactPatch, OfEdgesIsTheirCrossingOrTheirSharedPart) {
  const Quaternion<double> along_x = about(0, std::numbers::pi / 4);
  const Quaternion<double> along_y = about(1, std::numbers::pi / 4);
  const ContactPatch crossing =
      between(box({4, 2, 2}), {along_x, {0.5, 0.25, 2 * std::numbers::sqrt2 + small_gap}, 0, 0}, box({2, 4, 2}),
              {along_y, {0, 0, 0}, 0, 0});
  expect_points(crossing.vertices, {{0, 0.25, std::numbers::sqrt2}});

  const ShapePair pair(box({4, 2, 2}), box({4, 2, 2}));
  const Placement above{along_x, {3, 0, 2 * std::numbers::sqrt2 + small_gap}, 0, 0};
  const Placement below{along_x, {0, 0, 0}, 0, 0};
  const ContactPatch shared = contact_patch(pair, above, below, {{0, 0, 1}, small_gap, small_gap}, flatness);
  expect_points(shared.vertices, {{1, 0, std::numbers::sqrt2}, {2, 0, std::numbers::sqrt2}});
}

TEST(ContactPatch, OfAnEdgeOverAFaceEndsWithTheFace) {
  const ContactPatch patch =
      between(box({4, 2, 2}), {about(0, std::numbers::pi / 4), {1.5, 0, 1 + std::numbers::sqrt2 + small_gap}, 0, 0},
              box({2, 2, 2}), {upright, {0, 0, 0}, 0, 0});
  expect_points(patch.vertices, {{-0.5, 0, 1}, {1, 0, 1}});
}

TEST(ContactPatch, OfABallIsOnePoint) {
  const ContactPatch on_box = between(ball_shape(0.5), {upright, {0.25, 0.5, 1.5 + small_gap}, 0, 0}, box({2, 2, 2}),
                                      {upright, {0, 0, 0}, 0, 0});
  EXPECT_EQ(on_box.vertices.size(), 1U);
  EXPECT_LE((on_box.point - Vector(0.25, 0.5, 1 + small_gap / 2)).norm(), 1e-14);
  const ContactPatch balls =
      between(ball_shape(0.5), {upright, {0, 3, 0}, 0, 0}, ball_shape(2.5), {upright, {0, 0, 0}, 0, 0});
  EXPECT_EQ(balls.vertices.size(), 1U);
  EXPECT_LE((balls.point - Vector(0, 2.5, 0)).norm(), 1e-14);
}

/// A random face of one body lies on a random face of the other.
TEST(ContactPatch, LiesOnBothBodies) {
  const ConvexShape point{{{Vector::Zero()}, {}, {}}, 0, 0};
  int polygons = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    properties::Stream stream = properties::stream_from(seed);
    const ConvexShape a = convex_shape(unit::random_body(stream));
    const ConvexShape b = convex_shape(unit::random_body(stream));
    const auto laid = [&](const ConvexShape& shape, const Vector& direction) {
      const auto& face = shape.core.faces[static_cast<std::size_t>(stream.integer(0, 3))];
      const Vector normal = (shape.core.vertices[face[1]] - shape.core.vertices[face[0]])
                                .cross(shape.core.vertices[face[2]] - shape.core.vertices[face[1]]);
      const auto turn = Eigen::Quaterniond::FromTwoVectors(normal, direction);
      return Quaternion<double>(turn.w(), turn.x(), turn.y(), turn.z());
    };
    const Placement at_b{laid(b, {0, 0, 1}), {0, 0, 0}, 0, 0};
    Placement at_a{laid(a, {0, 0, -1}), {0.2 * stream.signed_unit(), 0.2 * stream.signed_unit(), 9}, 0, 0};
    const ShapePair pair(a, b);
    double highest = 0;
    for (const Vector& v : placed_vertices(b, at_b, Vector::Zero())) {
      highest = std::max(highest, v.z());
    }
    at_a.position.z() -= separation(a, at_a, {{0, 0, 1}, highest}).gap - small_gap;
    const Separation found = pair.separation(at_a, at_b);
    if (found.gap > 2 * small_gap) {
      continue;  // beside each other
    }
    const ContactPatch patch = contact_patch(pair, at_a, at_b, found, flatness);
    polygons += patch.vertices.size() > 2 ? 1 : 0;
    std::vector<Vector> points = patch.vertices;
    points.push_back(patch.point);
    for (const Vector& vertex : points) {
      const Placement at{upright, vertex, 0, 0};
      EXPECT_LE(unit::distance_by_features(a, at_a, point, at), 100 * flatness) << seed;
      EXPECT_LE(unit::distance_by_features(b, at_b, point, at), 100 * flatness) << seed;
    }
  }
  EXPECT_GT(polygons, 50);
}

}  // namespace
}  // namespace carom::scene
