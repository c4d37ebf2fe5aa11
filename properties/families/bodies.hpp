// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/properties/families/family.hpp>

/// The pieces that families are put together from.
namespace carom::properties {

/// V = V_A − V_B at the contact point, rounded: good enough to place a case, not to judge one.
[[nodiscard]] Vector3<double> relative_velocity(const Collision& collision);

/// Sets V by the linear velocity of one body, up to rounding: A's, or B's where A is immovable.
void set_relative_velocity(Collision& collision, const Vector3<double>& wanted);

/// Turns the normal around where the contact is not approaching.
void make_approaching(Collision& collision);

/// N·V < 0, as rounded.
[[nodiscard]] bool is_approaching(const Collision& collision);

/// Reverses all motion where the bodies separate: that keeps what is zero, equal, parallel or along an axis. True where
/// it does.
bool reverse_if_separating(Collision& collision);

/// Makes a body immovable and keeps its place; its velocity becomes zero.
void make_immovable(Body& body);

/// Two bodies of general inertia, the contact within about one body's size of both, approaching.
[[nodiscard]] Case general_bodies(Stream& stream);

/// The same, one in four with a few special values and relations (features/compose.hpp).
[[nodiscard]] Case sprinkled_bodies(Stream& stream);

/// Two convex bodies of uniform density, ellipsoids and polyhedra, the contact in or on both, approaching.
[[nodiscard]] Case convex_bodies(Stream& stream);

/// Two spheres that touch: r_A × N = r_B × N = 0 exactly, approaching.
[[nodiscard]] Case touching_spheres(Stream& stream);

/// A vector orthogonal to this one, exactly: two components exchanged, one negated. Never zero for a nonzero vector.
[[nodiscard]] Vector3<double> orthogonal(const Vector3<double>& vector);

}  // namespace carom::properties
