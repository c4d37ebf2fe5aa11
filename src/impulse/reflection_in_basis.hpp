// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <type_traits>

#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>

namespace carom::impulse {

/// The basis {N, T0, T1} of D. Eberly's note (docs/findings/note.md), §2, as columns. T0 is the normalised tangential
/// part of V⁻, and T1 = N × T0. T0 and T1 are zero if the tangential part is exactly zero. S is a floating-point type.
template <class S>
[[nodiscard]] Matrix3<S> tangent_basis(const Contact<S>& contact) {
  const Vector3<S> n = contact.normal / std::sqrt(contact.normal.dot(contact.normal));
  const Vector3<S> v = relative_velocity(contact);
  Vector3<S> t0 = v - n.dot(v) * n;
  const S length = std::sqrt(t0.dot(t0));
  if (length != S(0)) {
    t0 /= length;
  }
  Matrix3<S> basis;
  basis << n, t0, n.cross(t0);
  return basis;
}

/// A basis {N, T0, T1} that does not depend on V⁻. Let e be the coordinate axis that is least aligned with N. T0 is the
/// part of e orthogonal to N, divided by its length. The unit normal has a component of at most 1/√3 along e. So the
/// part has a length of at least √(2/3), and the subtraction loses no digits. S is a floating-point type.
template <class S>
[[nodiscard]] Matrix3<S> stable_tangent_basis(const Contact<S>& contact) {
  const Vector3<S> n = contact.normal / std::sqrt(contact.normal.dot(contact.normal));
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  Vector3<S> t0 = Vector3<S>::Unit(axis) - n * n[axis];
  t0 /= std::sqrt(t0.dot(t0));
  Matrix3<S> basis;
  basis << n, t0, n.cross(t0);
  return basis;
}

/// C = λI + Q_Aᵀ J_A⁻¹ Q_A + Q_Bᵀ J_B⁻¹ Q_B with the columns Q = [r × N, r × T0, r × T1]. These are the note's
/// equations 25 to 28, except that equation 27 wrongly adds λ twice. If the basis B = [N, T0, T1] is orthonormal, C
/// equals Bᵀ K B. The function does not check the basis.
template <class S>
[[nodiscard]] Matrix3<S> printed_collision_matrix(const Contact<S>& contact, const Matrix3<S>& basis) {
  const auto of_body = [&](const ContactBody<S>& body) -> Matrix3<S> {
    const Matrix3<S> q = moments_of_unit_impulses(body.inertia, body.lever_arm) * basis;
    return q.transpose() * body.inertia.inverse_moments.asDiagonal() * q;
  };
  // Exchanging A and B changes no bit.
  return Matrix3<S>::Identity() * inverse_mass(contact) + (of_body(contact.a) + of_body(contact.b));
}

/// B C Bᵀ: the matrix in world axes. The columns of B are an orthonormal basis.
template <class S>
[[nodiscard]] Matrix3<S> in_world_axes(const Matrix3<S>& matrix, const Matrix3<S>& basis) {
  return in_basis<S>(matrix, basis.transpose());
}

namespace detail {

/// Ldlt, without an excess of the impulse. Rounding may make C singular, although C ⪰ λI.
struct LdltWithoutExcess {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& c, const Vector3<S>& change, const S& least) {
    return without_excess<S>(Ldlt::solve<S>(c, change, least), change, least);
  }
};

}  // namespace detail

/// The outcome of the reflection law in a basis {N, T0, T1}, by the note's equations 25 to 28. In equation 25, N·V⁻
/// replaces the vector V⁻ that the note prints by mistake. `see` receives the matrix C in world axes.
template <class Solve = Ldlt, class S, class See = UnseenMatrix>
[[nodiscard]] Outcome<S> reflection_in_given_basis(const Contact<S>& contact, const Matrix3<S>& basis,
                                                   const See& see = {}) {
  const S approach = normal_velocity(contact) / std::sqrt(contact.normal.dot(contact.normal));
  if (!is_colliding(contact, approach)) {
    return unchanged(contact);
  }
  const Matrix3<S> c = printed_collision_matrix(contact, basis);
  if constexpr (!std::is_same_v<See, UnseenMatrix>) {
    see(in_world_axes(c, basis));
  }
  const Vector3<S> right_hand_side{-(S(1) + contact.restitution) * approach, S(0), S(0)};
  return apply_impulse<S>(contact, basis * Solve::template solve<S>(c, right_hand_side, inverse_mass(contact)));
}

/// The outcome of the reflection law as §2 of the note prints it. If V⁻ has no tangential part, the outcome is that of
/// equation 18 (`frictionless`), as in implementations of the note. Carom keeps this function as an example that fails:
/// near a head-on collision, T0 is rounding error and not orthogonal to N.
template <class S, class See = UnseenMatrix>
[[nodiscard]] Outcome<S> reflection_in_basis(const Contact<S>& contact, const See& see = {}) {
  const Matrix3<S> basis = tangent_basis(contact);
  if ((basis.col(1).array() == S(0)).all()) {
    see_matrix(contact, normal_velocity(contact), see);
    return frictionless(contact);
  }
  return reflection_in_given_basis(contact, basis, see);
}

/// The outcome of the reflection law in the basis of `stable_tangent_basis`. If N lies along both lever arms, the
/// outcome is that of `frictionless`, so that the rounding errors of T0 and T1 turn no body.
template <class S, class See = UnseenMatrix>
[[nodiscard]] Outcome<S> reflection_in_stable_basis(const Contact<S>& contact, const See& see = {}) {
  if (detail::turns_no_body(contact, approach_of(contact))) {
    see_matrix(contact, normal_velocity(contact), see);
    return frictionless(contact);
  }
  return reflection_in_given_basis<detail::LdltWithoutExcess>(contact, stable_tangent_basis(contact), see);
}

}  // namespace carom::impulse
