// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/expects.hpp>
#include <carom/impulse/numbers/difference_of_products.hpp>
#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/turning.hpp>

namespace carom::impulse {

/// Knowledge of a body's principal moments, before the code reads them.
enum class Moments {
  any,
  not_slender,  // `are_slender` is false
  equal,        // all moments are equal, and `axes` is the identity matrix unless the body is immovable
};

/// J⁻¹ = R diag(1/I) Rᵀ as two factors: the rotation R from body axes to world axes, and the principal moments I. To
/// apply J⁻¹ to a torque, rotate it into body axes, divide by I, and rotate back. So each component along a body axis
/// has a small relative error. In one matrix in world axes (world_inertia.hpp), the largest entry determines the
/// rounding errors of all entries. Then a body with moments 1 : ρ loses up to about ρ/10 ulps of angular momentum.
///
/// If the numbers are finite, results have the same bits for each `known`. For that, a zero is added where a zero might
/// be −0.
template <class S, Moments known = Moments::any>
struct PrincipalInertia {
  Matrix3<S> axes;             // its columns are the body axes, of unit length, in world coordinates
  Vector3<S> inverse_moments;  // 1/I about the centre of mass along the axes; 0 if immovable [1/(kg m²)]

  /// If the moments are equal, every axis is a body axis. `of` then chooses the world axes, which have no rounding
  /// error.
  static PrincipalInertia of(const Vector3<S>& moments, const Quaternion<S>& orientation) {
    const bool is_isotropic = moments[0] == moments[1] && moments[1] == moments[2];
    CAROM_EXPECTS(known != Moments::equal || is_isotropic, moments);
    return {is_isotropic ? Matrix3<S>::Identity() : rotation_matrix(orientation),
            Vector3<S>{S(1) / moments[0], S(1) / moments[1], S(1) / moments[2]}};
  }
  static PrincipalInertia immovable() { return {Matrix3<S>::Constant(S(0)), Vector3<S>::Constant(S(0))}; }
};

namespace detail {

template <class S>
[[nodiscard]] Vector3<S> products_of_components(const Vector3<S>& x, const Vector3<S>& y) {
  return {x[0] * y[0], x[1] * y[1], x[2] * y[2]};
}

/// |v₁| + |v₂| + |v₃|.
template <class S>
[[nodiscard]] S sum_of_sizes(const Vector3<S>& v) {
  return (absolute(v[0]) + absolute(v[1])) + absolute(v[2]);
}

}  // namespace detail

/// A body is slender if its largest moment exceeds this multiple of its smallest moment.
inline constexpr int least_ratio_of_slender_moments = 8;

/// The greatest of 1/I.
template <class S>
[[nodiscard]] S greatest_of(const Vector3<S>& inverse_moments) {
  return at_least(at_least(inverse_moments[0], inverse_moments[1]), inverse_moments[2]);
}

/// Whether a body with these 1/I is slender: a bool, or a mask if S is a pack. If two vectors a and b are nearly
/// parallel, `cross` has a rounding error of about u ‖a‖ ‖b‖, with the unit roundoff u. An error of a torque turns a
/// body with moments 1 : ρ about its long axis ρ times as much as about another axis. So slender bodies need
/// `accurate_cross`.
template <class S>
[[nodiscard]] auto are_slender(const Vector3<S>& inverse_moments) {
  const S least = -greatest_of<S>(-inverse_moments);
  return S(least_ratio_of_slender_moments) * least < greatest_of(inverse_moments);
}

/// Whether Moments::equal holds: a bool, or a mask if S is a pack.
template <class S>
[[nodiscard]] auto is_isotropic(const PrincipalInertia<S>& inertia) {
  const Matrix3<S>& e = inertia.axes;
  const auto has_world_axes = e(0, 0) == S(1) && e(1, 1) == S(1) && e(2, 2) == S(1) && e(1, 0) == S(0) &&
                              e(2, 0) == S(0) && e(2, 1) == S(0) && e(0, 1) == S(0) && e(0, 2) == S(0) &&
                              e(1, 2) == S(0);
  const Vector3<S>& inverse = inertia.inverse_moments;
  return inverse[0] == inverse[2] && inverse[1] == inverse[2] && (has_world_axes || inverse[2] == S(0));
}

template <class S, Moments known>
[[nodiscard]] auto is_slender(const PrincipalInertia<S, known>& inertia) {
  if constexpr (known == Moments::any) {
    return are_slender(inertia.inverse_moments);
  } else {
    return false;
  }
}

/// An upper bound of the eigenvalues of J⁻¹.
template <class S, Moments known>
[[nodiscard]] S bound_of_inverse(const PrincipalInertia<S, known>& inertia) {
  if constexpr (known == Moments::equal) {
    return inertia.inverse_moments[2];
  } else {
    return greatest_of(inertia.inverse_moments);
  }
}

/// The matrix with the rows e × r for the body axes e. Its product with an impulse F is Rᵀ (r × F).
template <class S, Moments known>
[[nodiscard]] Matrix3<S> moments_of_unit_impulses(const PrincipalInertia<S, known>& inertia, const Vector3<S>& r) {
  const auto rows_by = [&](const auto& product) {
    const Vector3<S> first = product(inertia.axes.col(0));
    const Vector3<S> second = product(inertia.axes.col(1));
    const Vector3<S> third = product(inertia.axes.col(2));
    Matrix3<S> rows;
    for (int column = 0; column < 3; ++column) {
      rows(0, column) = first[column];
      rows(1, column) = second[column];
      rows(2, column) = third[column];
    }
    return rows;
  };
  return select_called(
      is_slender(inertia), [&] { return rows_by([&](const Vector3<S>& e) { return accurate_cross(e, r); }); },
      [&] { return rows_by([&](const Vector3<S>& e) { return cross(e, r); }); });
}

namespace detail {

/// The vector with +0 in place of −0.
template <class S>
[[nodiscard]] Vector3<S> without_negative_zeros(const Vector3<S>& v) {
  return {v[0] + S(0), v[1] + S(0), v[2] + S(0)};
}

/// Rᵀ τ.
template <class S, Moments known>
[[nodiscard]] Vector3<S> in_body_frame(const PrincipalInertia<S, known>& inertia, const Vector3<S>& torque) {
  return {dot<S>(inertia.axes.col(0), torque), dot<S>(inertia.axes.col(1), torque),
          dot<S>(inertia.axes.col(2), torque)};
}

/// J⁻¹ τ and τᵀ J⁻¹ τ, for the torque in body axes.
template <class S, Moments known>
[[nodiscard]] Turning<S> turning_by(const PrincipalInertia<S, known>& inertia, const Vector3<S>& torque) {
  const Vector3<S> divided = products_of_components(torque, inertia.inverse_moments);
  if constexpr (known == Moments::equal) {
    return {without_negative_zeros(divided), dot(divided, torque)};
  } else {
    return {without_negative_zeros(times(inertia.axes, divided)), dot(divided, torque)};
  }
}

/// Rᵀ (r × F) of a contact with a slender body. The component along a body axis e is computed as (e × r)·F. If F lies
/// nearly along r, it is computed as e·(r × F), which is exactly 0 if F lies along r.
template <class S>
[[nodiscard]] Vector3<S> accurate_torque(const PrincipalInertia<S>& inertia, const Vector3<S>& r,
                                         const Vector3<S>& impulse) {
  const Vector3<S> torque = accurate_cross(r, impulse);
  constexpr int nearly = 4096;  // 1/4096 is far above a roundoff, and far below the usual |r × F| / (|r| |F|)
  const auto is_along = S(nearly) * sum_of_sizes(torque) < sum_of_sizes(r) * sum_of_sizes(impulse);
  return select_called(
      is_along, [&] { return in_body_frame(inertia, torque); },
      [&] { return times(moments_of_unit_impulses(inertia, r), impulse); });
}

}  // namespace detail

/// The effect of the impulse F on the spin. `torque` is r × F by `cross`. `moments` is `moments_of_unit_impulses`.
/// `has_slender` is true if either body of the contact is slender. So two bodies with the same r take the same r × F,
/// bit for bit. All calls are inlined, because they would cost the frictionless law a third of its time.
template <class S, Moments known, class Condition>
[[nodiscard, gnu::flatten]] Turning<S> turning_by_torque(const PrincipalInertia<S, known>& inertia, const Vector3<S>& r,
                                                         const Vector3<S>& impulse, const Vector3<S>& torque,
                                                         const Condition& has_slender) {
  if constexpr (known == Moments::any) {
    return select_called(
        has_slender, [&] { return detail::turning_by(inertia, detail::accurate_torque(inertia, r, impulse)); },
        [&] { return detail::turning_by(inertia, detail::in_body_frame(inertia, torque)); });
  } else if constexpr (known == Moments::not_slender) {
    return detail::turning_by(inertia, detail::in_body_frame(inertia, torque));
  } else {
    return detail::turning_by(inertia, torque);
  }
}

/// The same by the vectors e × r of which the collision matrix is made, so F acts as the matrix predicts.
template <class S, Moments known, class Condition>
[[nodiscard]] Turning<S> turning_by_moments(const PrincipalInertia<S, known>& inertia, const Vector3<S>& r,
                                            const Vector3<S>& impulse, const Matrix3<S>& moments,
                                            const Condition& has_slender) {
  if constexpr (known == Moments::any) {
    return select_called(
        has_slender, [&] { return detail::turning_by(inertia, detail::accurate_torque(inertia, r, impulse)); },
        [&] { return detail::turning_by(inertia, times(moments, impulse)); });
  } else if constexpr (known == Moments::not_slender) {
    return detail::turning_by(inertia, times(moments, impulse));
  } else {
    return detail::turning_by(inertia, cross(r, impulse));
  }
}

template <class S, Moments known, class Condition>
[[nodiscard]] Turning<S> turning(const PrincipalInertia<S, known>& inertia, const Vector3<S>& r,
                                 const Vector3<S>& impulse, const Condition& has_slender) {
  return turning_by_moments(inertia, r, impulse, moments_of_unit_impulses(inertia, r), has_slender);
}

/// Sums (e × r) ((e × r)·F) / I over the body axes e. If r lies along the axis of a slender body, the equal J⁻¹ (r × F)
/// × r is a small difference of large products.
template <class S, Moments known>
[[nodiscard]] Vector3<S> velocity_by_turning(const PrincipalInertia<S, known>& inertia, const Vector3<S>& r,
                                             const Vector3<S>& impulse) {
  const Matrix3<S> moments = moments_of_unit_impulses(inertia, r);
  const Vector3<S> divided = detail::products_of_components<S>(times(moments, impulse), inertia.inverse_moments);
  return {dot<S>(moments.col(0), divided), dot<S>(moments.col(1), divided), dot<S>(moments.col(2), divided)};
}

/// [r]ᵀ J⁻¹ [r] = Σ (e × r)(e × r)ᵀ / I over the body axes e, with [r] x = r × x. `moments` is
/// `moments_of_unit_impulses`. Exactly symmetric.
template <class S, Moments known>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const PrincipalInertia<S, known>& inertia,
                                                          const Vector3<S>& r, const Matrix3<S>& moments) {
  if constexpr (known == Moments::equal) {  // (r·r I − r rᵀ) / I
    const Vector3<S> divided = r * inertia.inverse_moments[2];
    const Vector3<S> squares = detail::products_of_components(divided, r);
    return symmetric_matrix<S>([&](int i, int j) -> S {
      return i == j ? S(squares[(i + 1) % 3] + squares[(i + 2) % 3]) : S(-(divided[i] * r[j]));
    });
  } else {
    return symmetric_matrix<S>([&](int i, int j) -> S {
      return dot<S>(moments.col(i), detail::products_of_components<S>(moments.col(j), inertia.inverse_moments));
    });
  }
}

}  // namespace carom::impulse
