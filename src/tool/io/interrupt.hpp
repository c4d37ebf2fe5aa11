// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

namespace carom::tool {

/// From the first call on, Ctrl-C, SIGTERM and SIGHUP request a stop and do not end the program. Signals within the
/// next second belong to the same request. A later signal ends the program. Exhausted memory also requests a stop
/// (memory_reserve.hpp). Call it before any other thread is started.
[[nodiscard]] std::stop_token stop_on_interrupt();

}  // namespace carom::tool
