// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <carom/properties/gate/tally.hpp>

namespace carom::properties {
namespace {

using oracles::Approach;

bool is_isotropic(const Body& body) {
  return body.immovable || (body.principal_inertia[0] == body.principal_inertia[1] &&
                            body.principal_inertia[1] == body.principal_inertia[2]);
}

void keep_worst(FamilyResult& result, const std::string& invariant, const WorstViolation& violation) {
  const auto [known, is_new] = result.worst.emplace(invariant, violation);
  const double own = seriousness(violation.verdict, violation.original.collision);
  const double others = seriousness(known->second.verdict, known->second.original.collision);
  const bool is_worse = own > others || (own == others && violation.index < known->second.index);
  if (!is_new && is_worse) {
    known->second = violation;
  }
}

/// Cases come in the order of their numbers, but from several threads, and one may come once for each invariant.
void keep_first(std::vector<ViolatedCase>& kept, const ViolatedCase& violated) {
  const auto place = std::lower_bound(kept.begin(), kept.end(), violated.index,
                                      [](const ViolatedCase& one, std::uint64_t index) { return one.index < index; });
  const bool is_known = place != kept.end() && place->index == violated.index;
  if (!is_known && (place != kept.end() || kept.size() < most_violated_kept)) {
    kept.insert(place, violated);
    kept.resize(std::min(kept.size(), most_violated_kept), violated);
  }
}

}  // namespace

Coverage coverage_of(const JudgedCase& judged_case) {
  Coverage coverage;
  coverage.cases = 1;
  if (!judged_case.is_valid()) {
    coverage.invalid = 1;
    return coverage;
  }
  const Collision& c = judged_case.generated().collision;
  const Approach approach = judged_case.exact().approach();
  coverage.colliding = approach == Approach::colliding ? 1 : 0;
  coverage.resting = approach == Approach::resting ? 1 : 0;
  coverage.separating = approach == Approach::separating ? 1 : 0;
  coverage.inert = approach == Approach::inert ? 1 : 0;
  coverage.one_immovable = c.a.immovable != c.b.immovable ? 1 : 0;
  coverage.spheres =
      approach != Approach::inert && is_isotropic(c.a) && is_isotropic(c.b) && judged_case.exact().is_collinear() ? 1
                                                                                                                  : 0;
  coverage.head_on = approach == Approach::colliding && judged_case.exact().is_head_on() ? 1 : 0;
  coverage.inelastic = c.restitution == 0 ? 1 : 0;
  coverage.elastic = c.restitution == 1 ? 1 : 0;
  return coverage;
}

void Tally::add(std::size_t family, std::uint64_t index, const JudgedCase& judged_case, const Answer& answer,
                const Judgement& judgement, const Claim& claim) {
  FamilyResult& result = families[family];
  ++result.cases;
  result.skipped += judgement.skipped ? 1 : 0;
  result.not_held += judgement.not_held.empty() ? 0 : 1;
  if (judgement.accuracy && judgement.accuracy->is_decided) {
    result.worst_backward_error =
        std::max(result.worst_backward_error, judgement.accuracy->backward_error(claim.yardstick.unit_roundoff));
    if (judged_case.exact().approach() == Approach::colliding && judgement.accuracy->is_of_truth) {
      digits.add(judgement.accuracy->digits());
    }
  }
  bool any_violated = false;
  for (const NamedVerdict& named : judgement.verdicts) {
    any_violated = any_violated || named.verdict.status == Status::violated;
    add(family, index, judged_case.generated(), answer, named);
  }
  result.violated += any_violated ? 1 : 0;
}

void Tally::add(std::size_t family, std::uint64_t index, const Case& one, const Answer& answer,
                const NamedVerdict& named) {
  counts.resize(families.size());
  std::vector<Count>& counts_of_family = counts[family];
  counts_of_family.resize(all_invariants().size());
  Count& count = counts_of_family[static_cast<std::size_t>(named.invariant - all_invariants().data())];
  switch (named.verdict.status) {
    case Status::holds:
      ++count.holds;
      break;
    case Status::skipped:
      ++count.skipped;
      break;
    case Status::violated:
      ++count.violated;
      keep_worst(families[family], std::string(named.invariant->name), {index, one, named.verdict, answer});
      keep_first(named.invariant->is_of_one_answer() ? families[family].first_violated
                                                     : families[family].first_violated_by_relations,
                 {index, one, answer});
      if (index < families[family].sampled) {
        families[family].violated_cases[std::string(named.invariant->name)].push_back(index);
      }
  }
}

void Tally::name_counts() {
  for (std::size_t f = 0; f < counts.size(); ++f) {
    for (std::size_t i = 0; i < counts[f].size(); ++i) {
      const Count& count = counts[f][i];
      if (count.holds + count.violated + count.skipped > 0) {
        Count& named = families[f].counts[std::string(all_invariants()[i].name)];
        named.holds += count.holds;
        named.violated += count.violated;
        named.skipped += count.skipped;
      }
    }
  }
  counts.clear();
}

Tally& Tally::operator+=(const Tally& other) {
  if (error.empty()) {
    error = other.error;
  }
  for (std::size_t f = 0; f < families.size(); ++f) {
    FamilyResult& into = families[f];
    const FamilyResult& from = other.families[f];
    into.cases += from.cases;
    into.skipped += from.skipped;
    into.not_held += from.not_held;
    into.violated += from.violated;
    into.worst_backward_error = std::max(into.worst_backward_error, from.worst_backward_error);
    for (const auto& [name, count] : from.counts) {
      into.counts[name].holds += count.holds;
      into.counts[name].violated += count.violated;
      into.counts[name].skipped += count.skipped;
    }
    for (const auto& [name, violation] : from.worst) {
      keep_worst(into, name, violation);
    }
    for (const ViolatedCase& violated : from.first_violated) {
      keep_first(into.first_violated, violated);
    }
    for (const ViolatedCase& violated : from.first_violated_by_relations) {
      keep_first(into.first_violated_by_relations, violated);
    }
    for (const auto& [name, cases] : from.violated_cases) {
      into.violated_cases[name].insert(into.violated_cases[name].end(), cases.begin(), cases.end());
    }
  }
  digits += other.digits;
  nanoseconds_per_solve += other.nanoseconds_per_solve;
  return *this;
}

}  // namespace carom::properties
