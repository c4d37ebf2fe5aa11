// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <string>

#include <fmt/format.h>

#include <carom/report/pages/pages.hpp>

#include "commands/commands.hpp"
#include "io/report_file.hpp"

namespace carom::tool {

void add_table(CLI::App& app, Chosen& chosen) {
  const auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("table", "Print the subjects of a report as a Markdown table");
  command->add_option("FILE", *file, "A report.json that `carom gate --out` wrote")->required();
  command->callback([&chosen, file] {
    chosen = [file] {
      fmt::print("{}", report::subjects_markdown(read_report(*file)));
      return exit_all_hold;
    };
  });
}

}  // namespace carom::tool
