// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <sys/types.h>

namespace carom::subjects::protocol {

/// The random name of the environment variable that ChildProcess sets for its children, and that their descendants
/// inherit.
[[nodiscard]] const std::string& mark_of_children();

/// Whether the process was started with the variable `mark_of_children()`. The result is false if the process dropped
/// or overwrote its environment, if this user cannot read it, or if there is no /proc.
[[nodiscard]] bool bears_mark_of_children(pid_t process);

}  // namespace carom::subjects::protocol
