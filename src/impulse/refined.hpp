// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/solve3.hpp>

/// Laws with one step of iterative refinement (N. J. Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed.
/// 2002, ch. 12). A solver forms and solves the system in a narrow type `Low`, computes the residual in the wide type
/// S, and solves for the correction in Low. The relative error of the impulse is about (c cond(K) u)², with the
/// collision matrix K, the unit roundoff u of Low, and a small number c. All numbers must stay in the range of Low.
namespace carom::impulse {

namespace detail {

template <class T, class S>
[[nodiscard]] ContactBody<T> rounded(const ContactBody<S>& body) {
  const PrincipalInertia<T> inertia{body.inertia.axes.template cast<T>(),
                                    body.inertia.inverse_moments.template cast<T>()};
  return {static_cast<T>(body.inverse_mass), inertia, body.lever_arm.template cast<T>(),
          body.velocity.template cast<T>(), body.angular_velocity.template cast<T>()};
}

}  // namespace detail

/// The contact in another scalar type, each number rounded.
template <class T, class S>
[[nodiscard]] Contact<T> rounded(const Contact<S>& contact) {
  return {detail::rounded<T>(contact.a),     detail::rounded<T>(contact.b),
          contact.normal.template cast<T>(), static_cast<T>(contact.restitution),
          static_cast<T>(contact.friction),  static_cast<T>(contact.tangential_restitution)};
}

/// The outcome of the frictionless law. Precondition: the contact was made from a valid collision.
template <class Low, class S>
[[nodiscard]] Outcome<S> frictionless_refined(const Contact<S>& contact) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const S approach = normal_velocity(contact);
  if (!is_colliding(contact, approach)) {
    return unchanged(contact);
  }
  const Contact<Low> low = rounded<Low>(contact);
  const Low inverse_effective_mass = dot(low.normal, response(low, low.normal));
  const auto solve = [&](const S& change) { return static_cast<S>(static_cast<Low>(change) / inverse_effective_mass); };
  const S change = -(S(1) + contact.restitution) * approach;
  const S f = solve(change);
  const S residual = change - f * dot(n, response(contact, n));
  return apply_impulse<S>(contact, n * (f + solve(residual)));
}

/// The outcome of the reflection law. The type `Solve` solves the 3×3 systems in Low (solve3.hpp). Precondition: the
/// contact was made from a valid collision.
template <class Low, class Solve, class S, class See = UnseenMatrix>
[[nodiscard]] Outcome<S> reflection_refined(const Contact<S>& contact, const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const S approach = normal_velocity(contact);
  if (!is_colliding(contact, approach)) {
    return unchanged(contact);
  }
  const Contact<Low> low = rounded<Low>(contact);
  const Matrix3<Low> k = collision_matrix(low);
  see(k);
  const auto solve = [&](const Vector3<S>& change) -> Vector3<S> {
    return Solve::template solve<Low>(k, change.template cast<Low>(), inverse_mass(low)).template cast<S>();
  };
  const Vector3<S> change = n * (-(S(1) + contact.restitution) * approach / dot(n, n));
  const Vector3<S> impulse = solve(change);
  const Vector3<S> residual = change - response(contact, impulse);
  return apply_impulse<S>(contact, impulse + solve(residual));
}

}  // namespace carom::impulse
