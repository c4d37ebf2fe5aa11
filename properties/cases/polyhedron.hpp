// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// A convex body with its centre of mass at the origin, in axes that make its inertia diagonal.
struct PrincipalShape {
  Vector3<double> second_moments;  // the diagonal of S = (1/vol) ∫ x xᵀ, each correct to the last place [m²]
  Vector3<double> point;           // a point of the body [m]
};

/// A random convex polyhedron with exact mass properties, without an eigenvalue problem. The hull of 4 to 8 integer
/// points has rational second moments S = L D Lᵀ (L unit triangular, D diagonal). The shear L⁻¹ maps the hull to a
/// convex polyhedron with second moments D.
[[nodiscard]] PrincipalShape random_polyhedron(Stream& stream);

}  // namespace carom::properties
