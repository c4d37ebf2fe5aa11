// SPDX-License-Identifier: BSL-1.0
#include <string_view>

#include <unistd.h>

#include <carom/subjects/engines.hpp>

#include "commands/commands.hpp"
#include "io/usage_error.hpp"

/// carom. Scenes are a component with a program of its own, carom-scene, which carom starts.
namespace carom::tool {
namespace {

/// Replaces this process by carom-scene if the command is `scene`, `time` or `plan` and carom-scene is in this
/// program's folder. Otherwise it returns.
void become_scene_program(int argc, char** argv) noexcept {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command != "scene" && command != "time" && command != "plan") {
    return;
  }
  const std::filesystem::path directory = subjects::program_directory();
  if (!directory.empty()) {
    execv((directory / "carom-scene").c_str(), argv);  // it returns only if the program cannot be run
  }
}

/// A command of a program that did not become carom-scene. It throws UsageError.
void add_missing(CLI::App& app, Chosen& chosen, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->allow_extras();
  command->callback([&chosen, name] {
    chosen = [name]() -> int {
      throw UsageError(name +
                       ": the program carom-scene is not in the directory of this program; install Carom's scenes");
    };
  });
}

void add_missing_scene(CLI::App& app, Chosen& chosen) {
  add_missing(app, chosen, "scene",
              "Simulate a scene: certify the order of its events, judge its impulses, and account for its energy");
}

void add_missing_time(CLI::App& app, Chosen& chosen) {
  add_missing(app, chosen, "time", "Measure engines that step in time against ten phenomena with known answers");
}

}  // namespace
}  // namespace carom::tool

int main(int argc, char** argv) {
  using namespace carom::tool;
  become_scene_program(argc, argv);
  return run_program(argc, argv,
                     {add_gate, add_check, add_domain, add_lists, add_chart, add_missing_scene, add_plan, add_compare,
                      add_merge, add_replay, add_missing_time});
}
