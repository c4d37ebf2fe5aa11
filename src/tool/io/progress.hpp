// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace carom::tool {

/// Shows how much of long work is done, "12 of 100 WHAT, 12 %", on one line of standard error that is written over,
/// where that is a terminal; empty where it is none.
[[nodiscard]] std::function<void(std::uint64_t done, std::uint64_t all)> progress_line(std::string what);

}  // namespace carom::tool
