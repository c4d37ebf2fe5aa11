// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include <carom/collision/vector.hpp>

/// Ways to solve M x = b for a general 3×3 matrix M, which a collision matrix does not need. Policies of `reflection`
/// as those of solve3.hpp are.
namespace carom::impulse {

/// Eigen's P M = L U, pivots by rows.
struct EigenPartialPivLu {
  template <class S>
  [[nodiscard]] static Vector3<S> solve(const Matrix3<S>& m, const Vector3<S>& b, const S& = S(0)) {
    return m.partialPivLu().solve(b);
  }
};

/// Eigen's P M Q = L U, pivots by rows and columns. It takes a pivot below 3 ε times the largest for zero.
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
