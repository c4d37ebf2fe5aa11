// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

namespace carom::tool {

/// From now on Ctrl-C, SIGTERM and SIGHUP request a stop in place of ending the program, once. What
/// follows within a second is the same wish; a later one ends the program. So does memory that runs out
/// (memory_reserve.hpp). To be called before any other thread is started.
[[nodiscard]] std::stop_token stop_on_interrupt();

}  // namespace carom::tool
