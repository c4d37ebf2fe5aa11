// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <variant>

#include <carom/collision/vector.hpp>
#include <carom/scene/polyhedra/convex_polyhedron.hpp>

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
  double radius = 0;        // upper bound of the distance of every vertex from the centre of mass [m]
  double vertex_error = 0;  // upper bound of the distance of every vertex from its exact position [m]
};

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
/// vertices, so a face with more than three corners is plane only within `vertex_error`. The given frame affects only
/// the rounding of the vertices, and the choice of axes if moments are equal.
///
/// Returns a defect if the density is not a positive number, or if a result would leave the range of normal doubles.
[[nodiscard]] std::variant<PolyhedralBody, ShapeDefect> polyhedral_body(const ConvexPolyhedron& polyhedron,
                                                                        double density);

/// The mass properties of a ball about 0: m = 4/3 π ρ R³ and I = 2/5 m R², with an error of at most ½ + 2⁻⁴⁰ ulps.
/// Returns a defect if the radius or the density is not a positive number, or if a result would leave the range of
/// normal doubles.
[[nodiscard]] std::variant<MassProperties, ShapeDefect> sphere_mass_properties(double radius, double density);

}  // namespace carom::scene
