// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <carom/impulse/contact.hpp>
#include <carom/impulse/numbers/products.hpp>

namespace carom::impulse {

/// `moments_of_unit_impulses` of both bodies. The collision matrix and the changes of spin are made of them.
template <class S>
struct ContactMoments {
  Matrix3<S> of_a;
  Matrix3<S> of_b;
};

template <class S, class Inertia>
[[nodiscard]] ContactMoments<S> moments_of_unit_impulses(const Contact<S, Inertia>& contact) {
  return {moments_of_unit_impulses(contact.a.inertia, contact.a.lever_arm),
          moments_of_unit_impulses(contact.b.inertia, contact.b.lever_arm)};
}

/// K = λI + [r_A]ᵀ J_A⁻¹ [r_A] + [r_B]ᵀ J_B⁻¹ [r_B], λ = 1/m_A + 1/m_B: the change of relative velocity per unit of
/// impulse [1/kg], in world axes. This is equation 24 of D. Eberly's note (docs/findings/note.md). The note's C
/// (equations 25 to 27) is K in another basis, except that equation 27 wrongly adds λ twice. Exactly symmetric.
template <class S, class Inertia>
[[nodiscard]] Matrix3<S> collision_matrix(const Contact<S, Inertia>& contact, const ContactMoments<S>& moments) {
  const Matrix3<S> a = angular_part_of_collision_matrix(contact.a.inertia, contact.a.lever_arm, moments.of_a);
  const Matrix3<S> b = angular_part_of_collision_matrix(contact.b.inertia, contact.b.lever_arm, moments.of_b);
  return symmetric_matrix<S>([&](int i, int j) -> S {
    return i == j ? S((a(i, j) + contact.a.inverse_mass) + (b(i, j) + contact.b.inverse_mass)) : S(a(i, j) + b(i, j));
  });
}

template <class S, class Inertia>
[[nodiscard]] Matrix3<S> collision_matrix(const Contact<S, Inertia>& contact) {
  return collision_matrix(contact, moments_of_unit_impulses(contact));
}

/// The default of a law's argument `see`: ignores the collision matrix. A law that forms K calls `see(K)`, with K in
/// world axes.
struct UnseenMatrix {
  template <class S>
  constexpr void operator()(const Matrix3<S>& /*matrix*/) const {}
};

/// Shows K of a contact that a law solves without K. Forms no K if it is not seen, or if the contact does not collide.
template <class S, class Inertia, class See>
void see_matrix(const Contact<S, Inertia>& contact, const S& normal_velocity, const See& see) {
  if constexpr (!std::is_same_v<See, UnseenMatrix>) {
    if (is_colliding(contact, normal_velocity)) {
      see(collision_matrix(contact));
    }
  }
}

namespace detail {

/// The contribution of one body to K F.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> response(const ContactBody<S, Inertia>& body, const Vector3<S>& impulse) {
  return impulse * body.inverse_mass + velocity_by_turning(body.inertia, body.lever_arm, impulse);
}

}  // namespace detail

/// K F without forming the collision matrix K: the change of the relative velocity V by the impulse F on A and −F on B.
template <class S, class Inertia>
[[nodiscard]] Vector3<S> response(const Contact<S, Inertia>& contact, const Vector3<S>& impulse) {
  return detail::response(contact.a, impulse) + detail::response(contact.b, impulse);
}

/// C = Bᵀ K B: the collision matrix in the basis of the columns of B. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> in_basis(const Matrix3<S>& matrix, const Matrix3<S>& basis) {
  const Matrix3<S> half = matrix * basis;
  return symmetric_matrix<S>([&](int i, int j) -> S { return basis.col(i).dot(half.col(j)); });
}

}  // namespace carom::impulse
