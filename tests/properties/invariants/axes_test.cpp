// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include <carom/properties/gate/trial.hpp>

#include "support/cases.hpp"
#include "support/exact.hpp"
#include "support/known_collisions.hpp"

/// A verdict stays the same if the collision and its outcome are rotated together.
namespace carom::properties {
namespace {

using oracles::LiftedOutcome;
using oracles::Rational;
using Solved = SolvedOutcome<Rational>;

/// Rotates by a quaternion q of integers. With s = ‖q‖² and the rotation matrix R, s R has integer entries. So s R
/// rotates vectors of few bits without rounding. The factor s changes the units to 1/s metres and s seconds.
struct WholeTurn {
  Quaternion<double> q;

  [[nodiscard]] double squared() const { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

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

  [[nodiscard]] Solved operator()(const Solved& y) const {
    const Rational s(squared());
    return {Outcome<Rational>{{(*this)(y.a.velocity) * s, (*this)(y.a.angular_velocity)},
                              {(*this)(y.b.velocity) * s, (*this)(y.b.angular_velocity)}},
            (*this)(*y.collision_matrix)};
  }

  /// R C Rᵀ. The collision matrix C is in 1/kg, so s does not scale it.
  [[nodiscard]] Matrix3<Rational> operator()(const Matrix3<Rational>& matrix) const {
    Matrix3<Rational> half;  // s R C
    for (int k = 0; k < 3; ++k) {
      half.col(k) = (*this)(Vector3<Rational>(matrix.col(k)));
    }
    Matrix3<Rational> turned;  // s² R C Rᵀ, whose rows are s² R (R C)ᵀ
    for (int k = 0; k < 3; ++k) {
      turned.row(k) = (*this)(Vector3<Rational>(half.row(k))).transpose();
    }
    return turned / Rational(squared() * squared());
  }
};

/// A collision of few bits with zero components, sometimes so far from the origin that binary32 barely resolves it.
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
  c.friction = stream.chance(2) ? 0.25 : 1;
  if (stream.chance(3)) {
    const double far = std::ldexp(1.0, stream.integer(8, 18));
    for (Vector3<double>* place : {&c.a.position, &c.b.position, &c.point}) {
      (*place)[0] += far;
    }
  }
  return c;
}

Claim claim_of_outcome(Law law, Precision precision) {
  Subject subject;
  subject.law = law;
  subject.precision = precision;
  subject.shows_collision_matrix = true;
  Claim claim = claim_of(subject, {});
  std::erase_if(claim.invariants, [](const Invariant* one) {
    return !std::holds_alternative<AboutOutcome>(one->about) && !std::holds_alternative<AboutMatrix>(one->about);
  });
  return claim;
}

/// `coulomb` has no sensitivity. If the contact sticks, the outcomes of `coulomb` and `sticking` are equal.
Law like(Law law) { return law == Law::coulomb ? Law::sticking : law; }

/// Let off = `share` · `allowance` · ‖C‖ and λ = 1/m_A + 1/m_B. The result is either C with off added to one entry, or
/// λI − t n nᵀ with a unit vector n and off ≤ t ≤ 64 off. The second error is near the permitted error of `definite`.
Matrix3<Rational> planted_matrix(Stream& stream, const Collision& c, double allowance, double share) {
  Matrix3<Rational> matrix = impulse::collision_matrix(unit::exact_contact(c));
  const double off =
      share * allowance * matrix.unaryExpr([](const Rational& x) { return oracles::to_double(x); }).norm();
  if (stream.chance(2)) {
    matrix(stream.integer(0, 2), stream.integer(0, 2)) += Rational(off);
    return matrix;
  }
  Rational inverse_mass(0);
  for (const Body* body : {&c.a, &c.b}) {
    inverse_mass += body->immovable ? Rational(0) : Rational(1) / Rational(body->mass);
  }
  const Vector3<Rational> n = stream.direction().unaryExpr([](double x) { return Rational(x); });
  const Matrix3<Rational> along =
      n * n.transpose() * Rational(Rational(std::ldexp(off, stream.integer(0, 6))) / n.dot(n));
  return Matrix3<Rational>::Identity() * inverse_mass - along;
}

/// The exact outcome with `share` of the permitted error in one of its vectors, and a `planted_matrix`.
Solved planted(Stream& stream, const oracles::ExactCase& exact_case, Law law, double allowance, double share) {
  Outcome<Rational> outcome = unit::outcome_of_law(exact_case, law);
  const OutcomeVector k = all_outcome_vectors[static_cast<std::size_t>(stream.integer(0, 3))];
  const Vector3<double> direction = stream.direction();
  const double size = share * allowance * exact_case.sensitivity(like(law), allowance)[k] / direction.norm();
  *vectors(outcome)[k] += direction.unaryExpr([&](double x) { return Rational(x * size); });
  return {outcome, planted_matrix(stream, exact_case.collision(), allowance, share)};
}

Judgement judged(const Collision& collision, const Claim& claim, const Solved& outcome) {
  return try_case(JudgedCase({collision, false}), claim,
                  [&](const Collision&) -> ExactAnswer { return LiftedOutcome(outcome); });
}

/// Permitted residuals are rounded, so a residual close to its permitted residual may pass or fail.
bool is_at_the_limit(const Verdict& verdict) {
  return verdict.status == Status::violated && std::abs(verdict.residual / verdict.allowed - 1) < 0x1p-20;
}

void expect_the_same(const Judgement& one, const Judgement& other, Law law, double share) {
  ASSERT_EQ(one.unjudged, other.unjudged);
  ASSERT_EQ(one.verdicts.size(), other.verdicts.size());
  for (std::size_t i = 0; i < one.verdicts.size(); ++i) {
    const Verdict& here = one.verdicts[i].verdict;
    const Verdict& there = other.verdicts[i].verdict;
    EXPECT_TRUE(here.status == there.status || is_at_the_limit(here) || is_at_the_limit(there))
        << one.verdicts[i].invariant->name << " of " << name_of(law) << ", off by " << share << ": " << here.detail
        << there.detail << ' ' << here.residual << " of " << here.allowed << ", " << there.residual << " of "
        << there.allowed;
  }
}

TEST(Verdicts, AreTheSameWhenACollisionIsTurned) {
  Stream stream = stream_from(51);
  std::map<std::pair<std::string_view, Status>, std::size_t> seen;
  for (int i = 0; i < unit::effort(180); ++i) {
    const Collision c = few_bits(stream);
    WholeTurn turn{{0, 0, 0, 0}};
    for (int j = 0; j < 4; ++j) {
      turn.q[j] = stream.integer(-3, 3);
    }
    turn.q[0] += turn.squared() == 0 ? 1 : 0;
    const Collision turned = turn(c);
    const JudgedCase original({c, false});
    for (const Law law : {Law::frictionless, Law::reflection, Law::sticking, Law::rough, Law::coulomb}) {
      const Claim claim = claim_of_outcome(law, i % 2 == 0 ? Precision::binary32 : Precision::binary64);
      for (const double share : {0.5, 0.75, 0.99, 1.01, 1.5, 2.0}) {
        const Solved outcome = planted(stream, original.exact(), law, claim.yardstick.allowance(), share);
        const Judgement here = judged(c, claim, outcome);
        expect_the_same(here, judged(turned, claim, turn(outcome)), law, share);
        for (const NamedVerdict& named : here.verdicts) {
          ++seen[{named.invariant->name, named.verdict.status}];
        }
      }
    }
  }
  std::map<Status, std::size_t> sum;
  for (const auto& [key, count] : seen) {
    sum[key.second] += count;
  }
  const auto share_of = [](int full) { return static_cast<std::size_t>(unit::effort(full)); };
  EXPECT_GT(sum[Status::holds], share_of(2000));
  EXPECT_GT(sum[Status::violated], share_of(2000));
  for (const char* invariant : {"backward_error", "linear_momentum", "angular_momentum", "restitution", "sticks",
                                "slip_opposed", "friction_cone", "energy", "definite", "matrix_used"}) {
    EXPECT_GT((seen[{invariant, Status::holds}]), share_of(60)) << invariant;
    EXPECT_GT((seen[{invariant, Status::violated}]), share_of(60)) << invariant;
  }
}

/// If a solver rotates torques into the body frame and back, an impulse along an axis causes a small spin by rounding.
/// This error passes, although the exact spin is zero.
TEST(Verdicts, AllowRoundingAcrossAnAxis) {
  Collision c = unit::ball_on_a_plane(0.4, 0);
  c.a.velocity = {0, -4, 0};
  Claim claim = claim_of_outcome(Law::frictionless, Precision::binary32);
  std::erase_if(claim.invariants, [](const Invariant* one) { return one->is_of_matrix(); });  // no matrix is shown
  const JudgedCase original({c, false});
  Solved outcome = original.exact().truth(Law::frictionless).outcome;
  outcome.a.angular_velocity[0] += Rational(0x1p-24);  // an ulp of v / r
  for (const NamedVerdict& named : judged(c, claim, outcome).verdicts) {
    EXPECT_NE(named.verdict.status, Status::violated) << named.invariant->name;
  }
}

}  // namespace
}  // namespace carom::properties
