// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>

/// Subjects that are made from others, and the options of a gate that judges them.
namespace carom::unit {

/// The options of a gate on these families, or on all if none is named.
[[nodiscard]] inline properties::GateOptions gate_options(std::uint64_t cases,
                                                          const std::vector<std::string_view>& families = {}) {
  properties::GateOptions options;
  options.cases = cases;
  for (const std::string_view family : families) {
    options.families.push_back(properties::family_named(family));
  }
  if (families.empty()) {
    options.families = properties::pointers_to(properties::all_families());
  }
  return options;
}

/// Precondition: the catalogue has a subject of this name.
[[nodiscard]] inline Subject subject_of(const std::string& name) { return subjects::subject_named(name).value(); }

/// The subject with `change(collisions, answers)` called on the answers of each call. Each session has a copy of
/// `change`.
template <class Change>
[[nodiscard]] Subject with_answers(Subject subject, Change change) {
  subject.open = [open = subject.open, change] {
    return Session([session = open(), change](std::span<const Collision> collisions) mutable {
      std::vector<Answer> answers = session(collisions);
      change(collisions, answers);
      return answers;
    });
  };
  return subject;
}

/// The subject with `change(collision, outcome)` called on each outcome.
template <class Change>
[[nodiscard]] Subject with_outcomes(Subject subject, Change change) {
  return with_answers(std::move(subject),
                      [change](std::span<const Collision> collisions, std::vector<Answer>& answers) mutable {
                        for (std::size_t i = 0; i < answers.size(); ++i) {
                          if (auto* outcome = std::get_if<ReportedOutcome>(&answers[i])) {
                            change(collisions[i], *outcome);
                          }
                        }
                      });
}

/// The subject that answers each collision as `change(collision)` leaves it.
template <class Change>
[[nodiscard]] Subject misreading(Subject subject, Change change) {
  subject.open = [open = subject.open, change] {
    return Session([session = open(), change](std::span<const Collision> collisions) mutable {
      std::vector<Collision> read(collisions.begin(), collisions.end());
      for (Collision& collision : read) {
        change(collision);
      }
      return session(read);
    });
  };
  return subject;
}

/// The subject, which claims no invariant but this one.
[[nodiscard]] inline Subject claiming_only(std::string_view invariant, Subject subject) {
  for (const properties::Invariant& other : properties::all_invariants()) {
    if (other.name != invariant) {
      subject.deviates.emplace_back(other.name);
    }
  }
  return subject;
}

/// A subject that leaves all bodies as they are.
[[nodiscard]] inline Subject idle_subject() {
  return with_outcomes(subject_of("frictionless-double"), [](const Collision& collision, ReportedOutcome& outcome) {
    outcome = reported(unchanged(collision));
  });
}

}  // namespace carom::unit
