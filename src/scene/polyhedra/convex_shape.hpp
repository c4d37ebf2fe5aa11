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

/// The exact sign of (b − a) × (c − a) · (d − a): +1 if d lies on the side from which a, b, c appear counterclockwise,
/// and 0 if the four points share a plane. If the error bound of J. Shewchuk ("Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", Discrete Comput. Geom. 18, 1997, `o3derrboundA`) leaves the sign
/// open, rational numbers decide. Precondition: every number is finite.
[[nodiscard]] int side_of_plane(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                                const Vector3<double>& d);

/// A shape that can touch others: all points within `margin` of the hull of the core's vertices, in the body frame. A
/// polyhedron has margin 0. A ball is one vertex with its radius as margin.
struct ConvexShape {
  ConvexPolyhedron core;
  double margin = 0;       // [m]
  double core_radius = 0;  // upper bound of the distance of every vertex from 0 [m]
};

/// A ball about the origin. Precondition: the radius [m] is positive.
[[nodiscard]] ConvexShape ball_shape(double radius);

/// All points x with normal · x ≤ offset, in the world.
struct HalfSpace {
  Vector3<double> normal{0, 0, 1};  // of length 1 within rounding
  double offset = 0;                // [m]
};

/// A placement of a shape, with bounds of its errors.
struct Placement {
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes, not zero
  Vector3<double> position{0, 0, 0};           // of the body frame's origin, world [m]
  double angle_error = 0;                      // [rad]
  double position_error = 0;                   // [m]
};

/// The vertices of the placed core, relative to a nearby point: x − origin [m].
[[nodiscard]] std::vector<Vector3<double>> placed_vertices(const ConvexShape& shape, const Placement& placement,
                                                           const Vector3<double>& origin);

/// The largest distance by which the errors of the placement move a vertex [m].
[[nodiscard]] double placement_error(const ConvexShape& shape, const Placement& placement);

/// Let x and y be placed vertices of two shapes with these core radii at this distance, and n a vector of length 1
/// within rounding. Returns an upper bound of the rounding error of (x − y) · n [m]. In units of 2⁻⁵³ (distance +
/// radii), the rotations add 17 (each number of a rotation matrix has an error of at most 8 · 2⁻⁵³). The positions add
/// 2, the product with n adds 4, and the length of n adds 4. The sum is 27; the function uses 64.
[[nodiscard]] inline double rounding_of_gap(double distance, double radius_a, double radius_b) {
  return 0x1p-47 * (distance + radius_a + radius_b);
}

}  // namespace carom::scene
