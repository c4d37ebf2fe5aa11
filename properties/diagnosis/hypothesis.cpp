// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/diagnosis/fits.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Whether the steps, further mistakes of `rest` and the fitted length give the answer.
bool explains_with(const Steps& steps, std::span<const Hypothesis* const> rest,
                   const std::optional<FittedLength>& length, const KnownCase& one) {
  if (rest.empty()) {
    if (length) {
      return gives_answer(*length, steps, one);
    }
    const std::optional<Impulses> impulses = impulses_by(steps, one);
    return impulses && is_explained_by(outcome_by(steps, *impulses, one), one);
  }
  const Hypothesis& first = *rest.front();
  const std::optional<FittedLength>& kept = first.length ? first.length : length;
  if (first.mistakes.empty()) {
    return explains_with(steps, rest.subspan(1), kept, one);
  }
  for (const Mistake& mistake : first.mistakes) {
    Steps changed = steps;
    if (mistake(changed, one) && explains_with(changed, rest.subspan(1), kept, one)) {
      return true;
    }
  }
  return false;
}

std::vector<Hypothesis> other_laws() {
  std::vector<Hypothesis> all;
  std::vector<Law> laws(laws_with_truth.begin(), laws_with_truth.end());
  laws.push_back(Law::coulomb);
  for (const Law law : laws) {
    all.push_back({"its law were " + std::string(name_of(law)),
                   "the claimed law: this answer is right for another `law` than the claimed one",
                   {[law](Steps& steps, const KnownCase& one) {
                     steps.law = law;
                     steps.has_right_impulse = false;
                     return law != one.law;
                   }}});
  }
  return all;
}

oracles::ContactState approach_by(ApproachTest test, const Collision& collision) {
  const oracles::ContactState approach = oracles::ExactCase(collision).state();
  if (test == ApproachTest::right || approach == oracles::ContactState::inert) {
    return approach;
  }
  const bool is_solved = test == ApproachTest::missing || approach != oracles::ContactState::colliding;
  return is_solved ? oracles::ContactState::colliding : oracles::ContactState::separating;
}

bool is_permitted(double restitution) { return restitution >= 0 && restitution <= 1; }

/// No value if the law has no answer: the steps solve a contact that does not collide, and only the formulas of the
/// linear laws extend to it.
std::optional<Vector3<double>> first_impulse_on_a(const Steps& steps, const Collision& collision) {
  const bool is_of_law =
      steps.friction == FrictionSteps{} && steps.inverse == nullptr && is_permitted(collision.restitution);
  if (is_of_law && steps.test == ApproachTest::right) {
    return law_impulse(collision, steps.law);
  }
  const oracles::ContactState as = approach_by(steps.test, collision);
  const bool is_extended = as == oracles::ContactState::colliding && oracles::ExactCase(collision).state() != as;
  if (is_extended && !is_linear(steps.law)) {
    return std::nullopt;
  }
  if (is_of_law) {
    return law_impulse(collision, steps.law, as);
  }
  return as == oracles::ContactState::colliding
             ? impulse_by(collision, steps.law, steps.friction, steps.inverse ? steps.inverse : inverse_inertia)
             : std::optional(Vector3<double>(Vector3<double>::Zero()));
}

std::optional<Vector3<double>> impulse_on_a(const Steps& steps, const Collision& collision) {
  const std::optional<Vector3<double>> first = first_impulse_on_a(steps, collision);
  if (!steps.is_solved_twice || !first || first->isZero(0)) {
    return first;
  }
  const Outcome<double> after = pushed(collision, *first);
  Steps again = steps;
  again.test = ApproachTest::missing;
  Collision second = collision;
  second.a.velocity = after.a.velocity;
  second.a.angular_velocity = after.a.angular_velocity;
  second.b.velocity = after.b.velocity;
  second.b.angular_velocity = after.b.angular_velocity;
  const std::optional<Vector3<double>> further = first_impulse_on_a(again, second);
  return further ? std::optional(Vector3<double>(*first + *further)) : std::nullopt;
}

/// The changes of bodies at rest by the impulse.
Outcome<double> changes_by(const Steps& steps, const Collision& still, const Vector3<double>& on_a) {
  if (steps.inverse == nullptr) {
    return pushed(still, on_a);
  }
  using Extended = long double;
  const BasicCollision<Extended> c = map_numbers<Extended>(still, [](double x) { return static_cast<Extended>(x); });
  const auto of_body = [&](const BasicBody<Extended>& body, const Vector3<Extended>& impulse) -> BodyVelocity<double> {
    if (body.immovable) {
      return {Vector3<double>::Zero(), Vector3<double>::Zero()};
    }
    const Vector3<Extended> spin = steps.inverse(body) * oracles::lever_arm(body, c.point).cross(impulse);
    return {Vector3<Extended>(impulse / body.mass).cast<double>(), spin.cast<double>()};
  };
  const Vector3<Extended> f = on_a.cast<Extended>();
  return {of_body(c.a, f), of_body(c.b, Vector3<Extended>(-f))};
}

/// Whether the collision is valid but for its restitution.
bool can_be_solved(Collision collision) {
  collision.restitution = is_permitted(collision.restitution) ? collision.restitution : 0;
  return validate(collision).empty();
}

}  // namespace

std::span<const Hypothesis> all_hypotheses() {
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> joined;
    for (const auto group : {misused_impulses, misread_friction, misread_contacts, misread_bodies, other_laws}) {
      std::ranges::move(group(), std::back_inserter(joined));
    }
    return joined;
  }();
  return all;
}

std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one) {
  CAROM_EXPECTS(!hypothesis.mistakes.empty() && !hypothesis.length, hypothesis.as_if);
  Steps steps = right_steps(one);
  if (!hypothesis.mistakes.front()(steps, one)) {
    return std::nullopt;
  }
  const std::optional<Impulses> impulses = impulses_by(steps, one);
  return impulses ? std::optional(outcome_by(steps, *impulses, one)) : std::nullopt;
}

bool explains(std::span<const Hypothesis* const> together, const KnownCase& one) {
  return explains_with(right_steps(one), together, {}, one);
}

bool explains(const Hypothesis& hypothesis, const KnownCase& one) {
  const Hypothesis* const alone = &hypothesis;
  return explains(std::span(&alone, 1), one);
}

Steps right_steps(const KnownCase& one) { return {one.collision, one.collision, one.law}; }

std::optional<Impulses> impulses_by(const Steps& steps, const KnownCase& one) {
  if (!can_be_solved(steps.applied_to) || !can_be_solved(steps.computed_from)) {
    return std::nullopt;
  }
  if (!steps.is_each_body_alone) {
    std::optional<Vector3<double>> on_a = one.impulse;
    if (!steps.has_right_impulse) {
      on_a = impulse_on_a(steps, steps.computed_from);
    }
    if (on_a && steps.tangential != 1) {
      const Vector3<double> normal = steps.computed_from.normal.stableNormalized();
      const Vector3<double> along = normal * normal.dot(*on_a);
      on_a = along + steps.tangential * (*on_a - along);
    }
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
  Outcome<double> changes = changes_by(steps, still, impulses.on_a);
  if (steps.is_each_body_alone) {
    changes.b = changes_by(steps, still, -impulses.on_b).b;
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

Mistake with_friction(std::function<void(FrictionSteps&)> change) {
  return [change = std::move(change)](Steps& steps, const KnownCase& one) {
    change(steps.friction);
    steps.has_right_impulse = false;
    return has_friction(steps.law) && one.approach == oracles::ContactState::colliding;
  };
}

Mistake with_factors(const PerVector<double>& factors) {
  return [factors](Steps& steps, const KnownCase&) {
    for (const OutcomeVector k : all_outcome_vectors) {
      steps.factors[k] *= factors[k];
    }
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
