// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "commands/commands.hpp"

namespace carom::tool {

/// The command `scene`.
void add_scene(CLI::App& app, Chosen& chosen);

}  // namespace carom::tool
