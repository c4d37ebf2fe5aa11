// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <carom/impulse/coulomb.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/coulomb.hpp>

#include "support/exact.hpp"

namespace carom::impulse {
namespace {

/// K = diag(3, 1, 3), V⁻ = (−3, −4, 0).
Collision ball_on_a_plane(double friction) { return unit::ball_on_a_plane(0.5, friction); }

TEST(Coulomb, SticksWhereFrictionSuffices) {
  const Outcome<double> after = coulomb(make_contact<double>(ball_on_a_plane(0.25)));
  EXPECT_TRUE(after.a.velocity.isApprox(Vector3<double>(-2, 2, 0), 0x1p-50)) << after.a.velocity;
  EXPECT_TRUE(after.a.angular_velocity.isApprox(Vector3<double>(0, 0, 2), 0x1p-50)) << after.a.angular_velocity;
}

TEST(Coulomb, SlidesWhereFrictionDoesNotSuffice) {
  const Outcome<double> after = coulomb(make_contact<double>(ball_on_a_plane(0.125)));
  EXPECT_TRUE(after.a.velocity.isApprox(Vector3<double>(-2.25, 2, 0), 0x1p-50)) << after.a.velocity;
  EXPECT_TRUE(after.a.angular_velocity.isApprox(Vector3<double>(0, 0, 1.5), 0x1p-50)) << after.a.angular_velocity;
}

TEST(Coulomb, HasTheBitsOfFrictionlessWithoutFriction) {
  const auto contact = make_contact<double>(ball_on_a_plane(0));
  const Outcome<double> after = coulomb(contact);
  EXPECT_EQ(after.a.velocity, frictionless(contact).a.velocity);
  EXPECT_EQ(after.a.angular_velocity, frictionless(contact).a.angular_velocity);
}

/// λ = 1/m_A + 1/m_B is finite, but the trace of K is not.
TEST(Coulomb, EndsWhereTheTraceOverflows) {
  Collision c = ball_on_a_plane(0.125);
  c.a.mass = 1e-308;
  c.a.principal_inertia.setConstant(1e-300);
  const Outcome<double> after = coulomb(make_contact<double>(c));
  EXPECT_TRUE(std::isfinite(after.a.velocity.norm())) << after.a.velocity;
}

TEST(Coulomb, LeavesASeparatingContactUnchanged) {
  Collision c = ball_on_a_plane(0.5);
  c.a.velocity[1] = 4;
  EXPECT_EQ(coulomb(make_contact<double>(c)).a.velocity, c.a.velocity);
}

/// The outcome equals an exact answer, up to rounding. The condition number of K multiplies the rounding errors of a
/// solve. For real bodies, this number is at most 16.
TEST(Coulomb, GivesOneOfTheExactAnswers) {
  int slides = 0;
  for (const char* family : {"physical", "collinear_spheres"}) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Collision collision = unit::case_of(family, i).collision;
      if (oracles::ExactCase(collision).approach() != oracles::Approach::colliding) {
        continue;
      }
      const auto contact = make_contact<double>(collision);
      const Outcome<double> found = coulomb(contact);
      double nearest = std::numeric_limits<double>::infinity();
      for (const oracles::CoulombAnswer& answer : oracles::coulomb_answers(oracles::lift(collision))) {
        const auto exact = map_outcome<double>(answer.truth.outcome,
                                               [](const oracles::Rational& x) { return oracles::nearest_double(x); });
        // 1 rad/s counts as 1 m/s.
        double distance = 0;
        for (const OutcomeVector k : all_outcome_vectors) {
          distance = std::max(distance, (*vectors(found)[k] - *vectors(exact)[k]).norm());
        }
        nearest = std::min(nearest, distance);
        slides += answer.kind == oracles::AnswerKind::slips ? 1 : 0;
      }
      double speed = 0;
      for (const Body* body : {&collision.a, &collision.b}) {
        const double length = body->immovable ? 1 : std::sqrt(body->principal_inertia.minCoeff() / body->mass);
        speed += (body->velocity.norm() + body->angular_velocity.norm()) * std::max(1.0, 1 / length);
      }
      EXPECT_LE(nearest, 0x1p-40 * speed) << family << ' ' << i;
    }
  }
  EXPECT_GT(slides, 20);
}

}  // namespace
}  // namespace carom::impulse
