// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>

namespace carom::impulse {

namespace detail {

/// Whether an impulse along N turns the bodies so little that F = f N solves K F = c N up to rounding, with the
/// collision matrix K. In other types than floating-point numbers and packs, the turning has to be 0.
///
/// With t = r × N and λ = 1/m_A + 1/m_B, K N = λ N + w, and w = Σ (J⁻¹ t) × r over both bodies. So f N with the f of
/// the frictionless law leaves a residual of at most ‖w‖ / (λ ‖N‖) of the change c N. ‖w‖ is at most 3 Σ |t| |r| / min
/// I, in the norm max|v_i|. The limit 3 allows a residual of at most 9 u, with the unit roundoff u. If a uniform ball
/// is struck along r, rounding usually leaves |t| < u |r| |N|, and |r|² / I is at most 2.5/m. So most such balls are
/// within the limit.
template <class S, class Inertia>
[[nodiscard]] auto turns_no_body(const Contact<S, Inertia>& contact, const Approach<S>& approach) {
  constexpr int limit = 3;
  const auto turning = [](const ContactBody<S, Inertia>& body, const Vector3<S>& torque_arm) -> S {
    return (bound_of_inverse(body.inertia) * greatest_size(torque_arm)) * greatest_size(body.lever_arm);
  };
  const S both = turning(contact.a, approach.torque_arm_a) + turning(contact.b, approach.torque_arm_b);
  const S permitted = S(limit * unit_roundoff<S>()) * (inverse_mass(contact) * greatest_size(contact.normal));
  return both < permitted || both == permitted;  // false for a NaN
}

}  // namespace detail

/// The impulse of the reflection law, without a tangent basis. Equations 17, 20 and 21 of D. Eberly's note
/// (docs/findings/note.md) together give K F = V⁺ − V⁻ = −(1+ε) (N·V⁻)/(N·N) N, with K the collision matrix. The type
/// `Solve` solves the 3×3 system (solve3.hpp).
///
/// Preconditions: the contact was made from a valid collision; `approach` is N·V⁻.
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] ContactImpulse<S> reflection_impulse(const Contact<S, Inertia>& contact, const Approach<S>& approach,
                                                   const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach.normal_velocity);
  if (is_known_false(colliding)) {
    return {colliding, n, n, n};
  }
  if constexpr (!std::is_same_v<See, UnseenMatrix>) {
    see(collision_matrix(contact));
  }
  const auto solved = [&] {
    const Vector3<S> velocity_change = n * S(-(S(1) + contact.restitution) * approach.normal_velocity / dot(n, n));
    const ContactMoments<S> moments = moments_of_unit_impulses(contact);
    const Vector3<S> impulse = solved_impulse<Solve>(contact, collision_matrix(contact, moments), velocity_change);
    return contact_impulse(contact, colliding, impulse, moments);
  };
  return select_called(
      detail::turns_no_body(contact, approach), [&] { return frictionless_impulse(contact, approach); }, solved);
}
template <class Solve = Ldlt, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> reflection_impulse(const Contact<S, Inertia>& contact) {
  return reflection_impulse<Solve>(contact, approach_of(contact));
}
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] ContactImpulse<S> reflection_impulse(const Contact<S, Inertia>& contact, const S& normal_velocity,
                                                   const See& see = {}) {
  return reflection_impulse<Solve>(contact, approach_of(contact, normal_velocity), see);
}

/// The outcome of the reflection law. A contact that is not colliding keeps its velocities. Precondition: the contact
/// was made from a valid collision.
template <class Solve = Ldlt, class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> reflection(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, reflection_impulse<Solve>(contact));
}

}  // namespace carom::impulse
