// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <variant>

#include <carom/collision/vector.hpp>
#include <carom/scene/polyhedra/convex_polyhedron.hpp>

namespace carom::scene {

/// What the motion of a body of uniform density depends on. "Rounded once": computed exactly, then rounded to nearest.
struct MassProperties {
  double volume = 0;                  // rounded once [m³]
  double mass = 0;                    // rounded once [kg]
  Vector3<double> centre{0, 0, 0};    // of mass, in the frame of the vertices as given, rounded once [m]
  Matrix3<double> inertia;            // about the centre, along the axes of that frame, rounded once [kg m²]
  Vector3<double> principal_inertia;  // along the body axes, each within 2⁻⁵² of it [kg m²]
  Quaternion<double> orientation;     // body axes to the axes of that frame; of length 1 within rounding
};

/// A body in its own frame: the centre of mass at 0, the principal axes along x, y and z, none exchanged: the axes of a
/// box along the given axes stay where they are.
struct PolyhedralBody {
  ConvexPolyhedron shape;  // in the body frame [m]
  MassProperties properties;
  double radius = 0;        // at least the distance of every vertex from the centre of mass [m]
  double vertex_error = 0;  // at least the distance of every vertex from where it is exactly [m]
};

/// A polyhedron as a body of uniform density [kg/m³].
///
/// Volume, centre and inertia are integrals of polynomials over tetrahedra (F. Tonon, "Explicit exact formulas for the
/// 3-D tetrahedron inertia tensor in terms of its vertex coordinates", J. Math. Stat. 1, 2005): exact in rationals. The
/// axes are found by Jacobi's rotations in numbers of 106 bits: ‖J − R diag Rᵀ‖ ≤ 2⁻⁹⁰ ‖J‖ for the exact J before
/// anything is rounded to double, so a principal moment keeps its relative precision where it is above 2⁻³⁵ of the
/// greatest. Vertices are turned into the body frame in those numbers and rounded once: each moves by at most 2⁻⁵³ of
/// its distance from the centre. The body that a scene moves is the hull of the rounded vertices; `faces` and `edges`
/// are those of the vertices as given, and a face of more than three corners is plane within `vertex_error`. The mass
/// properties are of the vertices as given. Moving or turning the given frame changes nothing but that rounding, and
/// which of equal axes are chosen.
///
/// A defect where the density is not a positive number, or where a result would leave the range of normal doubles.
[[nodiscard]] std::variant<PolyhedralBody, ShapeDefect> polyhedral_body(const ConvexPolyhedron& polyhedron,
                                                                        double density);

/// Of a ball about 0: m = 4/3 π ρ R³ and I = 2/5 m R², computed in numbers of 106 bits, so within half an ulp and 2⁻⁴⁰
/// of one. A defect as above.
[[nodiscard]] std::variant<MassProperties, ShapeDefect> sphere_mass_properties(double radius, double density);

}  // namespace carom::scene
