// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// A convex body as its corners and what joins them.
struct ConvexPolyhedron {
  std::vector<Vector3<double>> vertices;          // each of them a corner [m]
  std::vector<std::vector<std::size_t>> faces;    // corners in order, counterclockwise as seen from outside
  std::vector<std::array<std::size_t, 2>> edges;  // each once, the lesser index first
};

/// Why a list of points is no convex polyhedron, or a polyhedron no body.
struct ShapeDefect {
  std::string text;  // names the vertex by its index in the list, where it is one vertex's
};

/// The convex hull of points in any frame [m], where each of them is a corner of it. Everything is decided exactly:
/// points that share a plane are one face, however many they are, and a point is no corner where it lies inside, on a
/// face or on an edge, or is in the list twice; such a point is a defect, as are fewer than four points, points in one
/// plane, and numbers that are not finite. Gift wrapping (D. Chand, S. Kapur, "An algorithm for convex polytopes", J.
/// ACM 17, 1970): of the order of vertices times edges.
[[nodiscard]] std::variant<ConvexPolyhedron, ShapeDefect> convex_polyhedron(std::vector<Vector3<double>> vertices);

}  // namespace carom::scene
