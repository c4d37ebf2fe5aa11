// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// The number of violated cases that a hint needs. If at most half of all violated cases have a property, five random
/// ones all have it with a probability of at most 2⁻⁵ < 1/20. For four, the bound is 1/16.
inline constexpr std::uint64_t least_violated = 5;

struct Condition {
  std::string words;        // "for A or B the orientation is exactly 1, 0, 0, 0"
  std::string usual_cause;  // of such violations, as a place in a solver to check; empty if none is known
};

/// The conditions that nearly all violated cases meet, and few others.
struct Where {
  std::string of;  // the kind of nearly all violated cases, such as "contacts that approach"; empty: all kinds
  std::vector<Condition> conditions;  // all hold together; empty if no feature separates the violated cases
  std::uint64_t violated = 0;         // sampled cases in which something is violated
  std::uint64_t violated_there = 0;   // the number of those cases that meet the conditions
  std::uint64_t cases_there = 0;      // sampled cases that meet the conditions, violated or not
};

/// The violated cases of a run, or those of one fault. For each family, `violated` lists the numbers of violated
/// sampled cases, ascending. `judged` counts the judged sampled cases, the first of each family's sample. `left_out`
/// lists the numbers of cases that do not count, because it is not known whether they belong to the violated ones.
struct Violations {
  std::vector<std::vector<std::uint64_t>> violated;
  std::vector<std::uint64_t> judged;
  std::vector<std::vector<std::uint64_t>> left_out = {};
  std::uint64_t every = 1;
};

/// Whether a case is one of about one in `every` that are examined. Neighbours of a case are as likely as others.
[[nodiscard]] bool is_examined(std::uint64_t index, std::uint64_t every);

/// Finds a few conditions that nearly all violated cases meet, and as few others as possible. A condition is a feature
/// or its absence, a size, the approach of the contact, or the family. If a condition is no size, at least two thirds
/// of the cases that meet all conditions are violated.
[[nodiscard]] Where where_violated(const GateReport& report, const Violations& violations);

/// The result in one sentence. Empty if there are fewer than `least_violated` violated cases.
[[nodiscard]] std::string in_words(const Where& where);

}  // namespace carom::properties::diagnosis
