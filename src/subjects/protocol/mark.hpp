// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <sys/types.h>

namespace carom::subjects::protocol {

/// The name of the environment variable that ChildProcess sets for what it starts, and that no other run of any program
/// sets: it is drawn at random, once for this process. What a child starts inherits it.
[[nodiscard]] const std::string& mark_of_children();

/// Whether a process was started with that variable in its environment, itself or by inheritance. Where a process has
/// dropped its environment, written over it, or keeps it from this user, and where there is no /proc, it bears none.
[[nodiscard]] bool bears_mark_of_children(pid_t process);

}  // namespace carom::subjects::protocol
