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

/// The same outcomes judged twice, with every filter and in rational numbers alone.
namespace carom::equality {

/// How often one invariant came out how, by the rational judge.
struct Outcomes {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;
  std::uint64_t skipped = 0;
};

/// What came of comparing.
struct Agreement {
  std::uint64_t cases = 0;
  std::uint64_t judgements = 0;  // of one subject's outcome of one case
  std::uint64_t verdicts = 0;    // of one invariant each
  std::map<std::string, Outcomes> invariants;
  std::vector<std::string> differences;  // in words, each with the case
  std::chrono::nanoseconds filtered{};   // spent on judging, the subject left out
  std::chrono::nanoseconds rational{};

  Agreement& operator+=(const Agreement& other);
};

/// Whether relations are judged as well.
enum class Relations { left_out, judged };

/// A subject and its session.
struct Examined {
  explicit Examined(Subject of) : subject(std::move(of)), session(subject.open()) {}

  Subject subject;
  Session session;
};

/// Puts the case to each subject once, with all further questions, and judges the answers by both judges, each with
/// what it knows of the case worked out by itself; one time in three by a number of digits in place of ulps. `origin`
/// says in a difference where the case is from.
void compare_judges(const properties::Case& one, std::span<Examined> subjects, Relations relations,
                    const std::string& origin, Agreement& agreement);

}  // namespace carom::equality
