// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// The probable fault of a subject: a hint on which no judgement depends.
struct Diagnosis {
  std::string telling;           // the violated invariant that explains most of the others
  std::uint64_t violated = 0;    // sampled cases in which any invariant is violated
  std::uint64_t telling_in = 0;  // the number of those cases that violate `telling`
  std::string what;              // the fault in the answers
  std::string look_at;           // the places in a solver to check; empty if no place is likelier
  std::string where;             // the cases in which it happens
};

/// Precondition: `result.violated_invariants()` is not empty.
[[nodiscard]] Diagnosis diagnose(const SubjectResult& result, const GateReport& report);

/// The diagnoses of the report's subjects, in order. Empty for a subject that violates nothing.
[[nodiscard]] std::vector<Diagnosis> diagnose_all(const GateReport& report);

}  // namespace carom::properties::diagnosis
