// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

/// Runs programs as a user would.
namespace carom::tests {

struct RunResult {
  int exit_status;
  std::string output;
  std::string errors;
};

/// `carom ARG…`, without a shell.
[[nodiscard]] RunResult run_carom(const std::vector<std::string>& arguments);

/// Where it is.
[[nodiscard]] std::string carom_program();

/// Any other program, by its path.
[[nodiscard]] RunResult run_program(const std::string& program, const std::vector<std::string>& arguments);

/// Starts `carom ARG…` and goes on, its output dropped.
[[nodiscard]] pid_t start_carom(const std::vector<std::string>& arguments);

/// Waits for a started one: its exit status, or -1 where a signal ended it.
[[nodiscard]] int wait_for(pid_t process);

/// A directory of its own, removed at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file into it and returns its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string content_of(const std::filesystem::path& file);

}  // namespace carom::tests
