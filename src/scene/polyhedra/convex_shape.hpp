// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>
#include <carom/scene/polyhedra/mass_properties.hpp>

namespace carom::scene {

/// A shape that can touch others: all points within `margin` of the hull of the core's vertices, in the body frame. A
/// polyhedron has margin 0. A ball is one vertex with its radius as margin.
struct ConvexShape {
  ConvexPolyhedron core;
  double margin = 0;       // [m]
  double core_radius = 0;  // upper bound of the distance of every vertex from 0 [m]
};

[[nodiscard]] ConvexShape convex_shape(const PolyhedralBody& body);

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
