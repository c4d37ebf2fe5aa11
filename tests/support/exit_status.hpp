// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdio>
#include <exception>

namespace carom::unit {

/// Returns the result of run(). If run() throws, prints a line on standard error and returns 2.
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
