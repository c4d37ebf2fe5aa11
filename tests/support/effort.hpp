// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstdlib>

namespace carom::unit {

/// How many of `full` cases a heavy test takes: the share that the environment variable CAROM_EFFORT says, rounded up.
/// All of them if it is not set. CTest sets it where the test is only sampled (tests/CMakeLists.txt).
[[nodiscard]] inline int effort(int full) {
  const char* const share = std::getenv("CAROM_EFFORT");
  return share == nullptr ? full : static_cast<int>(std::ceil(full * std::strtod(share, nullptr)));
}

}  // namespace carom::unit
