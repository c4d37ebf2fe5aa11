// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace carom::subjects {

/// v/‖v‖ for any v ≠ 0, without overflow or underflow of the squared length.
template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, 1> unit(const Eigen::Matrix<double, Size, 1>& v) {
  return (v / v.cwiseAbs().maxCoeff()).normalized();
}

}  // namespace carom::subjects
