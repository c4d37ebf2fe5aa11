// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace carom::tests {

struct RunResult {
  int exit_status;
  std::string output;
  std::string errors;
};

/// Runs `carom ARG… MORE…`.
[[nodiscard]] RunResult run_carom(std::vector<std::string> arguments, const std::vector<std::string>& more = {});

/// Expects exit status 2, and each part in the error message.
void expect_error(const RunResult& run, const std::vector<std::string>& parts);

/// For `--deviates`: the invariants that a run of few families may judge in no case.
inline constexpr const char* few_families_judge_no =
    "invalid_refused,separating_untouched,immovable_untouched,collinear_spin,well_conditioned";

[[nodiscard]] std::string carom_program();

[[nodiscard]] RunResult run_program(const std::string& program, const std::vector<std::string>& arguments);

/// The files that the JSON schema accepts, in order. One process of python3-jsonschema reads all files, because its
/// start takes a second.
[[nodiscard]] std::vector<std::string> accepted_by(const std::string& schema, std::vector<std::string> files);

/// Starts `carom ARG…` and discards its output.
[[nodiscard]] pid_t start_carom(const std::vector<std::string>& arguments);

/// Waits for a started process. Returns its exit status, or -1 if a signal ended it.
[[nodiscard]] int wait_for(pid_t process);

class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// Empty if the file cannot be read: a process of /proc may end meanwhile.
[[nodiscard]] std::string content_of(const std::filesystem::path& file);

}  // namespace carom::tests
