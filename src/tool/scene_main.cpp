// SPDX-License-Identifier: BSL-1.0
#include "commands/commands.hpp"
#include "commands/plan_command.hpp"
#include "commands/scene_command.hpp"
#include "plan/contacts_of_scene.hpp"

/// carom-scene: the commands of `carom` for scenes.
int main(int argc, char** argv) {
  using namespace carom::tool;
  return run_program(argc, argv, {add_scene, [](CLI::App& app, Chosen& chosen) {
                                    add_plan_with(app, chosen, plan::contacts_of_scene);
                                  }});
}
