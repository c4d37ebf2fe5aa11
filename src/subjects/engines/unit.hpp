// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace carom::subjects {

/// v/‖v‖ for any v ≠ 0. Engines take unit normals and quaternions. Divided by its largest component first, so that the
/// squared length neither over- nor underflows.
template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, 1> unit(const Eigen::Matrix<double, Size, 1>& v) {
  return (v / v.cwiseAbs().maxCoeff()).normalized();
}

}  // namespace carom::subjects
