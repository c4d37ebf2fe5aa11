// SPDX-License-Identifier: BSL-1.0
#include "commands/options.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/words.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

// Limits of --limit [ulps]. Below the smallest, rounding alone violates the limit. Above the largest, no digit counts.
constexpr double smallest_limit = 1e-3;
constexpr double largest_limit = 1e15;
constexpr double shortest_timeout = 1e-3;  // [s]
constexpr double longest_timeout = 86400;  // [s]

bool is_named_in(const std::vector<Subject>& subjects, const std::string& name) {
  return std::any_of(subjects.begin(), subjects.end(), [&](const Subject& subject) { return subject.name == name; });
}

[[noreturn]] void fail_unknown(const std::string& argument) {
  std::vector<std::string> known;
  for (const Subject& subject : subjects::known_subjects()) {
    known.push_back(subject.name);
  }
  throw UsageError(
      fmt::format("there is no subject '{}'; `carom subjects` lists the subjects, and exec:PROGRAM selects a program{}",
                  carom::printable_line(argument, 4000), properties::did_you_mean(argument, known)));
}

properties::Domain domain_from_file(const std::string& option, const std::string& file) {
  try {
    const nlohmann::json record = parse_json(content_of_file(file));
    return report::Json<properties::Domain>::read(report::Field(record));
  } catch (const FormatError& error) {
    throw UsageError(report::shown(fmt::format("{}: {}: {}", option, file, error.what())));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}, or choose games, robotics, granular or everything", option, error.what()));
  }
}

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(text);
  }
}

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
      "Draw every case into this domain: games, robotics, granular, everything, a JSON file, or ranges and kinds such "
      "as size=0.1:10,bodies=spheres,movable=both,walls=resting,plane=xy, also together: games,plane=xy (default: the "
      "domain that a program declares, otherwise everything)");
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

Subject subject_from_argument(const std::string& argument, double timeout_seconds, const std::stop_token& stop,
                              std::optional<unsigned> spelling) {
  subjects::protocol::ExecOptions options = subjects::protocol::exec_options(timeout_seconds, stop);
  options.spelling = spelling;
  if (argument.starts_with(subjects::protocol::exec_prefix)) {
    return subjects::protocol::exec_subject(argument, options);
  }
  if (std::optional<Subject> subject = subjects::subject_named(argument, options)) {
    return *subject;
  }
  fail_unknown(argument);
}

bool runs_in_this_process(const std::string& argument) {
  if (is_named_in(subjects::all_subjects(), argument)) {
    return true;
  }
  if (argument.starts_with(subjects::protocol::exec_prefix) || is_named_in(subjects::known_subjects(), argument)) {
    return false;
  }
  fail_unknown(argument);
}

properties::Domain domain_from_argument(const std::string& option, const std::string& text) {
  if (!properties::domain_named(text) && text.find('=') == std::string::npos && !text.starts_with('{')) {
    return domain_from_file(option, text);
  }
  try {
    return properties::domain_from(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(report::shown(option + ": " + error.what()));
  }
}

properties::Domain declared_domain(const std::vector<Subject>& subjects) {
  const Subject* first = nullptr;
  properties::Domain declared;
  for (const Subject& subject : subjects) {
    try {
      const properties::Domain domain = properties::domain_from(subject.domain);
      if (first != nullptr && domain != declared) {
        throw UsageError(report::shown(fmt::format(
            "{} declares the domain {}, and {} declares {}; judge them one at a time, or choose a domain by --within",
            first->name, to_text(declared), subject.name, to_text(domain))));
      }
      declared = domain;
      first = &subject;
    } catch (const std::invalid_argument& error) {
      throw UsageError(
          report::shown(fmt::format("{}: the domain in the reply to start: {}", subject.name, error.what())));
    }
  }
  return declared;
}

std::vector<std::string> known_deviations(const std::vector<std::string>& texts) {
  std::vector<std::string> deviates;
  for (const std::string& text : texts) {
    try {
      (void)properties::deviation_from(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError(report::shown(std::string("--deviates: ") + error.what()));
    }
    add_once(deviates, text);
  }
  return deviates;
}

void let_deviate(Subject& subject, const std::vector<std::string>& deviates) {
  for (const std::string& text : deviates) {
    add_once(subject.deviates, text);
  }
}

}  // namespace carom::tool
