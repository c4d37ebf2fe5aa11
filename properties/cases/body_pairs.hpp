// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/cases/family.hpp>

namespace carom::properties {

/// Two approaching bodies of general inertia. The contact is at most about one body size from each centre of mass.
[[nodiscard]] Case general_bodies(Stream& stream);

/// `general_bodies` with friction. One case in four also gets a few features (`sprinkle`, features/compose.hpp).
[[nodiscard]] Case sprinkled_bodies(Stream& stream);

/// A convex body of uniform density, an ellipsoid or a polyhedron. The point is inside or on the surface.
[[nodiscard]] Body convex_body(Stream& stream, const Vector3<double>& point);

/// Two approaching convex bodies of uniform density, ellipsoids or polyhedra. The contact is inside or on the surface
/// of both.
[[nodiscard]] Case convex_bodies(Stream& stream);

/// Two approaching spheres that touch, with lever arms r exactly parallel to N.
[[nodiscard]] Case touching_spheres(Stream& stream);

}  // namespace carom::properties
