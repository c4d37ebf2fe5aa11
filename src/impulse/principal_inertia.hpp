// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/products.hpp>
#include <carom/impulse/rotation.hpp>

namespace carom::impulse {

/// J⁻¹ = R diag(1/I) Rᵀ in its parts. Torques are turned into the body frame, divided there by the principal moments,
/// and turned back, so that each principal component has a relative error of its own. As one matrix in world
/// coordinates (world_inertia.hpp) the greatest component rounds all others: that costs the angular momentum of a body
/// with moments 1 : ρ up to ρ/10 ulps.
template <class S>
struct PrincipalInertia {
  Matrix3<S> axes;             // its columns are the body axes, of unit length, in world coordinates
  Vector3<S> inverse_moments;  // 1/I about the centre of mass along them; 0 where immovable [1/(kg m²)]

  static PrincipalInertia of(const Vector3<S>& moments, const Quaternion<S>& orientation) {
    return {rotation_matrix(orientation), Vector3<S>{S(1) / moments[0], S(1) / moments[1], S(1) / moments[2]}};
  }
  static PrincipalInertia immovable() { return {Matrix3<S>::Constant(S(0)), Vector3<S>::Constant(S(0))}; }
};

/// The matrix whose rows are e × r for the body axes e: times F it is Rᵀ (r × F), the torque in body coordinates. What
/// K is made of and what an impulse does then have the same rounding errors, those of a body turned by a little.
template <class S>
[[nodiscard]] Matrix3<S> torque_in_body_frame(const PrincipalInertia<S>& inertia, const Vector3<S>& r) {
  Matrix3<S> rows;
  for (int k = 0; k < 3; ++k) {
    rows.row(k) = cross<S>(inertia.axes.col(k), r);
  }
  return rows;
}

namespace detail {

template <class S>
[[nodiscard]] Vector3<S> products_of_components(const Vector3<S>& x, const Vector3<S>& y) {
  return {x[0] * y[0], x[1] * y[1], x[2] * y[2]};
}

}  // namespace detail

/// J⁻¹ (r × F): the change of angular velocity by an impulse F [N s] at the lever arm r.
template <class S>
[[nodiscard]] Vector3<S> angular_response(const PrincipalInertia<S>& inertia, const Vector3<S>& r,
                                          const Vector3<S>& impulse) {
  const Vector3<S> torque = times(torque_in_body_frame(inertia, r), impulse);
  return times(inertia.axes, detail::products_of_components(torque, inertia.inverse_moments));
}

/// (r × F)ᵀ J⁻¹ (r × F): N·([r]ᵀ J⁻¹ [r]) N where F is N.
template <class S>
[[nodiscard]] S angular_part_along(const PrincipalInertia<S>& inertia, const Vector3<S>& r, const Vector3<S>& impulse) {
  const Vector3<S> torque = times(torque_in_body_frame(inertia, r), impulse);
  return dot(detail::products_of_components(torque, inertia.inverse_moments), torque);
}

/// [r]ᵀ J⁻¹ [r] = Σ (e × r)(e × r)ᵀ / I over the body axes e, with [r] x = r × x. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const PrincipalInertia<S>& inertia, const Vector3<S>& r) {
  const Matrix3<S> torque = torque_in_body_frame(inertia, r);
  Matrix3<S> matrix;
  for (int column = 0; column < 3; ++column) {
    const Vector3<S> divided = detail::products_of_components<S>(torque.col(column), inertia.inverse_moments);
    for (int row = column; row < 3; ++row) {
      matrix(row, column) = dot<S>(torque.col(row), divided);
      matrix(column, row) = matrix(row, column);
    }
  }
  return matrix;
}

}  // namespace carom::impulse
