// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <carom/properties/gate/boundary.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

struct Count {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;
  std::uint64_t skipped = 0;

  Count& operator+=(const Count& other);
};

/// The case of a family with the most serious violation of an invariant; the first one if several are equally serious.
struct WorstViolation {
  std::uint64_t index;
  Case original;
  Verdict verdict;
  Answer answer;
};

/// A case whose answer violated an invariant, and the answer.
struct ViolatedCase {
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// At most this many violated cases of a family are kept, the first ones.
inline constexpr std::size_t most_violated_kept = 12;

/// The results of a subject on a family. The size of the object does not grow with the number of cases.
struct FamilyResult {
  std::uint64_t cases = 0;
  std::uint64_t skipped = 0;                    // cases that the subject could not take
  UnjudgedCounts unjudged{};                    // valid cases that are not judged, by reason
  std::uint64_t violated = 0;                   // cases with a violation of any invariant
  double worst_backward_error = 0;              // ulps
  std::optional<Boundary> boundary;             // for a family beyond the claimed domain
  std::map<std::string, Count> counts;          // by invariant
  std::map<std::string, WorstViolation> worst;  // by invariant
  std::uint64_t sampled = 0;                    // this many cases are sampled, the first ones (sample.hpp)
  // The numbers of the sampled cases that violated each invariant. When the run is over, they ascend and each occurs
  // once.
  std::map<std::string, std::vector<std::uint64_t>> violated_cases;
  // Violated cases in ascending order of number, at most most_violated_kept in each list. The answers in the first list
  // are wrong by themselves. Only relations to further answers show that those in the second list are wrong.
  std::vector<ViolatedCase> first_violated;
  std::vector<ViolatedCase> first_violated_by_relations;

  /// Keeps the violation if it is more serious than the known one of the invariant.
  void keep_if_worst(const std::string& invariant, const WorstViolation& violation);

  /// Adds the results of other cases of the family. The numbers of violated cases stay unordered.
  FamilyResult& operator+=(const FamilyResult& other);

  /// Puts the numbers of violated cases in order, each once.
  void order_violated_cases();
};

/// Keeps the case if it is one of the first. Cases may come in any order, and the same case several times.
void keep_if_first(std::vector<ViolatedCase>& kept, const ViolatedCase& violated);

}  // namespace carom::properties
