// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>

namespace carom::properties {

/// V = V_A − V_B at the contact point [m/s], rounded. Accurate enough to draw a collision, but not to judge an answer.
[[nodiscard]] Vector3<double> relative_velocity(const Collision& collision);

/// Changes the linear velocity of A, or of B if A is immovable, so that V is `wanted` up to rounding.
void set_relative_velocity(Collision& collision, const Vector3<double>& wanted);

/// Reverses the normal if the bodies separate.
void make_approaching(Collision& collision);

/// Whether the rounded N·V is negative.
[[nodiscard]] bool is_approaching(const Collision& collision);

/// Reverses all motion if the bodies separate, and returns whether it did. Zero, equal, parallel and axis-aligned
/// vectors keep these properties.
bool reverse_if_separating(Collision& collision);

/// Makes a body immovable and stops it.
void make_immovable(Body& body);

}  // namespace carom::properties
