// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <carom/properties/gate/subject_tally.hpp>

namespace carom::properties {
namespace {

using oracles::ContactState;

bool is_isotropic(const Body& body) {
  return body.immovable || (body.principal_inertia[0] == body.principal_inertia[1] &&
                            body.principal_inertia[1] == body.principal_inertia[2]);
}

}  // namespace

Coverage coverage_of(const JudgedCase& judged_case) {
  Coverage coverage;
  coverage.cases = 1;
  for (const Adjustment adjustment : all_adjustments) {
    coverage.adjusted[adjustment] = judged_case.generated().adjusted[adjustment] ? 1 : 0;
  }
  if (!judged_case.is_valid()) {
    coverage.invalid = 1;
    return coverage;
  }
  const Collision& c = judged_case.generated().collision;
  const ContactState approach = judged_case.exact().state();
  coverage.colliding = approach == ContactState::colliding ? 1 : 0;
  coverage.resting = approach == ContactState::resting ? 1 : 0;
  coverage.separating = approach == ContactState::separating ? 1 : 0;
  coverage.inert = approach == ContactState::inert ? 1 : 0;
  coverage.one_immovable = c.a.immovable != c.b.immovable ? 1 : 0;
  coverage.spheres =
      approach != ContactState::inert && is_isotropic(c.a) && is_isotropic(c.b) && judged_case.exact().is_collinear()
          ? 1
          : 0;
  coverage.head_on = approach == ContactState::colliding && judged_case.exact().is_head_on() ? 1 : 0;
  coverage.inelastic = c.restitution == 0 ? 1 : 0;
  coverage.elastic = c.restitution == 1 ? 1 : 0;
  return coverage;
}

void SubjectTally::add(std::size_t family, std::uint64_t index, const JudgedCase& judged_case, const Answer& answer,
                       const Judgement& judgement, const Claim& claim) {
  FamilyResult& result = families[family];
  ++result.cases;
  if (judgement.skipped) {
    ++result.skipped;
    if (judged_case.is_valid() && index < result.sampled) {
      result.skipped_cases.push_back(index);
    }
  }
  if (judgement.unjudged) {
    ++result.unjudged[*judgement.unjudged];
  }
  for (const DeclaredEffect effect : all_declared_effects) {
    result.decided_by[effect] += judgement.decided_by[effect] ? 1 : 0;
  }
  if (judgement.accuracy && judgement.accuracy->is_decided) {
    result.worst_backward_error =
        std::max(result.worst_backward_error, judgement.accuracy->backward_error(claim.yardstick.unit_roundoff()));
    if (judged_case.exact().state() == ContactState::colliding && judgement.accuracy->is_of_truth) {
      digits.add(judgement.accuracy->digits());
    }
  }
  result.energy += energy_gains_of(index, judged_case, claim, answer, judgement);
  bool any_violated = false;
  for (const NamedVerdict& named : judgement.verdicts) {
    any_violated = any_violated || named.verdict.status == Status::violated;
    add(family, index, judged_case.generated(), answer, named);
  }
  result.violated += any_violated ? 1 : 0;
}

void SubjectTally::add(std::size_t family, std::uint64_t index, const Case& one, const Answer& answer,
                       const NamedVerdict& named) {
  const Invariant& invariant = *named.invariant;
  FamilyResult& result = families[family];
  Count& count = result.counts[&invariant];
  switch (named.verdict.status) {
    case Status::holds:
      ++count.holds;
      break;
    case Status::skipped:
      ++count.skipped;
      break;
    case Status::violated:
      ++count.violated;
      result.keep_if_worst(invariant, {index, one, named.verdict, answer});
      keep_if_first(invariant.is_of_one_answer() ? result.first_violated : result.first_violated_by_relations,
                    {index, one, answer});
      if (index < result.sampled) {
        if (invariant.is_of_one_answer()) {
          result.keep_answer(index, answer);
        }
        result.violated_cases[&invariant].push_back(index);
      }
  }
}

SubjectTally& SubjectTally::operator+=(const SubjectTally& other) {
  if (error.empty()) {
    error = other.error;
  }
  for (std::size_t f = 0; f < families.size(); ++f) {
    families[f] += other.families[f];
  }
  digits += other.digits;
  nanoseconds_per_solve += other.nanoseconds_per_solve;
  return *this;
}

}  // namespace carom::properties
