// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <variant>

#include <carom/collision/vector.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/scene/polyhedra/convex_shape.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// The properties of a body of uniform density that determine its motion. "Rounded once" means computed exactly and
/// rounded to nearest.
struct MassProperties {
  double volume = 0;                  // rounded once [m³]
  double mass = 0;                    // rounded once [kg]
  Vector3<double> centre{0, 0, 0};    // of mass, in the frame of the given vertices, rounded once [m]
  Matrix3<double> inertia;            // about the centre, along the axes of that frame, rounded once [kg m²]
  Vector3<double> principal_inertia;  // along the body axes, each with a relative error of at most 2⁻⁵² [kg m²]
  Quaternion<double> orientation;     // body axes to the axes of that frame; of length 1 within rounding
};

/// A body in its own frame, with the centre of mass at 0 and the principal axes along x, y and z. If the given axes are
/// principal axes, they stay, in their order.
struct PolyhedralBody {
  ConvexPolyhedron shape;  // in the body frame [m]
  MassProperties properties;
  double radius = 0;  // upper bound of the distance of every vertex from the centre of mass [m]
};

[[nodiscard]] inline ConvexShape convex_shape(const PolyhedralBody& body) { return {body.shape, 0, body.radius}; }

/// The factors of an inertia J = axes diag(moments) axesᵀ. The axes are right-handed columns.
struct PrincipalAxes {
  Vector3<impulse::DoubleDouble> moments;
  Matrix3<impulse::DoubleDouble> axes;
};

/// The principal axes of an inertia J by Jacobi's rotations. Each rotation is at most an eighth of a turn, so axes that
/// are almost principal axes keep their order. The error ‖J − axes diag(moments) axesᵀ‖ is at most 2⁻⁹⁵ ‖J‖, because
/// few sweeps suffice, and each rotation adds at most about 2⁻¹⁰⁰ ‖J‖. Precondition: J is symmetric, and its entry of
/// greatest size is between 2⁻¹⁰⁰ and 2¹⁰⁰.
[[nodiscard]] PrincipalAxes principal_axes(Matrix3<impulse::DoubleDouble> inertia);

/// A polyhedron as a body of uniform density [kg/m³].
///
/// Volume, centre and inertia are integrals of polynomials over tetrahedra (F. Tonon, "Explicit exact formulas for the
/// 3-D tetrahedron inertia tensor in terms of its vertex coordinates", J. Math. Stat. 1, 2005), computed in rational
/// numbers. Jacobi's rotations find the axes in numbers of 106 bits: ‖J − R D Rᵀ‖ ≤ 2⁻⁹⁰ ‖J‖ for the exact inertia J,
/// the axes R and the diagonal matrix D of moments. So a principal moment keeps its relative accuracy if it is above
/// 2⁻³⁵ of the greatest moment. The vertices are turned into the body frame in 106 bits and rounded once, so each
/// vertex moves by at most 2⁻⁵³ of its distance from the centre.
///
/// A scene moves the hull of the rounded vertices. `faces`, `edges` and the mass properties are those of the given
/// vertices, so a face with more than three corners is plane only within this rounding. The given frame affects only
/// the rounding of the vertices, and the choice of axes if moments are equal.
///
/// Returns a defect if the density is not a positive number, or if a result would leave the range of normal doubles.
[[nodiscard]] std::variant<PolyhedralBody, ShapeDefect> polyhedral_body(const ConvexPolyhedron& polyhedron,
                                                                        double density);

/// The mass properties of a ball about 0: m = 4/3 π ρ R³ and I = 2/5 m R², with an error of at most ½ + 2⁻⁴⁰ ulps.
/// Returns a defect if the radius or the density is not a positive number, or if a result would leave the range of
/// normal doubles.
[[nodiscard]] std::variant<MassProperties, ShapeDefect> sphere_mass_properties(double radius, double density);

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
