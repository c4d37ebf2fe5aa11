// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// One condition on a case, in words.
struct Condition {
  std::string words;        // "for A or B the orientation is exactly 1, 0, 0, 0"
  std::string usual_cause;  // of violations that meet it, as a place in a solver to check; empty if none is known
};

/// The conditions that the violated cases meet and the other cases do not.
struct Where {
  std::string of;  // the kind of nearly all violated cases, such as "contacts that approach"; empty: cases of all kinds
  std::vector<Condition> conditions;  // all hold together; empty if no feature separates the violated cases from the
                                      // others
  std::uint64_t violated = 0;         // sampled cases in which something is violated
  std::uint64_t violated_there = 0;   // the number of those cases in which the conditions hold
  std::uint64_t cases_there = 0;      // sampled cases in which the conditions hold, violated or not
};

/// The violated cases of a run. For each family, `violated` has the numbers of its violated sampled cases, ascending.
/// `judged` has the number of its judged sampled cases, which are the first ones.
struct Violations {
  std::vector<std::vector<std::uint64_t>> violated;
  std::vector<std::uint64_t> judged;
};

/// Finds a few conditions that nearly all violated cases meet and as few other cases as possible. The conditions are
/// features, their absence, sizes, the approach of the contact, and the family.
[[nodiscard]] Where where_violated(const GateReport& report, const Violations& violations);

/// The result in one sentence. Empty if there are fewer than `least_violated` violated cases (evidence.hpp).
[[nodiscard]] std::string in_words(const Where& where);

}  // namespace carom::properties::diagnosis
