// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include <carom/collision/subject.hpp>
#include <carom/subjects/protocol/child.hpp>

namespace carom::subjects::protocol {

struct ExecOptions {
  ChildLimits limits;
  /// A request to stop ends every wait for the program.
  std::stop_token stop;
  /// The spelling of every request (a way to write a collision, spelling.hpp), less than spelling_count. If this is
  /// empty, the spelling changes from call to call. Hexadecimal numbers have one spelling.
  std::optional<unsigned> spelling = {};
};

[[nodiscard]] inline ExecOptions exec_options(double timeout_seconds, std::stop_token stop) {
  ExecOptions options;
  options.limits.timeout =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(timeout_seconds));
  options.stop = std::move(stop);
  return options;
}

/// The prefix of a program's specification, where a subject's name is expected.
inline constexpr std::string_view exec_prefix = "exec:";

/// A program that speaks the protocol, from its specification "exec:PROGRAM ARG…". The words are split as a POSIX shell
/// does, but no shell is run. The first start serves the introduction and the first session. Each further session
/// starts the program again. If the first start fails, the returned subject has the specification as its name, and its
/// `open` throws the reason. A failed session throws SessionFailure with the request and the reason. Precondition: the
/// specification begins with exec_prefix.
[[nodiscard]] Subject exec_subject(const std::string& specification, const ExecOptions& options);

}  // namespace carom::subjects::protocol
