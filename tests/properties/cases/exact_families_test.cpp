// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/laws/equations.hpp>

#include "support/exact.hpp"

/// Exact tests of what families promise about N, V and K. If each of n cases has a property with probability p, the
/// count of cases with the property has a standard deviation of √(n p (1 − p)). The limits are five standard deviations
/// from the mean.
namespace carom::properties {
namespace {

using oracles::Approach;
using oracles::ExactCase;
using unit::ExactVector;
using unit::Rational;

constexpr std::uint64_t cases = 200;

int count(std::string_view family, Approach approach) {
  int found = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    found += ExactCase(unit::case_of(family, i).collision).approach() == approach ? 1 : 0;
  }
  return found;
}

TEST(Families, ApproachAsTheyPromise) {
  EXPECT_EQ(count("resting", Approach::resting), 200);
  EXPECT_EQ(count("both_immovable", Approach::inert), 200);
  EXPECT_EQ(count("head_on", Approach::colliding), 200);
  EXPECT_GE(count("near_head_on", Approach::colliding), 198);  // in a few of 10⁴ cases, a feature makes it rest
  // Rounding may give N·V the wrong sign near 0.
  EXPECT_GE(count("separating", Approach::separating), 198);
  for (const char* family :
       {"physical", "inelastic", "elastic", "mass_ratio", "immovable_a", "immovable_b", "driven_wall", "zero_lever",
        "common_velocity", "long_normal", "long_quaternion", "near_special", "needle_tip"}) {
    // One case in four gets features. A few of these features stop both bodies.
    EXPECT_GE(count(family, Approach::colliding), 190) << family;
  }
  // p = 7/8: 175 ± 5 · 4.7.
  EXPECT_NEAR(count("generic", Approach::colliding), 175, 24);
}

TEST(Families, AreExactlyHeadOnInAboutHalfOfHeadOn) {
  int exactly = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const ExactCase exact_case(unit::case_of("head_on", i).collision);
    const bool is_head_on = exact_case.is_head_on();
    exactly += is_head_on ? 1 : 0;
    const ExactVector v = unit::velocity_before(exact_case.exact());
    const ExactVector across = exact_case.exact().normal.cross(v);
    EXPECT_EQ(is_head_on, across[0] == 0 && across[1] == 0 && across[2] == 0);
  }
  // p = 1/2: 100 − 5 · 7.1. Rounding makes more cases exact.
  EXPECT_GE(exactly, 64);
}

TEST(Families, LieBesideTheConeOfStickingInStickOrSlip) {
  int sticking = 0;
  int slipping = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const ExactCase exact_case(unit::case_of("stick_or_slip", i).collision);
    if (exact_case.approach() != Approach::colliding) {
      continue;
    }
    const auto& c = exact_case.exact();
    const ExactVector& impulse = exact_case.truth(Law::sticking, Approach::colliding).impulse;
    const auto cone = oracles::squared_cone(c, impulse);
    if (c.normal.dot(impulse) <= 0 || cone.left[0] == 0) {
      continue;  // no friction suffices to stick, or none is needed
    }
    (cone.left[0] <= cone.right[0] ? sticking : slipping) += 1;
    // μ is 1 ± 10^-k times the least μ that sticks, with k ≥ 1. For general bodies, μ also has a rounding error.
    EXPECT_NEAR(std::sqrt(oracles::to_double(Rational(cone.left[0] / cone.right[0]))), 1, 0.12) << i;
  }
  // For each count, p is nearly 1/2, and the limit is more than 5 · 7.1 below the mean.
  EXPECT_GT(sticking, 50);
  EXPECT_GT(slipping, 50);
}

TEST(Families, AreNeverExactlyHeadOnInNearHeadOnWithoutRounding) {
  int exactly = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    exactly += ExactCase(unit::case_of("near_head_on", i).collision).is_head_on() ? 1 : 0;
  }
  // Three of the 18 ratios 10^-1 … 10^-18 are at or below rounding. p = 3/18: 33 + 5 · 5.3.
  EXPECT_LE(exactly, 60);
}

TEST(Families, AreCollinearAndIsotropicInCollinearSpheres) {
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Collision c = unit::case_of("collinear_spheres", i).collision;
    const auto exact = oracles::lift(c);
    EXPECT_TRUE(ExactCase(c).is_collinear()) << i;
    for (const BasicBody<Rational>* body : {&exact.a, &exact.b}) {
      if (body->immovable) {
        continue;
      }
      const ExactVector moment = ExactVector(exact.point - body->position).cross(exact.normal);
      EXPECT_TRUE(unit::same(moment, ExactVector(0, 0, 0))) << i;
      EXPECT_EQ(body->principal_inertia[0], body->principal_inertia[1]);
      EXPECT_EQ(body->principal_inertia[1], body->principal_inertia[2]);
    }
  }
}

TEST(Families, AreSeldomCollinearInNearCollinearAndGeneric) {
  int near = 0;
  int general = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    near += ExactCase(unit::case_of("near_collinear", i).collision).is_collinear() ? 1 : 0;
    general += ExactCase(unit::case_of("generic", i).collision).is_collinear() ? 1 : 0;
  }
  // Offsets of 10^-16 and 10^-15 of a radius may vanish by rounding. p = 2/16: 25 + 5 · 4.7.
  EXPECT_LE(near, 49);
  EXPECT_LE(general, 2);  // one case in four gets features, and a feature may put lever arms along the normal
}

/// The family draws |N·V| = 10^-k ‖V‖ with k from 1 to 18, and both signs.
TEST(Families, HaveASmallNormalVelocityInGrazing) {
  int slight = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const auto exact = oracles::lift(unit::case_of("grazing", i).collision);
    const ExactVector v = unit::velocity_before(exact);
    const ExactVector& n = exact.normal;
    const Rational squared = n.dot(v) * n.dot(v);
    const Rational scale = n.dot(n) * v.dot(v);
    slight += squared * 1000000 <= scale ? 1 : 0;  // |N·V| ≤ 10^-3
  }
  // k ≥ 3 has p = 8/9: 178 − 5 · 4.4.
  EXPECT_GE(slight, 155);
  EXPECT_GT(count("grazing", Approach::separating), 10);
  EXPECT_GT(count("grazing", Approach::colliding), 100);
}

/// λI ⪯ K ⪯ 16 λI, with λ = 1/m_A + 1/m_B. The construction of each stored moment and coordinate has fewer than 64
/// roundings. These roundings move an eigenvalue by at most 64 u Σ‖∂K/∂q‖ ‖q‖ (Weyl).
TEST(Families, AreBoundedBySixteenLambdaInPhysical) {
  Rational largest(0);
  for (const char* family : {"physical", "collinear_spheres"}) {
    for (std::uint64_t i = 0; i < cases; ++i) {
      const ExactCase exact_case(unit::case_of(family, i).collision);
      const Rational lambda = oracles::inverse_mass(exact_case.exact());
      const Rational rounding(64 * 0x1p-53 * exact_case.collision_matrix_sensitivity(64 * 0x1p-53));
      EXPECT_TRUE(oracles::is_at_most(exact_case.collision_matrix(), 16 * lambda + rounding)) << family << ' ' << i;
      EXPECT_TRUE(exact_case.is_bounded_by(16 * lambda + rounding)) << family << ' ' << i;
      const Rational trace = exact_case.collision_matrix().trace() / lambda;
      largest = std::max(largest, trace);
    }
  }
  // For some contact, the mean eigenvalue of K is more than 2 λ.
  EXPECT_GT(largest, 6);
}

TEST(Families, ExceedSixteenLambdaSomewhereInGeneric) {
  int above = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const ExactCase exact_case(unit::case_of("generic", i).collision);
    above += exact_case.is_bounded_by(16 * oracles::inverse_mass(exact_case.exact())) ? 0 : 1;
  }
  EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace carom::properties
