// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <sys/types.h>

namespace carom::subjects::protocol {

/// The name of the environment variable that ChildProcess sets for its children. It is drawn at random once for this
/// process, so that no other run of any program sets it. The descendants of a child inherit it.
[[nodiscard]] const std::string& mark_of_children();

/// Whether the process was started with that variable in its environment. The result is false if the process dropped or
/// overwrote its environment, if this user cannot read it, or if there is no /proc.
[[nodiscard]] bool bears_mark_of_children(pid_t process);

}  // namespace carom::subjects::protocol
