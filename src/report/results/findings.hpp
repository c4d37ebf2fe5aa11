// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>

#include <nlohmann/json.hpp>

#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/results/archive.hpp>

namespace carom::report {

/// The skips and violations of a subject in a family, as a shard records them. The record has the skipped and the
/// violated sampled cases (family_result.hpp), the first violated cases with their answers, and the worst case of each
/// invariant. Each case is recorded by its number, and merged_run draws it again. The counts of violations are recorded
/// elsewhere.
[[nodiscard]] nlohmann::json findings_record(const properties::FamilyResult& result);

/// Reads what findings_record wrote. `case_at` draws a case. Throws FormatError that names the place. It is also an
/// error if a case number is not below `cases`, or if an invariant that `into` counts as violated has no worst case.
/// Precondition: `into` has its counts, and the number of its sampled cases.
void read_findings(const Field& record, std::uint64_t cases,
                   const std::function<properties::Case(std::uint64_t)>& case_at, properties::FamilyResult& into);

}  // namespace carom::report
