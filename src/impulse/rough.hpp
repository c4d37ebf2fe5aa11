// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>
#include <carom/impulse/sticking.hpp>

namespace carom::impulse {

/// The result of the law `rough`. `rough_impulse` defines P_I, D and κ.
template <class S>
struct RoughImpulse {
  ContactImpulse<S> normal;         // (1 + ε) P_I
  ContactImpulse<S> with_friction;  // F = (1 + ε) P_I + κ D. `colliding` is true if normal.colliding and κ ≠ 0.
};

namespace detail {

/// ‖v‖, also if the squares of the components leave the range of S.
template <class S>
[[nodiscard]] S length(const Vector3<S>& v) {
  using std::sqrt;
  const S size = at_least_normal(sum_of_sizes(v));
  const Vector3<S> scaled = v * S(S(1) / size);
  return sqrt(dot(scaled, scaled)) * size;
}

/// F = `impulse`, or a fraction of F if −F adds energy. F is the computed solution of K F = V, with the collision
/// matrix K and the relative velocity V = `change`. The impulse −F removes the energy F·V − ½ F·K F. If K is singular
/// up to rounding, F may be so long that F·K F > 2 F·V, so −F adds energy. The fraction then removes as much energy as
/// possible.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> without_gain_of_energy(const Contact<S, Inertia>& contact, const Vector3<S>& impulse,
                                                const Vector3<S>& change) {
  const S size = at_least_normal(sum_of_sizes(impulse));
  const Vector3<S> scaled = impulse * S(S(1) / size);  // its square stays in the range of S
  const auto is_any_slender = has_slender(contact);
  const S by_turning = turning(contact.a.inertia, contact.a.lever_arm, scaled, is_any_slender).along_impulse +
                       turning(contact.b.inertia, contact.b.lever_arm, scaled, is_any_slender).along_impulse;
  const S asked = dot(scaled, change);
  const S made = size * (inverse_mass(contact) * dot(scaled, scaled) + by_turning);
  const auto gains = asked + asked < made;
  return none_of(gains) ? impulse : Vector3<S>(impulse * select(gains, S(asked / made), S(1)));
}

}  // namespace detail

/// The impulse of the law `rough` (A. Chatterjee, A. Ruina, "A new algebraic rigid-body collision law based on impulse
/// space considerations", J. Appl. Mech. 65, 1998). P_I is the impulse along N that stops the approach. P_II = −K⁻¹ V⁻
/// is the impulse that stops the contact point, with the collision matrix K. Then D = P_II − P_I, and
///
///   F = (1 + ε) P_I + κ D.
///
/// κ = 1 + e_t if this κ gives ‖N × F‖ ≤ μ N·F. Otherwise κ = μ (1 + ε) N·P_I / (‖N × D‖ − μ N·D).
///
/// The type `Solve` solves the 3×3 system (solve3.hpp). Preconditions: the contact was made from a valid collision;
/// `approach` is N·V⁻.
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] RoughImpulse<S> rough_impulse(const Contact<S, Inertia>& contact, const Approach<S>& approach,
                                            const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  const Vector3<S>& n = contact.normal;
  const ContactImpulse<S> normal = frictionless_impulse(contact, approach);
  if (is_known_false(normal.colliding)) {
    return {normal, normal};
  }
  // D is computed as P_II − P_I. The equal −K⁻¹ (V⁻ + K P_I) would multiply the rounding error of K P_I by the
  // condition number of K.
  const Vector3<S> velocity = relative_velocity(contact);
  const Vector3<S> approaching = velocity + n * S((approach.normal_velocity - dot(n, velocity)) / dot(n, n));
  const ContactMoments<S> moments = moments_of_unit_impulses(contact);
  const Matrix3<S> matrix = collision_matrix(contact, moments);
  see(matrix);
  const Vector3<S> solved = solved_impulse<Solve>(contact, matrix, approaching);
  const Vector3<S> stops_point = -detail::without_gain_of_energy<S>(contact, solved, approaching);
  // `d` is (1 + ε) D, and `share` is κ / (1 + ε).
  const S rebound = S(1) + contact.restitution;
  const S whole = S(1) + contact.tangential_restitution;
  const Vector3<S> d = stops_point * rebound - normal.on_a;
  // Both sides of the cone are divided by max(1, μ), so that a large μ does not overflow.
  const S unit = S(1) / at_least(S(1), contact.friction);
  const S slope = select(S(1) < contact.friction, S(1), contact.friction);
  const S limit = slope * dot(n, normal.on_a);
  const S divisor = detail::length<S>(cross(n, d)) * unit - slope * dot(n, d);
  const auto is_outside = limit * rebound < whole * divisor;
  const S share = S(select(is_outside, limit, whole) / select(is_outside, divisor, rebound));
  // If μ = 0, `share` is 0, unless the computed N × D is 0. Hence the condition μ > 0.
  const auto has_friction = normal.colliding && share > S(0) && contact.friction > S(0);
  return {normal, contact_impulse(contact, has_friction, Vector3<S>(normal.on_a + d * share), moments)};
}
template <class Solve = Ldlt, class S, class Inertia>
[[nodiscard]] RoughImpulse<S> rough_impulse(const Contact<S, Inertia>& contact) {
  return rough_impulse<Solve>(contact, approach_of(contact));
}
template <class Solve = Ldlt, class S, class Inertia, class See = UnseenMatrix>
[[nodiscard]] RoughImpulse<S> rough_impulse(const Contact<S, Inertia>& contact, const S& normal_velocity,
                                            const See& see = {}) {
  return rough_impulse<Solve>(contact, approach_of(contact, normal_velocity), see);
}

/// The impulse that acts. Without friction, it has the bits of the frictionless law. With friction, F acts in one step,
/// because (1 + ε) P_I alone may turn a slender body far more than F.
template <class S>
[[nodiscard]] ContactImpulse<S> acting_impulse(const RoughImpulse<S>& impulse) {
  return select(impulse.with_friction.colliding, impulse.with_friction, impulse.normal);
}

template <class S, class Inertia>
[[nodiscard]] Outcome<S> apply_impulse(const Contact<S, Inertia>& contact, const RoughImpulse<S>& impulse) {
  return apply_impulse(contact, acting_impulse(impulse));
}

/// The outcome of the law `rough`. A contact that is not colliding keeps its velocities. Precondition: the contact was
/// made from a valid collision.
template <class Solve = Ldlt, class S, class Inertia = PrincipalInertia<S>>
[[nodiscard]] Outcome<S> rough(const Contact<S, Inertia>& contact) {
  return apply_impulse(contact, rough_impulse<Solve>(contact));
}

}  // namespace carom::impulse
