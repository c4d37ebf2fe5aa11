// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stop_token>

namespace carom::tool {

/// Ctrl-C, SIGTERM, SIGHUP and the limit on processor time (`ulimit -S -t`) request this stop and do not end the
/// program. Signals within the next second belong to the same request. A later
/// signal ends the program. A signal that the parent left ignored, as `nohup` does, stays ignored. Call this function
/// before any other thread is started.
[[nodiscard]] std::stop_token stop_on_interrupt();

}  // namespace carom::tool
