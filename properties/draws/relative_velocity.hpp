// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>

/// What families and features ask of the relative velocity at the contact, and how they set it.
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

}  // namespace carom::properties
