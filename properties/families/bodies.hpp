// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// The building blocks of families.
namespace carom::properties {

/// V = V_A − V_B at the contact point [m/s], rounded. Accurate enough to place a case, but not to judge one.
[[nodiscard]] Vector3<double> relative_velocity(const Collision& collision);

/// Sets V, up to rounding, by changing the linear velocity of A, or of B if A is immovable.
void set_relative_velocity(Collision& collision, const Vector3<double>& wanted);

/// Reverses the normal if the bodies separate.
void make_approaching(Collision& collision);

/// N·V < 0, as rounded.
[[nodiscard]] bool is_approaching(const Collision& collision);

/// Reverses all motion if the bodies separate, and returns whether it did. Components that are zero, equal, parallel or
/// along an axis stay so.
bool reverse_if_separating(Collision& collision);

/// Makes a body immovable and keeps its position. Its velocity becomes zero.
void make_immovable(Body& body);

/// Two approaching bodies of general inertia. The contact is within about one body's size of each.
[[nodiscard]] Case general_bodies(Stream& stream);

/// Two bodies as in `general_bodies`, with friction. One case in four has a few special values and relations
/// (features/compose.hpp).
[[nodiscard]] Case sprinkled_bodies(Stream& stream);

/// Two approaching convex bodies of uniform density, ellipsoids or polyhedra. The contact is in or on both.
[[nodiscard]] Case convex_bodies(Stream& stream);

/// Two approaching spheres that touch: r_A × N = r_B × N = 0 exactly.
[[nodiscard]] Case touching_spheres(Stream& stream);

/// A vector exactly orthogonal to this one: two components are exchanged and one is negated. Nonzero for a nonzero
/// vector.
[[nodiscard]] Vector3<double> orthogonal(const Vector3<double>& vector);

}  // namespace carom::properties
