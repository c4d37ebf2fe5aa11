// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/subject_argument.hpp"

#include <optional>

#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "commands/commands.hpp"

namespace carom::tool {

Subject subject_from_argument(const std::string& argument, double timeout_seconds, const std::stop_token& stop) {
  const subjects::protocol::ExecOptions options = subjects::protocol::exec_options(timeout_seconds, stop);
  if (argument.starts_with(subjects::protocol::exec_prefix)) {
    return subjects::protocol::exec_subject(argument, options);
  }
  if (std::optional<Subject> subject = subjects::subject_named(argument, options)) {
    return *subject;
  }
  throw UsageError(
      fmt::format("there is no subject '{}'; `carom subjects` lists them, and exec:PROGRAM names a program", argument));
}

}  // namespace carom::tool
