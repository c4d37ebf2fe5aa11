// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/collision/vector.hpp>

/// Vectors in long double. Their unit roundoff is 2⁻¹¹ of that of double, in which scenes are stored.
namespace carom::properties {

using WideVector = Vector3<long double>;

[[nodiscard]] inline WideVector wide(const Vector3<double>& v) { return v.cast<long double>(); }

/// The rotation from body axes to world axes. Precondition: the quaternion is not zero.
template <class S>
[[nodiscard]] Matrix3<long double> wide_rotation(const Quaternion<S>& q) {
  CAROM_EXPECTS(!q.isZero(0), q);
  return Eigen::Quaternion<long double>(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace carom::properties
