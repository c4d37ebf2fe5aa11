// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

/// Derives a possible fault of a subject from its violations.
namespace carom::properties::diagnosis {

/// The probable fault of a subject that violates something, as far as its answers show it. It is a hint, not a verdict.
/// No judgement depends on it.
struct Diagnosis {
  std::string telling;           // the violated invariant that explains most of the others
  std::uint64_t violated = 0;    // sampled cases in which any invariant is violated
  std::uint64_t telling_in = 0;  // the number of those cases in which `telling` is violated
  std::string what;              // the fault in the answers
  std::string look_at;           // the places in a solver to check; empty if no place is more likely than the others
  std::string where;             // the cases in which it happens
};

/// The diagnosis of a subject of the report. Precondition: `result.violated_invariants()` is not empty.
[[nodiscard]] Diagnosis diagnose(const SubjectResult& result, const GateReport& report);

/// The diagnosis of each subject of the report, in order. It is empty for a subject that violates nothing.
[[nodiscard]] std::vector<Diagnosis> diagnose_all(const GateReport& report);

}  // namespace carom::properties::diagnosis
