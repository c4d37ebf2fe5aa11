// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Whether the steps, further mistakes of `rest` and the fitted size give the answer.
bool explains_with(const Steps& steps, std::span<const Hypothesis* const> rest, const std::optional<FittedSize>& size,
                   const KnownCase& one) {
  if (rest.empty()) {
    if (size) {
      return gives_answer(*size, steps, one);
    }
    const std::optional<Impulses> impulses = impulses_by(steps, one);
    return impulses && is_explained_by(outcome_by(steps, *impulses, one), one);
  }
  const Hypothesis& first = *rest.front();
  // A limit of the impulse comes last in a solver, so it replaces other sizes.
  const bool replaces = first.size && (!size || first.size->fit == Fit::length_of_impulse);
  const std::optional<FittedSize>& kept = replaces ? first.size : size;
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
  for (const Law law : laws_with_truth) {
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

/// No value if the law has no answer: the steps solve a contact that does not collide, and only the formulas of the
/// linear laws extend to it.
std::optional<Vector3<double>> impulse_on_a(const Steps& steps, const Collision& collision) {
  if (steps.test == ApproachTest::right) {
    return law_impulse(collision, steps.law);
  }
  const oracles::ContactState as = approach_by(steps.test, collision);
  const bool is_extended = as == oracles::ContactState::colliding && oracles::ExactCase(collision).state() != as;
  if (is_extended && !is_linear(steps.law)) {
    return std::nullopt;
  }
  return law_impulse(collision, steps.law, as);
}

}  // namespace

std::span<const Hypothesis> all_hypotheses() {
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> joined;
    for (const auto group : {misused_impulses, misread_contacts, misread_bodies, other_laws}) {
      std::ranges::move(group(), std::back_inserter(joined));
    }
    return joined;
  }();
  return all;
}

std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one) {
  CAROM_EXPECTS(!hypothesis.mistakes.empty() && !hypothesis.size, hypothesis.as_if);
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

namespace {

/// The outcomes from + t (to − from). `unit` is the size that the parameter t = 1 stands for, and `offset` the size at
/// t = 0.
struct Line {
  Outcome<double> from;
  Outcome<double> to;
  double unit;
  double offset;
};

Outcome<double> at(const Line& line, double t) {
  Outcome<double> outcome;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(outcome)[k] = *vectors(line.from)[k] + t * (*vectors(line.to)[k] - *vectors(line.from)[k]);
  }
  return outcome;
}

/// The parameter t for which the outcome is nearest to the subject's answer, if it is near enough.
std::optional<double> nearest(const Line& line, const KnownCase& one) {
  Outcome<double> step;
  Outcome<double> missing;
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(step)[k] = *vectors(line.to)[k] - *vectors(line.from)[k];
    *vectors(missing)[k] = *vectors(one.answered)[k] - *vectors(line.from)[k];
  }
  const double t = energy_product(one.collision, step, missing) / energy_product(one.collision, step, step);
  return std::isfinite(t) && is_explained_by(at(line, t), one) ? std::optional(t) : std::nullopt;
}

/// The law's outcome is affine in ε for these laws.
bool is_affine_in_restitution(Law law) {
  return law == Law::frictionless || law == Law::reflection || law == Law::sticking;
}

/// The outcomes for every size. No value if the steps do not depend on the size, or use an invalid collision.
std::optional<Line> line_of(Fit fit, const Steps& steps, const KnownCase& one) {
  if (fit == Fit::length_of_impulse) {
    const std::optional<Impulses> impulses = steps.is_each_body_alone ? std::nullopt : impulses_by(steps, one);
    return impulses ? std::optional(Line{one.before, outcome_by(steps, *impulses, one), impulses->on_a.stableNorm(), 0})
                    : std::nullopt;
  }
  if (!is_affine_in_restitution(steps.law)) {
    return std::nullopt;
  }
  const auto with_restitution = [&](double restitution) -> std::optional<Outcome<double>> {
    Steps changed = steps;
    changed.computed_from.restitution = restitution;
    changed.has_right_impulse = false;
    const std::optional<Impulses> impulses = impulses_by(changed, one);
    return impulses ? std::optional(outcome_by(changed, *impulses, one)) : std::nullopt;
  };
  const std::optional<Outcome<double>> inelastic = with_restitution(0);
  const std::optional<Outcome<double>> elastic = with_restitution(1);
  return inelastic && elastic ? std::optional(Line{*inelastic, *elastic, 1, -steps.computed_from.restitution})
                              : std::nullopt;
}

}  // namespace

bool agree(double x, double y) {
  constexpr double visible = 0x1p-10;
  return std::abs(x - y) <= visible * std::max(std::abs(x), std::abs(y));
}

bool gives_answer(const FittedSize& size, const Steps& steps, const KnownCase& one) {
  if (!size.value) {
    return fitted(size.fit, steps, one).has_value();
  }
  const std::optional<Line> line = line_of(size.fit, steps, one);
  const double t = line ? (*size.value - line->offset) / line->unit : 0;
  return line && std::isfinite(t) && is_explained_by(at(*line, t), one);
}

std::optional<double> fitted(Fit fit, const Steps& steps, const KnownCase& one) {
  const std::optional<Line> line = line_of(fit, steps, one);
  const std::optional<double> t = line ? nearest(*line, one) : std::nullopt;
  if (!t) {
    return std::nullopt;
  }
  const double size = line->offset + *t * line->unit;
  return fit == Fit::length_of_impulse ? std::abs(size) : size;
}

}  // namespace carom::properties::diagnosis
