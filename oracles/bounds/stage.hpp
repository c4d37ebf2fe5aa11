// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstdint>

#include <carom/collision/enum_array.hpp>

namespace carom::oracles {

/// The stages of the judge's decision on a comparison. The first stage that can decide decides.
enum class Stage { same_bits, enclosure, rational };

inline constexpr std::array all_stages{Stage::same_bits, Stage::enclosure, Stage::rational};
static_assert(counts_from_zero_to(all_stages, Stage::rational));

/// For each stage, the number of comparisons that it has decided in the calling thread.
using StageCounts = EnumArray<Stage, std::uint64_t, all_stages.size()>;

namespace detail {
inline constinit thread_local StageCounts stage_counts{};
}  // namespace detail

[[nodiscard]] inline const StageCounts& decided_by_stage() { return detail::stage_counts; }

inline void count(Stage stage) { ++detail::stage_counts[stage]; }

}  // namespace carom::oracles
