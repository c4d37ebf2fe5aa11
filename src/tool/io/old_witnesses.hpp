// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <vector>

namespace carom::tool {

/// The witnesses of earlier runs, which would pass for those of the next one: those that report.json in the directory
/// lists, or that of a run which was ended while it put its files in place. Relative to the directory; none where such
/// a report cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> old_witnesses(const std::filesystem::path& directory);

/// Removes those of them that report.json, which is new, does not list, where they are plain files directly in
/// witnesses/. Nothing is removed through a symbolic link. Throws UsageError where one cannot be removed.
void remove_old_witnesses(const std::filesystem::path& directory, const std::vector<std::filesystem::path>& old);

}  // namespace carom::tool
