// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/report/model/run_json.hpp>

namespace carom::tool {

/// A run, and the file that it was read from.
struct ReadRun {
  std::string file;
  report::Run run;
};

/// Reads a report.json, or the one in a directory. Throws UsageError that names the file and the place.
[[nodiscard]] ReadRun read_report(const std::string& file_or_directory);

/// Reads report.json, and the witnesses that it lists, from the directory of a gate with --shard. Throws UsageError
/// that names the file and the place if either cannot be read. It also throws if the report is of no shard or of
/// another version of Carom, or if the run was interrupted.
[[nodiscard]] report::ReadShard read_shard(const std::string& directory);

}  // namespace carom::tool
