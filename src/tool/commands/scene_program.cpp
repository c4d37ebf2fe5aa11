// SPDX-License-Identifier: BSL-1.0
#include "commands/scene_program.hpp"

#include <string_view>

#include <unistd.h>

#include <carom/subjects/engines/adapters.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {

void become_scene_program(int argc, char** argv) noexcept {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command != "scene" && command != "plan") {
    return;
  }
  const std::filesystem::path directory = subjects::program_directory();
  if (!directory.empty()) {
    execv((directory / "carom-scene").c_str(), argv);  // it returns only if the program cannot be run
  }
}

void add_missing_scene(CLI::App& app, Chosen& chosen) {
  CLI::App* command = app.add_subcommand(
      "scene", "Simulate a scene: certify the order of its events, judge its impulses, and account for its energy");
  command->allow_extras();
  command->callback([&chosen] {
    chosen = []() -> int {
      throw UsageError(
          "scene: the program carom-scene is not in the directory of this program; install Carom's scenes");
    };
  });
}

}  // namespace carom::tool
