// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <span>

#include <carom/collision/validate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "examinee.hpp"

namespace carom::properties {

std::vector<Examinee> built_in_examinees() {
  std::vector<Examinee> examinees;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (!subject.expected_to_pass) {
      continue;
    }
    Examinee examinee;
    examinee.name = subject.name;
    std::replace(examinee.name.begin(), examinee.name.end(), '-', '_');
    examinee.model = subject.model;
    examinee.yardstick.unit_roundoff = unit_roundoff(subject.precision);
    examinee.solve = [session = std::make_shared<Session>(subject.open())](const Collision& collision) {
      return lift((*session)(std::span(&collision, 1)).at(0));
    };
    examinee.shows_matrix = subject.shows_collision_matrix;
    examinees.push_back(std::move(examinee));
  }
  return examinees;
}

Examinee idle(Examinee examinee) {
  examinee.solve = [](const Collision& collision) -> ExactAnswer {
    if (!validate(collision).empty()) {
      return Refused{"invalid"};
    }
    return oracles::LiftedOutcome(
        map_outcome<long double>(unchanged(collision), [](double x) { return static_cast<long double>(x); }));
  };
  return examinee;
}

}  // namespace carom::properties
