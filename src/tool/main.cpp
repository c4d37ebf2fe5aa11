// SPDX-License-Identifier: BSL-1.0
#include "commands/commands.hpp"
#include "commands/scene_program.hpp"

int main(int argc, char** argv) {
  using namespace carom::tool;
  become_scene_program(argc, argv);
  return run_program(argc, argv,
                     {add_gate, add_domain, add_lists, add_chart, add_missing_scene, add_plan, add_compare, add_merge,
                      add_replay});
}
