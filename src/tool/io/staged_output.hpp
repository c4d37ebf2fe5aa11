// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::tool {

/// The files of a run, which come into the directory that --out names together or not at all. They are written into a
/// stage, a directory of its own inside of it, and renamed to their places once all of them are whole. What stood there
/// before stands until then.
class StagedOutput {
 public:
  /// Makes the directory, with its parents, and the stage. Throws UsageError where that cannot be done.
  explicit StagedOutput(std::filesystem::path directory);
  /// Removes what was not put in place.
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// Where to write: "stage / x" becomes "directory / x".
  [[nodiscard]] const std::filesystem::path& stage() const { return stage_; }

  /// Renames every file to its place, that of this name last of all; each is on the disk before the first is renamed.
  /// Throws UsageError where one cannot be: before the first rename, where that can be known.
  void put_in_place(const std::string& last);

 private:
  std::filesystem::path directory_;
  std::filesystem::path stage_;
  int lock_ = -1;  // the stage, open and locked for as long as its writer lives
};

/// The stages that runs which were ended have left there: those that nobody holds locked.
[[nodiscard]] std::vector<std::filesystem::path> abandoned_stages(const std::filesystem::path& directory);

/// Removes them. What cannot be removed stays.
void remove_abandoned_stages(const std::filesystem::path& directory);

}  // namespace carom::tool
