// SPDX-License-Identifier: BSL-1.0
#include "commands/options.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include <fmt/format.h>

#include "io/arguments.hpp"

namespace carom::tool {
namespace {

// Limits of --limit [ulps]. Below the smallest, rounding alone violates the limit. Above the largest, no digit counts.
constexpr double smallest_limit = 1e-3;
constexpr double largest_limit = 1e15;
constexpr double shortest_timeout = 1e-3;  // [s]
constexpr double longest_timeout = 86400;  // [s]

}  // namespace

std::string is_count(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  return error == std::errc() && end == text.data() + text.size() ? std::string()
                                                                  : "expected an integer from 0 to 2^64 - 1";
}

oracles::Limits LimitArguments::limits() const { return {limit_ulps, digits, !exact}; }

void add_accuracy(CLI::App& command, double& limit, std::optional<int>& digits, const std::string& of_limit,
                  const std::string& of_digits) {
  limit = oracles::default_limit_ulps;
  CLI::Option* limit_ulps = command.add_option("--limit-ulps", limit, of_limit);
  limit_ulps
      ->check([](const std::string& text) {
        // CLI::Range lets NaN pass.
        const double ulps = std::strtod(text.c_str(), nullptr);
        return ulps >= smallest_limit && ulps <= largest_limit
                   ? std::string()
                   : fmt::format("expected a number from {} to {}", smallest_limit, largest_limit);
      })
      ->capture_default_str();
  command.add_option("--digits", digits, of_digits)->check(CLI::Range(1, 18))->excludes(limit_ulps);
}

void add_limits(CLI::App& command, LimitArguments& arguments) {
  add_accuracy(command, arguments.limit_ulps, arguments.digits, "Largest permitted backward error, in ulps",
               "N permits a relative error of 10^-N, in place of --limit-ulps");
  command.add_flag("--exact", arguments.exact,
                   "Judge only in exact arithmetic, without the faster filters. The verdicts are the same");
}

void add_timeout(CLI::App& command, double& timeout) {
  command.add_option("--timeout", timeout, "Time limit for each reply of an exec: subject, in seconds")
      ->check([](const std::string& text) {
        const double seconds = std::strtod(text.c_str(), nullptr);
        return seconds >= shortest_timeout && seconds <= longest_timeout
                   ? std::string()
                   : fmt::format("expected a number from {} to {}", shortest_timeout, longest_timeout);
      })
      ->capture_default_str();
}

void add_format(CLI::App& command, std::string& format, std::vector<std::string> formats) {
  command.add_option("--format", format, "Format of the output")
      ->check(CLI::IsMember(std::move(formats)))
      ->capture_default_str();
}

CLI::Option* add_domain_option(CLI::App& command, const char* name, std::optional<properties::Domain>& domain,
                               const std::string& what) {
  return command
      .add_option_function<std::string>(
          name, [&domain, name](const std::string& text) { domain = domain_from_argument(name, text); }, what)
      ->type_name("DOMAIN");
}

CLI::Option* add_within(CLI::App& command, std::optional<properties::Domain>& domain) {
  return add_domain_option(
      command, "--within", domain,
      "Draw every case into this domain: games, robotics, granular, everything, a JSON file of ranges, or ranges such "
      "as size=0.1:10,mass_ratio=:100 (default: the domain that a program declares, otherwise everything)");
}

void add_deviates(CLI::App& command, std::vector<std::string>& deviates, const std::string& effect) {
  command
      .add_option("--deviates", deviates,
                  "Invariants that are not judged in this run, separated by commas: INVARIANT, or INVARIANT@FAMILY for "
                  "one family. " +
                      effect)
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_seed(CLI::App& command, std::uint64_t& seed, const std::string& what) {
  command.add_option("--seed", seed, what)->check(is_count)->capture_default_str();
}

void add_jobs(CLI::App& command, unsigned& jobs, const std::string& what) {
  constexpr int most = 1024;
  command.add_option("--jobs", jobs, what + " (default: the number of cores)")->check(CLI::Range(1, most));
}

}  // namespace carom::tool
