// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/cases/domain.hpp>

/// Subjects, domains and deviations from the command line.
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

/// The domain that the command line's `option` names: a text of `properties::domain_from`, or a JSON file of ranges.
/// Throws UsageError.
[[nodiscard]] properties::Domain domain_from_argument(const std::string& option, const std::string& text);

/// The domain that the subjects declare. A subject that declares none is meant for everything. Throws UsageError if two
/// subjects differ, or if a domain is not valid.
[[nodiscard]] properties::Domain declared_domain(const std::vector<Subject>& subjects);

/// The texts of `--deviates`, "INVARIANT" or "INVARIANT@FAMILY", each once. Throws UsageError if one is no deviation.
[[nodiscard]] std::vector<std::string> known_deviations(const std::vector<std::string>& texts);

/// Adds these deviations (unclaimed invariants) to those of the subject.
void let_deviate(Subject& subject, const std::vector<std::string>& deviates);

}  // namespace carom::tool
