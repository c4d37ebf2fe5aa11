// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/exact/rational.hpp>
#include <carom/oracles/laws/equations.hpp>

#include "support/cases.hpp"

namespace carom::oracles {
namespace {

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
