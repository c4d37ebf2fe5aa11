// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/truths/models.hpp>
#include <carom/properties/diagnosis/friction.hpp>
#include <carom/properties/diagnosis/known_case.hpp>
#include <carom/properties/diagnosis/precision.hpp>
#include <carom/properties/gate/declared_effects.hpp>

namespace carom::properties::diagnosis {
namespace {

template <class S>
BasicCollision<S> widened(const Collision& collision) {
  return map_numbers<S>(collision, [](double x) { return static_cast<S>(x); });
}

template <class S>
Outcome<S> widened(const Outcome<double>& outcome) {
  return map_outcome<S>(outcome, [](double x) { return static_cast<S>(x); });
}

Outcome<double> narrowed(const Outcome<Wide>& outcome) {
  return map_outcome<double>(outcome, [](Wide x) { return static_cast<double>(x); });
}

template <class S>
S twice_energy(const BasicBody<S>& body, const BodyVelocity<S>& motion) {
  return body.immovable ? S{0}
                        : body.mass * motion.velocity.squaredNorm() +
                              motion.angular_velocity.dot(oracles::apply_inertia(body, motion.angular_velocity));
}

template <class S>
BodyVelocity<S> difference(const BodyVelocity<S>& x, const BodyVelocity<S>& y) {
  return {x.velocity - y.velocity, x.angular_velocity - y.angular_velocity};
}

template <class S>
BodyVelocity<S> pushed_body(const BasicBody<S>& body, const Vector3<S>& point, const Vector3<S>& impulse) {
  if (body.immovable) {
    return {body.velocity, body.angular_velocity};
  }
  const Vector3<S> torque = oracles::lever_arm(body, point).cross(impulse);
  const Vector3<S> in_body = oracles::turned<S>(oracles::conjugate(body.orientation), torque);
  return {body.velocity + impulse / body.mass,
          body.angular_velocity + oracles::turned<S>(body.orientation, in_body.cwiseQuotient(body.principal_inertia))};
}

template <class T, class Nearest>
LawAnswer rounded(const oracles::Truth<T>& truth, const Nearest& nearest) {
  LawAnswer answer{map_outcome<double>(truth.outcome, nearest), {}};
  for (int i = 0; i < 3; ++i) {
    answer.impulse[i] = nearest(truth.impulse[i]);
  }
  return answer;
}

bool is_known(const oracles::Truth<oracles::Enclosure>& truth) {
  const auto of_bodies = vectors(truth.outcome);
  return std::all_of(all_outcome_vectors.begin(), all_outcome_vectors.end(), [&](OutcomeVector k) {
    return std::all_of(of_bodies[k]->begin(), of_bodies[k]->end(),
                       [](const oracles::Enclosure& x) { return std::isfinite(x.radius()); });
  });
}

std::optional<Vector3<double>> coulomb_impulse(const oracles::ExactCase& exact_case, oracles::ContactState as) {
  if (as != oracles::ContactState::colliding) {
    return Vector3<double>(Vector3<double>::Zero());
  }
  const Collision& collision = exact_case.collision();
  const bool is_known = exact_case.state() == as && exact_case.is_moderate() &&
                        oracles::growth_in_collision_matrix(collision) <= most_growth_in_wide;
  return is_known ? impulse_by(collision, Law::coulomb, {}) : std::nullopt;
}

/// The sign of N·V⁻, if rounding does not decide it.
std::optional<oracles::ContactState> clear_state(const Collision& collision) {
  if (!has_movable_body(collision)) {
    return oracles::ContactState::inert;
  }
  const auto clear = [&]<class S>(S) -> std::optional<oracles::ContactState> {
    const BasicCollision<S> c = widened<S>(collision);
    S approach = 0;
    S terms = 0;
    for (const auto* body : {&c.a, &c.b}) {
      const S sign = body == &c.a ? 1 : -1;
      const Vector3<S> arm = oracles::lever_arm(*body, c.point);
      approach += sign * c.normal.dot(body->velocity + body->angular_velocity.cross(arm));
      terms += c.normal.cwiseAbs().sum() *
               (body->velocity.cwiseAbs().sum() +
                2 * body->angular_velocity.cwiseAbs().sum() * (c.point.cwiseAbs() + body->position.cwiseAbs()).sum());
    }
    constexpr S roundings = 64;  // no sum has as many
    if (!(std::abs(approach) > roundings * std::numeric_limits<S>::epsilon() * terms)) {
      return std::nullopt;
    }
    return approach < 0 ? oracles::ContactState::colliding : oracles::ContactState::separating;
  };
  return in_sufficient_precision(clear, collision);
}

/// Whether `impulse_by` gives the impulse well enough.
bool is_quick(const Collision& collision, oracles::ContactState as) {
  return as != oracles::ContactState::colliding ||
         oracles::growth_in_collision_matrix(collision) <= most_growth_in_wide;
}

std::optional<Vector3<double>> quick_impulse(const Collision& collision, Law law, oracles::ContactState as) {
  return as == oracles::ContactState::colliding ? impulse_by(collision, law, {})
                                                : std::optional(Vector3<double>(Vector3<double>::Zero()));
}

/// The law's answer by intervals of binary64 numbers. None if they are too wide.
std::optional<LawAnswer> enclosed_answer(const oracles::ExactCase& exact_case, Law law, oracles::ContactState as) {
  const auto& enclosed = exact_case.enclosed_truth(law, as);
  return is_known(enclosed) ? std::optional(rounded(enclosed, [](const oracles::Enclosure& x) { return x.middle(); }))
                            : std::nullopt;
}

/// The impulse of the law's answer by exact arithmetic, without the check of the truth. This check takes half the time,
/// and no verdict rests on a diagnosis. Preconditions: those of `law_answer`.
Vector3<double> exact_impulse(const oracles::ExactCase& exact_case, Law law, oracles::ContactState as) {
  CAROM_EXPECTS(as == exact_case.state() || is_linear(law), law);
  if (as != oracles::ContactState::colliding) {
    return Vector3<double>::Zero();
  }
  const oracles::Branch branch = exact_case.branch(law);
  const auto impulse = [&](const auto& c) {
    const auto exact = oracles::colliding_impulse(c, law, branch);
    return Vector3<double>(oracles::nearest_double(exact[0]), oracles::nearest_double(exact[1]),
                           oracles::nearest_double(exact[2]));
  };
  return branch == oracles::Branch::on_cone ? impulse(widened<oracles::Radical>(exact_case.collision()))
                                            : impulse(exact_case.exact());
}

}  // namespace

oracles::ContactState state_of(const Collision& collision) {
  const std::optional<oracles::ContactState> clear = clear_state(collision);
  return clear ? *clear : oracles::ExactCase(collision).state();
}

bool is_linear(Law law) { return std::ranges::find(oracles::linear_laws, law) != oracles::linear_laws.end(); }

LawAnswer law_answer(const Collision& collision, Law law, std::optional<oracles::ContactState> approach) {
  CAROM_EXPECTS(determines_outcome(law), law);
  const oracles::ExactCase exact_case(collision);
  const oracles::ContactState as = approach.value_or(exact_case.state());
  if (const std::optional<LawAnswer> enclosed = enclosed_answer(exact_case, law, as)) {
    return *enclosed;
  }
  return exact_case.with_truth(law, as, [](const auto& truth) {
    return rounded(truth, [](const auto& x) { return oracles::nearest_double(x); });
  });
}

bool LawQuestion::operator==(const LawQuestion& other) const {
  bool is_same = law == other.law && approach == other.approach &&
                 collision.a.immovable == other.collision.a.immovable &&
                 collision.b.immovable == other.collision.b.immovable;
  for_each_number([&](const FieldPath&, double x, double y) { is_same = is_same && x == y; }, collision,
                  other.collision);
  return is_same;
}

std::optional<Vector3<double>> law_impulse(const Collision& collision, Law law,
                                           std::optional<oracles::ContactState> approach, Effort effort,
                                           const SlowImpulses* known) {
  if (const std::optional<oracles::ContactState> clear = clear_state(collision);
      clear && is_quick(collision, approach.value_or(*clear))) {
    return quick_impulse(collision, law, approach.value_or(*clear));
  }
  const oracles::ExactCase exact_case(collision);
  const oracles::ContactState as = approach.value_or(exact_case.state());
  if (law == Law::coulomb) {
    return coulomb_impulse(exact_case, as);
  }
  // A scalar with the unit roundoff u makes fewer than 2⁹ roundings, which grow by this factor. So the relative error
  // is below 2⁹ u · 2⁻⁵² / u = 2⁻⁴³. This is a thousandth of the least visible error.
  constexpr auto most_growth = static_cast<double>(0x1p-51L / std::numeric_limits<Wide>::epsilon());
  const double growth = oracles::growth_in_collision_matrix(collision);
  if (as != oracles::ContactState::colliding || !is_linear(law) || !exact_case.is_moderate() ||
      !(growth <= most_growth)) {
    const auto enclosed = [&]() -> std::optional<Vector3<double>> {
      const std::optional<LawAnswer> answer = enclosed_answer(exact_case, law, as);
      return answer ? std::optional(answer->impulse) : std::nullopt;
    };
    if (effort == Effort::without_rationals) {
      return enclosed();
    }
    const auto impulse = [&] {
      const std::optional<Vector3<double>> by_bounds = enclosed();
      return by_bounds ? *by_bounds : exact_impulse(exact_case, law, as);
    };
    return known == nullptr ? impulse() : known->get({collision, law, as}, impulse);
  }
  const oracles::Truth<Wide> truth = oracles::colliding_truth(widened<Wide>(collision), law, oracles::Branch::only);
  return truth.impulse.cast<double>();
}

std::optional<KnownCase> known_case(const ViolatedCase& violated, Law law) {
  const Collision& collision = violated.one.collision;
  const auto* outcome = std::get_if<ReportedOutcome>(&violated.answer);
  if (outcome == nullptr || !oracles::is_finite(*outcome) || !validate(collision).empty()) {
    return std::nullopt;
  }
  return known_case(collision, narrowed(*outcome), law);
}

std::optional<KnownCase> known_case(const Collision& collision, const Outcome<double>& answered, Law law) {
  std::optional<LawAnswer> answer;
  const std::optional<oracles::ContactState> clear = clear_state(collision);
  const oracles::ContactState state = clear ? *clear : oracles::ExactCase(collision).state();
  if (law == Law::coulomb || (law != Law::any && clear && is_quick(collision, state))) {
    if (const auto impulse = law_impulse(collision, law, state)) {
      answer = {pushed(collision, *impulse), *impulse};
    }
  } else if (determines_outcome(law)) {
    answer = law_answer(collision, law, state);
  }
  if (!answer) {
    return std::nullopt;
  }
  return KnownCase{collision, law, state, unchanged(collision), answered, answer->outcome, answer->impulse};
}

double energy_product(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y) {
  const auto product = [&]<class S>(S) {
    const auto of_body = [](const BasicBody<S>& body, const BodyVelocity<S>& one, const BodyVelocity<S>& other) {
      return body.immovable ? S{0}
                            : body.mass * one.velocity.dot(other.velocity) +
                                  one.angular_velocity.dot(oracles::apply_inertia(body, other.angular_velocity));
    };
    const BasicCollision<S> c = widened<S>(collision);
    const Outcome<S> one = widened<S>(x);
    const Outcome<S> other = widened<S>(y);
    return static_cast<double>(of_body(c.a, one.a, other.a) + of_body(c.b, one.b, other.b));
  };
  return in_sufficient_precision(product, collision, x, y);
}

double energy_distance(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y) {
  const auto distance = [&]<class S>(S) {
    const BasicCollision<S> c = widened<S>(collision);
    const Outcome<S> one = widened<S>(x);
    const Outcome<S> other = widened<S>(y);
    return static_cast<double>(
        std::sqrt(twice_energy(c.a, difference(one.a, other.a)) + twice_energy(c.b, difference(one.b, other.b))));
  };
  return in_sufficient_precision(distance, collision, x, y);
}

bool is_explained_by(const Outcome<double>& outcome, const KnownCase& one) {
  // A limit of the outcome may also change the velocity of an immovable body.
  const auto agree_if_immovable = [](const Body& body, const BodyVelocity<double>& x, const BodyVelocity<double>& y) {
    constexpr double rounding = 0x1p-40;
    const auto agree = [&](const Vector3<double>& given, const Vector3<double>& one_of, const Vector3<double>& other) {
      return one_of == other || (one_of != given && (one_of - other).stableNorm() <= rounding * other.stableNorm());
    };
    return !body.immovable || (agree(body.velocity, x.velocity, y.velocity) &&
                               agree(body.angular_velocity, x.angular_velocity, y.angular_velocity));
  };
  if (!agree_if_immovable(one.collision.a, outcome.a, one.answered.a) ||
      !agree_if_immovable(one.collision.b, outcome.b, one.answered.b)) {
    return false;
  }
  return energy_distance(one.collision, outcome, one.answered) <= (one.tolerance ? *one.tolerance : tolerance_of(one));
}

double tolerance_of(const KnownCase& one) {
  constexpr double small_share = 0x1p-10;  // rounding is less than this share of a visible error
  const double error = energy_distance(one.collision, one.truth, one.answered);
  return std::max(one.near, std::min(one.most_distant, small_share * error));
}

bool is_visibly_off(const KnownCase& one, double unit_roundoff) {
  constexpr double far_above_rounding = 0x1p20;
  const Outcome<double> still;
  const double size =
      energy_distance(one.collision, one.before, still) + energy_distance(one.collision, one.truth, still);
  constexpr double far_above_near = 4;
  return energy_distance(one.collision, one.truth, one.answered) >
         std::max(far_above_near * one.near, far_above_rounding * unit_roundoff * size);
}

double rounding_distance(const KnownCase& one, double unit_roundoff) {
  constexpr double roundings = 0x1p10;  // of a solver, and of its steps that are computed here
  const Collision& c = one.collision;
  double of_arms = 1;
  for (const Body* body : {&c.a, &c.b}) {
    const double arm = (c.point - body->position).stableNorm();
    const double length = oracles::length_of_lever_arm(*body, c.point);
    of_arms = std::max(of_arms, arm > 0 ? length / arm : 1);
  }
  const Outcome<double> still;
  const double size = energy_distance(c, one.before, still) + energy_distance(c, one.truth, still) +
                      energy_distance(c, one.answered, still);
  const double growth = has_movable_body(c) ? oracles::growth_in_collision_matrix(c) : 1;
  return roundings * unit_roundoff * of_arms * growth * size;
}

Outcome<double> pushed(const Collision& collision, const Vector3<double>& impulse) {
  const auto outcome = [&]<class S>(S) {
    const BasicCollision<S> c = widened<S>(collision);
    const Vector3<S>& f = impulse.cast<S>();
    const Outcome<S> after{pushed_body(c.a, c.point, f), pushed_body(c.b, c.point, Vector3<S>(-f))};
    return map_outcome<double>(after, [](S x) { return static_cast<double>(x); });
  };
  Outcome<double> sizes;  // whose numbers decide the scalar
  sizes.a.velocity = impulse;
  return in_sufficient_precision(outcome, collision, sizes);
}

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
