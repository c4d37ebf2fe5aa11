// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace carom::tool {

/// Shows the progress of long work on one line of standard error: "12 of 100 WHAT, 12 %". Empty if standard error is
/// not a terminal.
[[nodiscard]] std::function<void(std::uint64_t done, std::uint64_t all)> progress_line(std::string what);

}  // namespace carom::tool
