// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <numeric>
#include <utility>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/quantities.hpp>
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
  unjudged += other.unjudged;
  decided_by += other.decided_by;
  violated += other.violated;
  worst_backward_error = std::max(worst_backward_error, other.worst_backward_error);
  energy += other.energy;
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
  skipped_cases.insert(skipped_cases.end(), other.skipped_cases.begin(), other.skipped_cases.end());
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

void FamilyResult::order_cases() {
  std::ranges::sort(skipped_cases);
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

void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other) {
  const auto place = [](const Boundary& boundary) { return std::pair(boundary.quantity, boundary.index); };
  if (other && (!kept || place(*other) < place(*kept))) {
    kept = other;
  }
}

std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                    const Judgement& judgement) {
  const auto violated =
      std::find_if(judgement.verdicts.begin(), judgement.verdicts.end(),
                   [](const NamedVerdict& named) { return named.verdict.status == Status::violated; });
  if (!family.is_beyond_domain() || violated == judgement.verdicts.end()) {
    return std::nullopt;
  }
  return Boundary{family.beyond.of(collision), index, violated->invariant};
}

std::uint64_t sampled_of(const Family& family) {
  return sampled_of_each_family * static_cast<std::uint64_t>(family.weight);
}

SampledCase sampled_case(const JudgedCase& judged_case, std::vector<std::uint16_t> features) {
  const Collision& collision = judged_case.generated().collision;
  return {true, judged_case.exact().state(), std::move(features), quantities_of(collision), collision};
}

std::vector<SampledCase> drawn_sample(const Domain& within, const Family& family, std::uint64_t seed,
                                      std::uint64_t cases) {
  std::vector<SampledCase> sample(std::min(cases, sampled_of(family)));
  for (std::uint64_t index = 0; index < sample.size(); ++index) {
    const JudgedCase one(drawn_case_within(within, family, seed, index));
    if (one.is_valid()) {
      sample[index] = sampled_case(one, feature_places_of(one.generated().collision));
    }
  }
  return sample;
}

}  // namespace carom::properties
