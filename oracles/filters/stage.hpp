// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>

#include <carom/collision/enum_array.hpp>

namespace carom::oracles {

/// What decides: the cheapest that can.
enum class Stage { same_bits, closeness, approximation, enclosure, rational };

inline constexpr std::array all_stages{Stage::same_bits, Stage::closeness, Stage::approximation, Stage::enclosure,
                                       Stage::rational};
static_assert(counts_from_zero_to(all_stages, Stage::rational));

/// How much each stage has decided, by the calling thread since it began: comparisons, of which a verdict takes one or
/// more.
using StageCounts = EnumArray<Stage, std::uint64_t, all_stages.size()>;

namespace detail {
inline thread_local StageCounts stage_counts{};
}  // namespace detail

[[nodiscard]] inline const StageCounts& decided_by_stage() { return detail::stage_counts; }

inline void count(Stage stage) { ++detail::stage_counts[stage]; }

/// Approximations carry bounds of n u or more of the sum of a law's terms, n the most roundings of a term, thirty:
/// where less than some tens of n u is allowed, they would decide too seldom to be tried.
inline constexpr double least_allowance_for_approximations = 0x1p-43;

}  // namespace carom::oracles
