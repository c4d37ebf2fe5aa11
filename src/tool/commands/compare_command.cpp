// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>
#include <carom/report/results/comparison_record.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/report_file.hpp"

namespace carom::tool {
namespace {

struct CompareArguments {
  std::string before;  // reports, or the directories that hold them
  std::string now;
  std::string format = "text";
};

int compare_files(const CompareArguments& arguments) {
  const report::RecordedRun before = read_report(arguments.before);
  const report::Comparison comparison = report::compare_runs(before, read_report(arguments.now));
  if (arguments.format == "json") {
    fmt::print("{}\n", report::comparison_record(comparison).dump(2));
  } else if (arguments.format == "markdown") {
    fmt::print("{}", report::comparison_markdown(comparison));
  } else if (arguments.format == "html") {
    fmt::print("{}", report::comparison_html(comparison));
  } else {
    fmt::print("{}", report::comparison_text(comparison));
  }
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
  add_format(*command, arguments->format, {"text", "markdown", "html", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return compare_files(*arguments); }; });
}

}  // namespace carom::tool
