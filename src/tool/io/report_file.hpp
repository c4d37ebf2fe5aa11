// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/report/results/run_json.hpp>

namespace carom::tool {

/// Reads a report.json, or the one in a directory. Throws UsageError that names the file and the place.
[[nodiscard]] report::RecordedRun read_report(const std::string& file_or_directory);

/// Reads report.json, and the witnesses that it lists, from the directory of a gate with --shard. Throws UsageError
/// that names the file and the place. Also throws if the report is no shard, is of another version of Carom, or was
/// interrupted.
[[nodiscard]] report::ReadShard read_shard(const std::string& directory);

}  // namespace carom::tool
