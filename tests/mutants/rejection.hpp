// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <carom/properties/trial/trial.hpp>

namespace carom::mutants {

/// The names of the invariants that reject a subject.
using Rejecting = std::set<std::string_view>;

/// The invariants that reject each subject, on `cases` cases of each family, times its weight. These are the cases that
/// the gate draws from `seed`; at the end it asks a tenth of them again. Each case is drawn once and put to all
/// subjects. After an invariant rejects a subject, it is not evaluated again for that subject. Rigorous bounds decide
/// most passes; exact arithmetic decides every violation.
[[nodiscard]] std::vector<Rejecting> rejecting_invariants(std::span<const Subject> subjects,
                                                          std::span<const properties::Family> families,
                                                          std::uint64_t seed, std::uint64_t cases);

}  // namespace carom::mutants
