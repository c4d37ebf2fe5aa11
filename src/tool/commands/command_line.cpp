// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <carom/properties/trial/nearest_name.hpp>
#include <carom/report/model/version.hpp>

#include "commands/commands.hpp"
#include "io/memory_reserve.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

/// Of what was not expected, the command or the option that may have been meant; a line each.
std::string meant_words(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  std::vector<std::string> options;
  for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options()) {
    for (const std::string& name : option->get_lnames()) {
      options.push_back("--" + name);
    }
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  std::string lines;
  for (const std::string& word : app.remaining(true)) {
    const bool is_option = word.starts_with("--");
    if (!is_option && !chosen.empty()) {
      continue;
    }
    if (const auto nearest = properties::nearest_name(word.substr(0, word.find('=')), is_option ? options : commands)) {
      lines += fmt::format("Did you mean '{}'?\n", *nearest);
    }
  }
  return lines;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app("Carom judges rigid-body collision impulses against exact arithmetic.", "carom");
  app.set_version_flag("--version", report::version);
  app.require_subcommand(0, 1);
  Chosen chosen;
  for (const auto add : {add_gate, add_lists, add_chart, add_scene, add_plan, add_compare, add_merge, add_table,
                         add_badge, add_replay}) {
    add(app, chosen);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    app.exit(error);
    std::fputs(meant_words(app).c_str(), stderr);
    return exit_usage;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  if (!chosen) {
    std::fputs(fmt::format("carom: a command is needed\n{}", app.help()).c_str(), stderr);
    return exit_usage;
  }
  const int status = chosen();
  if (has_run_out_of_memory()) {
    std::fputs(out_of_memory, stderr);
    return exit_usage;
  }
  if (std::fflush(stdout) != 0) {
    throw UsageError("standard output cannot be written");
  }
  return status;
}

}  // namespace carom::tool
