// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/gate/gate_report.hpp>

/// Judges subjects on families of collisions.
namespace carom::properties {

/// Preconditions: no subject is absent; options with a budget have no shard.
[[nodiscard]] GateReport run_gate(const std::vector<Subject>& subjects, const GateOptions& options);

}  // namespace carom::properties
