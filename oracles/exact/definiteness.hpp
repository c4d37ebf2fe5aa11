// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <carom/oracles/numbers/approximation.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

/// Only the lower triangle of a matrix is read.
namespace carom::oracles {

/// Whether xᵀ M x > 0 for every x ≠ 0, by the leading minors (Sylvester).
[[nodiscard]] bool is_positive_definite(const Matrix3<Rational>& matrix);

/// Whether xᵀ M x ≥ 0 for every x. Leading minors do not decide this (they can vanish), all seven principal minors do.
[[nodiscard]] bool is_positive_semidefinite(const Matrix3<Rational>& matrix);

/// The same where the bounds decide it.
[[nodiscard]] std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix);
[[nodiscard]] std::optional<bool> is_positive_semidefinite(const Matrix3<Approximation>& matrix);

/// M − bound I, for T rational or known to within an error.
template <class T>
[[nodiscard]] Matrix3<T> less_multiple_of_identity(Matrix3<T> matrix, const T& bound) {
  for (int i = 0; i < 3; ++i) {
    matrix(i, i) -= bound;
  }
  return matrix;
}

/// Whether bound I ⪯ M.
[[nodiscard]] bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound);

/// Whether M ⪯ bound I.
[[nodiscard]] bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound);

}  // namespace carom::oracles
