// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "agreement.hpp"

namespace carom::equality {

inline constexpr std::uint64_t seed = 4;

/// Compares the judges on so many cases of each family, and on as many wild ones for each fifth family. Each case is
/// worked out once for all subjects.
void compare_on_families(std::span<Examined> examined, std::uint64_t cases, Relations relations, Agreement& agreement);

/// The differences, a line each.
[[nodiscard]] std::string joined(const Agreement& agreement);

}  // namespace carom::equality
