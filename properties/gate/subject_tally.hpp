// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/properties/gate/gate.hpp>

namespace carom::properties {

[[nodiscard]] Coverage coverage_of(const JudgedCase& judged_case);

/// The findings of one thread on one subject.
struct SubjectTally {
  std::string error;  // why the subject was not judged to the end; empty if it was
  std::vector<FamilyResult> families;
  Histogram<DigitsScale> digits;
  Histogram<TimeScale> nanoseconds_per_solve;  // one number per task

  void add(std::size_t family, std::uint64_t index, const JudgedCase& judged_case, const Answer& answer,
           const Judgement& judgement, const Claim& claim);

  /// Adds one verdict that is reached separately from the other verdicts of its case.
  void add(std::size_t family, std::uint64_t index, const Case& one, const Answer& answer, const NamedVerdict& named);

  SubjectTally& operator+=(const SubjectTally& other);
};

}  // namespace carom::properties
