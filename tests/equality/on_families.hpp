// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "agreement.hpp"

namespace carom::equality {

inline constexpr std::uint64_t seed = 4;

/// Compares the judges on `cases` cases of each family (a named random generator of collisions). After about every
/// fifth case, it also compares them on a wild case (wild.hpp). All subjects share the facts of a case.
void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement);

/// The differences, one per line.
[[nodiscard]] std::string joined(const Agreement& agreement);

}  // namespace carom::equality
