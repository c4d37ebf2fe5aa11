// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// A convex body in axes that make its inertia diagonal, with the centre of mass at the origin.
struct PrincipalShape {
  Vector3<double> second_moments;  // the diagonal of S = (1/vol) ∫ x xᵀ, each correct to the last place [m²]
  Vector3<double> point;           // a point of the body [m]
};

/// A random convex polyhedron. It starts from the hull of 4 to 8 integer points, whose second moments S are rational.
/// With S = L D Lᵀ (L unit triangular, D diagonal), the shear L⁻¹ maps the hull to a convex polyhedron with second
/// moments D. So the mass properties of this polyhedron are exact without an eigenvalue problem.
[[nodiscard]] PrincipalShape random_polyhedron(Stream& stream);

}  // namespace carom::properties
