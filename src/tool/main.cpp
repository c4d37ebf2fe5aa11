// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <string_view>

#include <unistd.h>

#include <carom/subjects/engines.hpp>

#include "commands/commands.hpp"

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

}  // namespace
}  // namespace carom::tool

int main(int argc, char** argv) {
  using namespace carom::tool;
  become_scene_program(argc, argv);
  return run_program(argc, argv,
                     {add_gate, add_check, add_domain, add_lists, add_chart, add_missing_scene, add_plan, add_compare,
                      add_merge, add_replay, add_missing_time});
}
