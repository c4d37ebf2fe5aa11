// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/solve3.hpp>

namespace carom::impulse {

/// V, the component along N of what the spins add to it taken from r × N as that of `normal_velocity` is.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> relative_velocity_along_normal(const Contact<S, Inertia>& contact) {
  const Vector3<S>& n = contact.normal;
  const Vector3<S> by_spins =
      cross(contact.a.angular_velocity, contact.a.lever_arm) - cross(contact.b.angular_velocity, contact.b.lever_arm);
  const S along_normal = dot(contact.a.angular_velocity, cross(contact.a.lever_arm, n)) -
                         dot(contact.b.angular_velocity, cross(contact.b.lever_arm, n));
  const S missing = (along_normal - dot(n, by_spins)) / dot(n, n);
  return (contact.a.velocity - contact.b.velocity) + (by_spins + n * missing);
}

/// The law that lets the contact point stick, the limit μ → ∞ of Coulomb friction: N·V⁺ = −ε N·V⁻ and N × V⁺ = 0, so
/// K F = V⁺ − V⁻ = −(V⁻ + ε (N·V⁻)/(N·N) N), with K the collision matrix. Solve is one of solve3.hpp.
///
/// Preconditions: the contact was made from a valid collision; `approach` is N·V⁻.
template <class Solve, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> sticking_impulse(const Contact<S, Inertia>& contact, const S& approach) {
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach);
  if (none_of(colliding)) {
    return {colliding, n};
  }
  const Vector3<S> velocity = relative_velocity_along_normal(contact);
  const S factor = contact.restitution * approach / dot(n, n);
  const Vector3<S> velocity_change = -(velocity + n * factor);
  return {colliding, Solve::template solve<S>(collision_matrix(contact), velocity_change, inverse_mass(contact))};
}
template <class Solve, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> sticking_impulse(const Contact<S, Inertia>& contact) {
  return sticking_impulse<Solve, S>(contact, normal_velocity(contact));
}

/// A contact that is not colliding keeps its velocities. Precondition: the contact was made from a valid collision.
template <class Solve, class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> sticking(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, sticking_impulse<Solve>(contact));
}

}  // namespace carom::impulse
