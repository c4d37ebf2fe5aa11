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

/// The case of a family that violated an invariant most; of equals the first.
struct WorstViolation {
  std::uint64_t index;
  Case original;
  Verdict verdict;
  Answer answer;
};

/// A case whose outcome violated something, and the answer to it.
struct ViolatedCase {
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// The first so many violated cases of a family are kept.
inline constexpr std::size_t most_violated_kept = 12;

/// What came of a subject on a family. It does not grow with the number of cases.
struct FamilyResult {
  std::uint64_t cases = 0;
  std::uint64_t skipped = 0;                    // cases that could not be posed to the subject
  UnjudgedCounts unjudged{};                    // valid cases that are not judged, by reason
  std::uint64_t violated = 0;                   // cases that violated any invariant
  double worst_backward_error = 0;              // ulps
  std::optional<Boundary> boundary;             // of a family beyond the claimed domain
  std::map<std::string, Count> counts;          // by invariant
  std::map<std::string, WorstViolation> worst;  // by invariant
  std::uint64_t sampled = 0;                    // cases, the first ones
  // The numbers of the sampled cases that violated an invariant; ascending, each once, when the run is over.
  std::map<std::string, std::vector<std::uint64_t>> violated_cases;
  // By their numbers, at most most_violated_kept of each: those whose answer is wrong by itself, and those that only
  // further questions show.
  std::vector<ViolatedCase> first_violated;
  std::vector<ViolatedCase> first_violated_by_relations;

  /// Keeps it where it is worse than what is known of the invariant.
  void keep_if_worst(const std::string& invariant, const WorstViolation& violation);

  /// Adds what came of other cases of the family. The numbers of violated cases are left in any order.
  FamilyResult& operator+=(const FamilyResult& other);

  /// Puts the numbers of violated cases in order, each once.
  void order_violated_cases();
};

/// Keeps it where it is one of the first. Cases may come in any order, and one several times.
void keep_if_first(std::vector<ViolatedCase>& kept, const ViolatedCase& violated);

}  // namespace carom::properties
