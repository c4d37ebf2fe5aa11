// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include <carom/properties/gate/trial.hpp>

/// Judges the same outcomes twice: with every filter, and in rational arithmetic alone.
namespace carom::equality {

/// Counts the rational judge's verdicts on one invariant.
struct Outcomes {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;
};

struct Agreement {
  std::uint64_t cases = 0;
  std::map<std::string, Outcomes> invariants;
  std::string differences;  // in words, a line each, with the case
};

struct Examined {
  explicit Examined(Subject of) : subject(std::move(of)), session(subject.open()) {}

  Subject subject;
  Session session;
};

/// Asks each subject once for its answers to the case and to the related collisions. Both judges judge these answers,
/// and each judge computes the facts of the case by itself. In one of three comparisons, the yardstick is a number of
/// digits instead of ulps. `origin` names the case in a reported difference.
void compare_judges(const properties::Case& one, std::span<Examined> subjects, properties::RelationTurn relations,
                    const std::string& origin, Agreement& agreement);

}  // namespace carom::equality
