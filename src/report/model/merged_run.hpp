// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <vector>

#include <carom/report/model/run_json.hpp>

namespace carom::report {

/// The shards are not those of one run, each once.
class MergeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run that the shards are the parts of: its counts, coverage, worst backward errors and cases, digits and sample
/// are those of a run without shards. A witness is the worst of those that the shards have of the family that shows
/// most; the time of a solve is the mean of theirs, by their cases; date and machine are those of the first shard.
/// Throws MergeError, which says what differs, where the shards do not belong together, one is missing, or one stands
/// there twice.
[[nodiscard]] Run merged_run(const std::vector<ReadShard>& shards);

}  // namespace carom::report
