// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compare/read_report.hpp"
#include "report/records.hpp"

namespace carom::tool {

/// How a run is to be shown.
struct Presentation {
  std::string out;                 // the directory of the reports and witnesses; empty for none
  std::string format = "text";     // on standard output: "text" or "json"
  bool has_annotations = false;    // after it, as GitHub reads them
  std::string summary;             // the file to whose end a summary in Markdown is added; empty for none
  std::function<void()> annotate;  // called before annotations are printed; may be empty
};

/// Compares the run with its baseline where there is one, prints it, and writes what is to be written. The exit status.
/// Throws UsageError where a file cannot be written.
[[nodiscard]] int present_run(GateRun run, const std::optional<compare::ReadReport>& baseline,
                              const Presentation& presentation);

}  // namespace carom::tool
