// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::tool {

/// The files of a run, which appear in the directory of --out together or not at all. They are written into a stage, a
/// temporary directory inside that directory. When all files are complete, they replace the previous files. One run at
/// a time writes to a directory: the object holds a lock on it, which the kernel releases if the process is killed. On
/// a file system without locks, runs are not kept apart. A run of the npm package has a lock of its own, which names
/// its process; the object respects it.
class StagedOutput {
 public:
  /// Makes the directory, with its parents, and the stage. Throws UsageError if one of them cannot be made, or if
  /// another run holds the lock.
  explicit StagedOutput(std::filesystem::path directory);
  /// Removes the files that were not put in place, and releases the lock.
  ~StagedOutput();
  StagedOutput(const StagedOutput&) = delete;
  StagedOutput& operator=(const StagedOutput&) = delete;

  /// The directory to write to. "stage / x" becomes "directory / x".
  [[nodiscard]] const std::filesystem::path& stage() const { return stage_; }

  /// Renames every file to its place, and the file `last` last. Every file is flushed to disk before the first rename.
  /// Throws UsageError if a file cannot be renamed. If possible, it throws before the first rename.
  void put_in_place(const std::string& last);

  /// The stages that killed runs left behind in the directory.
  [[nodiscard]] std::vector<std::filesystem::path> abandoned_stages() const;

  /// Removes the abandoned stages. A stage that cannot be removed stays.
  void remove_abandoned_stages() const;

 private:
  void release_lock() const;

  std::filesystem::path directory_;
  std::filesystem::path stage_;
  int lock_ = -1;  // the open file that is locked; -1 if the file system has no locks
};

}  // namespace carom::tool
