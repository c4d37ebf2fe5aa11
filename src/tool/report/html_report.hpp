// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>

#include "report/records.hpp"

namespace carom::tool {

/// report.html: one page that needs nothing else, neither script nor network, and is well-formed XML as well.
/// `out_directory` is where the reports are written.
[[nodiscard]] std::string html_report(const GateRun& run, const std::filesystem::path& out_directory);

/// The run in one sentence.
[[nodiscard]] std::string summary_of(const GateRun& run);

}  // namespace carom::tool
