// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "commands/commands.hpp"

/// Scenes are a component with a program of its own, carom-scene. `carom` starts that program.
namespace carom::tool {

/// Replaces this process by carom-scene if the command is `scene` or `plan` and carom-scene is in this program's
/// folder. Otherwise it returns.
void become_scene_program(int argc, char** argv) noexcept;

/// The command `scene` of a program that did not become carom-scene. It throws UsageError.
void add_missing_scene(CLI::App& app, Chosen& chosen);

}  // namespace carom::tool
