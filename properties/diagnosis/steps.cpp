// SPDX-License-Identifier: BSL-1.0
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/steps.hpp>

namespace carom::properties::diagnosis {

namespace {

oracles::Approach approach_by(ApproachTest test, const Collision& collision) {
  const oracles::Approach approach = oracles::ExactCase(collision).approach();
  if (test == ApproachTest::right || approach == oracles::Approach::inert) {
    return approach;
  }
  const bool is_solved = test == ApproachTest::missing || approach != oracles::Approach::colliding;
  return is_solved ? oracles::Approach::colliding : oracles::Approach::separating;
}

/// No value if the law has no answer: the steps solve a contact that does not collide, and only the formulas of the
/// linear laws extend to it.
std::optional<Vector3<double>> impulse_on_a(const Steps& steps, const Collision& collision) {
  if (steps.test == ApproachTest::right) {
    return law_impulse(collision, steps.law);
  }
  const oracles::Approach as = approach_by(steps.test, collision);
  const bool is_extended = as == oracles::Approach::colliding && oracles::ExactCase(collision).approach() != as;
  if (is_extended && !is_linear(steps.law)) {
    return std::nullopt;
  }
  return law_impulse(collision, steps.law, as);
}

}  // namespace

Steps right_steps(const KnownCase& one) { return {one.collision, one.collision, one.law}; }

std::optional<Impulses> impulses_by(const Steps& steps, const KnownCase& one) {
  if (!validate(steps.applied_to).empty() || !validate(steps.computed_from).empty()) {
    return std::nullopt;
  }
  if (!steps.is_each_body_alone) {
    const auto on_a = steps.has_right_impulse ? one.impulse : impulse_on_a(steps, steps.computed_from);
    return on_a ? std::optional(Impulses{*on_a, -*on_a}) : std::nullopt;
  }
  Collision of_a = steps.computed_from;
  of_a.b.immovable = true;
  Collision of_b = steps.computed_from;
  of_b.a.immovable = true;
  const auto on_a = impulse_on_a(steps, of_a);
  const auto on_b = impulse_on_a(steps, of_b);
  return on_a && on_b ? std::optional(Impulses{*on_a, -*on_b}) : std::nullopt;
}

Outcome<double> outcome_by(const Steps& steps, const Impulses& impulses, const KnownCase& one) {
  Collision still = steps.applied_to;
  for (Body* body : {&still.a, &still.b}) {
    body->velocity.setZero();
    body->angular_velocity.setZero();
  }
  Outcome<double> changes = pushed(still, impulses.on_a);
  if (steps.is_each_body_alone) {
    changes.b = pushed(still, -impulses.on_b).b;
  }
  Outcome<double> outcome = one.before;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(outcome)[k] += steps.factors[k] * *vectors(changes)[k];
  }
  return outcome;
}

Mistake misread_as(std::function<void(Collision&)> change) {
  return [change = std::move(change)](Steps& steps, const KnownCase&) {
    change(steps.computed_from);
    change(steps.applied_to);
    steps.has_right_impulse = false;
    return true;
  };
}

Mistake computed_as(std::function<void(Collision&)> change) {
  return [change = std::move(change)](Steps& steps, const KnownCase&) {
    change(steps.computed_from);
    steps.has_right_impulse = false;
    return true;
  };
}

Mistake applied_as(std::function<void(Collision&)> change) {
  return [change = std::move(change)](Steps& steps, const KnownCase&) {
    change(steps.applied_to);
    return true;
  };
}

}  // namespace carom::properties::diagnosis
