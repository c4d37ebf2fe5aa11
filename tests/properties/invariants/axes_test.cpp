// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include <carom/properties/trial/trial.hpp>

#include "support/exact.hpp"

/// A law of mechanics knows no axes, and no verdict does: it is the same for a collision and its outcome turned
/// together.
namespace carom::properties {
namespace {

using oracles::LiftedOutcome;
using oracles::Rational;

/// A rotation by a quaternion q of whole numbers. With s = ‖q‖² the matrix s R has whole numbers too, so that vectors
/// of few bits are turned without rounding, and lengthened by s. That is undone by units: lengths are s times as many
/// metres, times 1/s as many seconds.
struct WholeTurn {
  Quaternion<double> q;

  [[nodiscard]] double squared() const { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

  /// s R v.
  template <class T>
  [[nodiscard]] Vector3<T> operator()(const Vector3<T>& v) const {
    const Vector3<T> turned = oracles::turned<T>(q.unaryExpr([](double x) { return T(x); }), v);
    return turned * T(squared());
  }

  [[nodiscard]] Collision operator()(const Collision& collision) const {
    const double s = squared();
    Collision c = collision;
    const auto exactly = [&](const Vector3<double>& v) {
      const Vector3<Rational> turned = (*this)(Vector3<Rational>(v.unaryExpr([](double x) { return Rational(x); })));
      return Vector3<double>(turned.unaryExpr([](const Rational& x) { return oracles::to_double(x); }));
    };
    for (Body* body : {&c.a, &c.b}) {
      body->position = exactly(body->position);
      body->velocity = exactly(body->velocity) * s;
      body->angular_velocity = exactly(body->angular_velocity);
      body->principal_inertia *= s * s;
      const Quaternion<double> p = body->orientation;
      const Vector3<double> u = q.tail<3>();
      const Vector3<double> w = p.tail<3>();
      body->orientation[0] = q[0] * p[0] - u.dot(w);
      body->orientation.tail<3>() = q[0] * w + p[0] * u + u.cross(w);
    }
    c.point = exactly(c.point);
    c.normal = exactly(c.normal);
    return c;
  }

  [[nodiscard]] Outcome<Rational> operator()(const Outcome<Rational>& y) const {
    const Rational s(squared());
    return {{(*this)(y.a.velocity) * s, (*this)(y.a.angular_velocity)},
            {(*this)(y.b.velocity) * s, (*this)(y.b.angular_velocity)}};
  }
};

/// Of few bits, with components that are zero, and at times as far away as binary32 can tell.
Collision few_bits(Stream& stream) {
  Collision c = unit::small_collision(stream);
  for (Vector3<double>* v : {&c.normal, &c.a.velocity, &c.b.velocity, &c.a.angular_velocity, &c.b.angular_velocity}) {
    if (stream.chance(3)) {
      (*v)[stream.integer(0, 2)] = 0;
    }
  }
  if (c.normal == Vector3<double>::Zero()) {
    c.normal[1] = 1;
  }
  if (stream.chance(3)) {
    const double far = std::ldexp(1.0, stream.integer(8, 18));
    for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
      (*place)[0] += far;
    }
  }
  return c;
}

Claim claim_of_outcome(Model model) {
  Subject subject;
  subject.model = model;
  subject.precision = Precision::binary32;
  Claim claim = claim_of(subject, {});
  std::erase_if(claim.invariants,
                [](const Invariant* one) { return !std::holds_alternative<AboutOutcome>(one->about); });
  return claim;
}

/// The truth, off by `share` of what is allowed in one of its vectors.
Outcome<Rational> planted(Stream& stream, const oracles::ExactCase& exact_case, Model model, double allowance,
                          double share) {
  Outcome<Rational> outcome = exact_case.truth(model).outcome;
  const OutcomeVector k = all_outcome_vectors[static_cast<std::size_t>(stream.integer(0, 3))];
  const Vector3<double> direction = stream.direction();
  const double size = share * allowance * exact_case.sensitivity(model, allowance)[k] / direction.norm();
  *vectors(outcome)[k] += direction.unaryExpr([&](double x) { return Rational(x * size); });
  return outcome;
}

Judgement judged(const Collision& collision, const Claim& claim, const Outcome<Rational>& outcome) {
  return try_case(JudgedCase({collision, false}), claim,
                  [&](const Collision&) -> ExactAnswer { return LiftedOutcome(outcome); });
}

/// Allowances are rounded, and what they are compared with may lie as near as that to the limit.
bool is_at_the_limit(const Verdict& verdict) {
  return verdict.status == Status::violated && std::abs(verdict.residual / verdict.allowed - 1) < 0x1p-20;
}

void expect_the_same(const Judgement& one, const Judgement& other, Model model, double share) {
  ASSERT_EQ(one.unjudged, other.unjudged);
  ASSERT_EQ(one.verdicts.size(), other.verdicts.size());
  for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
    const Verdict& here = one.verdicts[i].verdict;
    const Verdict& there = other.verdicts[i].verdict;
    EXPECT_TRUE(here.status == there.status || is_at_the_limit(here) || is_at_the_limit(there))
        << one.verdicts[i].invariant->name << " of " << name_of(model) << ", off by " << share << ": " << here.detail
        << there.detail << ' ' << here.residual << " of " << here.allowed << ", " << there.residual << " of "
        << there.allowed;
  }
}

TEST(Verdicts, AreTheSameWhenACollisionIsTurned) {
  Stream stream = stream_from(51);
  std::size_t violated = 0;
  std::size_t held = 0;
  for (int i = 0; i < 300; ++i) {
    const Collision c = few_bits(stream);
    WholeTurn turn{{0, 0, 0, 0}};
    for (int j = 0; j < 4; ++j) {
      turn.q[j] = stream.integer(-3, 3);
    }
    turn.q[0] += turn.squared() == 0 ? 1 : 0;
    const Collision turned = turn(c);
    const JudgedCase original({c, false});
    for (const Model model : {Model::frictionless, Model::reflection, Model::sticking}) {
      const Claim claim = claim_of_outcome(model);
      for (const double share : {0.5, 0.75, 0.99, 1.01, 1.5, 2.0}) {
        const Outcome<Rational> outcome = planted(stream, original.exact(), model, claim.yardstick.allowance(), share);
        const Judgement here = judged(c, claim, outcome);
        expect_the_same(here, judged(turned, claim, turn(outcome)), model, share);
        for (const NamedVerdict& named : here.verdicts) {
          violated += named.verdict.status == Status::violated ? 1 : 0;
          held += named.verdict.status == Status::holds ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(violated, 2000U);
  EXPECT_GT(held, 2000U);
}

/// A blow along an axis and the same blow along none: an answer with the rounding of a turn into the body's axes passes
/// both, though no component of the input but one is other than zero.
TEST(Verdicts, AllowRoundingAcrossAnAxis) {
  Collision c = unit::ball_on_a_plane(0.4, 0);
  c.a.velocity = {0, -4, 0};
  const Claim claim = claim_of_outcome(Model::frictionless);
  const JudgedCase original({c, false});
  Outcome<Rational> outcome = original.exact().truth(Model::frictionless).outcome;
  outcome.a.angular_velocity[0] += Rational(0x1p-24);  // an ulp of v / r
  for (const NamedVerdict& named : judged(c, claim, outcome).verdicts) {
    EXPECT_NE(named.verdict.status, Status::violated) << named.invariant->name;
  }
}

}  // namespace
}  // namespace carom::properties
