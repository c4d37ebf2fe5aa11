// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/select.hpp>

namespace carom::impulse {

/// `solved_impulse` refines an impulse F if tr(K) ‖F‖ exceeds this multiple of ‖K F‖, with the collision matrix K.
/// Rounding in K and in a solve of three equations leaves a residual of about u tr(K) ‖F‖, with the unit roundoff u. So
/// the residual of other impulses is at most about 24 ulps of the change of velocity K F. The judge permits 32.
inline constexpr int greatest_growth_of_roundings = 24;

namespace detail {

/// F, shortened to λ ‖F‖ = ‖c‖ if it is longer, with c = K F. The exact F is not longer, because λI ⪯ K. A longer F
/// shows that K is singular up to rounding. The squares of λ ‖F‖ and ‖c‖ have at most 11 and 5 relative errors of u: λ
/// has 2, each product 1, each square 1, and each sum 2. So an exact F keeps its bits. Precondition: `least` is λ > 0.
template <class S>
[[nodiscard]] Vector3<S> without_excess(const Vector3<S>& impulse, const Vector3<S>& change, const S& least) {
  using std::sqrt;
  const S scale = finite_reciprocal(greatest_size(change));  // squares stay in the range of S
  const Vector3<S> made = (impulse * least) * scale;
  const Vector3<S> asked = change * scale;
  const S length_of_made = dot(made, made);
  const S length_of_asked = dot(asked, asked);
  const auto is_long = length_of_asked * S(1 + 16 * unit_roundoff<S>()) < length_of_made;
  const S share = select(is_long, length_of_asked, S(1)) / select(is_long, length_of_made, S(1));
  return none_of(is_long) ? impulse : Vector3<S>(impulse * S(sqrt(share)));
}

}  // namespace detail

/// The impulse F with K F = `change`. `matrix` is K, and the type `Solve` solves the 3×3 system (solve3.hpp).
///
/// If a body is struck on a tip along its lever arm, K N = λ N, with the normal N and λ = 1/m_A + 1/m_B. Two other
/// eigenvalues of K are up to 16 λ, so the residual of a solve is up to 33 ulps of the change. One step of refinement
/// removes it: K F is the sum of the responses of the bodies, where no large entry of K rounds the small λ (N. J.
/// Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed. 2002, ch. 12).
///
/// A correction of more than F/2 shows that K is singular up to rounding. It is left out. An impulse that no K permits
/// is shortened.
template <class Solve, class S, class Inertia>
[[nodiscard]] Vector3<S> solved_impulse(const Contact<S, Inertia>& contact, const Matrix3<S>& matrix,
                                        const Vector3<S>& change) {
  const S least = inverse_mass(contact);
  const Vector3<S> solved = Solve::template solve<S>(matrix, change, least);
  const auto refined = [&] {
    const Vector3<S> residual = change - response(contact, solved);
    const Vector3<S> correction = Solve::template solve<S>(matrix, residual, least);
    const auto is_small = S(2) * detail::sum_of_sizes(correction) < detail::sum_of_sizes(solved);
    const Vector3<S> corrected = select<decltype(is_small), S>(is_small, Vector3<S>(solved + correction), solved);
    return detail::without_excess<S>(corrected, change, least);
  };
  const S trace = (matrix(0, 0) + matrix(1, 1)) + matrix(2, 2);
  const auto is_rounded_much =
      S(greatest_growth_of_roundings) * detail::sum_of_sizes(change) < trace * detail::sum_of_sizes(solved);
  const Vector3<S> impulse = select_called(is_rounded_much, refined, [&] { return solved; });
  return detail::without_negative_zeros(impulse);
}

}  // namespace carom::impulse
