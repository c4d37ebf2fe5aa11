// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>

#include <carom/oracles/exact/rational.hpp>

/// The functions of this file read only the lower triangle of a matrix.
namespace carom::oracles {

/// The seven principal minors, the determinant last. T is a ring.
template <class T>
[[nodiscard]] std::array<T, 7> principal_minors(const Matrix3<T>& m) {
  const auto minor = [&](int i, int j) -> T { return m(i, i) * m(j, j) - m(j, i) * m(j, i); };
  const T determinant = m(0, 0) * minor(1, 2) - m(1, 0) * (m(1, 0) * m(2, 2) - m(2, 1) * m(2, 0)) +
                        m(2, 0) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
  return {m(0, 0), m(1, 1), m(2, 2), minor(0, 1), minor(0, 2), minor(1, 2), determinant};
}

/// Whether xᵀ M x > 0 for every x ≠ 0, by all seven principal minors. They are positive if and only if M is
/// definite, as each is the determinant of a definite matrix, and the leading ones suffice (Sylvester).
[[nodiscard]] bool is_positive_definite(const Matrix3<Rational>& matrix);

/// Whether xᵀ M x ≥ 0 for every x, by all seven principal minors. The leading minors do not suffice: for
/// diag(0, 0, −1), they are zero.
[[nodiscard]] bool is_positive_semidefinite(const Matrix3<Rational>& matrix);

/// M − bound · I.
template <class T>
[[nodiscard]] Matrix3<T> less_multiple_of_identity(Matrix3<T> matrix, const T& bound) {
  for (int i = 0; i < 3; ++i) {
    matrix(i, i) -= bound;
  }
  return matrix;
}

/// Whether bound · I ⪯ M.
[[nodiscard]] bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound);

/// Whether M ⪯ bound · I.
[[nodiscard]] bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound);

}  // namespace carom::oracles
