// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/exact/definiteness.hpp>

namespace carom::oracles {

/// Whether xᵀ M x ≥ 0 for every x, or no value if the bounds do not decide it.
[[nodiscard]] inline std::optional<bool> is_positive_semidefinite(const Matrix3<Enclosure>& matrix) {
  bool decided = true;
  for (const Enclosure& minor : principal_minors(matrix)) {
    const std::optional<int> sign = minor.sign();
    if (sign == -1) {
      return false;
    }
    decided = decided && sign.has_value();
  }
  return decided ? std::optional<bool>(true) : std::nullopt;
}

}  // namespace carom::oracles
