// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <numeric>

#include <carom/properties/gate/family_result.hpp>

namespace carom::properties {

Count& Count::operator+=(const Count& other) {
  holds += other.holds;
  violated += other.violated;
  skipped += other.skipped;
  return *this;
}

std::uint64_t FamilyResult::judged() const {
  return cases - skipped - std::accumulate(unjudged.begin(), unjudged.end(), std::uint64_t{0});
}

void FamilyResult::keep_if_worst(const Invariant& invariant, const WorstViolation& violation) {
  const auto [known, is_new] = worst.emplace(&invariant, violation);
  const double own = seriousness(violation.verdict, violation.original.collision);
  const double others = seriousness(known->second.verdict, known->second.original.collision);
  const bool is_worse = own > others || (own == others && violation.index < known->second.index);
  if (!is_new && is_worse) {
    known->second = violation;
  }
}

FamilyResult& FamilyResult::operator+=(const FamilyResult& other) {
  cases += other.cases;
  skipped += other.skipped;
  for (const Unjudged reason : all_reasons_unjudged) {
    unjudged[reason] += other.unjudged[reason];
  }
  for (const DeclaredEffect effect : all_declared_effects) {
    decided_by[effect] += other.decided_by[effect];
  }
  violated += other.violated;
  worst_backward_error = std::max(worst_backward_error, other.worst_backward_error);
  keep_if_least(boundary, other.boundary);
  for (const auto& [invariant, count] : other.counts) {
    counts[invariant] += count;
  }
  for (const auto& [invariant, violation] : other.worst) {
    keep_if_worst(*invariant, violation);
  }
  for (const ViolatedCase& one : other.first_violated) {
    keep_if_first(first_violated, one);
  }
  for (const ViolatedCase& one : other.first_violated_by_relations) {
    keep_if_first(first_violated_by_relations, one);
  }
  sampled_answers.insert(sampled_answers.end(), other.sampled_answers.begin(), other.sampled_answers.end());
  for (const auto& [invariant, numbers] : other.violated_cases) {
    std::vector<std::uint64_t>& own = violated_cases[invariant];
    own.insert(own.end(), numbers.begin(), numbers.end());
  }
  return *this;
}

void FamilyResult::keep_answer(std::uint64_t index, const Answer& answer) {
  if (sampled_answers.empty() || sampled_answers.back().index != index) {
    sampled_answers.push_back(sampled_answer(index, answer));
  }
}

void FamilyResult::order_violated_cases() {
  for (auto& [invariant, numbers] : violated_cases) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }
  std::ranges::sort(sampled_answers, {}, &SampledAnswer::index);
  const auto have_one_index = [](const SampledAnswer& x, const SampledAnswer& y) { return x.index == y.index; };
  sampled_answers.erase(std::unique(sampled_answers.begin(), sampled_answers.end(), have_one_index),
                        sampled_answers.end());
}

AnswerKind kind_of(const Answer& answer) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    return oracles::is_finite(*outcome) ? AnswerKind::outcome : AnswerKind::not_finite;
  }
  if (std::holds_alternative<Refused>(answer)) {
    return AnswerKind::refused;
  }
  return std::holds_alternative<Failed>(answer) ? AnswerKind::failed : AnswerKind::skipped;
}

SampledAnswer sampled_answer(std::uint64_t index, const Answer& answer) {
  const AnswerKind kind = kind_of(answer);
  if (kind != AnswerKind::outcome) {
    return {index, kind, {}};
  }
  return {index, kind,
          map_outcome<double>(std::get<ReportedOutcome>(answer), [](long double x) { return static_cast<double>(x); })};
}

void keep_if_first(std::vector<ViolatedCase>& kept, const ViolatedCase& violated) {
  const auto place = std::lower_bound(kept.begin(), kept.end(), violated.index,
                                      [](const ViolatedCase& one, std::uint64_t index) { return one.index < index; });
  const bool is_known = place != kept.end() && place->index == violated.index;
  if (!is_known && (place != kept.end() || kept.size() < most_violated_kept)) {
    kept.insert(place, violated);
    kept.resize(std::min(kept.size(), most_violated_kept), violated);
  }
}

}  // namespace carom::properties
