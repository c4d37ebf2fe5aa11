// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace carom::tool {

/// Removes the witnesses of an earlier run, which would pass for this one's: those that report.json in the directory
/// lists, where they are plain files directly in its witnesses/. Nothing is removed where that report cannot be read,
/// or through a symbolic link. Throws UsageError where one cannot be removed.
void remove_old_witnesses(const std::filesystem::path& directory);

}  // namespace carom::tool
