// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <carom/properties/gate/gate_result.hpp>

namespace carom::tool {

/// What families changed after they drew a case, in a sentence with the number of cases for each reason.
[[nodiscard]] std::string adjusted_sentence(const properties::GateReport& report);

}  // namespace carom::tool
