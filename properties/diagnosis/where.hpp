// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// The number of violated cases that a hint needs. If at most half of all violated cases have a property, five random
/// ones all have it with a probability of at most 2⁻⁵ < 1/20. For four, the bound is 1/16.
inline constexpr std::uint64_t least_violated = 5;

struct Share {
  std::uint64_t violated = 0;  // sampled cases
  std::uint64_t cases = 0;     // sampled cases, violated or not
};

/// The words of a condition that a special statement nearly holds begin so.
inline constexpr std::string_view nearly_holds = "if it nearly holds, within ";

struct Condition {
  std::string words;        // "if A or B is immovable", "unless ε = 0"
  std::string usual_cause;  // of such violations, as a place in a solver to check; empty if none is known
  Share there = {};         // of the cases that meet this condition
};

/// The conditions that nearly all violated cases meet, and few others.
struct Where {
  std::string of;  // the kind of nearly all violated cases, such as "colliding contacts"; empty: all kinds
  /// All hold together, and the first one separates most. Empty if nothing separates the violated cases.
  std::vector<Condition> conditions;
  std::uint64_t violated = 0;  // sampled cases in which something is violated
  Share all;                   // of the kind
  Share there;                 // of the kind, where all conditions hold
};

/// The judged sampled cases of a family: the first ones of its sample, without those that the subject skipped.
struct JudgedSample {
  std::uint64_t first = 0;
  std::vector<std::uint64_t> skipped = {};  // ascending

  [[nodiscard]] bool has(std::uint64_t index) const {
    return index < first && !std::binary_search(skipped.begin(), skipped.end(), index);
  }
};

/// The violated cases of a run, or those of one fault. For each family, `violated` lists the numbers of violated
/// sampled cases, ascending. `left_out` lists the numbers of cases that do not count, because it is not known whether
/// they belong to the violated ones.
struct Violations {
  std::vector<std::vector<std::uint64_t>> violated;
  std::vector<JudgedSample> judged;
  std::vector<std::vector<std::uint64_t>> left_out = {};
  std::uint64_t every = 1;
};

/// Whether a case is one of about one in `every` that are examined. Neighbours of a case are as likely as others.
[[nodiscard]] bool is_examined(std::uint64_t index, std::uint64_t every);

/// Finds a few conditions that nearly all violated cases meet, and as few others as possible. A condition is a feature
/// or its absence, a size, the approach of the contact, or the family. If a condition is no size, at least two thirds
/// of the cases that meet all conditions are violated.
[[nodiscard]] Where where_violated(const GateReport& report, const Violations& violations);

/// The condition that tells most. An exception ("unless") tells less, because it may only hide the fault. Null if no
/// condition tells anything.
[[nodiscard]] const Condition* told_condition(const Where& where);

/// The told condition and the shares that it separates, as a clause that follows the fault: "if the speed of approach
/// is at most 0.5 m/s (93 % of such colliding contacts fail, else 0 %)". Empty if there are fewer than `least_violated`
/// violated cases.
[[nodiscard]] std::string in_words(const Where& where);

/// A fault (`Fault::what`) and the clause that says where it happens (`Fault::where`), as one sentence if it can be
/// one.
[[nodiscard]] std::string in_one_sentence(const std::string& what, const std::string& where);

}  // namespace carom::properties::diagnosis
