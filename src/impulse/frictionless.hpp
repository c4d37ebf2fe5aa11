// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/contact_impulse.hpp>

namespace carom::impulse {

/// The impulse f N on A and −f N on B, and the changes of spin that it causes. No impulse acts if the contact is not
/// colliding.
template <class S>
struct NormalImpulse {
  decltype(std::declval<S>() < std::declval<S>()) colliding;  // a bool, or a mask if S is a pack
  Vector3<S> on_a;                                            // f N [N s]; all vectors are meaningless if not colliding
  Vector3<S> change_of_spin_of_a;                             // f J_A⁻¹ (r_A × N)
  Vector3<S> change_of_spin_of_b;                             // −f J_B⁻¹ (r_B × N)
};

/// The impulse of the frictionless law, F = f N, by equation 18 of D. Eberly's note (docs/findings/note.md) for a
/// normal of any length:
///
///   f = −(1+ε) (N·(v_A − v_B) + (w_A·(r_A×N) − w_B·(r_B×N)))
///       / (λ N·N + (r_A×N)ᵀ J_A⁻¹ (r_A×N) + (r_B×N)ᵀ J_B⁻¹ (r_B×N)).
///
/// Preconditions: the contact was made from a valid collision (`is_made_of_valid`); `approach` is N·V⁻.
template <class S, class Inertia>
[[nodiscard]] NormalImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact, const S& approach) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach);
  if (none_of(colliding)) {
    return {colliding, n, n, n};
  }
  const auto is_any_slender = has_slender(contact);
  const Turning<S> a = turning(contact.a.inertia, contact.a.lever_arm, n, is_any_slender);
  const Turning<S> b = turning(contact.b.inertia, contact.b.lever_arm, n, is_any_slender);
  const S inverse_effective_mass = inverse_mass(contact) * dot(n, n) + (a.along_impulse + b.along_impulse);
  const S f = -(S(1) + contact.restitution) * approach / inverse_effective_mass;
  return {colliding, n * f, a.change_of_spin * f, -b.change_of_spin * f};
}
template <class S, class Inertia>
[[nodiscard]] NormalImpulse<S> frictionless_impulse(const Contact<S, Inertia>& contact) {
  return frictionless_impulse<S>(contact, normal_velocity(contact));
}

template <class S, class Inertia>
[[nodiscard]] Outcome<S> apply_impulse(const Contact<S, Inertia>& contact, const NormalImpulse<S>& impulse) {
  const auto struck = [&](const ContactBody<S, Inertia>& body, const Vector3<S>& on_body,
                          const Vector3<S>& change_of_spin) -> BodyVelocity<S> {
    return select_of_both(
        impulse.colliding,
        [&]() -> BodyVelocity<S> {
          return {body.velocity + on_body * body.inverse_mass, body.angular_velocity + change_of_spin};
        },
        [&] { return unchanged(body); });
  };
  return {struck(contact.a, impulse.on_a, impulse.change_of_spin_of_a),
          struck(contact.b, -impulse.on_a, impulse.change_of_spin_of_b)};
}

/// The outcome of the frictionless law. A contact that is not colliding keeps its velocities. Precondition: the contact
/// was made from a valid collision.
template <class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> frictionless(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, frictionless_impulse(contact));
}

}  // namespace carom::impulse
