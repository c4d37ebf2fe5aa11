// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/sensitivity.hpp>
#include <carom/oracles/truths/superposition.hpp>
#include <carom/properties/draws/stream.hpp>

#include "covers.hpp"
#include "support/exact.hpp"
#include "support/rounding_count.hpp"

namespace carom::bounds {
namespace {

using oracles::ExactCase;
using oracles::Rational;

/// A body of unit mass with equal moments that hits a wall at `arm` from its centre.
Collision against_a_wall(const Vector3<double>& arm, double moment) {
  Collision c;
  c.b.immovable = true;
  c.a.mass = 1;
  c.a.principal_inertia = Vector3<double>::Constant(moment);
  c.a.position = -arm;
  c.normal = {0, 0, 1};
  c.a.velocity = {0, 0, -1};
  return c;
}

/// The bound t³ / (4 det K) of the condition number of K, in ℚ, with the trace t of K.
Rational condition_bound(const Collision& c) {
  const unit::ExactMatrix k = impulse::collision_matrix(unit::exact_contact(c));
  const Rational t = k.trace();
  return t * t * t / (Rational(4) * unit::ExactVector(k.col(0)).dot(unit::ExactVector(k.col(1)).cross(k.col(2))));
}

/// ExactCase rounds its bound, so the test skips bounds within a thousandth of the threshold 2²⁰.
TEST(ExactCase, IsWellConditionedUpToTheBoundInRationals) {
  properties::Stream stream = properties::stream_from(77);
  int well = 0;
  int ill = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector3<double> arm = stream.direction();
    // With the moment J and s = r·r/J, K = I + (r·r I − r rᵀ)/J has the trace t = 3 + 2 s and the determinant (1 + s)².
    // So t³ / (4 det K) is about 2 s.
    const double s = 0x1p19 * stream.between(0.9, 1.1);
    const Collision c = against_a_wall(arm, arm.squaredNorm() / s);
    const Rational share = condition_bound(c) / Rational(0x1p20);
    if (share < Rational(0.999)) {
      EXPECT_TRUE(ExactCase(c).is_well_conditioned());
      ++well;
    } else if (share > Rational(1.001)) {
      EXPECT_FALSE(ExactCase(c).is_well_conditioned());
      ++ill;
    }
  }
  EXPECT_GT(well, 100);
  EXPECT_GT(ill, 100);
}

TEST(ExactCase, KnowsTheSignOfTheNormalVelocity) {
  Collision c = against_a_wall({0, 0, 0}, 1);
  EXPECT_EQ(ExactCase(c).normal_velocity().sign, -1);
  c.a.velocity = {0, 0, 1};
  EXPECT_EQ(ExactCase(c).normal_velocity().sign, 1);
  EXPECT_EQ(ExactCase(c).normal_velocity().value, 1);
  c.a.velocity = {1, 0, 0};
  EXPECT_EQ(ExactCase(c).normal_velocity().sign, 0);
  // The velocities cancel except for 2⁻⁴⁰. Binary64 keeps four digits of this rest, and an enclosure keeps twenty.
  c.b.velocity = {0, 0, 1};
  c.a.velocity = {0, 0, 1 + 0x1p-40};
  EXPECT_EQ(ExactCase(c).normal_velocity().sign, 1);
}

/// r lies along the long axis of a needle. The large term r·r / I₁ cancels in K, and its rounding errors may exceed
/// ‖K‖.
TEST(ExactCase, TakesHalfOfLambdaWhereLargeTermsCancel) {
  Collision c = against_a_wall({1, 0, 0}, 1);  // K = diag(1, 2, 2), of norm 3
  c.a.principal_inertia = {0x1p-21, 1, 1};
  EXPECT_NEAR(ExactCase(c).collision_matrix_sensitivity_below(), 1.5, 0x1p-20) << "half of ‖K‖ ≥ 2⁻²⁰ · 2²¹";
  c.a.principal_inertia = {0x1p-22, 1, 1};
  EXPECT_NEAR(ExactCase(c).collision_matrix_sensitivity_below(), 0.5, 0x1p-20) << "half of λ";
}

/// The ball moves with the wall, and its lever arm is 0, so a first-order change gives it no spin. But rounding of the
/// velocities (α (2 + 2)) may cause the impulse 4 · 4 α, and the lever arm has the uncertainty α (5 + 5 + 1/2), with
/// the extent √(J / (2 m)) = 1/2. The spin is their product over J = 2.
TEST(ExactCase, GrazesWithTheSpinByAnImpulseAndAnArmOfRounding) {
  constexpr double allowance = 0x1p-40;
  Collision c = against_a_wall({0, 0, 0}, 2);
  c.a.mass = 4;
  c.a.position = c.point = {3, 4, 0};
  c.a.velocity = c.b.velocity = {0, 0, -2};
  EXPECT_GE(ExactCase(c).sensitivity(Law::frictionless, allowance)[OutcomeVector::angular_velocity_of_a],
            allowance * 4 * 4 * 10.5 / 2);
}

TEST(PermittedInputs, MoveTheVelocitiesOfBothBodies) {
  constexpr double allowance = 0x1p-40;
  Collision c = against_a_wall({0, 0, 0}, 1);
  c.b.velocity = {0, 3, 0};
  const oracles::PermittedInputs permitted(ExactCase(c), allowance);
  EXPECT_NEAR(permitted.relative_velocity().radius / allowance, 1 + 3, 0x1p-40) << "‖v_A‖ + ‖v_B‖";
}

/// The ball and the wall move together, and the relative velocity is (0, 0, −1). Rounding of the two velocities changes
/// its tangential part by 2 α U. The tangential impulse is half of that, as K = 2 there, and turns the ball by α U. A
/// thousandth of it covers the parts by the relative velocity, which is 2⁻²⁰ U.
TEST(PermittedInputs, TurnABallByTheRoundingOfACommonVelocity) {
  constexpr double allowance = 0x1p-40;
  constexpr double common = 0x1p+20;
  Collision c = against_a_wall({0, 0, -1}, 1);
  c.restitution = 0;
  c.a.velocity[0] = c.b.velocity[0] = common;
  const ExactCase exact_case(c);
  const auto distance = oracles::PermittedInputs(exact_case, allowance)
                            .distance_of_answers(exact_case, {0, 0, 1}, Law::sticking, oracles::Branch::only, false);
  EXPECT_GE(distance[OutcomeVector::angular_velocity_of_a], 0.999 * allowance * common);
}

/// The answer inside of the cone changes by a few α, as the inputs do. A wrong share of the friction would move it by
/// 6/7, which is 10¹² α.
TEST(PermittedInputs, MoveARoughAnswerByRoundingOnly) {
  constexpr double allowance = 0x1p-40;
  Collision c = against_a_wall({0, 0, -1}, 0.4);
  c.restitution = 0;
  c.friction = 10;
  c.tangential_restitution = 0;
  c.a.velocity = {-3, 0, -4};  // K is 1 along the normal, and 3.5 across it
  const ExactCase exact_case(c);
  const auto distance =
      oracles::PermittedInputs(exact_case, allowance)
          .distance_of_answers(exact_case, {3 / 3.5, 0, 4}, Law::rough, oracles::Branch::inside_cone, false);
  EXPECT_LE(distance[OutcomeVector::velocity_of_a], 1000 * allowance);
}

/// For an impulse along x, a torque of the lever arm's rounding turns the body about y and z. The extent is √(J₃ / 2).
TEST(SecondOrder, OfArmsIsByTheMomentsAcrossTheImpulse) {
  Collision c = against_a_wall({0, 0, 0}, 1);
  c.a.principal_inertia = {0x1p+10, 0x1p+10, 0x1p-10};
  c.a.position = c.point = {3, 4, 0};
  const double length = 5 + 5 + std::sqrt(0x1p-10 / 2);
  EXPECT_NEAR(oracles::second_order_of_arms(c, {{1, 0, 0}})[OutcomeVector::velocity_of_a] / (0x1p+10 * length * length),
              1, 1e-5)
      << "1/J₂ is 2⁻²⁰ of 1/J₃";
}

/// The wall turns about a distant centre, so that its point at the contact rests. The impulse grows with all terms of
/// the relative velocity: 5 for the ball, and 8 + 1 · 8 for the wall.
TEST(GrowthOfRoundings, IsOfAllTermsOfTheRelativeVelocity) {
  Collision c = against_a_wall({0, 0, -1}, 0.4);
  c.friction = 0.1;
  c.a.velocity = {-3, 0, -4};
  const auto growth = [&] {
    return oracles::growth_of_roundings(c, ExactCase(c).enclosed(), Law::rough, oracles::Branch::on_cone);
  };
  const double at_rest = growth();
  c.b.position = {8, 0, 0};
  c.b.angular_velocity = {0, 0, 1};
  c.b.velocity = {0, 8, 0};
  EXPECT_NEAR(growth() / at_rest, (5 + 8 + 8) / 5.0, 0x1p-40) << "a few roundings of binary64";
}

// The last tests check the inequalities and constants of oracles/judge/exact_case_bounds.hpp. That header defines the
// symbols.

/// The bodies are at the origin, so the lever arm r = P − X is P. P counts as rounded once, like the difference P − X.
template <class T>
BasicCollision<T> normalised_collision() {
  BasicCollision<T> c;
  const T input(RoundingCount::input());
  for (BasicBody<T>* body : {&c.a, &c.b}) {
    body->mass = input;
    body->principal_inertia.setConstant(input);
    body->orientation.setConstant(input);
    body->velocity.setConstant(T(RoundingCount::input(0.5)));
    body->angular_velocity.setConstant(T(RoundingCount::input(0.5)));
  }
  c.point.setConstant(T(RoundingCount::input(1, 1)));
  c.normal.setConstant(input);
  c.restitution = input;
  return c;
}

namespace exact_case_bounds = oracles::exact_case_bounds;

TEST(ExactCase, KnowANormalVelocityToSixDigits) {
  EXPECT_TRUE(covers(1e-6, exact_case_bounds::known_radius_of_normal_velocity + u, 1.1));
}

template <class S, class Convert>
BasicCollision<oracles::Dual<S, 8>> with_inertia_as_inputs(BasicCollision<oracles::Dual<S, 8>> c,
                                                           const Convert& convert) {
  std::size_t next = 0;
  for (BasicBody<oracles::Dual<S, 8>>* body : {&c.a, &c.b}) {
    body->mass = oracles::Dual<S, 8>::input(convert(body->mass), next++);
    for (int i = 0; i < 3; ++i) {
      body->principal_inertia[i] = oracles::Dual<S, 8>::input(convert(body->principal_inertia[i]), next++);
    }
  }
  return c;
}

/// Inequality (1) for K follows from Σ_j x_j ∂K/∂x_j = −K over the masses and moments x_j. This test checks the
/// equation exactly.
TEST(ExactCase, HasACollisionMatrixThatIsHomogeneousInMassesAndMoments) {
  using T = oracles::Dual<Rational, 8>;
  properties::Stream stream = properties::stream_from(71);
  for (int i = 0; i < 50; ++i) {
    Collision c = unit::small_collision(stream);
    c.b.immovable = false;
    const auto lifted = map_numbers<T>(c, [](double x) { return T(Rational(x)); });
    const auto k =
        oracles::response_matrix(with_inertia_as_inputs<Rational>(lifted, [](const T& x) { return x.value; }));
    for (const T& entry : k.reshaped()) {
      Rational sum(0);
      std::size_t next = 0;
      for (const Body* body : {&c.a, &c.b}) {
        sum += Rational(body->mass) * entry.derivative[next++];
        for (int axis = 0; axis < 3; ++axis) {
          sum += Rational(body->principal_inertia[axis]) * entry.derivative[next++];
        }
      }
      EXPECT_EQ(sum, -entry.value) << i;
    }
  }
}

/// The error of Σ_j ‖∂K/∂x_j‖_F |x_j| over masses and moments x_j, in units of u, for ‖r‖ = 1 and min I = 1.
double error_of_matrix_sensitivity() {
  using T = oracles::Dual<RoundingCount, 8>;
  const Matrix3<T> k = oracles::response_matrix(
      with_inertia_as_inputs<RoundingCount>(normalised_collision<T>(), [](const T& x) { return x.value; }));
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j) {
    double squares = 0;
    for (const T& entry : k.reshaped()) {
      squares += entry.derivative[j].error() * entry.derivative[j].error();
    }
    sum += std::sqrt(squares);
  }
  return sum;
}

/// Inequalities (2) and (3) for K.
TEST(ExactCase, CoverTheRoundingOfTheMatrixSensitivity) {
  const double needed = error_of_matrix_sensitivity();
  EXPECT_TRUE(covers(exact_case_bounds::roundings_of_matrix_sensitivity, needed, 4));
  EXPECT_LE(exact_case_bounds::roundings_of_matrix_sensitivity * u / exact_case_bounds::least_share_of_largest_terms,
            0.25);
}

}  // namespace
}  // namespace carom::bounds
