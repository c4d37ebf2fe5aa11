// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/results/merged_run.hpp>
#include <carom/report/results/words.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/output.hpp"
#include "io/reports.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

struct CompareArguments {
  std::string before;  // reports, or the directories that hold them
  std::string now;
};

int compare_files(const CompareArguments& arguments) {
  const report::RecordedRun before = read_report(arguments.before);
  const report::Comparison comparison = report::compare_runs(before, read_report(arguments.now));
  fmt::print("{}", report::comparison_text(comparison));
  return comparison.count_new(false) > 0 ? exit_violated : exit_all_hold;
}

struct MergeArguments {
  std::vector<std::string> directories;  // of the shards
  std::string out;                       // a directory
  std::string baseline;                  // as in `carom gate`
  std::string format = "text";
};

namespace fs = std::filesystem;

/// Throws UsageError if the output would replace the report of a shard.
void require_apart(const std::string& out, const std::vector<std::string>& directories) {
  for (const std::string& directory : directories) {
    std::error_code ignored;
    if (fs::equivalent(out, directory, ignored)) {
      throw UsageError(
          fmt::format("--out: {} is the directory of a shard; choose another directory", report::shown(out)));
    }
  }
}

int merge_shards(const MergeArguments& arguments) {
  require_apart(arguments.out, arguments.directories);
  const std::optional<report::RecordedRun> baseline =
      arguments.baseline.empty() ? std::nullopt : std::optional(read_report(arguments.baseline));
  std::vector<report::ReadShard> shards;
  for (const std::string& directory : arguments.directories) {
    shards.push_back(read_shard(directory));
  }
  report::Run run = report::merged_run(shards);
  make_directories(fs::path(arguments.out) / "witnesses");
  std::optional<StagedOutput> staged(std::in_place, arguments.out);
  return present_run(std::move(run), baseline, {arguments.out, arguments.format, false, {}, {}}, staged);
}

}  // namespace

void add_compare(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Compare two reports; exit status 0 there are no new violations, 1 there are new violations, 2 bad input");
  command->add_option("OLD", arguments->before, "The earlier report.json of `carom gate --out`, or its directory")
      ->required();
  command->add_option("NEW", arguments->now, "The later report.json, or its directory")->required();
  command->callback([&chosen, arguments] { chosen = [arguments] { return compare_files(*arguments); }; });
}

void add_merge(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand("merge",
                                         "Combine the reports of all shards of a run into one; exit status as for the "
                                         "whole run, 2 if the shards do not belong to one run");
  command
      ->add_option("DIRECTORY", arguments->directories,
                   "Directories that `carom gate --shard I/N --out` wrote, one for each shard")
      ->required();
  command->add_option("--out", arguments->out, "Directory for the reports and for witnesses/")->required();
  command->add_option("--baseline", arguments->baseline, "An earlier report of a whole run, as for carom gate");
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return merge_shards(*arguments); }; });
}

}  // namespace carom::tool
