// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact_impulse.hpp>

namespace carom::impulse {

/// The frictionless law, F = f N (note eq. 18, for a normal of any length):
///
///   f = −(1+ε) (N·(v_A − v_B) + (w_A·(r_A×N) − w_B·(r_B×N)))
///       / (λ N·N + (r_A×N)ᵀ J_A⁻¹ (r_A×N) + (r_B×N)ᵀ J_B⁻¹ (r_B×N)).
///
/// Preconditions: the contact was made from a valid collision; `approach` is N·V⁻.
template <class S, class Inertia>
[[nodiscard]] ContactImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact, const S& approach) {
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach);
  if (none_of(colliding)) {
    return {colliding, n};
  }
  const S by_turning_a = angular_part_along(contact.a.inertia, contact.a.lever_arm, n);
  const S by_turning_b = angular_part_along(contact.b.inertia, contact.b.lever_arm, n);
  const S inverse_effective_mass = inverse_mass(contact) * dot(n, n) + (by_turning_a + by_turning_b);
  const S f = -(S(1) + contact.restitution) * approach / inverse_effective_mass;
  return {colliding, n * f};
}
template <class S, class Inertia>
[[nodiscard]] ContactImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact) {
  return frictionless_impulse<S>(contact, normal_velocity(contact));
}

/// A contact that is not colliding keeps its velocities. Precondition: the contact was made from a valid collision.
template <class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> frictionless(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, frictionless_impulse(contact));
}

}  // namespace carom::impulse
