// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <carom/properties/trial/trial.hpp>

/// Judges the same outcomes twice: with every filter, and in rational arithmetic alone.
namespace carom::equality {

/// The numbers of the rational judge's verdicts on one invariant.
struct Outcomes {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;
  std::uint64_t skipped = 0;
};

struct Agreement {
  std::uint64_t cases = 0;
  std::uint64_t judgements = 0;  // one for each subject's outcome of one case
  std::uint64_t verdicts = 0;    // one for each invariant of a judgement
  std::map<std::string, Outcomes> invariants;
  std::vector<std::string> differences;  // in words, each with the case
  std::chrono::nanoseconds filtered{};   // time of judging, without the subject
  std::chrono::nanoseconds rational{};

  Agreement& operator+=(const Agreement& other);
};

/// Whether relations (invariants that compare answers to related collisions) are judged, too.
enum class Relations { left_out, judged };

struct Examined {
  explicit Examined(Subject of) : subject(std::move(of)), session(subject.open()) {}

  Subject subject;
  Session session;
};

/// Asks each subject once for its answers to the case and to the related collisions. Both judges judge these answers,
/// and each judge computes the facts of the case by itself. In one of three comparisons, the yardstick is a number of
/// digits instead of ulps. `origin` names the case in a reported difference.
void compare_judges(const properties::Case& one, std::span<Examined> subjects, Relations relations,
                    const std::string& origin, Agreement& agreement);

}  // namespace carom::equality
