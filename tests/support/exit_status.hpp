// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdio>
#include <exception>

namespace carom::unit {

/// What run() returns; where it throws, 2, and a line on standard error.
template <class Run>
[[nodiscard]] int exit_status(const char* program, const Run& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 2;
  }
}

}  // namespace carom::unit
