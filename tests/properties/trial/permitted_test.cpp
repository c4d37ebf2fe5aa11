// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include <carom/oracles/models/models.hpp>
#include <carom/oracles/numbers/quantities.hpp>
#include <carom/properties/trial/trial.hpp>

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

/// The law's exact outcome. There is none for `rough` if the impulse is not inside the friction cone, because the
/// outcome may be irrational.
std::optional<Outcome<Rational>> answer_to(const BasicCollision<Rational>& c, Law law) {
  const bool collides = oracles::normal_velocity_before(c) < 0;
  oracles::Branch branch = oracles::Branch::only;
  if (law == Law::rough && c.friction != 0) {
    const auto sign = [](const Rational& x) { return std::optional<int>(oracles::sign_of(x)); };
    if (!*oracles::is_inside_cone<Rational>(c, nullptr, sign)) {
      return std::nullopt;
    }
    branch = oracles::Branch::inside_cone;
  }
  return collides ? oracles::colliding_truth(c, law, branch).outcome : unchanged(c);
}

/// Cases near and far from the origin. Far away, the rounding of a position may exceed the body's size.
std::vector<Collision> cases(Stream& stream) {
  std::vector<Collision> all;
  for (const char* family : {"generic", "physical", "collinear_spheres", "sticking", "grazing", "driven_wall"}) {
    for (std::uint64_t i = 0; i < 12; ++i) {
      Collision c = unit::case_of(family, i).collision;
      all.push_back(c);
      const Vector3<double> away = stream.direction() * stream.power_of_ten(1, 7);
      for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
        *place += away;
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

void expect_to_pass(const Collision& collision, Law law, Precision precision, Stream& stream, Seen& seen) {
  Subject subject;
  subject.law = law;
  subject.precision = precision;
  Claim claim = claim_of(subject, {});
  std::erase_if(claim.invariants,
                [](const Invariant* one) { return !std::holds_alternative<AboutOutcome>(one->about); });
  const JudgedCase judged({collision, false});
  if (reason_unjudged(judged.exact(), claim.yardstick)) {
    return;
  }
  // The last tenth of the allowance covers second-order changes. Except in hard cases, these are at most 1/32 of the
  // first-order changes.
  constexpr double share = 0.9;
  const double allowance = claim.yardstick.allowance();
  const std::optional<Outcome<Rational>> outcome = answer_to(perturbed(stream, collision, share * allowance), law);
  if (!outcome) {
    return;
  }
  const Judgement judgement =
      try_case(judged, claim, [&](const Collision&) -> ExactAnswer { return oracles::LiftedOutcome(*outcome); });
  ++seen.judged;
  seen.blind += judged.exact().permitted_inputs(allowance) != nullptr ? 1 : 0;
  for (const NamedVerdict& named : judgement.verdicts) {
    EXPECT_NE(named.verdict.status, Status::violated)
        << named.invariant->name << ": " << named.verdict.detail << ", " << named.verdict.residual << " of "
        << named.verdict.allowed << ", " << name_of(law) << ", " << name_of(precision);
  }
}

TEST(Permitted, OutcomesOfPermittedInputsPass) {
  Stream stream = stream_from(33);
  Seen seen;
  for (const Collision& collision : cases(stream)) {
    for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough}) {
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        expect_to_pass(collision, law, precision, stream, seen);
      }
    }
  }
  EXPECT_GT(seen.judged, 500U);
  EXPECT_GT(seen.blind, 100U);
}

/// The ball is far from the origin. The permitted error is at most 20 times the largest change of the outcome by 400
/// permitted inputs.
TEST(Permitted, DistancesAreNoLargerThanTheyHaveToBe) {
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
    const auto y = answer_to(perturbed(stream, c, allowance), Law::reflection);
    for (const OutcomeVector k : all_outcome_vectors) {
      const Vector3<Rational> change = *vectors(*y)[k] - *vectors(truth)[k];
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
