// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>

#include <nlohmann/json.hpp>

#include <carom/properties/gate/gate_result.hpp>
#include <carom/report/model/field.hpp>

namespace carom::report {

/// What a shard hands on of the violations of a subject on a family, beyond their counts: the numbers of the violated
/// ones among the sampled cases, the first of them with the answers to them, and the worst of each invariant. Cases are
/// named by their numbers; a merge draws them anew.
[[nodiscard]] nlohmann::json findings_record(const properties::FamilyResult& result);

/// Puts back what findings_record wrote. `case_at` draws a case. Throws FormatError, which names the place, also where
/// a number is not below `cases`, or no worst case is named of what `into` counts as violated. Precondition: `into` has
/// its counts, and how many cases are sampled.
void read_findings(const Field& record, std::uint64_t cases,
                   const std::function<properties::Case(std::uint64_t)>& case_at, properties::FamilyResult& into);

}  // namespace carom::report
