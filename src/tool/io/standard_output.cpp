// SPDX-License-Identifier: BSL-1.0
#include "io/standard_output.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "io/usage_error.hpp"

namespace carom::tool {

void flush_output() {
  if (std::fflush(stdout) == 0) {
    return;
  }
  const std::error_code code(errno, std::generic_category());
  if (code == std::errc::broken_pipe) {
    throw std::system_error(code);
  }
  throw UsageError(fmt::format("standard output cannot be written: {}", code.message()));
}

void end_by_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  // A parent may have left the signal blocked.
  constexpr int as_killed_by_a_signal = 128;
  std::_Exit(as_killed_by_a_signal + SIGPIPE);
}

}  // namespace carom::tool
