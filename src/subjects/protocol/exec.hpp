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
  /// Ends all waiting for the program.
  std::stop_token stop;
  /// How every collision is spelt (spelling.hpp), from 0 to before spelling_count. Empty: in a way that follows from
  /// its bits and changes from call to call, so that what is asked again is asked in other words.
  std::optional<unsigned> spelling = {};
};

[[nodiscard]] inline ExecOptions exec_options(double timeout_seconds, std::stop_token stop) {
  ExecOptions options;
  options.limits.timeout =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(timeout_seconds));
  options.stop = std::move(stop);
  return options;
}

/// What stands before the words of a program in place of a subject's name.
inline constexpr std::string_view exec_prefix = "exec:";

/// A program that speaks the protocol, from its specification "exec:PROGRAM ARG…": the words are split and unquoted as
/// a POSIX shell would, and no shell is run. The program is started to ask what it is, which is also its first session,
/// and once for each further one. Where that goes wrong the subject still stands for it, under its specification as a
/// name, and `open` throws the reason. A session throws SessionFailure that names the request and the reason; it is
/// then of no further use. Precondition: the specification begins with exec_prefix.
[[nodiscard]] Subject exec_subject(const std::string& specification, const ExecOptions& options);

}  // namespace carom::subjects::protocol
