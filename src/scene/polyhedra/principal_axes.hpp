// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>
#include <carom/impulse/numbers/double_double.hpp>

namespace carom::scene {

/// The factors of an inertia J = axes diag(moments) axesᵀ. The axes are right-handed columns.
struct PrincipalAxes {
  Vector3<impulse::DoubleDouble> moments;
  Matrix3<impulse::DoubleDouble> axes;
};

/// The principal axes of an inertia J by Jacobi's rotations. Each rotation is at most an eighth of a turn, so axes that
/// are almost principal axes keep their order. The error ‖J − axes diag(moments) axesᵀ‖ is at most 2⁻⁹⁵ ‖J‖, because
/// few sweeps suffice, and each rotation adds at most about 2⁻¹⁰⁰ ‖J‖. Precondition: J is symmetric, and its entry of
/// greatest size is between 2⁻¹⁰⁰ and 2¹⁰⁰.
[[nodiscard]] PrincipalAxes principal_axes(Matrix3<impulse::DoubleDouble> inertia);

/// The quaternion of a rotation matrix, whose columns are a right-handed frame. The component of greatest size is
/// positive, and each component is accurate to an ulp of 1.
[[nodiscard]] Quaternion<double> quaternion_of(const Matrix3<impulse::DoubleDouble>& rotation);

}  // namespace carom::scene
