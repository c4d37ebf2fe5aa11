// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <carom/collision/vector.hpp>

/// Products with one fixed order of addition, so that a scalar and each lane of a pack get the same bits, on every
/// machine. The order of Eigen's products varies.
namespace carom::impulse {

/// x·y = (x₀ y₀ + x₁ y₁) + x₂ y₂.
template <class S>
[[nodiscard]] S dot(const Vector3<S>& x, const std::type_identity_t<Vector3<S>>& y) {
  return (x[0] * y[0] + x[1] * y[1]) + x[2] * y[2];
}

/// x × y.
template <class S>
[[nodiscard]] Vector3<S> cross(const Vector3<S>& x, const std::type_identity_t<Vector3<S>>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// M x. Each row adds in the order of `dot`.
template <class S>
[[nodiscard]] Vector3<S> times(const Matrix3<S>& m, const std::type_identity_t<Vector3<S>>& x) {
  const auto row = [&](int i) -> S { return (m(i, 0) * x[0] + m(i, 1) * x[1]) + m(i, 2) * x[2]; };
  return {row(0), row(1), row(2)};
}

/// The symmetric matrix whose entries are entry(i, j) on and below the diagonal. The entries are written one by one,
/// because gcc keeps a matrix of packs in memory if an index is a variable.
template <class S, class Entry>
[[nodiscard]] Matrix3<S> symmetric_matrix(const Entry& entry) {
  Matrix3<S> matrix;
  matrix(0, 0) = entry(0, 0);
  matrix(1, 1) = entry(1, 1);
  matrix(2, 2) = entry(2, 2);
  matrix(1, 0) = matrix(0, 1) = entry(1, 0);
  matrix(2, 0) = matrix(0, 2) = entry(2, 0);
  matrix(2, 1) = matrix(1, 2) = entry(2, 1);
  return matrix;
}

}  // namespace carom::impulse
