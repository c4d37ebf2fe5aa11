// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/old_witnesses.hpp"
#include "commands/output_file.hpp"
#include "commands/present_run.hpp"
#include "merge/merged_run.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// Throws where what is written would replace what is read.
void require_apart(const std::string& out, const std::vector<std::string>& directories) {
  for (const std::string& directory : directories) {
    std::error_code ignored;
    if (fs::equivalent(out, directory, ignored)) {
      throw UsageError(fmt::format("--out: {} is that of a shard", compare::shown(out)));
    }
  }
}

}  // namespace

int merge_shards(const MergeArguments& arguments) {
  require_apart(arguments.out, arguments.directories);
  std::optional<compare::ReadReport> baseline;
  if (!arguments.baseline.empty()) {
    baseline = compare::read_report(arguments.baseline);
  }
  std::vector<merge::ReadShard> shards;
  for (const std::string& directory : arguments.directories) {
    shards.push_back(merge::read_shard(directory));
  }
  GateRun run = merge::merged_run(shards);
  run.is_shard = false;
  run.diagnoses = properties::diagnosis::diagnose_all(run.report);
  make_directories(fs::path(arguments.out) / "witnesses");
  std::optional<StagedOutput> staged(std::in_place, arguments.out);
  return present_run(std::move(run), baseline, {arguments.out, arguments.format, false, {}, {}}, staged);
}

}  // namespace carom::tool
