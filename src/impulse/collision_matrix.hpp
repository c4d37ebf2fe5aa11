// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/contact.hpp>

namespace carom::impulse {

/// The contribution of one body to the collision matrix: I/m + [r]ᵀ J⁻¹ [r], with [r] x = r × x. Exactly symmetric.
template <class S, class Inertia>
[[nodiscard]] Matrix3<S> collision_matrix(const ContactBody<S, Inertia>& body) {
  Matrix3<S> matrix = angular_part_of_collision_matrix(body.inertia, body.lever_arm);
  for (int i = 0; i < 3; ++i) {
    matrix(i, i) += body.inverse_mass;
  }
  return matrix;
}

/// K = λI + [r_A]ᵀ J_A⁻¹ [r_A] + [r_B]ᵀ J_B⁻¹ [r_B], λ = 1/m_A + 1/m_B: the change of relative velocity per unit of
/// impulse [1/kg], in world axes. This is equation 24 of D. Eberly's note (docs/findings/note.md). The note's C
/// (equations 25 to 27) is K in another basis, except that equation 27 wrongly adds λ twice.
template <class S, class Inertia>
[[nodiscard]] Matrix3<S> collision_matrix(const Contact<S, Inertia>& contact) {
  return collision_matrix(contact.a) + collision_matrix(contact.b);
}

/// The default of a law's argument `see`: ignores the collision matrix. A law that forms K calls `see(K)`, with K in
/// world axes.
struct UnseenMatrix {
  template <class S>
  constexpr void operator()(const Matrix3<S>& /*matrix*/) const {}
};

/// C = Bᵀ K B: the collision matrix in the basis of the columns of B. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> in_basis(const Matrix3<S>& matrix, const Matrix3<S>& basis) {
  const Matrix3<S> half = matrix * basis;
  Matrix3<S> result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      const S entry = basis.col(row).dot(half.col(column));
      result(row, column) = entry;
      result(column, row) = entry;
    }
  }
  return result;
}

}  // namespace carom::impulse
