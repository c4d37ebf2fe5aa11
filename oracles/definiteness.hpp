// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/oracles/rational.hpp>

namespace carom::oracles {

/// Whether xᵀ M x > 0 for every x ≠ 0, by the leading minors (Sylvester). Only the lower triangle is read.
[[nodiscard]] bool is_positive_definite(const Matrix3<Rational>& matrix);

/// Whether xᵀ M x ≥ 0 for every x. Leading minors do not decide this (they can vanish), all seven principal minors do.
/// Only the lower triangle is read.
[[nodiscard]] bool is_positive_semidefinite(const Matrix3<Rational>& matrix);

/// Whether bound I ⪯ M.
[[nodiscard]] bool is_at_least(const Matrix3<Rational>& matrix, const Rational& bound);

/// Whether M ⪯ bound I.
[[nodiscard]] bool is_at_most(const Matrix3<Rational>& matrix, const Rational& bound);

}  // namespace carom::oracles
