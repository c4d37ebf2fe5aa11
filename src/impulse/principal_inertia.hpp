// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/numbers/difference_of_products.hpp>
#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/impulse/select.hpp>
#include <carom/impulse/turning.hpp>

namespace carom::impulse {

/// J⁻¹ = R diag(1/I) Rᵀ as two factors: the rotation R from body axes to world axes, and the principal moments I. To
/// apply J⁻¹ to a torque, rotate it into body axes, divide by I, and rotate back. So each component along a body axis
/// has a small relative error. In one matrix in world axes (world_inertia.hpp), the largest entry determines the
/// rounding errors of all entries. Then a body with moments 1 : ρ loses up to ρ/10 ulps of angular momentum.
/// `may_be_slender` is false if the body is known not to be slender (`is_slender`).
template <class S, bool may_be_slender = true>
struct PrincipalInertia {
  Matrix3<S> axes;             // its columns are the body axes, of unit length, in world coordinates
  Vector3<S> inverse_moments;  // 1/I about the centre of mass along the axes; 0 if immovable [1/(kg m²)]

  /// If the moments are equal, every axis is a body axis. `of` then chooses the world axes, which have no rounding
  /// error.
  static PrincipalInertia of(const Vector3<S>& moments, const Quaternion<S>& orientation) {
    const bool is_isotropic = moments[0] == moments[1] && moments[1] == moments[2];
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

/// A body is slender if its largest moment exceeds this multiple of its smallest moment. For other bodies, the rounding
/// error of `cross` (products.hpp) costs at most about 4 ulps.
inline constexpr int least_ratio_of_slender_moments = 8;

/// Whether the body is slender. If two vectors a and b are nearly parallel, `cross` has a rounding error of about u ‖a‖
/// ‖b‖, with the unit roundoff u. An error of a torque turns a body with moments 1 : ρ about its long axis ρ times as
/// much as about another axis. So slender bodies need `accurate_cross`.
template <class S, bool may_be_slender>
[[nodiscard]] auto is_slender(const PrincipalInertia<S, may_be_slender>& inertia) {
  if constexpr (may_be_slender) {
    const S& x = inertia.inverse_moments[0];
    const S& y = inertia.inverse_moments[1];
    const S& z = inertia.inverse_moments[2];
    const S greatest = at_least(at_least(x, y), z);
    const S least = -at_least(at_least(S(-x), S(-y)), S(-z));
    return S(least_ratio_of_slender_moments) * least < greatest;
  } else {
    return false;
  }
}

/// The matrix with the rows e × r for the body axes e. Its product with an impulse F is Rᵀ (r × F).
template <class S, bool may_be_slender>
[[nodiscard]] Matrix3<S> moments_of_unit_impulses(const PrincipalInertia<S, may_be_slender>& inertia,
                                                  const Vector3<S>& r) {
  const auto rows_by = [&](const auto& product) {
    Matrix3<S> rows;
    for (int k = 0; k < 3; ++k) {
      rows.row(k) = product(Vector3<S>(inertia.axes.col(k)));
    }
    return rows;
  };
  return select_called(
      is_slender(inertia), [&] { return rows_by([&](const Vector3<S>& e) { return accurate_cross(e, r); }); },
      [&] { return rows_by([&](const Vector3<S>& e) { return cross(e, r); }); });
}

/// Rᵀ (r × F), the torque in body axes. Its component along a body axis e is computed as (e × r)·F. The collision
/// matrix is made of the same vectors e × r, so the impulse F acts as the matrix predicts. If F lies nearly along r,
/// the component is computed as e·(r × F), which is exactly 0 if F lies along r. `has_slender` is true if either body
/// of the contact is slender. So two bodies with the same r get the same r × F, bit for bit.
template <class S, bool may_be_slender, class Condition>
[[nodiscard]] Vector3<S> torque_in_body_frame(const PrincipalInertia<S, may_be_slender>& inertia, const Vector3<S>& r,
                                              const Vector3<S>& impulse, const Condition& has_slender) {
  const Vector3<S> torque = select_called(
      has_slender, [&] { return accurate_cross(r, impulse); }, [&] { return cross(r, impulse); });
  constexpr int nearly = 4096;  // 1/4096 is far above a roundoff, and far below the usual |r × F| / (|r| |F|)
  const auto is_along =
      S(nearly) * detail::sum_of_sizes(torque) < detail::sum_of_sizes(r) * detail::sum_of_sizes(impulse);
  return select_called(
      is_along,
      [&] {
        return Vector3<S>{dot<S>(inertia.axes.col(0), torque), dot<S>(inertia.axes.col(1), torque),
                          dot<S>(inertia.axes.col(2), torque)};
      },
      [&] { return times(moments_of_unit_impulses(inertia, r), impulse); });
}

/// Computes both results from one torque, so that an impulse turns the body as much as the law expects. All calls in it
/// are inlined, because they would cost the frictionless law a third of its time.
template <class S, bool may_be_slender, class Condition>
[[nodiscard, gnu::flatten]] Turning<S> turning(const PrincipalInertia<S, may_be_slender>& inertia, const Vector3<S>& r,
                                               const Vector3<S>& impulse, const Condition& has_slender) {
  const Vector3<S> torque = torque_in_body_frame(inertia, r, impulse, has_slender);
  const Vector3<S> divided = detail::products_of_components(torque, inertia.inverse_moments);
  return {times(inertia.axes, divided), dot(divided, torque)};
}

/// Sums (e × r) ((e × r)·F) / I over the body axes e. If r lies along the axis of a slender body, the equal J⁻¹ (r × F)
/// × r is a small difference of large products.
template <class S, bool may_be_slender>
[[nodiscard]] Vector3<S> velocity_by_turning(const PrincipalInertia<S, may_be_slender>& inertia, const Vector3<S>& r,
                                             const Vector3<S>& impulse) {
  const Matrix3<S> moments = moments_of_unit_impulses(inertia, r);
  const Vector3<S> divided = detail::products_of_components<S>(times(moments, impulse), inertia.inverse_moments);
  return {dot<S>(moments.col(0), divided), dot<S>(moments.col(1), divided), dot<S>(moments.col(2), divided)};
}

/// [r]ᵀ J⁻¹ [r] = Σ (e × r)(e × r)ᵀ / I over the body axes e, with [r] x = r × x. Exactly symmetric.
template <class S, bool may_be_slender>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const PrincipalInertia<S, may_be_slender>& inertia,
                                                          const Vector3<S>& r) {
  const Matrix3<S> moments = moments_of_unit_impulses(inertia, r);
  Matrix3<S> matrix;
  for (int column = 0; column < 3; ++column) {
    const Vector3<S> divided = detail::products_of_components<S>(moments.col(column), inertia.inverse_moments);
    for (int row = column; row < 3; ++row) {
      matrix(row, column) = dot<S>(moments.col(row), divided);
      matrix(column, row) = matrix(row, column);
    }
  }
  return matrix;
}

}  // namespace carom::impulse
