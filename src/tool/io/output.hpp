// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace carom::tool {

/// Throws the UsageError for a file that cannot be written. `error` is an errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error, const std::string& option = "--out");

/// Writes the text as the whole file. Throws UsageError that names the file's option and the file if the file cannot be
/// written.
void write_file(const std::filesystem::path& path, const std::string& text, const std::string& option = "--out");

/// Appends the text to the file. An empty text only checks that appending is possible. Throws UsageError that names the
/// file's option if appending is not possible.
void append_to_file(const std::string& option, const std::filesystem::path& path, const std::string& text);

/// Leaves the path as it is. Throws UsageError, which names the option, if the file cannot be written.
void require_writable(const std::string& option, const std::filesystem::path& path);

/// Makes a directory that is the option's or below it, with its parents. Throws UsageError if it cannot be made.
void make_directories(const std::filesystem::path& directory, const std::string& option = "--out");

/// The files of a run, which appear in the directory of --out together or not at all. They are written into a stage, a
/// temporary directory inside that directory. When all files are complete, they replace the previous files. One run at
/// a time writes to a directory: the object holds the lock of the directory, which the kernel releases if the process
/// is killed. On a file system without locks, runs are not kept apart.
class StagedOutput {
 public:
  /// Makes the directory, with its parents, and the stage. Removes the stages that killed runs left behind. Throws
  /// UsageError if a directory cannot be made, or if another run, of this program or of the npm package, has the lock.
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

 private:
  void release_lock() const;

  std::filesystem::path directory_;
  std::filesystem::path stage_;
  int lock_ = -1;  // the open file that is locked; -1 if the file system has no locks
};

/// Writes the text to standard output at once. Throws as `flush_output`.
void write_output(const std::string& text);

/// Writes what is buffered for standard output. Throws a std::system_error with the code `broken_pipe` if the reader is
/// gone, as fmt::print does. Throws UsageError if the output cannot be written for another reason.
void flush_output();

/// Shows the progress of long work on one line of standard error: "12 of 100 WHAT, 12 %". Empty if standard error is
/// not a terminal.
[[nodiscard]] std::function<void(std::uint64_t done, std::uint64_t all)> progress_line(std::string what);

}  // namespace carom::tool
