// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>
#include <carom/impulse/numbers/double_double.hpp>

namespace carom::scene {

/// J = axes diag(moments) axesᵀ; the axes are the columns, right-handed.
struct PrincipalAxes {
  Vector3<impulse::DoubleDouble> moments;
  Matrix3<impulse::DoubleDouble> axes;
};

/// By Jacobi's rotations, each of at most an eighth of a turn, so that axes that are almost right are not exchanged;
/// two or three sweeps converge, quadratically. Every rotation adds at most some 2⁻¹⁰⁰ ‖J‖: ‖J − axes diag axesᵀ‖ ≤
/// 2⁻⁹⁵ ‖J‖. Precondition: symmetric, the greatest number between 2⁻¹⁰⁰ and 2¹⁰⁰.
[[nodiscard]] PrincipalAxes principal_axes(Matrix3<impulse::DoubleDouble> inertia);

/// The rotation of a right-handed frame of columns as a quaternion with its greatest component positive, each within an
/// ulp of one.
[[nodiscard]] Quaternion<double> quaternion_of(const Matrix3<impulse::DoubleDouble>& rotation);

}  // namespace carom::scene
