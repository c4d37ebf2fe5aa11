// SPDX-License-Identifier: BSL-1.0
#include "io/subject_argument.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/trial/nearest_name.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/exec.hpp>

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

}  // namespace carom::tool
