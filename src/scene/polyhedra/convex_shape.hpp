// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>
#include <carom/scene/polyhedra/mass_properties.hpp>

namespace carom::scene {

/// What can touch: all points within `margin` of the hull of the vertices, in the body frame. A polyhedron has margin
/// 0, a ball is one vertex with its radius as margin.
struct ConvexShape {
  ConvexPolyhedron core;
  double margin = 0;       // [m]
  double core_radius = 0;  // at least the distance of every vertex from 0 [m]
};

[[nodiscard]] ConvexShape convex_shape(const PolyhedralBody& body);

/// A ball about 0. Precondition: the radius is positive [m].
[[nodiscard]] ConvexShape ball_shape(double radius);

/// All points x with normal · x ≤ offset, in the world.
struct HalfSpace {
  Vector3<double> normal{0, 0, 1};  // of length 1 within rounding
  double offset = 0;                // [m]
};

/// Where a shape is, and what that may be wrong by.
struct Placement {
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes, not zero
  Vector3<double> position{0, 0, 0};           // of the body frame's origin, world [m]
  double angle_error = 0;                      // [rad]
  double position_error = 0;                   // [m]
};

/// The core's vertices as placed, relative to a point near by: x − origin [m].
[[nodiscard]] std::vector<Vector3<double>> placed_vertices(const ConvexShape& shape, const Placement& placement,
                                                           const Vector3<double>& origin);

/// What the placement's errors move a vertex by, at most [m].
[[nodiscard]] double placement_error(const ConvexShape& shape, const Placement& placement);

/// At least the error of (x − y) · n for placed vertices x and y of shapes with these core radii at this distance, n of
/// length 1 within rounding. In units of 2⁻⁵³: the rotation matrix is right within 8 in each number, so a turned vertex
/// within 17 of its length; the difference of the positions and the sum add 2, the product with n 4, its length 4: less
/// than 27 of distance + radii, and 64 are taken.
[[nodiscard]] inline double rounding_of_gap(double distance, double radius_a, double radius_b) {
  return 0x1p-47 * (distance + radius_a + radius_b);
}

}  // namespace carom::scene
