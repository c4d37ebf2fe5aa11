// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>

namespace carom::impulse {

namespace detail {

/// Whether an impulse along `impulse` turns neither body: for each body, the computed r × `impulse` is zero or the body
/// is immovable.
template <class S, class Inertia>
[[nodiscard]] auto turns_no_body(const Contact<S, Inertia>& contact, const Vector3<S>& impulse) {
  const auto is_not_turned = [&](const ContactBody<S, Inertia>& body) {
    return is_zero<S>(cross(body.lever_arm, impulse)) || body.inverse_mass == S(0);
  };
  return is_not_turned(contact.a) && is_not_turned(contact.b);
}

}  // namespace detail

/// The impulse of the reflection law, without a tangent basis. Equations 17, 20 and 21 of D. Eberly's note
/// (docs/findings/note.md) together give K F = V⁺ − V⁻ = −(1+ε) (N·V⁻)/(N·N) N, with K the collision matrix. The type
/// `Solve` solves the 3×3 system (solve3.hpp).
///
/// Preconditions: the contact was made from a valid collision; `approach` is N·V⁻.
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] ContactImpulse<S> reflection_impulse(const Contact<S, Inertia>& contact, const S& approach,
                                                   const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach);
  if (none_of(colliding)) {
    return {colliding, n};
  }
  const S factor = -(S(1) + contact.restitution) * approach / dot(n, n);
  const Vector3<S> velocity_change = n * factor;
  const Matrix3<S> matrix = collision_matrix(contact);
  see(matrix);
  const Vector3<S> solved = solved_impulse<Solve>(contact, matrix, velocity_change);
  // If N lies along both lever arms, K N = λ N with λ = 1/m_A + 1/m_B. So F is computed from λ, because rounding errors
  // in K would turn a body.
  const Vector3<S> along = n * (factor / inverse_mass(contact));
  return {colliding, select(detail::turns_no_body(contact, n), along, solved)};
}
template <class Solve = Ldlt, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> reflection_impulse(const Contact<S, Inertia>& contact) {
  return reflection_impulse<Solve, S>(contact, normal_velocity(contact));
}

/// The outcome of the reflection law. A contact that is not colliding keeps its velocities. Precondition: the contact
/// was made from a valid collision.
template <class Solve = Ldlt, class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> reflection(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, reflection_impulse<Solve>(contact));
}

}  // namespace carom::impulse
