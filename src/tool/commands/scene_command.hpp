// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "commands/commands.hpp"

namespace carom::tool {

void add_scene(CLI::App& app, Chosen& chosen);

/// The command `plan`, of scenes and of collisions.
void add_plan_of_scenes(CLI::App& app, Chosen& chosen);

}  // namespace carom::tool
