// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include <carom/collision/subject.hpp>

namespace carom::tool {

/// What the command line means by a SUBJECT: a name, or "exec:PROGRAM ARG…". A program that cannot be run still gives a
/// subject: opening it says why. A program is asked in that spelling, or in all of them in turn (ExecOptions). Throws
/// UsageError where there is no such name.
[[nodiscard]] Subject subject_from_argument(const std::string& argument, double timeout_seconds,
                                            const std::stop_token& stop,
                                            std::optional<unsigned> spelling = std::nullopt);

/// Whether the name is that of a subject that runs in this process: one that a file may name and have judged, where
/// every other is a program to start. Throws UsageError where it can be neither.
[[nodiscard]] bool runs_in_this_process(const std::string& argument);

}  // namespace carom::tool
