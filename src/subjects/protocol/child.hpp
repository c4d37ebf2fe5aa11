// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace carom::subjects::protocol {

/// What a child process may take.
struct ChildLimits {
  std::chrono::milliseconds timeout{5000};             // for each line, and for the end of the process
  std::size_t line = std::size_t{1} << 20U;            // bytes
  std::size_t standard_error = std::size_t{1} << 16U;  // bytes that are kept, the last ones
};

/// The process did not do what was expected of it; the text says what, not who.
class ChildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program of its own process group that reads and writes lines. No shell is run. For one thread: the one that made
/// it. Whatever happens to this process, the child does not outlive it (on Linux). Its environment is this process's
/// and the mark of mark.hpp.
class ChildProcess {
 public:
  /// From the first one on, this process ignores SIGPIPE where it did not handle it.
  /// Precondition: words are not empty. Throws ChildError where the program cannot be run.
  ChildProcess(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop);

  /// Kills the process group.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes the text while it reads `count` lines, and gives each line, without its end, to `on_line`. Throws
  /// ChildError, and what on_line throws; the process is then of no further use.
  void exchange(const std::string& text, std::size_t count, const std::function<void(std::string_view)>& on_line);

  /// Writes the text, closes the process's standard input, and waits for its end. Throws ChildError where it writes
  /// another line, does not end in time, or ends in anything but status 0.
  void finish(const std::string& text);

  /// The last of what it wrote on standard error.
  [[nodiscard]] std::string standard_error();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace carom::subjects::protocol
