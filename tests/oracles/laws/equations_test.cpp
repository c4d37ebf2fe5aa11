// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/solve3.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/truths/models.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ExactMatrix;
using unit::ExactVector;
using unit::ratio;

/// The exact change of energy by a law, ΔE: the kinetic energy that the movable bodies gain, minus the work of a moving
/// wall. tests/identities checks the formulas of ΔE.
Rational energy_change(const BasicCollision<Rational>& c, const Outcome<Rational>& after) {
  const auto sides = equation::Energy{}(c, after);
  return sides.left[0] - sides.right[0];
}

/// Some contacts do not collide, because the formulas hold for N·V⁻ of either sign.
std::vector<BasicCollision<Rational>> collisions() {
  std::vector<BasicCollision<Rational>> result;
  for (std::uint64_t i = 0; i < 300; ++i) {
    properties::Stream stream = properties::stream_from(9000 + i);
    result.push_back(lift(unit::small_collision(stream)));
  }
  for (const auto& [family, one] : unit::valid_cases(4)) {
    if (family != "both_immovable") {
      result.push_back(lift(one.collision));
    }
  }
  return result;
}

/// ΔE = ½ F·(V⁻ + V⁺), for any impulse F.
TEST(Energy, IsTheWorkOfTheImpulseAtTheMeanVelocity) {
  for (const auto& c : collisions()) {
    for (const Law law : linear_laws) {
      const Truth<Rational> truth = colliding_truth(c, law, Branch::only);
      const ExactVector sum = unit::velocity_before(c) + relative_velocity<Rational>(c, truth.outcome);
      EXPECT_EQ(energy_change(c, truth.outcome), truth.impulse.dot(sum) / 2);
    }
  }
}

/// Sticking, with A = K⁻¹. Among all slips with a given N·V⁻, the least V⁻ᵀ A V⁻ is (N·V⁻)²/(NᵀKN). So ΔE ≤ ½ (N·V⁻)²
/// (ε² NᵀAN/(N·N)² − 1/(NᵀKN)). The slip of least V⁻ᵀ A V⁻ attains this bound. The bound is positive if and only if ε²
/// (NᵀAN) (NᵀKN) > (N·N)² and N·V⁻ ≠ 0.
TEST(Energy, IsCreatedByStickingAboveACertainRestitution) {
  int can_create = 0;
  for (BasicCollision<Rational> c : collisions()) {
    const ExactVector n = c.normal;
    const ExactMatrix k = response_matrix(c);
    const Rational length = n.dot(n);
    const Rational product = n.dot(impulse::Ldlt::solve<Rational>(k, n)) * n.dot(ExactVector(k * n));
    const ExactVector v = unit::velocity_before(c);
    // The slip of least V⁻ᵀ A V⁻ has V⁻ along K N.
    const ExactVector least = k * n * Rational(n.dot(v) / n.dot(ExactVector(k * n)));
    (c.a.immovable ? c.b : c.a).velocity += (c.a.immovable ? Rational(-1) : Rational(1)) * ExactVector(least - v);
    const Rational change = energy_change(c, colliding_truth(c, Law::sticking, Branch::only).outcome);
    const Rational excess = c.restitution * c.restitution * product - length * length;
    EXPECT_EQ(sign_of(change), n.dot(v) == 0 ? 0 : sign_of(excess));
    can_create += change > 0 ? 1 : 0;
  }
  EXPECT_GT(can_create, 0);
}

/// Kantorovich's inequality: (NᵀAN) (NᵀKN) ≤ (κ + 1)²/(4κ) (N·N)², with A = K⁻¹ and the condition number κ of K. For
/// convex uniform bodies κ ≤ 16, so (κ + 1)²/(4κ) ≤ (17/8)². So sticking creates no energy for ε ≤ 8/17.
TEST(Energy, IsNeverCreatedByStickingConvexBodiesBelowEightSeventeenths) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    BasicCollision<Rational> c = lift(unit::case_of("physical", i).collision);
    c.restitution = ratio(8, 17);
    EXPECT_LE(energy_change(c, colliding_truth(c, Law::sticking, Branch::only).outcome), 0) << i;
  }
}

/// The outcome of an impulse on a ball of mass 1 and velocity (−3, −4, 0). The spin stays zero, so the slip is the
/// tangential velocity.
Outcome<Rational> struck(const Vector3<Rational>& impulse) {
  const BasicCollision<Rational> c = lift(unit::ball_on_a_plane(0.5, 0.25));
  Outcome<Rational> after = unchanged(c);
  after.a.velocity += impulse;
  return after;
}

TEST(FrictionEquations, CompareFrictionWithTheSlipAfterTheImpulse) {
  const BasicCollision<Rational> c = lift(unit::ball_on_a_plane(0.5, 0.25));
  const auto sides = [&](const auto& equation, const Vector3<Rational>& impulse) {
    const auto of = equation(c, struck(impulse));
    return std::pair(of.left, of.right);
  };
  // The slip after F = (1, 6, 0) is (−2, 0, 0), and F opposes the slip: N × F = (0, 0, −1), N × V⁺ = (0, 0, 2).
  const Vector3<Rational> against(1, 6, 0);
  EXPECT_TRUE(sides(equation::FrictionAlongSlip{true}, against).first.isZero(0));
  EXPECT_EQ(sides(equation::FrictionAgainstSlip{true}, against).first[0], -2);
  // F = (4, 6, 0) points along the slip (1, 0, 0) after the impulse.
  EXPECT_EQ(sides(equation::FrictionAgainstSlip{true}, Vector3<Rational>(4, 6, 0)).first[0], 4);
  // F = (1, 6, 3): (N × F) × (N × V⁺) = (3, 0, −1) × (3, 0, 2) = (0, −9, 0).
  EXPECT_EQ(Vector3<Rational>(sides(equation::FrictionAlongSlip{true}, Vector3<Rational>(1, 6, 3)).first),
            Vector3<Rational>(0, -9, 0));
  EXPECT_EQ(sides(equation::FrictionAgainstSlip{true}, Vector3<Rational>(1, 6, 3)).first[0], 7);
}

TEST(FrictionEquations, CompareFrictionWithPressure) {
  const BasicCollision<Rational> c = lift(unit::ball_on_a_plane(0.5, 0.25));
  const auto cone = equation::FrictionCone{true}(c, struck(Vector3<Rational>(1, 6, 2)));
  EXPECT_EQ(cone.left[0], 5);                 // ‖N × F‖²
  EXPECT_EQ(cone.right[0], Rational(9) / 4);  // (6/4)²
}

}  // namespace
}  // namespace carom::oracles
