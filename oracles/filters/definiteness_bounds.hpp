// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/numbers/enclosure.hpp>

namespace carom::oracles {

/// Whether xᵀ M x ≥ 0 for every x, or no value if the bounds do not decide it.
[[nodiscard]] std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix);

/// Whether bound · I ⪯ M, by enclosures if they decide it, otherwise by rationals.
[[nodiscard]] bool is_at_least_by_enclosures(const Matrix3<Rational>& matrix, const Rational& bound);

/// Whether M ⪯ bound · I, in the same way.
[[nodiscard]] bool is_at_most_by_enclosures(const Matrix3<Rational>& matrix, const Rational& bound);

}  // namespace carom::oracles
