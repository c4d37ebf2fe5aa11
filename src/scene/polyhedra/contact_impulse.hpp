// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/collision.hpp>
#include <carom/collision/law.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/precision.hpp>

namespace carom::scene {

/// The outcome of a law, computed in a precision, for bodies of any shape. Preconditions: the collision is valid; the
/// law is not `any`.
[[nodiscard]] Outcome<double> struck_bodies(Law law, Precision precision, const Collision& collision);

/// The outcome of an impulse along the normal that makes N·V/‖N‖ at least `speed` [m/s], with V the velocity of A's
/// contact point relative to B's. Precondition: the collision is valid.
[[nodiscard]] Outcome<double> sent_apart(const Collision& collision, double speed);

/// N·V/‖N‖, the speed at which the contact points part [m/s].
[[nodiscard]] double parting_speed(const Collision& collision);

}  // namespace carom::scene
