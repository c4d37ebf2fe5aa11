// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>

/// Reads and sets the relative velocity at the contact.
namespace carom::properties {

/// V = V_A − V_B at the contact point [m/s], rounded. It is accurate enough to draw a collision, but not to judge an
/// answer.
[[nodiscard]] Vector3<double> relative_velocity(const Collision& collision);

/// Sets V, up to rounding, by changing the linear velocity of A, or of B if A is immovable.
void set_relative_velocity(Collision& collision, const Vector3<double>& wanted);

/// Reverses the normal if the bodies separate.
void make_approaching(Collision& collision);

/// N·V < 0, as rounded.
[[nodiscard]] bool is_approaching(const Collision& collision);

/// Reverses all motion if the bodies separate, and returns whether it did. Zero or equal components, and vectors that
/// are parallel or along an axis, stay so.
bool reverse_if_separating(Collision& collision);

/// Makes a body immovable and keeps its position. Its velocity becomes zero.
void make_immovable(Body& body);

}  // namespace carom::properties
