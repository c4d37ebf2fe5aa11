// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/subject.hpp>

namespace carom::tool {

/// The subject for a SUBJECT of the command line: a name, or "exec:PROGRAM ARG…". Opening the subject of a program that
/// cannot be run throws the reason. `spelling` is the JSON spelling of requests to a program; if it is empty,
/// ExecOptions chooses. Throws UsageError if there is no subject with this name.
[[nodiscard]] Subject subject_from_argument(const std::string& argument, double timeout_seconds,
                                            const std::stop_token& stop,
                                            std::optional<unsigned> spelling = std::nullopt);

/// Whether the argument names a subject that runs in this process. Any other subject is a program, which a file may not
/// start. Throws UsageError if the argument names no subject.
[[nodiscard]] bool runs_in_this_process(const std::string& argument);

}  // namespace carom::tool
