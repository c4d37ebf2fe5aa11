// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/LU>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/diagnosis/fits.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/diagnosis/precision.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Whether the steps and further mistakes of `rest` give the answer.
bool explains_with(const Steps& steps, std::span<const Hypothesis* const> rest, const KnownCase& one) {
  if (rest.empty()) {
    const std::optional<Outcome<double>> outcome = outcome_of(steps, one);
    return outcome && is_explained_by(*outcome, one);
  }
  return std::ranges::any_of(rest.front()->mistakes, [&](const Mistake& mistake) {
    Steps changed = steps;
    return mistake(changed, one) && explains_with(changed, rest.subspan(1), one);
  });
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
                   }},
                   false});
  }
  return all;
}

oracles::ContactState approach_by(ApproachTest test, const Collision& collision) {
  const oracles::ContactState approach = state_of(collision);
  if (test == ApproachTest::right || approach == oracles::ContactState::inert) {
    return approach;
  }
  const bool approaches = test == ApproachTest::of_centres
                              ? collision.normal.dot(collision.a.velocity - collision.b.velocity) < 0
                              : approach == oracles::ContactState::colliding;
  const bool is_solved = test == ApproachTest::missing || approaches != (test == ApproachTest::inverted);
  return is_solved ? oracles::ContactState::colliding : oracles::ContactState::separating;
}

bool is_permitted(double restitution) { return restitution >= 0 && restitution <= 1; }

/// Whether the collision is valid but for its restitution.
bool can_be_solved(Collision collision) {
  if (!std::isfinite(collision.restitution)) {
    return false;
  }
  collision.restitution = is_permitted(collision.restitution) ? collision.restitution : 0;
  return validate(collision).empty();
}

/// No value if the law has no answer. If the steps solve a contact that does not collide, the formulas of the linear
/// laws extend to it. With the other laws, its normal impulse is negative, so that the cone permits no friction.
std::optional<Vector3<double>> first_impulse_on_a(const Steps& steps, const Collision& collision) {
  const bool is_of_law =
      steps.friction == FrictionSteps{} && steps.matrix == MatrixSteps{} && is_permitted(collision.restitution);
  if (is_of_law && steps.test == ApproachTest::right) {
    return law_impulse(collision, steps.law, {}, steps.effort, steps.impulses);
  }
  const oracles::ContactState as = approach_by(steps.test, collision);
  const bool is_extended = as == oracles::ContactState::colliding && state_of(collision) != as;
  const Law law = is_extended && !is_linear(steps.law) ? Law::frictionless : steps.law;
  if (is_of_law) {
    return law_impulse(collision, law, as, steps.effort, steps.impulses);
  }
  return as == oracles::ContactState::colliding
             ? impulse_by(collision, law, is_extended ? FrictionSteps{} : steps.friction, steps.matrix)
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
  if (!can_be_solved(second)) {  // the first impulse may overflow
    return std::nullopt;
  }
  const std::optional<Vector3<double>> further = first_impulse_on_a(again, second);
  return further ? std::optional(Vector3<double>(*first + *further)) : std::nullopt;
}

/// The changes of bodies at rest by the impulse.
Outcome<double> changes_by(const Steps& steps, const Collision& still, const Vector3<double>& on_a) {
  if (steps.matrix.inverse_of_a == inverse_inertia && steps.matrix.inverse_of_b == inverse_inertia &&
      !steps.has_turned_torque_of_a && !steps.has_turned_torque_of_b) {
    return pushed(still, on_a);
  }
  const BasicCollision<Wide> c = map_numbers<Wide>(still, [](double x) { return static_cast<Wide>(x); });
  const auto of_body = [&](const BasicBody<Wide>& body, const Vector3<Wide>& impulse, InverseInertia inverse,
                           bool is_turned) -> BodyVelocity<double> {
    if (body.immovable) {
      return {Vector3<double>::Zero(), Vector3<double>::Zero()};
    }
    const Vector3<Wide> of_torque =
        is_turned ? oracles::turned<Wide>(oracles::conjugate(body.orientation), impulse) : impulse;
    const Vector3<Wide> spin = inverse(body) * oracles::lever_arm(body, c.point).cross(of_torque);
    return {Vector3<Wide>(impulse / body.mass).cast<double>(), spin.cast<double>()};
  };
  const Vector3<Wide> f = on_a.cast<Wide>();
  return {of_body(c.a, f, steps.matrix.inverse_of_a, steps.has_turned_torque_of_a),
          of_body(c.b, Vector3<Wide>(-f), steps.matrix.inverse_of_b, steps.has_turned_torque_of_b)};
}

/// The outcome with the impulse on A that comes nearest to the subject's answer. It is linear in the impulse.
std::optional<Outcome<double>> nearest_outcome(const Steps& steps, const KnownCase& one) {
  const double size = one.impulse.isZero(0) ? 1 : one.impulse.stableNorm();
  const auto change_from = [](const Outcome<double>& from, const Outcome<double>& to) {
    Outcome<double> change;
    for (const OutcomeVector k : all_outcome_vectors) {
      *vectors(change)[k] = *vectors(to)[k] - *vectors(from)[k];
    }
    return change;
  };
  const Outcome<double> missing = change_from(one.before, one.answered);
  std::array<Outcome<double>, 3> changes;
  Matrix3<double> products;
  Vector3<double> sides;
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> on_a = Vector3<double>::Unit(i) * size;
    changes[static_cast<std::size_t>(i)] = change_from(one.before, outcome_by(steps, {on_a, -on_a}, one));
    for (int j = 0; j <= i; ++j) {
      products(i, j) = products(j, i) =
          energy_product(one.collision, changes[static_cast<std::size_t>(i)], changes[static_cast<std::size_t>(j)]);
    }
    sides[i] = energy_product(one.collision, changes[static_cast<std::size_t>(i)], missing);
  }
  const Vector3<double> on_a = products.fullPivLu().solve(sides) * size;
  return on_a.allFinite() ? std::optional(outcome_by(steps, {on_a, -on_a}, one)) : std::nullopt;
}

Vector3<double> limited_to(double most, const Vector3<double>& v) {
  if (most == unlimited) {
    return v;
  }
  const double length = v.stableNorm();
  return length > most ? Vector3<double>(v * (most / length)) : v;
}

/// The impulse that a solver applies if it computed this one.
Vector3<double> changed_impulse(const Steps& steps, const Vector3<double>& computed) {
  Vector3<double> on_a = computed;
  if (steps.tangential != 1 || steps.normal != 1) {
    const Vector3<double> normal = steps.computed_from.normal.stableNormalized();
    const Vector3<double> along = normal * normal.dot(on_a);
    on_a = steps.normal * along + steps.tangential * (on_a - along);
  }
  return limited_to(steps.most_impulse, on_a.cwiseProduct(steps.components));
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
  CAROM_EXPECTS(!hypothesis.mistakes.empty(), hypothesis.as_if);
  Steps steps = right_steps(one);
  return hypothesis.mistakes.front()(steps, one) ? outcome_of(steps, one) : std::nullopt;
}

std::optional<Outcome<double>> outcome_of(const Steps& steps, const KnownCase& one) {
  if (steps.freedom == Freedom::whole) {
    return can_be_solved(steps.applied_to) ? nearest_outcome(steps, one) : std::nullopt;
  }
  std::optional<Impulses> impulses = impulses_by(steps, one);
  if (impulses && steps.freedom == Freedom::length) {
    const Outcome<double> to = outcome_by(steps, *impulses, one);
    const auto changes = [&](const Outcome<double>& after) {
      Outcome<double> change;
      for (const OutcomeVector k : all_outcome_vectors) {
        *vectors(change)[k] = *vectors(after)[k] - *vectors(one.before)[k];
      }
      return change;
    };
    const double factor = energy_product(one.collision, changes(to), changes(one.answered)) /
                          energy_product(one.collision, changes(to), changes(to));
    if (!std::isfinite(factor)) {
      return std::nullopt;
    }
    impulses = Impulses{factor * impulses->on_a, factor * impulses->on_b};
  }
  return impulses ? std::optional(outcome_by(steps, *impulses, one)) : std::nullopt;
}

bool is_applied_right(const KnownCase& one) {
  Steps steps = right_steps(one);
  steps.freedom = Freedom::whole;
  const std::optional<Outcome<double>> outcome = outcome_of(steps, one);
  return outcome && is_explained_by(*outcome, one);
}

bool explains(std::span<const Hypothesis* const> together, const KnownCase& one) {
  return explains_with(right_steps(one), together, one);
}

bool explains(const Hypothesis& hypothesis, const KnownCase& one) {
  const Hypothesis* const alone = &hypothesis;
  return explains(std::span(&alone, 1), one);
}

Steps right_steps(const KnownCase& one) {
  Steps steps{one.collision, one.collision, one.law};
  steps.impulses = one.impulses.get();
  return steps;
}

std::optional<Impulses> impulses_by(const Steps& steps, const KnownCase& one) {
  if (!can_be_solved(steps.applied_to) || !can_be_solved(steps.computed_from)) {
    return std::nullopt;
  }
  if (!steps.is_each_body_alone) {
    const std::optional<Vector3<double>> computed =
        steps.has_right_impulse ? std::optional(one.impulse) : impulse_on_a(steps, steps.computed_from);
    if (!computed) {
      return std::nullopt;
    }
    const Vector3<double> on_a = changed_impulse(steps, *computed);
    return Impulses{on_a, -on_a};
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
    const bool is_spin = k == OutcomeVector::angular_velocity_of_a || k == OutcomeVector::angular_velocity_of_b;
    *vectors(outcome)[k] = limited_to(is_spin ? steps.most_spin : steps.most_speed, *vectors(outcome)[k]);
  }
  return outcome;
}

const char* words_of(Use use) {
  switch (use) {
    case Use::computation:
      return " in the computation of the impulse, which is applied correctly";
    case Use::velocity:
      return " in V⁻";
    case Use::matrix:
      return " in the collision matrix";
    case Use::application:
      return " in the application of the impulse, which itself is right";
    case Use::everywhere:
      break;
  }
  return "";
}

Mistake misread_in(Use use, std::function<void(Collision&)> change) {
  return [use, change = std::move(change)](Steps& steps, const KnownCase&) {
    if (use == Use::everywhere || use == Use::application) {
      change(steps.applied_to);
    }
    if (use == Use::application) {
      return true;
    }
    steps.has_right_impulse = false;
    if (use == Use::everywhere || use == Use::computation) {
      change(steps.computed_from);
      return true;
    }
    // The velocity of each body's material point at P says which lever arms V⁻ uses.
    Collision changed = steps.computed_from;
    change(changed);
    Collision& kept = use == Use::velocity ? steps.computed_from : changed;
    const Collision& told = use == Use::velocity ? changed : steps.computed_from;
    for (const auto field : {&Collision::a, &Collision::b}) {
      const Body& of_velocity = told.*field;
      Body& body = kept.*field;
      body.velocity = of_velocity.velocity + of_velocity.angular_velocity.cross(told.point - of_velocity.position) -
                      body.angular_velocity.cross(kept.point - body.position);
    }
    if (use == Use::matrix) {
      steps.computed_from = changed;
    }
    return true;
  };
}

Mistake misread_as(std::function<void(Collision&)> change) { return misread_in(Use::everywhere, std::move(change)); }

Mistake computed_as(std::function<void(Collision&)> change) { return misread_in(Use::computation, std::move(change)); }

Mistake with_steps(std::function<void(Steps&, const KnownCase&)> change) {
  return [change = std::move(change)](Steps& steps, const KnownCase& one) {
    change(steps, one);
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

}  // namespace carom::properties::diagnosis
