// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include <carom/collision/vector.hpp>

/// Ways to solve M x = b for a general 3×3 matrix M. (A collision matrix is positive definite and does not need them.)
/// Each struct is an argument for the template parameter `Solve` of a law, as in solve3.hpp.
namespace carom::impulse {

/// Eigen's P M = L U, with pivots by rows.
struct EigenPartialPivLu {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.partialPivLu().solve(b);
  }
};

/// Eigen's P M Q = L U, with pivots by rows and columns. A pivot below 3 machine epsilons times the largest pivot
/// counts as zero.
struct EigenFullPivLu {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.fullPivLu().solve(b);
  }
};

/// Eigen's M P = Q R by Householder reflections.
struct EigenColPivHouseholderQr {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.colPivHouseholderQr().solve(b);
  }
};

}  // namespace carom::impulse
