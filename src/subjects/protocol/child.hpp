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

struct ChildLimits {
  std::chrono::milliseconds timeout{5000};             // for each line, and for the end of the process
  std::size_t line = std::size_t{1} << 20U;            // bytes
  std::size_t standard_error = std::size_t{1} << 16U;  // how many of the last bytes of standard error are kept
};

/// The process misbehaved. The text does not name the subject.
class ChildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program that reads and writes lines, started without a shell in its own process group. The destructor ends this
/// group: the program, and the processes that it started and that did not leave the group. Nothing else in this process
/// may wait for the program, and no handling of a signal changes. Use the object only on the thread that made it. On
/// Linux, the program also ends if this process is killed.
class ChildProcess {
 public:
  /// Precondition: `words` is not empty. Throws ChildError if the program cannot be run.
  ChildProcess(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop);

  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes the text while it reads `count` lines. Passes each line, without its line end, to `on_line`. Throws
  /// ChildError, and exceptions of `on_line`. After an exception, the process cannot be used any more.
  void exchange(const std::string& text, std::size_t count, const std::function<void(std::string_view)>& on_line);

  /// Writes the text, closes the process's standard input, and waits for the process to end. Throws ChildError if the
  /// process writes another line, does not end in time, or ends with a status other than 0.
  void finish(const std::string& text);

  /// The last bytes that the process wrote to standard error.
  [[nodiscard]] std::string standard_error();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace carom::subjects::protocol
