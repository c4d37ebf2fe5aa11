// SPDX-License-Identifier: BSL-1.0
#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/without_effects.hpp>
#include <carom/properties/gate/declared_effects.hpp>

namespace carom::properties::diagnosis {

ViolatedCase without_effects(const ViolatedCase& one, const Subject& subject) {
  ViolatedCase changed = one;
  if (subject.effects == DeclaredEffects{} || !validate(one.one.collision).empty()) {
    return changed;
  }
  changed.one.collision = judged_collision(one.one.collision, subject.effects);
  ExactAnswer answer = lift(one.answer);
  take_out_effects(answer, subject.effects, oracles::ExactCase(changed.one.collision), subject.law, 0);
  if (const auto* outcome = std::get_if<oracles::LiftedOutcome>(&answer)) {
    changed.answer = reported(outcome->rounded());
  }
  return changed;
}

}  // namespace carom::properties::diagnosis
