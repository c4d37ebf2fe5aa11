// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "agreement.hpp"

namespace carom::equality {

inline constexpr std::uint64_t seed = 4;

/// Compares the judges on `cases` cases of each family, and after about every fifth case on a wild case (wild.hpp).
void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement);

/// The differences, one per line.
[[nodiscard]] std::string joined(const Agreement& agreement);

}  // namespace carom::equality
