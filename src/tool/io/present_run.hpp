// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/report_file.hpp"
#include "io/staged_output.hpp"

namespace carom::tool {

/// How a run is to be shown.
struct Presentation {
  std::string out;                 // the directory of the reports and witnesses; empty for none
  std::string format = "text";     // on standard output: "text" or "json"
  bool has_annotations = false;    // after it, as GitHub reads them
  std::string summary;             // the file to whose end a summary in Markdown is added; empty for none
  std::function<void()> annotate;  // called before annotations are printed; may be empty
};

/// Compares the run with its baseline where there is one, writes what is to be written, and prints it. The exit status.
/// Throws UsageError where a file cannot be written. `staged`: where the reports are written, of the directory
/// `presentation.out`; none where there is none. It is gone afterwards.
[[nodiscard]] int present_run(report::Run run, const std::optional<ReadRun>& baseline, const Presentation& presentation,
                              std::optional<StagedOutput>& staged);

}  // namespace carom::tool
