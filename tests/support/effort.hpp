// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstdlib>

namespace carom::unit {

/// The number of cases of a heavy test: `full` times the environment variable CAROM_EFFORT, rounded up, or `full` if
/// the variable is not set. CTest sets the variable for SAMPLED tests (tests/CMakeLists.txt).
[[nodiscard]] inline int effort(int full) {
  const char* const share = std::getenv("CAROM_EFFORT");
  return share == nullptr ? full : static_cast<int>(std::ceil(full * std::strtod(share, nullptr)));
}

}  // namespace carom::unit
