// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// The pieces that families are put together from.
namespace carom::properties {

/// Two bodies of general inertia, the contact within about one body's size of both, approaching.
[[nodiscard]] Case general_bodies(Stream& stream);

/// The same, one in four with a few special values and relations (features/compose.hpp).
[[nodiscard]] Case sprinkled_bodies(Stream& stream);

/// Two convex bodies of uniform density, ellipsoids and polyhedra, the contact in or on both, approaching.
[[nodiscard]] Case convex_bodies(Stream& stream);

/// Two spheres that touch: r_A × N = r_B × N = 0 exactly, approaching.
[[nodiscard]] Case touching_spheres(Stream& stream);

}  // namespace carom::properties
