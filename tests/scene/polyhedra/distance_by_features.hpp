// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <carom/scene/polyhedra/convex_shape.hpp>

#include "bodies.hpp"

/// The distance of two disjoint convex polyhedra as the minimum over all pairs of features, in long double. It shares
/// no code with the search that it checks.
namespace carom::scene::unit {

using Extended = Vector3<long double>;

struct ExtendedPolyhedron {
  std::vector<Extended> points;
  const ConvexPolyhedron& shape;
};

[[nodiscard]] inline ExtendedPolyhedron extended(const ConvexShape& shape, const Placement& placement) {
  const Quaternion<long double> q = placement.orientation.cast<long double>().normalized();
  const Eigen::Quaternion<long double> turn(q[0], q[1], q[2], q[3]);
  ExtendedPolyhedron result{{}, shape.core};
  for (const Vector& vertex : shape.core.vertices) {
    result.points.emplace_back(placement.position.cast<long double>() + turn * vertex.cast<long double>());
  }
  return result;
}

[[nodiscard]] inline long double to_segment(const Extended& p, const Extended& a, const Extended& b) {
  const Extended edge = b - a;
  const long double share = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0L, 1.0L);
  return (p - a - share * edge).norm();
}

[[nodiscard]] inline long double to_triangle(const Extended& p, const Extended& a, const Extended& b,
                                             const Extended& c) {
  const Extended normal = (b - a).cross(c - a);
  const Extended foot = p - (p - a).dot(normal) / normal.squaredNorm() * normal;
  const bool inside = (b - a).cross(foot - a).dot(normal) >= 0 && (c - b).cross(foot - b).dot(normal) >= 0 &&
                      (a - c).cross(foot - c).dot(normal) >= 0;
  return inside ? (p - foot).norm() : std::numeric_limits<long double>::infinity();
}

/// The distance of two segments if the nearest points of their lines lie within them; otherwise infinite.
[[nodiscard]] inline long double within_segments(const Extended& a, const Extended& b, const Extended& c,
                                                 const Extended& d) {
  const Extended u = b - a;
  const Extended v = d - c;
  const Extended w = a - c;
  const long double uv = u.dot(v);
  const long double determinant = u.squaredNorm() * v.squaredNorm() - uv * uv;
  if (determinant <= 1e-17L * u.squaredNorm() * v.squaredNorm()) {
    return std::numeric_limits<long double>::infinity();  // parallel: an end of a segment is among the nearest points
  }
  const long double s = (uv * v.dot(w) - v.squaredNorm() * u.dot(w)) / determinant;
  const long double t = (u.squaredNorm() * v.dot(w) - uv * u.dot(w)) / determinant;
  const bool inside = s >= 0 && s <= 1 && t >= 0 && t <= 1;
  // The distance along the common normal keeps its digits.
  const Extended normal = u.cross(v);
  return inside ? std::abs(w.dot(normal)) / normal.norm() : std::numeric_limits<long double>::infinity();
}

[[nodiscard]] inline long double to_surface(const Extended& p, const ExtendedPolyhedron& body) {
  long double least = std::numeric_limits<long double>::infinity();
  for (const auto& face : body.shape.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      least = std::min(least, to_triangle(p, body.points[face[0]], body.points[face[i]], body.points[face[i + 1]]));
    }
  }
  for (const auto& edge : body.shape.edges) {
    least = std::min(least, to_segment(p, body.points[edge[0]], body.points[edge[1]]));
  }
  return least;
}

/// The distance of two disjoint bodies, including their margins.
[[nodiscard]] inline long double distance_by_features(const ConvexShape& a, const Placement& at_a, const ConvexShape& b,
                                                      const Placement& at_b) {
  const ExtendedPolyhedron first = extended(a, at_a);
  const ExtendedPolyhedron second = extended(b, at_b);
  long double least = std::numeric_limits<long double>::infinity();
  if (first.points.size() == 1 && second.points.size() == 1) {
    least = (first.points[0] - second.points[0]).norm();
  }
  for (const Extended& point : first.points) {
    least = std::min(least, to_surface(point, second));
  }
  for (const Extended& point : second.points) {
    least = std::min(least, to_surface(point, first));
  }
  for (const auto& edge : a.core.edges) {
    for (const auto& other : b.core.edges) {
      least = std::min(least, within_segments(first.points[edge[0]], first.points[edge[1]], second.points[other[0]],
                                              second.points[other[1]]));
    }
  }
  return least - static_cast<long double>(a.margin) - static_cast<long double>(b.margin);
}

}  // namespace carom::scene::unit
