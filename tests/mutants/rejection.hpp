// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include <carom/properties/trial/trial.hpp>

namespace carom::mutants {

/// The invariants that reject a subject on so many cases of each family, times its weight, those that the gate draws
/// from `seed`; a tenth of them is asked again in the end. An invariant that has rejected is not asked again: the judge
/// decides most passes by enclosures, and no violation.
[[nodiscard]] std::set<std::string_view> rejecting_invariants(const Subject& subject,
                                                              std::span<const properties::Family> families,
                                                              std::uint64_t seed, std::uint64_t cases);

}  // namespace carom::mutants
