// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>

namespace carom::impulse {

namespace detail {

/// For each component i of w × r: |w_j r_k| + |w_k r_j|, with cyclic i, j, k. The rounding error of the component is
/// about this sum times the unit roundoff.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> terms_of_spin(const ContactBody<S, Inertia>& body) {
  const Vector3<S>& w = body.angular_velocity;
  const Vector3<S>& r = body.lever_arm;
  const auto component = [&](int j, int k) -> S { return absolute(S(w[j] * r[k])) + absolute(S(w[k] * r[j])); };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

}  // namespace detail

/// The relative velocity V, corrected so that N·V equals the more accurate `normal_velocity`. The correction changes
/// each component of w × r by at most a few times its rounding error.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> relative_velocity_along_normal(const Contact<S, Inertia>& contact) {
  const Vector3<S>& n = contact.normal;
  const Vector3<S> by_spins =
      cross(contact.a.angular_velocity, contact.a.lever_arm) - cross(contact.b.angular_velocity, contact.b.lever_arm);
  const S along_normal = normal_velocity_by_spins(contact, approach_of(contact, S(0)));
  const Vector3<S> terms = detail::terms_of_spin(contact.a) + detail::terms_of_spin(contact.b);
  // The correction δ has the least Σ (δ_i / terms_i)² of all δ with N·δ = along_normal − N·by_spins.
  const Vector3<S> along{n[0] * terms[0], n[1] * terms[1], n[2] * terms[2]};
  const S sum = (absolute(along[0]) + absolute(along[1])) + absolute(along[2]);
  const Vector3<S> shares = along * finite_reciprocal(sum);
  const S divisor = dot(shares, along);
  const S missing = (along_normal - dot(n, by_spins)) / select(divisor > S(0), divisor, S(1));
  const auto mended = [&](int i) -> S { return by_spins[i] + missing * shares[i] * terms[i]; };
  return (contact.a.velocity - contact.b.velocity) + Vector3<S>{mended(0), mended(1), mended(2)};
}

/// The impulse F of the law `sticking`, the limit μ → ∞ of Coulomb friction: N·V⁺ = −ε N·V⁻ and N × V⁺ = 0. So K F = V⁺
/// − V⁻ = −(V⁻ + ε (N·V⁻)/(N·N) N), with K the collision matrix. The type `Solve` solves the 3×3 system (solve3.hpp).
///
/// Preconditions: the contact was made from a valid collision; `approach` is N·V⁻.
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] ContactImpulse<S> sticking_impulse(const Contact<S, Inertia>& contact, const S& approach,
                                                 const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const auto colliding = is_colliding(contact, approach);
  if (is_known_false(colliding)) {
    return {colliding, n, n, n};
  }
  const Vector3<S> velocity = relative_velocity_along_normal(contact);
  const S factor = contact.restitution * approach / dot(n, n);
  const Vector3<S> velocity_change = -(velocity + n * factor);
  const ContactMoments<S> moments = moments_of_unit_impulses(contact);
  const Matrix3<S> matrix = collision_matrix(contact, moments);
  see(matrix);
  return contact_impulse(contact, colliding, solved_impulse<Solve>(contact, matrix, velocity_change), moments);
}
template <class Solve = Ldlt, class S, class Inertia>
[[nodiscard]] ContactImpulse<S> sticking_impulse(const Contact<S, Inertia>& contact) {
  return sticking_impulse<Solve, S>(contact, normal_velocity(contact));
}

/// The outcome of the law `sticking`. A contact that is not colliding keeps its velocities. Precondition: the contact
/// was made from a valid collision.
template <class Solve = Ldlt, class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> sticking(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, sticking_impulse<Solve>(contact));
}

}  // namespace carom::impulse
