// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// A convex body with its corners, faces and edges.
struct ConvexPolyhedron {
  std::vector<Vector3<double>> vertices;          // every vertex is a corner [m]
  std::vector<std::vector<std::size_t>> faces;    // corners in order, counterclockwise as seen from outside
  std::vector<std::array<std::size_t, 2>> edges;  // each once, with the smaller index first
};

/// Why points do not form a convex polyhedron, or why a polyhedron is not a body.
struct ShapeDefect {
  std::string text;  // if the defect belongs to one vertex, names its index in the list
};

/// The convex hull of points in any frame [m], or a defect if a point is not a corner of the hull. All decisions are
/// exact. Points in one plane form one face. Defects are: a point inside the hull, on a face or on an edge; a point
/// twice; fewer than four points; points in one plane; numbers that are not finite. The algorithm is gift wrapping (D.
/// Chand, S. Kapur, "An algorithm for convex polytopes", J. ACM 17, 1970). Its time is of the order of vertices times
/// edges.
[[nodiscard]] std::variant<ConvexPolyhedron, ShapeDefect> convex_polyhedron(std::vector<Vector3<double>> vertices);

}  // namespace carom::scene
