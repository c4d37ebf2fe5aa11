// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

/// The impulse of the frictionless law, F = f N, by equation 18 of D. Eberly's note (docs/findings/note.md) for a
/// normal of any length:
///
///   f = −(1+ε) (N·(v_A − v_B) + (w_A·(r_A×N) − w_B·(r_B×N)))
///       / (λ N·N + (r_A×N)ᵀ J_A⁻¹ (r_A×N) + (r_B×N)ᵀ J_B⁻¹ (r_B×N)).
///
/// Preconditions: the contact was made from a valid collision (`is_made_of_valid`); `approach` is N·V⁻.
template <class S, class Inertia>
[[nodiscard]] ContactImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact, const Approach<S>& approach) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach.normal_velocity);
  if (is_known_false(colliding)) {
    return {colliding, n, n, n};
  }
  const auto is_any_slender = has_slender(contact);
  const Turning<S> a =
      turning_by_torque(contact.a.inertia, contact.a.lever_arm, n, approach.torque_arm_a, is_any_slender);
  const Turning<S> b =
      turning_by_torque(contact.b.inertia, contact.b.lever_arm, n, approach.torque_arm_b, is_any_slender);
  const S inverse_effective_mass = inverse_mass(contact) * dot(n, n) + (a.along_impulse + b.along_impulse);
  const S f = -(S(1) + contact.restitution) * approach.normal_velocity / inverse_effective_mass;
  return {colliding, n * f, a.change_of_spin * f, -b.change_of_spin * f};
}
template <class S, class Inertia>
[[nodiscard]] ContactImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact) {
  return frictionless_impulse(contact, approach_of(contact));
}
template <class S, class Inertia>
[[nodiscard]] ContactImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact, const S& normal_velocity) {
  return frictionless_impulse(contact, approach_of(contact, normal_velocity));
}

/// The outcome of the frictionless law. A contact that is not colliding keeps its velocities. Precondition: the contact
/// was made from a valid collision.
template <class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> frictionless(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, frictionless_impulse(contact));
}

}  // namespace carom::impulse
