// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/oracles/exact/rational.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// A convex body in axes in which its inertia is diagonal, with the centre of mass at the origin.
struct PrincipalShape {
  Vector3<double> second_moments;  // the diagonal of S = (1/vol) ∫ x xᵀ, each correct to the last place [m²]
  Vector3<double> point;           // a point of the body [m]
};

/// A random convex polyhedron, the hull of 4 to 8 integer points. Its second moments S are rational; with S = L D Lᵀ
/// the shear L⁻¹ takes it to a convex polyhedron whose second moments are D: exact mass properties without an
/// eigenproblem.
[[nodiscard]] PrincipalShape random_polyhedron(Stream& stream);

}  // namespace carom::properties
