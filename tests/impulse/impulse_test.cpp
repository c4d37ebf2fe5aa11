// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/world_inertia.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/truths/superposition.hpp>
#include <carom/properties/cases/body_pairs.hpp>

#include "support/exact.hpp"

/// In rational arithmetic, the solvers satisfy their laws exactly.
namespace carom::impulse {
namespace {

using unit::exact_contact;
using unit::ExactMatrix;
using unit::ExactVector;
using unit::ratio;
using unit::Rational;
using unit::same;

properties::Stream stream_of(std::uint64_t index) { return properties::stream_from(1000 + index); }

TEST(RotationMatrix, IsOrthogonalForAQuaternionOfAnyLength) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    properties::Stream stream = stream_of(i);
    Quaternion<Rational> q;
    for (int k = 0; k < 4; ++k) {
      q[k] = Rational(stream.signed_unit());
    }
    q[stream.integer(0, 3)] += 1;
    const ExactMatrix r = rotation_matrix(q);
    EXPECT_TRUE(same(ExactMatrix(r * r.transpose()), ExactMatrix::Identity()));
    const ExactVector r0 = r.col(0);
    EXPECT_EQ(r0.dot(ExactVector(r.col(1)).cross(ExactVector(r.col(2)))), 1);
    EXPECT_TRUE(same(rotation_matrix<Rational>(q * Rational(-7, 3)), r));
  }
}

TEST(RotationMatrix, TurnsAboutTheAxisByTheRightHand) {
  // A quarter turn about z: (1, 0, 0, 1)/√2 maps x to y and y to −x.
  const ExactMatrix r = rotation_matrix(Quaternion<Rational>{3, 0, 0, 3});
  EXPECT_TRUE(same(r * ExactVector(1, 0, 0), ExactVector(0, 1, 0)));
  EXPECT_TRUE(same(r * ExactVector(0, 1, 0), ExactVector(-1, 0, 0)));
}

TEST(WorldInverseInertia, IsSymmetricAndInvertsTheInertiaOfTheOracle) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const auto body = oracles::lift(unit::case_of("generic", i).collision).a;
    const ExactMatrix inverse = world_inverse_inertia(body.principal_inertia, body.orientation);
    EXPECT_TRUE(same(inverse, ExactMatrix(inverse.transpose())));
    for (int axis = 0; axis < 3; ++axis) {
      const ExactVector unit_vector = ExactMatrix::Identity().col(axis);
      EXPECT_TRUE(same(inverse * oracles::apply_inertia<Rational>(body, unit_vector), unit_vector)) << i;
    }
  }
}

TEST(PrincipalInertia, IsTheSameAsInWorldCoordinates) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const auto body = oracles::lift(unit::case_of("generic", i).collision).a;
    const auto principal = PrincipalInertia<Rational>::of(body.principal_inertia, body.orientation);
    const auto world = WorldInertia<Rational>::of(body.principal_inertia, body.orientation);
    const ExactVector& r = body.velocity;
    const ExactVector& impulse = body.angular_velocity;
    EXPECT_TRUE(same(angular_response(principal, r, impulse), angular_response(world, r, impulse))) << i;
    EXPECT_EQ(angular_part_along(principal, r, impulse), angular_part_along(world, r, impulse)) << i;
    EXPECT_TRUE(same(angular_part_of_collision_matrix(principal, r), angular_part_of_collision_matrix(world, r))) << i;
  }
}

TEST(CollisionMatrix, IsExactlySymmetricInFloatingPoint) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Matrix3<float> k = collision_matrix(make_contact<float>(unit::case_of("generic", i).collision));
    EXPECT_EQ(k, Matrix3<float>(k.transpose()));
  }
}

TEST(PrintedCollisionMatrix, EqualsTheCollisionMatrixInARationalOrthonormalBasis) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    properties::Stream stream = stream_of(i);
    const auto contact = exact_contact(unit::small_collision(stream));
    const ExactMatrix basis = rotation_matrix(Quaternion<Rational>{
        1, unit::exact_eighths(stream, 16), unit::exact_eighths(stream, 16), unit::exact_eighths(stream, 16)});
    EXPECT_TRUE(same(in_basis(collision_matrix(contact), basis), printed_collision_matrix(contact, basis))) << i;
  }
}

/// In eq. 27 of the note, the entries (2,2) and (3,3) contain 1/m_A + 1/m_B twice.
TEST(PrintedCollisionMatrix, DiffersFromTheNoteWhichCountsLambdaTwice) {
  properties::Stream stream = stream_of(0);
  const auto contact = exact_contact(unit::small_collision(stream));
  const ExactMatrix basis = rotation_matrix(Quaternion<Rational>{1, ratio(1, 2), ratio(1, 3), ratio(1, 5)});
  const Rational lambda = contact.a.inverse_mass + contact.b.inverse_mass;
  ExactMatrix as_in_the_note = printed_collision_matrix(contact, basis);
  as_in_the_note(1, 1) += lambda;
  as_in_the_note(2, 2) += lambda;
  const ExactMatrix right = in_basis(collision_matrix(contact), basis);
  EXPECT_FALSE(same(as_in_the_note, right));
  EXPECT_EQ(as_in_the_note(1, 1) - right(1, 1), lambda);
  EXPECT_EQ(as_in_the_note(2, 2) - right(2, 2), lambda);
  as_in_the_note(1, 1) -= lambda;
  as_in_the_note(2, 2) -= lambda;
  EXPECT_TRUE(same(as_in_the_note, right));
}

TEST(InBasis, IsExactlySymmetricForAnyBasis) {
  properties::Stream stream = stream_of(1);
  for (int i = 0; i < 100; ++i) {
    ExactMatrix matrix;
    ExactMatrix basis;
    matrix << unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20);
    matrix = ExactMatrix(matrix + matrix.transpose());
    basis << unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20);
    EXPECT_TRUE(same(in_basis(matrix, basis), ExactMatrix(basis.transpose() * matrix * basis)));
  }
}

template <class Solve>
class Solve3 : public testing::Test {};
using Policies = testing::Types<Ldlt, Adjugate>;
TYPED_TEST_SUITE(Solve3, Policies);

TYPED_TEST(Solve3, SolvesExactlyInAField) {
  properties::Stream stream = stream_of(2);
  for (int i = 0; i < 300; ++i) {
    ExactMatrix factor;
    factor << unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20), unit::exact_eighths3(stream, 20);
    const ExactMatrix m = factor * factor.transpose() + ExactMatrix::Identity() * ratio(1, 7);
    const ExactVector b = unit::exact_eighths3(stream, 20);
    const ExactVector x = TypeParam::template solve<Rational>(m, b);
    EXPECT_TRUE(same(m * x, b)) << unit::to_text(m);
  }
}

/// Twice the kinetic energy of A per unit mass, with J = I/6.
Rational twice_energy(const BodyVelocity<Rational>& motion) {
  return motion.velocity.dot(motion.velocity) + motion.angular_velocity.dot(motion.angular_velocity) / 6;
}

/// The smallest example that gains energy (docs/findings/note.md).
Outcome<Rational> smallest_example(int restitution) {
  BasicCollision<Rational> c;
  c.a.principal_inertia = {ratio(1, 6), ratio(1, 6), ratio(1, 6)};
  c.a.position = {ratio(-1, 2), ratio(1, 2), 0};
  c.a.velocity = {-1, -1, 0};
  c.b.immovable = true;
  c.restitution = restitution;
  return reflection<Ldlt>(make_contact<Rational>(c));
}

TEST(Reflection, CreatesEnergyInTheSmallestExample) {
  EXPECT_EQ(twice_energy({{-1, -1, 0}, {0, 0, 0}}), 2);          // E = 1 before
  EXPECT_EQ(twice_energy(smallest_example(1).a), ratio(7, 2));   // 1.75 at ε = 1
  EXPECT_EQ(twice_energy(smallest_example(0).a), ratio(17, 8));  // 1.0625 at ε = 0
  EXPECT_TRUE(same(smallest_example(1).a.velocity, ExactVector(ratio(-7, 4), ratio(1, 4), 0)));
  EXPECT_TRUE(same(smallest_example(1).a.angular_velocity, ExactVector(0, 0, ratio(3, 2))));
}

/// For spheres r × N = 0, so C is block diagonal.
TEST(Reflection, EqualsFrictionlessForSpheres) {
  int colliding = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    properties::Stream stream = stream_of(i);
    const auto contact = exact_contact(properties::touching_spheres(stream).collision);
    const Outcome<Rational> by_reflection = reflection<Ldlt>(contact);
    EXPECT_TRUE(same(by_reflection, frictionless(contact))) << i;
    EXPECT_TRUE(same(by_reflection.a.angular_velocity, contact.a.angular_velocity)) << i;
    EXPECT_TRUE(same(by_reflection.b.angular_velocity, contact.b.angular_velocity)) << i;
    colliding += same(by_reflection, unchanged(contact)) ? 0 : 1;
  }
  EXPECT_GT(colliding, 450);  // touching_spheres approach unless V·N = 0
}

template <class S>
bool is_rough_as_frictionless(const Collision& collision) {
  const auto contact = make_contact<S>(collision);
  return same(rough<Ldlt>(contact), frictionless(contact));
}

TEST(Rough, WithoutFrictionHasTheBitsOfTheFrictionlessLaw) {
  for (const auto& [family, one] : unit::valid_cases(40)) {
    Collision c = one.collision;
    c.friction = 0;
    EXPECT_TRUE(is_rough_as_frictionless<float>(c)) << family;
    EXPECT_TRUE(is_rough_as_frictionless<double>(c)) << family;
  }
}

/// Compares a slipping ball with a ball of 2^`mass` times the mass and 2^`speed` times the speed.
template <class S>
void expect_rough_to_scale(int mass, int speed, S relative_rounding) {
  Collision c = unit::ball_on_a_plane(0.4, 0.0625);
  const Outcome<S> usual = rough<Ldlt>(make_contact<S>(c));
  c.a.mass = std::ldexp(c.a.mass, mass);
  c.a.principal_inertia *= std::ldexp(1.0, mass);
  c.a.velocity *= std::ldexp(1.0, speed);
  const Outcome<S> scaled = rough<Ldlt>(make_contact<S>(c));
  const S scale = std::ldexp(S(1), speed);
  EXPECT_LE((scaled.a.velocity - usual.a.velocity * scale).norm(), relative_rounding * usual.a.velocity.norm() * scale);
  EXPECT_LE((scaled.a.angular_velocity - usual.a.angular_velocity * scale).norm(),
            relative_rounding * usual.a.angular_velocity.norm() * scale);
}

/// Subnormal impulses have few bits: 34 at 2⁻¹⁰⁴⁰ N s in binary64, and 13 at 2⁻¹³⁶ N s in binary32. Rounding costs a
/// few of these bits.
TEST(Rough, SlipsByImpulsesThatAreSubnormal) {
  expect_rough_to_scale<double>(-1000, -40, 0x1p-30);
  expect_rough_to_scale<float>(-110, -26, 0x1p-9F);
}

void expect_same_rough(const oracles::ExactCase& exact_case, const std::string& family) {
  using oracles::Radical;
  const auto contact = make_contact<Radical>(
      map_numbers<Radical>(exact_case.collision(), [](double number) { return Radical(number); }));
  const Outcome<Radical> solved = rough<Ldlt, Radical>(contact);
  exact_case.with_truth(Law::rough, exact_case.state(), [&]<class T>(const oracles::Truth<T>& truth) {
    for (const OutcomeVector k : all_outcome_vectors) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ((*vectors(solved)[k])[i], Radical((*vectors(truth.outcome)[k])[i])) << family << ' ' << name_of(k);
      }
    }
  });
}

/// ExactSolvers.SatisfyEachClaimedInvariantWithoutAnAllowance compares the solvers of the linear laws.
TEST(Rough, EqualsTheOracleExactly) {
  for (const auto& [family, one] : unit::valid_cases(3)) {
    expect_same_rough(oracles::ExactCase(one.collision), std::string(family));
  }
}

}  // namespace
}  // namespace carom::impulse
