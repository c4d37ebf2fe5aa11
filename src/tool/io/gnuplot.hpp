// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <filesystem>
#include <span>

#include <carom/report/pictures/plot.hpp>

namespace carom::tool {

/// Writes each picture's script to DIRECTORY/gnuplot/NAME.gp and has gnuplot draw DIRECTORY/NAME.svg. Throws UsageError
/// if gnuplot is not installed or fails.
void draw(std::span<const report::Plot> pictures, const std::filesystem::path& directory);

/// Like draw(), but returns the UsageError (nullptr for none), so that the caller can still save the data.
[[nodiscard]] std::exception_ptr try_to_draw(std::span<const report::Plot> pictures,
                                             const std::filesystem::path& directory);

}  // namespace carom::tool
