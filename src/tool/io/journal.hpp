// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include <carom/report/model/run.hpp>
#include <carom/report/model/run_facts.hpp>

namespace carom::tool {

/// A folder that keeps the finished parts of a run. Each part is a file part-I-OF-N.json, a report of the shard I/N. A
/// file appears when it is complete, so a killed run leaves only whole parts.
class Journal {
 public:
  /// Makes the folder. `facts` are those of each part, and `shards` is N. Throws UsageError if the folder cannot be
  /// made, or if it has parts of another number of shards.
  Journal(std::filesystem::path folder, report::RunFacts facts, std::uint64_t shards);

  /// The results of a part, without samples and witnesses; none if the part is not finished. Throws UsageError that
  /// names the file and the place if the file is no such report, or belongs to another run.
  [[nodiscard]] std::optional<properties::GateReport> finished(const properties::Shard& part) const;

  /// Keeps the part that `run` is. Precondition: the run is a shard, and was judged to its end. Throws UsageError if
  /// the file cannot be written.
  void keep(const report::Run& run) const;

  /// Removes the parts, and the folder if nothing else is in it.
  void remove() const;

 private:
  std::filesystem::path folder_;
  report::RunFacts facts_;
};

}  // namespace carom::tool
