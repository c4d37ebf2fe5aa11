// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <span>

#include <carom/collision/validate.hpp>
#include <carom/subjects/catalogue.hpp>

#include "examinee.hpp"

namespace carom::properties {
namespace {

Stream stream_of(const Collision& collision) {
  std::uint64_t seed = 0;
  for_each_number(
      [&](const FieldPath&, const double& x) { seed = seed * 0x100000001b3U ^ std::bit_cast<std::uint64_t>(x); },
      collision);
  return stream_from(seed);
}

}  // namespace

std::vector<Examinee> built_in_examinees() {
  std::vector<Examinee> examinees;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (!subject.expected_to_pass) {
      continue;
    }
    Examinee examinee;
    examinee.name = subject.name;
    std::replace(examinee.name.begin(), examinee.name.end(), '-', '_');
    examinee.law = subject.law;
    examinee.yardstick = oracles::Yardstick::of(subject.precision);
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

Examinee erratic(Examinee examinee) {
  examinee.solve = [shows_matrix = examinee.shows_matrix](const Collision& collision) -> ExactAnswer {
    Stream stream = stream_of(collision);
    const auto by_chance = [&](double) { return static_cast<long double>(stream.between(-4, 4)); };
    ReportedOutcome outcome = map_outcome<long double>(unchanged(collision), by_chance);
    if (shows_matrix && validate(collision).empty()) {
      const long double factor = stream.chance(2) ? 20 : -1;
      outcome.collision_matrix = oracles::ExactCase(collision).collision_matrix().unaryExpr(
          [&](const oracles::Rational& x) { return factor * static_cast<long double>(oracles::to_double(x)); });
    }
    return oracles::LiftedOutcome(outcome);
  };
  return examinee;
}

Examinee without_numbers(Examinee examinee) {
  examinee.name += "_without_numbers";
  examinee.solve = [](const Collision&) -> ExactAnswer { return NotFinite{}; };
  return examinee;
}

}  // namespace carom::properties
