// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <carom/collision/enum_array.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/energy_gains.hpp>
#include <carom/properties/gate/trial.hpp>

namespace carom::properties {

struct Count {
  std::uint64_t holds = 0;
  std::uint64_t violated = 0;
  std::uint64_t skipped = 0;

  [[nodiscard]] std::uint64_t judged() const { return holds + violated; }

  Count& operator+=(const Count& other);
};

/// A subject's limit in a family beyond the claimed domain: the violation with the least value of `Family::beyond`.
struct Boundary {
  double quantity = 0;
  std::uint64_t index = 0;  // number of the case in its family
  const Invariant* invariant = nullptr;
};

/// Keeps the boundary with the lesser quantity, or with the lesser case number if the quantities are equal.
void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other);

/// The boundary that a judged case shows. None if no invariant is violated, or if the family has no `Family::beyond`.
[[nodiscard]] std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                                  const Judgement& judgement);

/// The case of a family with the most serious violation of an invariant (`seriousness`). The first case wins a tie.
struct WorstViolation {
  std::uint64_t index;
  Case original;
  Verdict verdict;
  Answer answer;
};

struct ViolatedCase {
  std::uint64_t index;
  Case one;
  Answer answer;
};

/// The kind of an answer to a valid collision.
enum class AnswerKind { outcome, not_finite, refused, failed, skipped };
inline constexpr std::array all_answer_kinds{AnswerKind::outcome, AnswerKind::not_finite, AnswerKind::refused,
                                             AnswerKind::failed, AnswerKind::skipped};
static_assert(counts_from_zero_to(all_answer_kinds, AnswerKind::skipped));

[[nodiscard]] AnswerKind kind_of(const Answer& answer);

/// The answer to a sampled case (SampledCase), without its words.
struct SampledAnswer {
  std::uint64_t index;  // of the case
  AnswerKind kind;
  Outcome<double> outcome;  // of the kind `outcome`, rounded; otherwise zero
};

[[nodiscard]] SampledAnswer sampled_answer(std::uint64_t index, const Answer& answer);

/// A family keeps its first violated cases, at most this many.
inline constexpr std::size_t most_violated_kept = 12;

/// The results of a subject on a family. Their size does not grow with the number of cases.
struct FamilyResult {
  std::uint64_t cases = 0;
  std::uint64_t skipped = 0;        // cases that the subject could not take
  UnjudgedCounts unjudged{};        // valid cases that are not judged, by reason
  EffectCounts decided_by{};        // colliding cases that a declared effect decides
  std::uint64_t violated = 0;       // cases with a violation of any invariant
  double worst_backward_error = 0;  // ulps
  EnergyGains energy = {};
  std::optional<Boundary> boundary;  // for a family beyond the claimed domain
  PerInvariant<Count> counts;
  PerInvariant<WorstViolation> worst;
  std::uint64_t sampled = 0;                      // this many of the first cases are sampled (SampledCase)
  std::vector<std::uint64_t> skipped_cases = {};  // the numbers of the sampled valid cases; after the run, they ascend
  // The numbers of the sampled cases that violated each invariant. After the run, they ascend and are unique.
  PerInvariant<std::vector<std::uint64_t>> violated_cases;
  // The answers to the sampled cases that violated an invariant of one answer. After the run, they ascend and are
  // unique.
  std::vector<SampledAnswer> sampled_answers;
  // The first violated cases, ascending, at most most_violated_kept in each list. The second list has the violations
  // that need further answers: of relations, or of a repeated question.
  std::vector<ViolatedCase> first_violated;
  std::vector<ViolatedCase> first_violated_by_relations;

  /// The number of cases that are neither skipped nor unjudged.
  [[nodiscard]] std::uint64_t judged() const;

  /// Keeps the violation if it is more serious than the stored violation of the invariant.
  void keep_if_worst(const Invariant& invariant, const WorstViolation& violation);

  /// Keeps the answer to a sampled case. Calls for one case follow each other.
  void keep_answer(std::uint64_t index, const Answer& answer);

  /// Adds the results of other cases of the family. Call `order_cases` after the last addition.
  FamilyResult& operator+=(const FamilyResult& other);

  /// Puts the numbers of skipped and violated cases and the sampled answers in order, each once.
  void order_cases();
};

/// Keeps the case if it is one of the first most_violated_kept. Cases may come in any order and repeatedly.
void keep_if_first(std::vector<ViolatedCase>& kept, const ViolatedCase& violated);

/// A sampled case, with the properties that a diagnosis compares.
struct SampledCase {
  bool is_valid = false;
  oracles::ContactState approach = oracles::ContactState::inert;  // of a valid case
  std::vector<std::uint16_t> features = {};                       // places in all_features(), ascending
  std::vector<float> quantities = {};  // decimal logarithms, in the order of all_compared_quantities()
  Collision collision = {};
};

/// This many of a family's first cases, times the family's weight, are sampled.
inline constexpr std::uint64_t sampled_of_each_family = 1000;
[[nodiscard]] std::uint64_t sampled_of(const Family& family);

/// A valid case with these features (indices of all_features()).
[[nodiscard]] SampledCase sampled_case(const JudgedCase& judged_case, std::vector<std::uint16_t> features);

/// Draws the sampled cases among the first `cases` of the family. Invalid cases stay default-constructed.
[[nodiscard]] std::vector<SampledCase> drawn_sample(const Domain& within, const Family& family, std::uint64_t seed,
                                                    std::uint64_t cases);

}  // namespace carom::properties
