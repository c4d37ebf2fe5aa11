// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/subject.hpp>

namespace carom::tool {

/// The subject for a SUBJECT of the command line: a name, or "exec:PROGRAM ARG…". A program that cannot be run is a
/// subject too, and opening it throws the reason. `spelling` is the JSON spelling of requests to a program; if it is
/// empty, ExecOptions chooses. Throws UsageError if there is no subject with this name.
[[nodiscard]] Subject subject_from_argument(const std::string& argument, double timeout_seconds,
                                            const std::stop_token& stop,
                                            std::optional<unsigned> spelling = std::nullopt);

/// Whether the argument names a subject that runs in this process. A file may only choose such subjects, because every
/// other subject is a program to start. Throws UsageError if the argument is neither.
[[nodiscard]] bool runs_in_this_process(const std::string& argument);

}  // namespace carom::tool
