// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <CLI/CLI.hpp>

#include "commands/commands.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

/// A command of a program that did not become carom-scene. It throws UsageError.
void add_missing(CLI::App& app, Chosen& chosen, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->allow_extras();
  command->callback([&chosen, name] {
    chosen = [name]() -> int {
      throw UsageError(name + ": the program carom-scene is not in the directory of this program; build " +
                       "the component scenes, or install the package carom-scene");
    };
  });
}

}  // namespace

void add_missing_scene(CLI::App& app, Chosen& chosen) {
  add_missing(app, chosen, "scene",
              "Simulate a scene: certify the order of its events, judge its impulses, and account for its energy");
}

void add_missing_time(CLI::App& app, Chosen& chosen) {
  add_missing(app, chosen, "time", "Measure engines that step in time against ten phenomena with known answers");
}

}  // namespace carom::tool
