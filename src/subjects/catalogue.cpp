// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/engines.hpp>

namespace carom::subjects {
namespace {

void append(std::vector<Subject>& to, const std::vector<Subject>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

std::vector<Subject> linked_engines() {
  std::vector<Subject> engines = bullet_subjects();
  append(engines, ode_subjects());
  return engines;
}

}  // namespace

std::vector<Subject> all_subjects() {
  std::vector<Subject> all = built_in_subjects();
  append(all, linked_engines());
  return all;
}

std::vector<Subject> default_subjects() {
  std::vector<std::string> names{"coulomb-double", "reflection-in-basis-double"};
  for (const Law law : laws_with_truth) {
    names.push_back(std::string(name_of(law)) + "-double");
  }
  std::vector<Subject> subjects = built_in_subjects();
  std::erase_if(subjects, [&](const Subject& subject) { return std::ranges::count(names, subject.name) == 0; });
  append(subjects, linked_engines());
  return subjects;
}

std::vector<Subject> engine_subjects(const protocol::ExecOptions& options) {
  std::vector<Subject> engines = linked_engines();
  for (const Subject& claim : protocol_engines()) {
    engines.push_back(started(claim, options));
  }
  return engines;
}

std::vector<Subject> known_subjects() {
  std::vector<Subject> known = all_subjects();
  append(known, protocol_engines());
  return known;
}

std::optional<Subject> subject_named(std::string_view name, const protocol::ExecOptions& options) {
  const std::vector<Subject> known = known_subjects();
  const auto found = std::find_if(known.begin(), known.end(), [&](const Subject& s) { return s.name == name; });
  return found == known.end() ? std::nullopt : std::optional<Subject>(started(*found, options));
}

}  // namespace carom::subjects
