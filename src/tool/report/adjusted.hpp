// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/gate/gate_result.hpp>

namespace carom::tool {

/// The changes that families made to cases after they drew them: a sentence for each reason, with the number of cases.
[[nodiscard]] std::string adjusted_sentences(const properties::GateReport& report);

}  // namespace carom::tool
