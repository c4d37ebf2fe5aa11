// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <carom/properties/gate/trial.hpp>

namespace carom::mutants {

using Rejecting = std::set<std::string_view>;

/// The invariants that reject each subject. The gate's generator draws `cases` cases of each family, times the family's
/// weight, from `seed`. After an invariant rejects the subject, it is not evaluated again. Rigorous bounds decide most
/// passes; exact arithmetic decides every violation.
[[nodiscard]] std::vector<Rejecting> rejecting_invariants(std::span<const Subject> subjects,
                                                          std::span<const properties::Family> families,
                                                          std::uint64_t seed, std::uint64_t cases);

}  // namespace carom::mutants
