// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Why a run cannot judge a subject if `part` of `all` cases say nothing about it.
[[nodiscard]] constexpr bool is_more_than_a_tenth(std::uint64_t part, std::uint64_t all) { return part * 10 > all; }

/// The declared effects that decide more than a tenth of the colliding cases. For each, the text names a domain within
/// which the law and the effect leave the subject to be judged. Empty if there is no such effect. `colliding` is the
/// number of colliding cases of the run.
[[nodiscard]] std::string why_decided_by_effects(const SubjectResult& result, const GateOptions& options,
                                                 std::uint64_t colliding);

}  // namespace carom::properties
