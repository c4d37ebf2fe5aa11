// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// One condition on a case, in words.
struct Condition {
  std::string words;  // "A or B: the orientation is exactly 1, 0, 0, 0"
};

/// What the violated cases have in common, and others have not.
struct Where {
  std::string of;  // "contacts that approach": what nearly all violated ones are; empty: of all kinds
  std::vector<Condition> conditions;  // all hold; none where nothing tells them apart
  std::uint64_t violated = 0;         // sampled cases in which something is violated
  std::uint64_t violated_there = 0;   // of them, those in which the conditions hold
  std::uint64_t cases_there = 0;      // sampled cases in which they hold, violated or not
};

/// Of each family of a run, the numbers of the violated ones among its sampled cases, ascending, and before which
/// number cases were judged.
struct Violations {
  std::vector<std::vector<std::uint64_t>> violated;
  std::vector<std::uint64_t> judged;
};

/// Looks for few conditions that nearly all violated cases fulfil and as few others as can be: features, their absence,
/// sizes, how the contact approaches, the family.
[[nodiscard]] Where where_violated(const GateReport& report, const Violations& violations);

/// In one sentence.
[[nodiscard]] std::string in_words(const Where& where);

}  // namespace carom::properties::diagnosis
