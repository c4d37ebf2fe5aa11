// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/impulse/reflection.hpp>
#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/laws/equations.hpp>

#include "support/exact.hpp"

/// Findings about the note (D. Eberly, "Computing Impulse Forces for Colliding Contact"), on exact numbers.
namespace carom {
namespace {

using unit::ExactMatrix;
using unit::ExactVector;
using unit::ratio;
using unit::Rational;
using unit::same;

/// Two unit masses without spin, with centres on the normal. A approaches the resting B at speed 1, ε = 1.
BasicCollision<Rational> newtons_cradle() {
  BasicCollision<Rational> c;
  c.a.position = {0, 1, 0};
  c.b.position = {0, -1, 0};
  c.a.velocity = {0, -1, 0};
  return c;
}

/// Eq. 9 and 13 reverse the normal velocity of each body separately: N·v⁺ = −ε N·v⁻. If they were right, the resting B
/// would stay at rest. But B takes over the velocity of A. Only eq. 17, the difference of eq. 9 and 13, is right.
TEST(Note, IsWrongThatEachBodyReversesItsOwnNormalVelocity) {
  const auto c = newtons_cradle();
  const auto contact = impulse::make_contact<Rational>(c);
  const Outcome<Rational> after = impulse::reflection<impulse::Ldlt>(contact);
  EXPECT_TRUE(same(after.a.velocity, ExactVector(0, 0, 0)));
  EXPECT_TRUE(same(after.b.velocity, ExactVector(0, -1, 0)));
  const Rational minus_epsilon = -c.restitution;
  EXPECT_NE(c.normal.dot(after.a.velocity), minus_epsilon * c.normal.dot(c.a.velocity));  // eq. 9
  EXPECT_NE(c.normal.dot(after.b.velocity), minus_epsilon * c.normal.dot(c.b.velocity));  // eq. 13
  const auto sides = oracles::equation::Restitution{}(c, after);                          // eq. 17
  EXPECT_EQ(sides.left[0], sides.right[0]);
}

/// The matrix that the note calls Q, with Q y = r × y.
ExactMatrix cross_matrix(const ExactVector& r) {
  ExactMatrix q;
  q << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return q;
}

/// The note says "yᵀQy ≥ 0, so Q is positive semidefinite". This proves nothing: Q is skew-symmetric, so yᵀQy = 0 for
/// every y.
TEST(Note, IsWrongThatTheSkewMatrixIsSemidefinite) {
  properties::Stream stream = properties::stream_from(3);
  for (int i = 0; i < 500; ++i) {
    const ExactMatrix q = cross_matrix(unit::exact_eighths3(stream, 50));
    const ExactVector y = unit::exact_eighths3(stream, 50);
    EXPECT_EQ(y.dot(ExactVector(q * y)), 0);
    EXPECT_TRUE(same(ExactMatrix(q.transpose()), ExactMatrix(-q)));
  }
}

/// QᵀJ⁻¹Q is semidefinite, because J⁻¹ is definite. QᵀJ⁻¹Q r = 0.
TEST(Note, IsRightThatTheAngularPartOfTheCollisionMatrixIsSemidefinite) {
  properties::Stream stream = properties::stream_from(4);
  for (int i = 0; i < 200; ++i) {
    const auto contact = unit::exact_contact(unit::small_collision(stream));
    const auto& [axes, inverse_moments] = contact.a.inertia;
    const ExactMatrix q = cross_matrix(contact.a.lever_arm);
    const ExactMatrix part = q.transpose() * (axes * inverse_moments.asDiagonal() * axes.transpose()) * q;
    EXPECT_TRUE(oracles::is_positive_semidefinite(part));
    EXPECT_FALSE(oracles::is_positive_definite(part));
    EXPECT_TRUE(same(part * contact.a.lever_arm, ExactVector(0, 0, 0)));
    EXPECT_TRUE(oracles::is_positive_definite(ExactMatrix(part + ExactMatrix::Identity() * contact.a.inverse_mass)));
  }
}

/// The note says "λI is positive definite", with λ = 1/m_A + 1/m_B. This holds only if a body is movable.
TEST(Note, NeedsAMovableBodyForADefiniteCollisionMatrix) {
  auto c = newtons_cradle();
  c.a.immovable = true;
  EXPECT_TRUE(oracles::is_positive_definite(impulse::collision_matrix(impulse::make_contact<Rational>(c))));
  c.b.immovable = true;
  const ExactMatrix k = impulse::collision_matrix(impulse::make_contact<Rational>(c));
  EXPECT_TRUE(same(k, ExactMatrix(ExactMatrix::Zero())));
  EXPECT_FALSE(oracles::is_positive_definite(k));
}

/// λI ⪯ K. Both sides are equal if both centres of mass are at the contact point.
TEST(Note, IsRightThatTheCollisionMatrixIsDefiniteWithTheMarginLambda) {
  int sharp = 0;
  for (const auto& [family, one] : unit::valid_cases(4)) {
    const oracles::ExactCase exact_case(one.collision);
    const Rational lambda = oracles::inverse_mass(exact_case.exact());
    EXPECT_TRUE(oracles::is_at_least(exact_case.collision_matrix(), lambda)) << family;
    EXPECT_TRUE(exact_case.is_definite()) << family;
    if (one.collision.point == one.collision.a.position && one.collision.point == one.collision.b.position) {
      EXPECT_FALSE(oracles::is_at_least(exact_case.collision_matrix(), lambda * ratio(1000001, 1000000))) << family;
      ++sharp;
    }
  }
  EXPECT_GT(sharp, 0);
}

}  // namespace
}  // namespace carom
