// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "commands/commands.hpp"

/// Scenes are a component of their own, with a program of its own. `carom` starts it as git starts its commands.
namespace carom::tool {

/// If the command is `scene` or `plan`, and carom-scene stands beside this program, it takes the place of this process.
/// Else it returns.
void become_scene_program(int argc, char** argv) noexcept;

/// The command `scene` of a program that did not become carom-scene: it throws UsageError.
void add_missing_scene(CLI::App& app, Chosen& chosen);

}  // namespace carom::tool
