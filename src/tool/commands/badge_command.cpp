// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>

#include "commands/commands.hpp"
#include "io/output.hpp"
#include "io/report_file.hpp"

namespace carom::tool {

void add_badge(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    std::string file;
    std::string out;  // empty for standard output
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("badge", "Write the verdict of a report as JSON for a shields.io badge");
  command->add_option("FILE", arguments->file, "A report.json that `carom gate --out` wrote")->required();
  command->add_option("--out", arguments->out, "File to write (default: standard output)")->type_name("FILE");
  command->callback([&chosen, arguments] {
    chosen = [arguments] {
      const std::string record = report::badge_record(read_report(arguments->file)).dump() + '\n';
      if (arguments->out.empty()) {
        fmt::print("{}", record);
      } else {
        write_file(arguments->out, record);
      }
      return exit_all_hold;
    };
  });
}

}  // namespace carom::tool
