// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/properties/draws/stream.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::scene::unit {

using Vector = Vector3<double>;
using Points = std::vector<Vector>;
using properties::Stream;

/// A box with its lowest corner at 0.
[[nodiscard]] inline Points box_points(const Vector& size) {
  Points points;
  for (unsigned i = 0; i < 8; ++i) {
    points.emplace_back((i & 1U) * size.x(), ((i >> 1U) & 1U) * size.y(), ((i >> 2U) & 1U) * size.z());
  }
  return points;
}

/// Four corners of the cube from −1 to 1.
[[nodiscard]] inline Points tetrahedron_points() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

[[nodiscard]] inline Vector unit_vector(Stream& stream) {
  Vector v;
  do {
    v = stream.vector();
  } while (v.norm() < 0.1);
  return v.normalized();
}

[[nodiscard]] inline Quaternion<double> unit_quaternion(Stream& stream) { return stream.quaternion().normalized(); }

/// Points on an ellipsoid with half axes from 1/4 to 2. Except for rounding, all points are corners.
[[nodiscard]] inline Points ellipsoid_points(Stream& stream, int count) {
  const Vector axes(stream.between(0.25, 2), stream.between(0.25, 2), stream.between(0.25, 2));
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(axes.cwiseProduct(unit_vector(stream)));
  }
  return points;
}

[[nodiscard]] inline Points moved(Points points, const Matrix3<double>& turn, const Vector& shift) {
  for (Vector& point : points) {
    point = turn * point + shift;
  }
  return points;
}

[[nodiscard]] inline Matrix3<double> matrix_of(const Quaternion<double>& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// The defect of the points; empty if they form a convex polyhedron.
[[nodiscard]] inline std::string defect_of(const Points& points) {
  const auto result = convex_polyhedron(points);
  const auto* defect = std::get_if<ShapeDefect>(&result);
  return defect != nullptr ? defect->text : "";
}

[[nodiscard]] inline ConvexPolyhedron hull_of(const Points& points) {
  return std::get<ConvexPolyhedron>(convex_polyhedron(points));
}

[[nodiscard]] inline PolyhedralBody body_of(const Points& points, double density = 1) {
  return std::get<PolyhedralBody>(polyhedral_body(hull_of(points), density));
}

[[nodiscard]] inline PolyhedralBody random_body(Stream& stream) {
  while (true) {
    const Points points = stream.chance(3) ? box_points({stream.between(0.25, 2), stream.between(0.25, 2), 1})
                                           : ellipsoid_points(stream, stream.integer(4, 14));
    if (defect_of(points).empty()) {
      return body_of(points);
    }
  }
}

}  // namespace carom::scene::unit
