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

/// For each subject the invariants that reject it, on so many cases of each family, times its weight. These are the
/// cases that the gate draws from `seed`; a tenth of them is asked again in the end. Each case is drawn once and put to
/// all subjects. An invariant that has rejected a subject is not asked about it again: the judge decides most passes by
/// enclosures, and no violation.
[[nodiscard]] std::vector<Rejecting> rejecting_invariants(std::span<const Subject> subjects,
                                                          std::span<const properties::Family> families,
                                                          std::uint64_t seed, std::uint64_t cases);

}  // namespace carom::mutants
