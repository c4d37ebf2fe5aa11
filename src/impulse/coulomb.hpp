// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact_impulse.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/solved_impulse.hpp>
#include <carom/impulse/sticking.hpp>

namespace carom::impulse {

namespace detail {

/// The impulse F of the law `coulomb` as a function of the slip resistance ν ≥ 0, with V_T⁺ = −ν F_T. The subscript T
/// marks the part orthogonal to N. All vectors are in a basis {N, T0, T1}.
template <class S>
class SlipResistance {
 public:
  /// Arguments: the collision matrix C in the basis, the change of velocity of a contact that sticks, a lower bound of
  /// the eigenvalues of C, and μ.
  SlipResistance(const Matrix3<S>& matrix, const Vector3<S>& change, const S& least, const S& friction)
      : matrix_(matrix), change_(change), least_(least), friction_(friction) {}

  [[nodiscard]] Vector3<S> impulse(const S& resistance) const {
    Matrix3<S> resisting = matrix_;
    resisting(1, 1) += resistance;
    resisting(2, 2) += resistance;
    return Ldlt::solve<S>(resisting, change_, least_);
  }
  [[nodiscard]] bool is_in_cone(const Vector3<S>& impulse) const {
    return std::hypot(impulse[1], impulse[2]) <= friction_ * impulse[0];
  }

  /// The impulse on the surface of the friction cone, by bisection of ν. Preconditions: μ > 0, and
  /// `is_in_cone(impulse(0))` is false.
  [[nodiscard]] Vector3<S> impulse_on_cone() const {
    CAROM_EXPECTS(friction_ > S(0) && !is_in_cone(impulse(S(0))), friction_, impulse(S(0)));
    constexpr S step = 256;
    constexpr S largest = std::numeric_limits<S>::max() / step;
    S inside = std::min(S(matrix_.trace()), largest);
    while (!is_in_cone(impulse(inside)) && inside < largest) {
      inside *= step;
    }
    S outside = inside / step;
    while (outside > S(0) && is_in_cone(impulse(outside))) {
      inside = outside;
      outside /= step;
    }
    for (S middle = (inside + outside) / 2; outside < middle && middle < inside; middle = (inside + outside) / 2) {
      (is_in_cone(impulse(middle)) ? inside : outside) = middle;
    }
    return impulse(inside);
  }

 private:
  Matrix3<S> matrix_;
  Vector3<S> change_;
  S least_;
  S friction_;
};

}  // namespace detail

/// The impulse of the law `coulomb`: Newton's restitution, and friction opposed to the slip after the impulse. The
/// subscript T marks the part orthogonal to N.
///
///   N·V⁺ = −ε N·V⁻,   ‖N × F‖ ≤ μ N·F,
///   and either N × V⁺ = 0 (stick), or ‖N × F‖ = μ N·F and V_T⁺ = −ν F_T with ν > 0 (slip).
///
/// Let K be the collision matrix, and P = I − N Nᵀ/(N·N). Both cases satisfy one system: (K + ν P) F = −(V⁻ + ε
/// (N·V⁻)/(N·N) N). At ν = 0 the contact point sticks. As ν → ∞, friction vanishes, and F lies in the cone. So if F is
/// outside the cone at ν = 0, some ν > 0 puts F on the surface of the cone (docs/guide/laws.md).
///
/// S is a floating-point type. Preconditions: the contact was made from a valid collision (`is_made_of_valid`); μ > 0.
template <class S, class See = UnseenMatrix>
[[nodiscard]] ContactImpulse<S> coulomb_impulse(const Contact<S>& contact, const See& see = {}) {
  CAROM_EXPECTS(is_made_of_valid(contact), contact.a.inverse_mass, contact.b.inverse_mass, contact.normal,
                contact.restitution, contact.friction, contact.tangential_restitution);
  CAROM_EXPECTS(contact.friction > S(0), contact.friction);
  const S approach = normal_velocity(contact);
  if (!is_colliding(contact, approach)) {
    return {false, contact.normal, contact.normal, contact.normal};
  }
  const Matrix3<S> basis = stable_tangent_basis(contact);
  const Vector3<S> velocity = relative_velocity_along_normal(contact);
  const Vector3<S> change{-(S(1) + contact.restitution) * approach / std::sqrt(dot(contact.normal, contact.normal)),
                          -basis.col(1).dot(velocity), -basis.col(2).dot(velocity)};
  const Matrix3<S> matrix = collision_matrix(contact);
  see(matrix);
  const detail::SlipResistance<S> law(in_basis<S>(matrix, basis), change, inverse_mass(contact), contact.friction);
  const Vector3<S> sticking = law.impulse(S(0));
  const Vector3<S> solved = law.is_in_cone(sticking) ? sticking : law.impulse_on_cone();
  // λI ⪯ K + ν P.
  return contact_impulse(contact, true, times(basis, detail::without_excess<S>(solved, change, inverse_mass(contact))));
}

/// The outcome of the law `coulomb`. For μ = 0, this is the frictionless outcome. A contact that is not colliding keeps
/// its velocities. Precondition: the contact was made from a valid collision.
template <class S, class See = UnseenMatrix>
[[nodiscard]] Outcome<S> coulomb(const Contact<S>& contact, const See& see = {}) {
  if (contact.friction > S(0)) {
    return apply_impulse(contact, coulomb_impulse(contact, see));
  }
  see_matrix(contact, normal_velocity(contact), see);
  return frictionless(contact);
}

}  // namespace carom::impulse
