// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <variant>

#include <carom/scene/polyhedra/convex_shape.hpp>
#include <carom/scene/polyhedra/mass_properties.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// A body at the beginning of a scene. In the shape's frame, the origin is the centre of mass, and the axes are the
/// principal axes.
struct RigidBody {
  ConvexShape shape;
  double mass = 1;                             // [kg]
  Vector3<double> principal_inertia{1, 1, 1};  // along the body axes [kg m²]
  Vector3<double> position{0, 0, 0};           // of the centre of mass [m]
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes, of length 1 within rounding
  Vector3<double> velocity{0, 0, 0};           // of the centre of mass [m/s]
  Vector3<double> angular_velocity{0, 0, 0};   // [rad/s]

  /// An upper bound of the distance of every point from the centre of mass [m].
  [[nodiscard]] double radius() const { return shape.core_radius + shape.margin; }
};

/// The body of a polyhedron, or the defect of its vertices or its density. Preconditions: position and velocities are
/// finite; the orientation is finite and not zero.
[[nodiscard]] std::variant<RigidBody, ShapeDefect> rigid_body(const Polyhedron& polyhedron);

/// The body of a sphere. Precondition: the sphere is valid (valid_scene.hpp).
[[nodiscard]] RigidBody rigid_body(const Sphere& sphere);

}  // namespace carom::scene
