// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <carom/collision/subject.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/cases/domain.hpp>

/// Options that several commands share, and the subjects, domains and deviations that they name.
namespace carom::tool {

/// The options of the yardstick, the amount of rounding that is allowed.
struct LimitArguments {
  double limit_ulps = 32;
  std::optional<int> digits;
  bool exact = false;  // whether to judge in ℚ alone, without the filters

  [[nodiscard]] oracles::Limits limits() const;
};

void add_accuracy(CLI::App& command, double& limit_ulps, std::optional<int>& digits, const std::string& of_limit,
                  const std::string& of_digits);
void add_limits(CLI::App& command, LimitArguments& arguments);

/// Adds the option for the seconds that a program may take for each reply.
void add_timeout(CLI::App& command, double& seconds);
void add_format(CLI::App& command, std::string& format, std::vector<std::string> formats);
/// Adds an option that takes a domain: its name, a JSON file, or ranges.
CLI::Option* add_domain_option(CLI::App& command, const char* name, std::optional<properties::Domain>& domain,
                               const std::string& what);
/// Adds `--within`.
CLI::Option* add_within(CLI::App& command, std::optional<properties::Domain>& domain);
/// Adds `--deviates`. `effect` is a sentence about the result.
void add_deviates(CLI::App& command, std::vector<std::string>& deviates, const std::string& effect);
void add_seed(CLI::App& command, std::uint64_t& seed, const std::string& what);
void add_jobs(CLI::App& command, unsigned& jobs, const std::string& what);

/// The error message if the text is not an unsigned integer of 64 bits; empty if it is one. CLI11 itself wraps larger
/// and negative numbers.
[[nodiscard]] std::string is_count(const std::string& text);

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
