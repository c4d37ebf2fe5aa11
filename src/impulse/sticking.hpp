// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/solve3.hpp>

namespace carom::impulse {

/// The law that lets the contact point stick, the limit μ → ∞ of Coulomb friction: N·V⁺ = −ε N·V⁻ and N × V⁺ = 0, so
/// K F = V⁺ − V⁻ = −(V⁻ + ε (N·V⁻)/(N·N) N), with K the collision matrix. Solve is one of solve3.hpp.
///
/// Precondition: the contact was made from a valid collision.
template <class Solve, class S>
[[nodiscard]] ContactImpulse<S> sticking_impulse(const Contact<S>& contact) {
  const Vector3<S>& n = contact.normal;
  const Vector3<S> velocity = relative_velocity(contact);
  const S normal_velocity = dot(n, velocity);
  const auto colliding = is_colliding(contact, normal_velocity);
  if (none_of(colliding)) {
    return {colliding, n};
  }
  const S factor = contact.restitution * normal_velocity / dot(n, n);
  const Vector3<S> velocity_change = -(velocity + n * factor);
  return {colliding, Solve::template solve<S>(collision_matrix(contact), velocity_change, inverse_mass(contact))};
}

/// A contact that is not colliding keeps its velocities. Precondition: the contact was made from a valid collision.
template <class Solve, class S>
[[nodiscard]] Outcome<S> sticking(const Contact<S>& contact) {
  return apply_impulse(contact, sticking_impulse<Solve>(contact));
}

}  // namespace carom::impulse
