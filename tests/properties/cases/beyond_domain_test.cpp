// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/features/geometry.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

constexpr std::uint64_t drawn_cases = 400;

struct Drawn {
  int colliding = 0;
  double least = HUGE_VAL;
  double greatest = 0;
};

Drawn drawn_of(const Family& family) {
  Drawn drawn;
  for (std::uint64_t i = 0; i < drawn_cases; ++i) {
    const Collision c = unit::case_of(family.name, i).collision;
    EXPECT_EQ(describe(validate(c)), "") << family.name << ' ' << i;
    drawn.colliding += oracles::ExactCase(c).state() == oracles::ContactState::colliding ? 1 : 0;
    drawn.least = std::min(drawn.least, family.beyond.of(c));
    drawn.greatest = std::max(drawn.greatest, family.beyond.of(c));
  }
  return drawn;
}

TEST(BeyondDomain, IsOfFamiliesOfItsOwn) {
  for (const Family& family : all_families()) {
    EXPECT_FALSE(family.is_beyond_domain()) << family.name;
  }
  ASSERT_EQ(families_beyond_domain().size(), 3U);
  for (const Family& family : families_beyond_domain()) {
    EXPECT_TRUE(family.is_beyond_domain()) << family.name;
    EXPECT_EQ(family_named(family.name), &family);
  }
}

TEST(BeyondDomain, HasContactsFromNearToFarOutside) {
  const Drawn drawn = drawn_of(*family_named("far_contacts"));
  EXPECT_GE(drawn.colliding, 396);  // a body without lever arm and nearly without spin may rest
  // A body gets one of 27 powers of two as a factor. 400 cases lack the smallest or the largest factor with a
  // probability of at most 2 (26/27)^400 < 10⁻⁶. With the factor 1, the bound of the condition number of K is at most a
  // few tens.
  EXPECT_LT(drawn.least, 1e3);
  EXPECT_GT(drawn.greatest, 1e14);
  EXPECT_LT(drawn.greatest, 1e19);
}

TEST(BeyondDomain, HasMomentsThatNoBodyHas) {
  const Family& family = *family_named("impossible_moments");
  const Drawn drawn = drawn_of(family);
  EXPECT_GE(drawn.colliding, 396);
  EXPECT_GE(drawn.least, 1);
  EXPECT_LT(drawn.least, 10);
  EXPECT_GT(drawn.greatest, 1e15);
}

TEST(BeyondDomain, HasNeedlesUpToAMillionTimesAsLongAsWide) {
  const Drawn drawn = drawn_of(*family_named("needle_tip"));
  EXPECT_EQ(drawn.colliding, 400);
  // A needle is 10 to 10⁶ times as long as wide, and its widths vary by a factor of 3.
  EXPECT_LT(drawn.least, 1e3);
  EXPECT_GT(drawn.greatest, 1e11);
}

/// No body of `physical` has a moment above the sum of the others, except by rounding.
TEST(BeyondDomain, IsNotReachedByPhysicalBodies) {
  for (std::uint64_t i = 0; i < drawn_cases; ++i) {
    const Collision c = unit::case_of("physical", i).collision;
    EXPECT_LE(moment_excess(c), 1 + 0x1p-50) << i;
    // tr K/λ − 2 with λ = 1/m_A + 1/m_B and K ⪯ 16 λI
    EXPECT_LE(condition_number_at_most(c), 1 + 3 * 15 + 0x1p-40) << i;
  }
}

/// condition_number_at_most is tr K/λ − 2. In binary64, it is a sum of positive terms with fewer than 64 roundings.
TEST(BeyondDomain, MeasuresTheTraceOfTheCollisionMatrix) {
  for (const char* family : {"far_contacts", "impossible_moments", "generic", "driven_wall"}) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      const oracles::ExactCase exact_case(unit::case_of(family, i).collision);
      const oracles::Rational lambda = oracles::inverse_mass(exact_case.exact());
      const double exact =
          oracles::to_double(oracles::Rational(exact_case.collision_matrix().trace()) / lambda - oracles::Rational(2));
      const double measured = condition_number_at_most(exact_case.collision());
      // The rotated lever arm has a rounding error of u times its length. The division by a small moment enlarges this
      // error.
      const double rounding =
          64 * 0x1p-53 * exact *
          std::max({1.0, moment_ratio(exact_case.collision().a), moment_ratio(exact_case.collision().b)});
      EXPECT_NEAR(measured, exact, rounding) << family << ' ' << i;
    }
  }
}

TEST(BeyondDomain, IsNoFurtherUpToTheFreeLimitsOrTheOtherCollision) {
  Collision ordinary;
  Collision slender = ordinary;
  slender.a.principal_inertia = {0.1, 1, 1};
  Collision impossible = ordinary;
  impossible.b.principal_inertia = {1, 1, 2.5};
  Collision far = ordinary;
  far.a.position = {0, 8, 0};
  for (const Collision& beyond : {slender, impossible, far}) {
    EXPECT_FALSE(is_no_further_beyond_domain(beyond, ordinary));
    EXPECT_TRUE(is_no_further_beyond_domain(beyond, beyond));
    EXPECT_TRUE(is_no_further_beyond_domain(ordinary, beyond));
  }
  Collision other_body = ordinary;
  other_body.b.principal_inertia = slender.a.principal_inertia;
  EXPECT_FALSE(is_no_further_beyond_domain(other_body, slender)) << "each body counts by itself";
  Collision at_the_limits = ordinary;
  at_the_limits.a.principal_inertia = {0.125, 1, 1};
  at_the_limits.b.principal_inertia = {1, 1, 2};
  EXPECT_TRUE(is_no_further_beyond_domain(at_the_limits, ordinary));
}

Collision at(std::string_view sweep, double quantity) {
  Stream stream = stream_from(5);
  const auto named = [&](const Sweep& one) { return one.name == sweep; };
  return std::find_if(all_sweeps().begin(), all_sweeps().end(), named)->generate(stream, quantity);
}

TEST(Sweeps, GiveValidCollisionsAtEveryDecade) {
  for (const Sweep& sweep : all_sweeps()) {
    const int step = sweep.last_exponent > sweep.first_exponent ? 1 : -1;
    for (int k = sweep.first_exponent; k != sweep.last_exponent + step; k += step) {
      for (std::uint64_t i = 0; i < 20; ++i) {
        Stream stream = stream_from(i);
        EXPECT_TRUE(validate(sweep.generate(stream, std::pow(10, k))).empty()) << sweep.name << " 1e" << k;
      }
    }
  }
}

TEST(Sweeps, SetTheQuantityThatTheyAreNamedAfter) {
  for (const double quantity : {1e2, 1e6}) {
    // The ratios have at most ten roundings.
    const double rounding = 10 * 0x1p-53 * quantity;
    const Vector3<double> rod = at("slenderness", quantity).a.principal_inertia;
    EXPECT_NEAR(rod.maxCoeff() / rod.minCoeff(), quantity, rounding);
    const auto size_of_a = [](const Collision& c) { return features::radius_of_gyration(c.a); };
    EXPECT_NEAR(size_of_a(at("large_size", quantity)) / size_of_a(at("large_size", 1)), quantity, rounding);
    EXPECT_NEAR(size_of_a(at("size_ratio", quantity)) / size_of_a(at("size_ratio", 1)), quantity, rounding);
    EXPECT_EQ(at("small_restitution", 1 / quantity).restitution, 1 / quantity);
  }
}

}  // namespace
}  // namespace carom::properties
