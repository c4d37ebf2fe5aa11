// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/engines/engines.hpp>

namespace carom::subjects {

std::vector<Subject> all_subjects() {
  std::vector<Subject> all = built_in_subjects();
  for (const auto& engine : {bullet_subjects(), ode_subjects()}) {
    all.insert(all.end(), engine.begin(), engine.end());
  }
  return all;
}

std::optional<Subject> subject_named(std::string_view name) {
  for (const Subject& subject : all_subjects()) {
    if (subject.name == name) {
      return subject;
    }
  }
  return std::nullopt;
}

}  // namespace carom::subjects
