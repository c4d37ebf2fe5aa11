// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/kit/statement.hpp>

namespace carom::conformance {

/// The diagnosis of the suite's subject by a short run of the gate, in at most ten lines. Empty if the run finds no
/// violation. The run takes at most about four seconds of processor time. A fault of the run costs the diagnosis, and
/// nothing else.
[[nodiscard]] std::string gate_diagnosis(const Suite& suite);

}  // namespace carom::conformance
