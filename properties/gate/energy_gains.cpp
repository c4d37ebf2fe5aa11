// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/properties/gate/energy_gains.hpp>

namespace carom::properties {
namespace {

using oracles::ContactState;

void keep_greater(std::optional<EnergyGain>& kept, const std::optional<EnergyGain>& other, double EnergyGain::*size) {
  const auto rank = [&](const EnergyGain& gain) { return std::pair(-(gain.*size), gain.index); };
  if (other && (!kept || rank(*other) < rank(*kept))) {
    kept = other;
  }
}

/// The velocity of the immovable body's point at the contact; zero without an immovable body.
Vector3<double> wall_velocity(const Collision& c) {
  for (const Body* body : {&c.a, &c.b}) {
    if (body->immovable) {
      return oracles::point_velocity<double>({body->velocity, body->angular_velocity},
                                             oracles::lever_arm(*body, c.point));
    }
  }
  return {0, 0, 0};
}

/// The kinetic energy before the impulse, in the frame of the wall's contact point. There, the wall does no work.
double energy_before(const Collision& c) {
  const Vector3<double> frame = wall_velocity(c);
  double energy = 0;
  for (const Body* body : {&c.a, &c.b}) {
    if (!body->immovable) {
      const Vector3<double> v = body->velocity - frame;
      energy += (body->mass * v.dot(v) +
                 body->angular_velocity.dot(oracles::apply_inertia<double>(*body, body->angular_velocity))) /
                2;
    }
  }
  return energy;
}

template <class T>
T gain_beyond_work(const BasicCollision<T>& c, const Outcome<T>& after) {
  const auto sides = oracles::equation::Energy{}(c, after);
  return sides.left[0] - sides.right[0];
}

/// A bound of the error of `gain_beyond_work` in binary64, and of the rounding of the outcome to binary64. The terms
/// are at most m (‖v⁺‖ + ‖v⁻‖)², the same for the spin with the greatest moment, and the wall's speed times
/// m (‖v⁺‖ + ‖v⁻‖). Each term has fewer than 200 roundings, and turning by a quaternion adds terms of at most 9 times
/// the result. Their product is below the factor 2¹².
double error_of_gain(const Collision& c, const Outcome<double>& after) {
  constexpr double factor = 0x1p-41;
  double wall_speed = 0;
  double terms = 0;
  for (const Body* body : {&c.a, &c.b}) {
    if (body->immovable) {
      wall_speed = oracles::norm_of(body->velocity) + oracles::norm_of(body->angular_velocity) *
                                                          oracles::norm_of(Vector3<double>(c.point - body->position));
    }
  }
  const auto add = [&](const Body& body, const BodyVelocity<double>& now) {
    if (!body.immovable) {
      const double speed = oracles::norm_of(now.velocity) + oracles::norm_of(body.velocity);
      const double spin = oracles::norm_of(now.angular_velocity) + oracles::norm_of(body.angular_velocity);
      terms += body.mass * speed * (speed + wall_speed) + body.principal_inertia.maxCoeff() * spin * spin;
    }
  };
  add(c.a, after.a);
  add(c.b, after.b);
  return factor * terms;
}

/// Whether binary64 shows that the outcome gains no energy beyond the wall's work. Outside of these limits, products
/// may lose digits to underflow, or overflow.
bool surely_gains_nothing(const oracles::ExactCase& exact_case, const oracles::LiftedOutcome& outcome) {
  constexpr double least_error = 0x1p-900;
  const Collision& c = exact_case.collision();
  if (!exact_case.is_moderate() || !outcome.is_moderate()) {
    return false;
  }
  const double error = error_of_gain(c, outcome.rounded());
  return error > least_error && std::isfinite(error) && gain_beyond_work(c, outcome.rounded()) + error <= 0;
}

/// The verdict of the invariant `energy`, if it was reached.
std::optional<bool> gains_by_verdict(const Judgement& judgement) {
  const auto found = std::find_if(judgement.verdicts.begin(), judgement.verdicts.end(),
                                  [](const NamedVerdict& named) { return named.invariant->name == "energy"; });
  if (found == judgement.verdicts.end() || found->verdict.status == Status::skipped) {
    return std::nullopt;
  }
  return found->verdict.status == Status::violated;
}

bool gains(const oracles::ExactCase& exact_case, const Claim& claim, const oracles::LiftedOutcome& outcome) {
  if (claim.yardstick.filtered() && surely_gains_nothing(exact_case, outcome)) {
    return false;
  }
  const oracles::EquationCheck check = oracles::compare(oracles::equation::Energy{}, oracles::EquationForm::at_most,
                                                        exact_case, outcome, claim.yardstick);
  return check.is_decided && !check.holds;
}

double joules_of(const oracles::ExactCase& exact_case, const oracles::LiftedOutcome& outcome) {
  const double enclosed = gain_beyond_work(exact_case.enclosed(), outcome.enclosed()).middle();
  return std::isfinite(enclosed) ? enclosed : oracles::to_double(gain_beyond_work(exact_case.exact(), outcome.exact()));
}

/// Whether the answer is one of the law: no equation of the law is violated. A deviation would hide a violation.
bool is_answer_of_law(const Claim& claim, const Judgement& judgement) {
  return claim.deviations.empty() && !std::ranges::any_of(judgement.verdicts, [](const NamedVerdict& named) {
           return named.invariant->is_of_one_answer() && named.verdict.status == Status::violated;
         });
}

/// Whether the exact outcome gains energy beyond the wall's work. If `filtered`, bounds may decide.
bool outcome_gains(const oracles::ExactCase& exact_case, const Outcome<oracles::Rational>& after, bool filtered) {
  const auto exactly = [&] { return sign_of(gain_beyond_work(exact_case.exact(), after)); };
  if (!filtered) {
    return exactly() > 0;
  }
  const auto near = map_outcome<oracles::Enclosure>(after, [](const auto& x) { return oracles::Enclosure(x); });
  const std::optional<int> sign = gain_beyond_work(exact_case.enclosed(), near).sign();
  return (sign ? *sign : exactly()) > 0;
}

/// Whether an answer of the law gains energy. Precondition: the case collides.
bool gains_by_law(const JudgedCase& judged_case, const Claim& claim, const Judgement& judgement) {
  const oracles::ExactCase& exact_case = judged_case.exact();
  switch (claim.law) {
    case Law::frictionless:
    case Law::rough:  // proved: energy.v, friction.v and driven_walls.v
    case Law::any:    // has no answer of its own
      return false;
    case Law::reflection:
    case Law::sticking:
      return gain_beyond_work(exact_case.enclosed(), exact_case.enclosed_truth(claim.law).outcome).sign() == 1;
    case Law::coulomb:
      break;
  }
  if (is_answer_of_law(claim, judgement)) {
    return true;
  }
  return std::ranges::any_of(judged_case.coulomb_answers(), [&](const oracles::CoulombAnswer& answer) {
    return outcome_gains(exact_case, answer.truth.outcome, claim.yardstick.filtered());
  });
}

}  // namespace

EnergyGains& EnergyGains::operator+=(const EnergyGains& other) {
  colliding += other.colliding;
  gaining += other.gaining;
  by_law += other.by_law;
  keep_greater(greatest, other.greatest, &EnergyGain::joules);
  keep_greater(greatest_share, other.greatest_share, &EnergyGain::share);
  return *this;
}

EnergyGains energy_gains_of(std::uint64_t index, const JudgedCase& judged_case, const Claim& claim,
                            const Answer& answer, const Judgement& judgement) {
  EnergyGains gained;
  const auto* reported = std::get_if<ReportedOutcome>(&answer);
  if (reported == nullptr || !oracles::is_finite(*reported) || !judged_case.is_valid() || judgement.unjudged ||
      !judged_case.collides()) {
    return gained;
  }
  gained.colliding = 1;
  const oracles::ExactCase& exact_case = judged_case.exact();
  // The invariant judges the answer without declared effects.
  const std::optional<bool> by_verdict =
      claim.effects == DeclaredEffects{} ? gains_by_verdict(judgement) : std::nullopt;
  if (by_verdict == false) {
    return gained;
  }
  const oracles::LiftedOutcome outcome(static_cast<const Outcome<long double>&>(*reported));
  if (!by_verdict && !gains(exact_case, claim, outcome)) {
    return gained;
  }
  const double joules = joules_of(exact_case, outcome);
  const EnergyGain gain{joules, joules / energy_before(exact_case.collision()), index};
  gained.gaining = 1;
  gained.by_law = gains_by_law(judged_case, claim, judgement) ? 1 : 0;
  gained.greatest = gain;
  if (std::isfinite(gain.share)) {
    gained.greatest_share = gain;
  }
  return gained;
}

}  // namespace carom::properties
