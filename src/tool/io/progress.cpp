// SPDX-License-Identifier: BSL-1.0
#include "io/progress.hpp"

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace carom::tool {

std::function<void(std::uint64_t, std::uint64_t)> progress_line(std::string what) {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return [what = std::move(what), shown = std::uint64_t{101}](std::uint64_t done, std::uint64_t all) mutable {
    const std::uint64_t percent = 100 * done / all;
    if (percent != shown) {
      shown = percent;
      std::fputs(fmt::format("\r{} of {} {}, {} %{}", done, all, what, percent, done == all ? "\n" : "").c_str(),
                 stderr);
      std::fflush(stderr);
    }
  };
}

}  // namespace carom::tool
