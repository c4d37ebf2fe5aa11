// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/gate/gate_report.hpp>

namespace carom::properties::diagnosis {

/// The probable faults of a subject: hints on which no judgement depends.
struct Diagnosis {
  const Invariant* telling = nullptr;  // the violated invariant that explains most of the others
  std::uint64_t violated = 0;          // sampled cases in which any invariant is violated
  std::uint64_t telling_in = 0;        // the number of those cases that violate `telling`
  std::vector<Fault> faults;           // at least one, unless `missing` is set
  std::string missing = {};            // the failure of the diagnosis; empty if there is a diagnosis
};

/// Precondition: `result.violated_invariants()` is not empty.
[[nodiscard]] Diagnosis diagnose(const SubjectResult& result, const GateReport& report);

/// The diagnoses of the report's subjects, in order. A diagnosis is empty if the subject violates nothing, or if the
/// options do not explain it. If a diagnosis fails, it has only `missing`.
[[nodiscard]] std::vector<Diagnosis> diagnose_all(const GateReport& report);

}  // namespace carom::properties::diagnosis
