// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <carom/oracles/judge/yardstick.hpp>
#include <carom/properties/cases/domain.hpp>

/// Options that several commands share.
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

}  // namespace carom::tool
