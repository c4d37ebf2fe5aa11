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
  Matrix3<S> inverse_inertia;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      S sum(0);
      for (int axis = 0; axis < 3; ++axis) {
        sum += rotation(row, axis) * rotation(column, axis) / moments[axis];
      }
      inverse_inertia(row, column) = sum;
      inverse_inertia(column, row) = sum;
    }
  }
  return inverse_inertia;
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

/// False, because `turning` treats a slender WorldInertia like any other.
template <class S>
[[nodiscard]] bool is_slender(const WorldInertia<S>& /*inertia*/) {
  return false;
}

template <class S>
[[nodiscard]] Turning<S> turning(const WorldInertia<S>& inertia, const Vector3<S>& r, const Vector3<S>& impulse,
                                 bool /*has_slender*/) {
  const Vector3<S> torque = cross(r, impulse);
  const Vector3<S> change_of_spin = times(inertia.inverse, torque);
  return {change_of_spin, dot(torque, change_of_spin)};
}

template <class S>
[[nodiscard]] Vector3<S> velocity_by_turning(const WorldInertia<S>& inertia, const Vector3<S>& r,
                                             const Vector3<S>& impulse) {
  return cross(times(inertia.inverse, cross(r, impulse)), r);
}

/// [r]ᵀ J⁻¹ [r], with [r] x = r × x. Exactly symmetric.
template <class S>
[[nodiscard]] Matrix3<S> angular_part_of_collision_matrix(const WorldInertia<S>& inertia, const Vector3<S>& r) {
  Matrix3<S> half;  // J⁻¹ [r]: xᵀ [r] = (x × r)ᵀ, and the rows of J⁻¹ equal its columns
  for (int row = 0; row < 3; ++row) {
    half.row(row) = cross<S>(inertia.inverse.col(row), r);
  }
  Matrix3<S> matrix;
  for (int column = 0; column < 3; ++column) {
    const Vector3<S> entries = cross<S>(half.col(column), r);  // [r]ᵀ x = x × r
    for (int row = column; row < 3; ++row) {
      matrix(row, column) = entries[row];
      matrix(column, row) = entries[row];
    }
  }
  return matrix;
}

}  // namespace carom::impulse
