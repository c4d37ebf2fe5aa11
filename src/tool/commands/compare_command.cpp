// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>

#include "commands/commands.hpp"
#include "io/reports.hpp"

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

}  // namespace carom::tool
