// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "commands/commands.hpp"
#include "commands/contacts_of_file.hpp"

namespace carom::tool {

/// The command `plan`. If `contacts_of_scene` is empty, the command refuses scenes.
void add_plan_with(CLI::App& app, Chosen& chosen, plan::ContactsOfScene contacts_of_scene);

}  // namespace carom::tool
