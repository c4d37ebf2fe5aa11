// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/output.hpp"
#include "io/report_file.hpp"

namespace carom::tool {

struct Presentation {
  std::string out;                 // the directory of the reports and witnesses; empty for none
  std::string format = "text";     // on standard output: "text" or "json"
  bool has_annotations = false;    // after the run, in GitHub's format
  std::string summary;             // the file to which a summary in Markdown is appended; empty for none
  std::function<void()> annotate;  // called before annotations are printed; may be empty
};

/// Compares the run with its baseline, if there is one, writes the files, prints the run, and returns the exit status.
/// Throws UsageError if a file cannot be written. `staged` is the staged output of `presentation.out`, if there is one.
/// The function resets it.
[[nodiscard]] int present_run(report::Run run, const std::optional<report::RecordedRun>& baseline,
                              const Presentation& presentation, std::optional<StagedOutput>& staged);

}  // namespace carom::tool
