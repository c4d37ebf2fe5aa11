// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/truths/models.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/trial.hpp>

#include "support/exact.hpp"

/// Tests the promise of the yardstick (docs/reference/yardstick.md): an outcome that is exact for permitted inputs
/// passes, even in a hard case.
namespace carom::properties {
namespace {

using oracles::ExactCase;
using oracles::Rational;

/// A random unit vector of `count` components, or zero.
std::vector<double> direction(Stream& stream, std::size_t count) {
  std::vector<double> components(count);
  double squares = 0;
  for (double& x : components) {
    x = stream.signed_unit();
    squares += x * x;
  }
  const double length = squares > 0 ? std::sqrt(squares) : 1;
  for (double& x : components) {
    x /= length;
  }
  return components;
}

/// Moves each quantity by at most `share` times its length, in a random direction.
BasicCollision<Rational> perturbed(Stream& stream, const Collision& collision, double share) {
  std::vector<double> change;
  for (const oracles::Quantity& q : oracles::quantities_of(collision)) {
    for (const double x : direction(stream, q.count)) {
      change.push_back(x * share * q.length);
    }
  }
  std::size_t next = 0;
  BasicCollision<Rational> result =
      map_numbers<Rational>(collision, [&](double x) { return Rational(x) + Rational(change[next++]); });
  result.restitution = std::min(Rational(1), std::max(Rational(0), result.restitution));
  result.tangential_restitution = std::min(Rational(1), std::max(Rational(-1), result.tangential_restitution));
  return result;
}

/// An exact outcome of the law. An outcome on the cone's surface has a relative error of at most 2⁻¹²⁰.
Outcome<Rational> answer_to(const BasicCollision<Rational>& c, Law law) {
  if (!has_movable_body(c) || oracles::normal_velocity_before(c) >= 0) {
    return unchanged(c);
  }
  if (law == Law::coulomb) {
    return oracles::coulomb_answers(c).front().truth.outcome;
  }
  if (law != Law::rough || c.friction == 0) {
    return oracles::colliding_truth(c, law, oracles::Branch::only).outcome;
  }
  const auto sign = [](const Rational& x) { return std::optional<int>(oracles::sign_of(x)); };
  if (*oracles::is_inside_cone<Rational>(c, nullptr, sign)) {
    return oracles::colliding_truth(c, law, oracles::Branch::inside_cone).outcome;
  }
  const auto in_radicals = map_numbers<oracles::Radical>(c, [](const Rational& x) { return oracles::Radical(x); });
  return map_outcome<Rational>(oracles::colliding_truth(in_radicals, law, oracles::Branch::on_cone).outcome,
                               [](const oracles::Radical& x) { return oracles::approximately(x); });
}

/// Cases of a family, near and far from the origin. Far away, the rounding of a position may exceed the body's size.
std::vector<Collision> cases_of(const Family& family, int count, Stream& stream) {
  std::vector<Collision> all;
  for (int i = 0; i < count; ++i) {
    Collision c = unit::case_of(family.name, static_cast<std::uint64_t>(i)).collision;
    all.push_back(c);
    if (i % 4 == 0) {
      const Vector3<double> away = stream.direction() * stream.power_of_ten(1, 9);
      for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
        *place += away;
      }
      if (i % 8 == 0) {
        c.a.position = c.point;
      }
      all.push_back(c);
    }
  }
  return all;
}

struct Seen {
  std::size_t judged = 0;
  std::size_t blind = 0;
};

/// The share of the limit by which the quantities move. The rest covers third-order changes, and second-order changes
/// where the first order does not vanish.
constexpr double share_of_limit = 0.95;

/// The claims about one outcome of a subject with this law and precision.
Claim claims_of_one_outcome(Law law, Precision precision) {
  Subject subject;
  subject.law = law;
  subject.precision = precision;
  Claim claim = claim_of(subject, {});
  std::erase_if(claim.invariants,
                [](const Invariant* one) { return !std::holds_alternative<AboutOutcome>(one->about); });
  return claim;
}

/// Judges an exact outcome of `law` to permitted inputs, under the law and under `any`.
void expect_to_pass(const Collision& collision, Law law, Precision precision, Stream& stream, Seen& seen) {
  const JudgedCase judged({collision});
  const Claim own = claims_of_one_outcome(law, precision);
  if (reason_unjudged(judged.exact(), own.yardstick)) {
    return;
  }
  const double allowance = own.yardstick.allowance();
  const Outcome<Rational> outcome = answer_to(perturbed(stream, collision, share_of_limit * allowance), law);
  ++seen.judged;
  seen.blind += judged.exact().permitted_inputs(allowance) != nullptr ? 1 : 0;
  for (const Claim& claim : {own, claims_of_one_outcome(Law::any, precision)}) {
    const Judgement judgement =
        try_case(judged, claim, [&](const Collision&) -> ExactAnswer { return oracles::LiftedOutcome(outcome); });
    for (const NamedVerdict& named : judgement.verdicts) {
      if (named.verdict.status == Status::violated) {
        ADD_FAILURE() << named.invariant->name << ": " << named.verdict.detail << ", " << named.verdict.residual
                      << " of " << named.verdict.allowed << ", " << name_of(law) << " under " << name_of(claim.law)
                      << ", " << name_of(precision) << "\n"
                      << in_words(collision, "  ");
      }
    }
  }
}

TEST(Permitted, OutcomesOfPermittedInputsPass) {
  Stream stream = stream_from(33);
  Seen seen;
  for (const Family& family : all_families()) {
    if (!family.is_valid) {
      continue;
    }
    for (const Collision& collision : cases_of(family, unit::effort(60), stream)) {
      for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
        for (const Precision precision : {Precision::binary32, Precision::binary64}) {
          expect_to_pass(collision, law, precision, stream, seen);
        }
      }
    }
  }
  EXPECT_GT(seen.judged, 2000U);
  EXPECT_GT(seen.blind, 200U);
}

/// The collision with the friction at which its contact point just sticks, or the same collision if there is none.
Collision at_end_of_sticking(Collision c) {
  if (has_movable_body(c)) {
    const Vector3<double> n = c.normal.stableNormalized();
    const Vector3<double> f = oracles::colliding_truth(c, Law::sticking, oracles::Branch::only).impulse;
    const double friction = f.cross(n).stableNorm() / n.dot(f);
    c.friction = friction > 0 && friction < 1 ? friction : c.friction;
  }
  return c;
}

/// The answer is continuous, also where sticking ends and where the contact grazes.
TEST(Permitted, CoulombAnswersMoveByAtMostTheirSensitivity) {
  Stream stream = stream_from(34);
  int judged = 0;
  double farthest = 0;
  for (const Family& family : all_families()) {
    if (!family.is_valid) {
      continue;
    }
    for (const Collision& drawn : cases_of(family, std::max(2, unit::effort(3)), stream)) {
      const Collision c = stream.chance(2) ? at_end_of_sticking(drawn) : drawn;
      const ExactCase exact_case(c);
      const double allowance = 32 * unit_roundoff(stream.chance(2) ? Precision::binary32 : Precision::binary64);
      const auto sensitivity = oracles::has_one_coulomb_answer(exact_case, allowance)
                                   ? oracles::coulomb_sensitivity(exact_case, allowance)
                                   : std::nullopt;
      if (!sensitivity) {
        continue;
      }
      const Outcome<Rational> truth = answer_to(exact_case.exact(), Law::coulomb);
      const Outcome<Rational> moved = answer_to(perturbed(stream, c, allowance), Law::coulomb);
      const oracles::Sensitivity below = oracles::coulomb_sensitivity_below(exact_case);
      for (const OutcomeVector k : all_outcome_vectors) {
        const Vector3<Rational> change = *vectors(moved)[k] - *vectors(truth)[k];
        const double length = std::sqrt(oracles::to_double(change.dot(change)));
        EXPECT_LE(length, allowance * (*sensitivity)[k]) << family.name << ' ' << name_of(k) << '\n'
                                                         << in_words(c, "  ");
        EXPECT_LE(below[k], (*sensitivity)[k]) << family.name;
        farthest = std::max(farthest, (*sensitivity)[k] > 0 ? length / (allowance * (*sensitivity)[k]) : 0);
      }
      ++judged;
    }
  }
  EXPECT_GT(judged, 50);
  EXPECT_GT(farthest, 0.05);
  RecordProperty("judged", judged);
  RecordProperty("farthest", std::to_string(farthest));
}

/// The ball is far from the origin. The permitted error is at most 20 times the largest change of the outcome by 400
/// permitted inputs.
TEST(Permitted, ErrorsAreAtMostTwentyTimesThoseOfPermittedInputs) {
  constexpr double allowance = 32 * 0x1p-24;
  Collision c = unit::ball_on_a_plane(0.4, 0);
  const Vector3<double> away{1e5, 0, 0};
  for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
    *place += away;
  }
  const ExactCase exact_case(c);
  ASSERT_NE(exact_case.permitted_inputs(allowance), nullptr);
  const oracles::Sensitivity sensitivity = exact_case.sensitivity(Law::reflection, allowance);
  const Outcome<Rational>& truth = exact_case.truth(Law::reflection).outcome;
  Stream stream = stream_from(7);
  PerVector<double> farthest{};
  for (int i = 0; i < 400; ++i) {
    const Outcome<Rational> y = answer_to(perturbed(stream, c, allowance), Law::reflection);
    for (const OutcomeVector k : all_outcome_vectors) {
      const Vector3<Rational> change = *vectors(y)[k] - *vectors(truth)[k];
      farthest[k] = std::max(farthest[k], std::sqrt(oracles::to_double(change.dot(change))));
    }
  }
  for (const OutcomeVector k : {OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a}) {
    EXPECT_LE(farthest[k], allowance * sensitivity[k]);
    EXPECT_GE(20 * farthest[k], allowance * sensitivity[k]) << name_of(k);
  }
}

}  // namespace
}  // namespace carom::properties
