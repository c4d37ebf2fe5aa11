// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "report/records.hpp"

namespace carom::tool::merge {

/// A shard's report, read back as the run that it was.
struct ReadShard {
  std::string file;
  GateRun run;
};

/// Of the directory that a gate with --shard wrote: report.json, and the witnesses that it lists. Throws UsageError,
/// which names file and place, where either cannot be read, the report is of no shard or of another version of Carom,
/// or the run was interrupted.
[[nodiscard]] ReadShard read_shard(const std::string& directory);

}  // namespace carom::tool::merge
