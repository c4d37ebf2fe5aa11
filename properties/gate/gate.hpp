// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/properties/gate/gate_result.hpp>

/// Judges subjects on families of collisions.
namespace carom::properties {

/// Precondition: no subject is absent.
[[nodiscard]] GateReport run_gate(const std::vector<Subject>& subjects, const GateOptions& options);

}  // namespace carom::properties
