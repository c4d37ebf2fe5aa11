// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <carom/report/results/run_json.hpp>

#include "io/output.hpp"

namespace carom::tool {

/// Reads a report.json, or the one in a directory. Throws UsageError that names the file and the place.
[[nodiscard]] report::RecordedRun read_report(const std::string& file_or_directory);

/// Reads report.json, and the witnesses that it lists, from the directory of a gate with --shard. Throws UsageError
/// that names the file and the place. Also throws if the report is no shard, is of another version of Carom, or was
/// interrupted.
[[nodiscard]] report::ReadShard read_shard(const std::string& directory);

struct Presentation {
  std::string out;                 // the directory of the reports and witnesses; empty for none
  std::string format = "text";     // on standard output: "text" or "json"
  bool has_annotations = false;    // after the run, in GitHub's format
  std::string summary;             // the file to which a summary in Markdown is appended; empty for none
  std::function<void()> annotate;  // called before annotations are printed; may be empty
  bool has_coverage = false;       // whether the text has what was generated
};

/// Compares the run with its baseline, if there is one, writes the files, prints the run, and returns the exit status.
/// Throws UsageError if a file cannot be written. `staged` is the staged output of `presentation.out`, if there is one.
/// The function resets it.
[[nodiscard]] int present_run(report::Run run, const std::optional<report::RecordedRun>& baseline,
                              const Presentation& presentation, std::optional<StagedOutput>& staged);

}  // namespace carom::tool
