// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <vector>

#include "io/staged_output.hpp"

namespace carom::tool {

/// The witnesses of earlier runs, which could be mistaken for those of the next run. The report.json in the directory
/// lists them. If a run was killed while it put its files in place, the report.json in its abandoned stage lists them,
/// too. A report that cannot be read lists none. The paths are relative to the directory.
[[nodiscard]] std::vector<std::filesystem::path> old_witnesses(const std::filesystem::path& directory,
                                                               const StagedOutput& staged);

/// Removes the old witnesses that the new report.json does not list. Only removes regular files directly in witnesses/,
/// and follows no symbolic link. Throws UsageError if a file cannot be removed.
void remove_old_witnesses(const std::filesystem::path& directory, const std::vector<std::filesystem::path>& old);

}  // namespace carom::tool
