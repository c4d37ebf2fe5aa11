// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/model/run.hpp>

#include "io/journal.hpp"

namespace carom::tool {

/// The number of parts of a journaled run. A part has about a thousand cases of each family, as a run has by default,
/// so a kill costs little. A shard has at most a thousand parts.
[[nodiscard]] std::uint64_t parts_of(const properties::GateOptions& options);

/// Judges the shard options.shard part by part, and keeps each finished part in the journal. Parts that the journal has
/// are not judged again. The result is that of properties::run_gate, except for the times. `as_run` makes the run that
/// the journal keeps. Preconditions as for run_gate; also, options have no budget, and fail_fast is false.
[[nodiscard]] properties::GateReport journaled_gate(const std::vector<Subject>& subjects,
                                                    const properties::GateOptions& options, const Journal& journal,
                                                    const std::function<report::Run(properties::GateReport)>& as_run);

}  // namespace carom::tool
