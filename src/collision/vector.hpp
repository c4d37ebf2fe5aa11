// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace carom {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// The components w, x, y, z of a quaternion q of any nonzero length: the rotation q/‖q‖ from body axes to world axes.
template <class S>
using Quaternion = Eigen::Matrix<S, 4, 1>;

}  // namespace carom
