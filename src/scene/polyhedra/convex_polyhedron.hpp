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

/// The reason why points do not form a convex polyhedron, or why a polyhedron is not a body.
struct ShapeDefect {
  std::string text;  // if the defect belongs to one vertex, names its index in the list
};

/// The convex hull of points in any frame [m], if each point is a corner of the hull. Every decision is exact. Points
/// in one plane form one face, however many they are. A point that is not a corner is a defect: it lies inside the
/// hull, on a face or on an edge, or is in the list twice. Fewer than four points, points in one plane, and numbers
/// that are not finite are defects too. The algorithm is gift wrapping (D. Chand, S. Kapur, "An algorithm for convex
/// polytopes", J. ACM 17, 1970). Its time is of the order of vertices times edges.
[[nodiscard]] std::variant<ConvexPolyhedron, ShapeDefect> convex_polyhedron(std::vector<Vector3<double>> vertices);

}  // namespace carom::scene
