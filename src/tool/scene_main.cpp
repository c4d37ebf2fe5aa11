// SPDX-License-Identifier: BSL-1.0
#include "commands/commands.hpp"

/// carom-scene: the commands of `carom` that know scenes and steps.
int main(int argc, char** argv) {
  using namespace carom::tool;
  return run_program(argc, argv, {add_scene, add_plan_of_scenes, add_time});
}
