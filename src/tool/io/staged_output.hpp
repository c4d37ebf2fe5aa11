// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::tool {

/// The files of a run, which appear in the directory of --out together or not at all. They are written into a stage, a
/// temporary directory inside that directory. When all files are complete, they replace the previous files.
class StagedOutput {
 public:
  /// Makes the directory, with its parents, and the stage. Throws UsageError if one of them cannot be made.
  explicit StagedOutput(std::filesystem::path directory);
  /// Removes the files that were not put in place.
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// The directory to write to. "stage / x" becomes "directory / x".
  [[nodiscard]] const std::filesystem::path& stage() const { return stage_; }

  /// Renames every file to its place, and the file `last` last. Every file is flushed to disk before the first rename.
  /// Throws UsageError if a file cannot be renamed. If possible, it throws before the first rename.
  void put_in_place(const std::string& last);

 private:
  std::filesystem::path directory_;
  std::filesystem::path stage_;
  int lock_ = -1;  // the stage, open and locked for as long as its writer lives
};

/// The stages in the directory that ended runs left behind. No process holds a lock on them.
[[nodiscard]] std::vector<std::filesystem::path> abandoned_stages(const std::filesystem::path& directory);

/// Removes the abandoned stages. A stage that cannot be removed stays.
void remove_abandoned_stages(const std::filesystem::path& directory);

}  // namespace carom::tool
