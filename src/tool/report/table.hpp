// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/records.hpp"

namespace carom::tool {

/// The report for a terminal: what was generated, a line a subject, then each violation with its witness in words.
[[nodiscard]] std::string report_text(const GateRun& run, const std::string& out_directory);

}  // namespace carom::tool
