// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/properties/gate/gate.hpp>

namespace carom::properties {

/// What the case adds to what its family turned out to hold.
[[nodiscard]] Coverage coverage_of(const JudgedCase& judged_case);

/// What one thread found of one subject. It does not grow with the number of cases.
struct Tally {
  std::string error;  // why the subject was judged no further; empty where it was
  std::vector<FamilyResult> families;
  Histogram<DigitsScale> digits;
  Histogram<TimeScale> nanoseconds_per_solve;  // of each task
  std::vector<std::vector<Count>> counts;      // of each family and invariant of the catalogue, until they are named

  /// Adds what was found on one case of a family.
  void add(std::size_t family, std::uint64_t index, const JudgedCase& judged_case, const Answer& answer,
           const Judgement& judgement, const Claim& claim);

  /// Adds one verdict that came apart from the others of its case.
  void add(std::size_t family, std::uint64_t index, const Case& one, const Answer& answer, const NamedVerdict& named);

  /// Adds the counts to those of the families, by name. To be called before the families' counts are read.
  void name_counts();

  Tally& operator+=(const Tally& other);
};

}  // namespace carom::properties
