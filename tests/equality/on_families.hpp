// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "agreement.hpp"

namespace carom::equality {

inline constexpr std::uint64_t seed = 4;

/// Compares the judges on `cases` cases of each family. After about every fifth case, it compares them on a wild case
/// (wild.hpp), too.
void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement);

[[nodiscard]] std::string joined(const Agreement& agreement);

}  // namespace carom::equality
