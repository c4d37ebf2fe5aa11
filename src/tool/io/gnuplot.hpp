// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <filesystem>
#include <span>

#include <carom/report/pictures/plot.hpp>

namespace carom::tool {

/// Writes each picture's script to DIRECTORY/gnuplot/NAME.gp and has gnuplot draw DIRECTORY/NAME.svg. Returns a
/// UsageError if gnuplot is not installed or fails, otherwise nullptr, so that the caller can still save the data.
[[nodiscard]] std::exception_ptr try_to_draw(std::span<const report::Plot> pictures,
                                             const std::filesystem::path& directory);

}  // namespace carom::tool
