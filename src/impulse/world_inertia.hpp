// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/impulse/numbers/products.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/impulse/turning.hpp>

namespace carom::impulse {

/// J⁻¹ = R diag(1/I) Rᵀ in world axes, with the rotation R of `orientation` and the moments I. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> world_inverse_inertia(const Vector3<S>& moments, const Quaternion<S>& orientation) {
  const Matrix3<S> rotation = rotation_matrix(orientation);
  return symmetric_matrix<S>([&](int i, int j) -> S {
    S sum(0);
    for (int axis = 0; axis < 3; ++axis) {
      sum += rotation(i, axis) * rotation(j, axis) / moments[axis];
    }
    return sum;
  });
}

/// J⁻¹ as engines store it: one matrix in world coordinates, smaller and faster than `PrincipalInertia`. Carom keeps
/// this type as an example that fails: slender bodies lose angular momentum about their long axes.
template <class S>
struct WorldInertia {
  Matrix3<S> inverse;  // about the centre of mass; 0 if immovable [1/(kg m²)]

  static WorldInertia of(const Vector3<S>& moments, const Quaternion<S>& orientation) {
    return {world_inverse_inertia(moments, orientation)};
  }
  static WorldInertia immovable() { return {Matrix3<S>::Constant(S(0))}; }
};

/// An upper bound of the eigenvalues of J⁻¹: its trace.
template <class S>
[[nodiscard]] S bound_of_inverse(const WorldInertia<S>& inertia) {
  return (inertia.inverse(0, 0) + inertia.inverse(1, 1)) + inertia.inverse(2, 2);
}

/// False, because `turning` treats a slender WorldInertia like any other.
template <class S>
[[nodiscard]] bool is_slender(const WorldInertia<S>& /*inertia*/) {
  return false;
}

template <class S>
[[nodiscard]] Turning<S> turning_by_torque(const WorldInertia<S>& inertia, const Vector3<S>& /*r*/,
                                           const Vector3<S>& /*impulse*/, const Vector3<S>& torque,
                                           bool /*has_slender*/) {
  const Vector3<S> change_of_spin = times(inertia.inverse, torque);
  return {change_of_spin, dot(torque, change_of_spin)};
}

template <class S>
[[nodiscard]] Turning<S> turning(const WorldInertia<S>& inertia, const Vector3<S>& r, const Vector3<S>& impulse,
                                 bool has_slender) {
  return turning_by_torque(inertia, r, impulse, cross(r, impulse), has_slender);
}

template <class S>
[[nodiscard]] Turning<S> turning_by_moments(const WorldInertia<S>& inertia, const Vector3<S>& r,
                                            const Vector3<S>& impulse, const Matrix3<S>& /*moments*/,
                                            bool has_slender) {
  return turning(inertia, r, impulse, has_slender);
}

template <class S>
[[nodiscard]] Vector3<S> velocity_by_turning(const WorldInertia<S>& inertia, const Vector3<S>& r,
                                             const Vector3<S>& impulse) {
  return cross(times(inertia.inverse, cross(r, impulse)), r);
}

/// J⁻¹ [r], with [r] x = r × x: xᵀ [r] = (x × r)ᵀ, and the rows of J⁻¹ equal its columns.
template <class S>
[[nodiscard]] Matrix3<S> moments_of_unit_impulses(const WorldInertia<S>& inertia, const Vector3<S>& r) {
  Matrix3<S> moments;
  for (int row = 0; row < 3; ++row) {
    moments.row(row) = cross<S>(inertia.inverse.col(row), r);
  }
  return moments;
}

/// [r]ᵀ J⁻¹ [r]. `moments` is J⁻¹ [r]. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const WorldInertia<S>& /*inertia*/, const Vector3<S>& r,
                                                          const Matrix3<S>& moments) {
  return symmetric_matrix<S>([&](int i, int j) -> S { return cross<S>(moments.col(j), r)[i]; });  // [r]ᵀ x = x × r
}

}  // namespace carom::impulse
