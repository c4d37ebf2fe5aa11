// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/collision/vector.hpp>

namespace carom::impulse {

/// The rotation matrix, from body axes to world axes, of a quaternion (q₀, q) of any nonzero length, with [q] x = q ×
/// x: R = ((q₀² − q·q) I + 2 q qᵀ + 2 q₀ [q]) / (q₀² + q·q).
template <class S>
[[nodiscard]] Matrix3<S> rotation_matrix(const Quaternion<S>& quaternion) {
  const S& w = quaternion[0];
  const S& x = quaternion[1];
  const S& y = quaternion[2];
  const S& z = quaternion[3];
  const S squared_length = (w * w + x * x) + (y * y + z * z);
  Matrix3<S> rotation;
  rotation << (w * w + x * x) - (y * y + z * z), S(2) * (x * y - w * z), S(2) * (x * z + w * y),  //
      S(2) * (x * y + w * z), (w * w + y * y) - (x * x + z * z), S(2) * (y * z - w * x),          //
      S(2) * (x * z - w * y), S(2) * (y * z + w * x), (w * w + z * z) - (x * x + y * y);
  return rotation / squared_length;
}

}  // namespace carom::impulse
