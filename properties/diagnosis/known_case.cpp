// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/models/models.hpp>
#include <carom/oracles/models/sensitivity.hpp>
#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {
namespace {

// The range of Wide holds the squares of all binary64 numbers.
using Wide = long double;

BasicCollision<Wide> widened(const Collision& collision) {
  return map_numbers<Wide>(collision, [](double x) { return static_cast<Wide>(x); });
}

Outcome<Wide> widened(const Outcome<double>& outcome) {
  return map_outcome<Wide>(outcome, [](double x) { return static_cast<Wide>(x); });
}

Outcome<double> narrowed(const Outcome<Wide>& outcome) {
  return map_outcome<double>(outcome, [](Wide x) { return static_cast<double>(x); });
}

Wide twice_energy(const BasicBody<Wide>& body, const BodyVelocity<Wide>& motion) {
  return body.immovable ? 0
                        : body.mass * motion.velocity.squaredNorm() +
                              motion.angular_velocity.dot(oracles::apply_inertia(body, motion.angular_velocity));
}

BodyVelocity<Wide> difference(const BodyVelocity<Wide>& x, const BodyVelocity<Wide>& y) {
  return {x.velocity - y.velocity, x.angular_velocity - y.angular_velocity};
}

BodyVelocity<Wide> pushed_body(const BasicBody<Wide>& body, const Vector3<Wide>& point, const Vector3<Wide>& impulse) {
  if (body.immovable) {
    return {body.velocity, body.angular_velocity};
  }
  const Vector3<Wide> torque = oracles::lever_arm(body, point).cross(impulse);
  const Vector3<Wide> in_body = oracles::turned<Wide>(oracles::conjugate(body.orientation), torque);
  return {
      body.velocity + impulse / body.mass,
      body.angular_velocity + oracles::turned<Wide>(body.orientation, in_body.cwiseQuotient(body.principal_inertia))};
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

}  // namespace

LawAnswer law_answer(const Collision& collision, Law law, std::optional<oracles::Approach> approach) {
  CAROM_EXPECTS(determines_outcome(law), law);
  const oracles::ExactCase exact_case(collision);
  const oracles::Approach as = approach.value_or(exact_case.approach());
  if (const auto& enclosed = exact_case.enclosed_truth(law, as); is_known(enclosed)) {
    return rounded(enclosed, [](const oracles::Enclosure& x) { return x.middle(); });
  }
  return exact_case.with_truth(law, as, [](const auto& truth) {
    return rounded(truth, [](const auto& x) { return oracles::nearest_double(x); });
  });
}

Vector3<double> law_impulse(const Collision& collision, Law law, std::optional<oracles::Approach> approach) {
  const oracles::ExactCase exact_case(collision);
  const oracles::Approach as = approach.value_or(exact_case.approach());
  // `Wide` makes fewer than 2⁹ roundings of 2⁻⁶⁴, which grow by this factor. So the relative error is below 2⁻⁴³. This
  // is a thousandth of the least visible error.
  constexpr double largest_growth = 0x1p+12;
  const bool is_linear = std::ranges::find(oracles::linear_laws, law) != oracles::linear_laws.end();
  if (as != oracles::Approach::colliding || !is_linear || !exact_case.bounds().is_moderate() ||
      oracles::growth_in_collision_matrix(collision) > largest_growth) {
    return law_answer(collision, law, as).impulse;
  }
  const oracles::Truth<Wide> truth = oracles::colliding_truth(widened(collision), law, oracles::Branch::only);
  return truth.impulse.cast<double>();
}

std::optional<KnownCase> known_case(const ViolatedCase& violated, Law law) {
  const Collision& collision = violated.one.collision;
  const auto* outcome = std::get_if<ReportedOutcome>(&violated.answer);
  if (outcome == nullptr || !oracles::is_finite(*outcome) || !determines_outcome(law) || !validate(collision).empty()) {
    return std::nullopt;
  }
  return known_case(collision, narrowed(*outcome), law);
}

KnownCase known_case(const Collision& collision, const Outcome<double>& answered, Law law) {
  const LawAnswer answer = law_answer(collision, law);
  return {collision,      law,           oracles::ExactCase(collision).approach(), unchanged(collision), answered,
          answer.outcome, answer.impulse};
}

double energy_product(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y) {
  const BasicCollision<Wide> c = widened(collision);
  const auto of_body = [](const BasicBody<Wide>& body, const BodyVelocity<Wide>& one, const BodyVelocity<Wide>& other) {
    return body.immovable ? Wide{0}
                          : body.mass * one.velocity.dot(other.velocity) +
                                one.angular_velocity.dot(oracles::apply_inertia(body, other.angular_velocity));
  };
  const Outcome<Wide> one = widened(x);
  const Outcome<Wide> other = widened(y);
  return static_cast<double>(of_body(c.a, one.a, other.a) + of_body(c.b, one.b, other.b));
}

double energy_distance(const Collision& collision, const Outcome<double>& x, const Outcome<double>& y) {
  const BasicCollision<Wide> c = widened(collision);
  const Outcome<Wide> one = widened(x);
  const Outcome<Wide> other = widened(y);
  return static_cast<double>(
      std::sqrt(twice_energy(c.a, difference(one.a, other.a)) + twice_energy(c.b, difference(one.b, other.b))));
}

bool is_explained_by(const Outcome<double>& outcome, const KnownCase& one) {
  const auto agree_if_immovable = [](const Body& body, const BodyVelocity<double>& x, const BodyVelocity<double>& y) {
    return !body.immovable || (x.velocity == y.velocity && x.angular_velocity == y.angular_velocity);
  };
  if (!agree_if_immovable(one.collision.a, outcome.a, one.answered.a) ||
      !agree_if_immovable(one.collision.b, outcome.b, one.answered.b)) {
    return false;
  }
  constexpr double small_share = 0x1p-10;  // rounding is less than this share of a visible error
  return energy_distance(one.collision, outcome, one.answered) <=
         small_share * energy_distance(one.collision, one.truth, one.answered);
}

bool is_visibly_off(const KnownCase& one, double unit_roundoff) {
  constexpr double far_above_rounding = 0x1p20;
  const Outcome<double> still;
  const double size =
      energy_distance(one.collision, one.before, still) + energy_distance(one.collision, one.truth, still);
  return energy_distance(one.collision, one.truth, one.answered) > far_above_rounding * unit_roundoff * size;
}

Outcome<double> pushed(const Collision& collision, const Vector3<double>& impulse) {
  const BasicCollision<Wide> c = widened(collision);
  const Vector3<Wide> f = impulse.cast<Wide>();
  return narrowed({pushed_body(c.a, c.point, f), pushed_body(c.b, c.point, -f)});
}

}  // namespace carom::properties::diagnosis
