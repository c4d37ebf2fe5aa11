// SPDX-License-Identifier: BSL-1.0
#include "io/arguments.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/report/results/domain_json.hpp>
#include <carom/report/results/words.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "io/json_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

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
