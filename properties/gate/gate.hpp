// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties {

/// Judges subjects on families of collisions. A fault of the judge ends the run, and is in the report with the results
/// before it. Preconditions: `absent` of each subject is empty; options with a budget
/// have shard.of = 1.
[[nodiscard]] GateReport run_gate(const std::vector<Subject>& subjects, const GateOptions& options);

}  // namespace carom::properties
