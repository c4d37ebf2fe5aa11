// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "agreement.hpp"

namespace carom::equality {

inline constexpr std::uint64_t seed = 4;

/// Compares the judges on `cases` cases of each family, and on as many wild cases for every fifth family. All
/// subjects share the results computed for a case.
void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement);

/// The differences, one per line.
[[nodiscard]] std::string joined(const Agreement& agreement);

}  // namespace carom::equality
