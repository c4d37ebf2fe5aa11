// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <carom/properties/gate/gate_report.hpp>

/// From the violations of a subject to what may be wrong with it.
namespace carom::properties::diagnosis {

/// What a subject that violates something does wrong, as far as its answers tell. A hint, not a verdict: nothing that
/// is judged depends on it.
struct Diagnosis {
  std::string telling;           // the violated invariant that explains most of the others
  std::uint64_t violated = 0;    // sampled cases in which anything is violated
  std::uint64_t telling_in = 0;  // of them, those in which this invariant is
  std::string what;              // what is wrong with the answers
  std::string look_at;           // where in a solver that is done; empty where no one place is likelier than others
  std::string where;             // in which cases
};

/// Of a subject of the report that violates something.
[[nodiscard]] Diagnosis diagnose(const SubjectResult& result, const GateReport& report);

/// Of each subject of the report, in their order; nothing in it where the subject violates nothing.
[[nodiscard]] std::vector<Diagnosis> diagnose_all(const GateReport& report);

}  // namespace carom::properties::diagnosis
