// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/read_report.hpp"
#include "report/records.hpp"

namespace carom::tool {

/// Compares the run with its baseline where there is one, prints it as "text" or "json", and writes the reports and
/// witnesses into the directory `out`; none where that is empty. The exit status. Throws UsageError where a file cannot
/// be written.
[[nodiscard]] int present_run(GateRun run, const std::optional<compare::ReadReport>& baseline, const std::string& out,
                              const std::string& format);

}  // namespace carom::tool
