// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/exact/definiteness.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/relative_velocity.hpp>

#include "support/exact.hpp"

namespace carom::properties {
namespace {

constexpr std::uint64_t cases = 300;

TEST(Families, DependOnSeedNameAndIndex) {
  std::set<std::uint64_t> first_words;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (const char* name : {"generic", "elastic"}) {
      for (std::uint64_t index = 0; index < 100; ++index) {
        first_words.insert(case_stream(seed, name, index).bits());
      }
    }
  }
  EXPECT_EQ(first_words.size(), 600U);
  EXPECT_EQ(case_stream(7, "generic", 5).bits(), case_stream(7, "generic", 5).bits());
}

TEST(Families, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (const Family& family : all_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_EQ(family_named(family.name), &family);
    EXPECT_FALSE(family.summary.empty());
  }
  EXPECT_EQ(family_named("no_such_family"), nullptr);
}

TEST(Families, AreValidButForTheInvalidOne) {
  for (const Family& family : all_families()) {
    for (std::uint64_t i = 0; i < cases; ++i) {
      const auto errors = validate(unit::case_of(family.name, i).collision);
      EXPECT_EQ(errors.empty(), family.is_valid) << family.name << ' ' << i << ": " << describe(errors);
    }
  }
}

TEST(Families, MakeEachFieldInvalidInTurn) {
  std::set<std::string> fields;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const InputError& error : validate(unit::case_of("invalid", i).collision)) {
      fields.insert(error.field + ' ' + error.expected);
    }
  }
  // Each of the 43 numbers may be infinite or NaN. The mass, the three moments and the orientation of each body, and
  // four other fields, may be out of range.
  EXPECT_EQ(fields.size(), 43U + 10U + 4U);
}

TEST(Families, HoldTheRestitutionThatTheyAreNamedAfter) {
  for (std::uint64_t i = 0; i < cases; ++i) {
    EXPECT_EQ(unit::case_of("inelastic", i).collision.restitution, 0);
    EXPECT_EQ(unit::case_of("elastic", i).collision.restitution, 1);
  }
}

TEST(Families, HoldTheImmovableBodiesThatTheyAreNamedAfter) {
  std::uint64_t wall_is_a = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Collision a = unit::case_of("immovable_a", i).collision;
    EXPECT_TRUE(a.a.immovable && !a.b.immovable) << i;
    const Collision b = unit::case_of("immovable_b", i).collision;
    EXPECT_TRUE(!b.a.immovable && b.b.immovable) << i;
    const Collision both = unit::case_of("both_immovable", i).collision;
    EXPECT_TRUE(both.a.immovable && both.b.immovable) << i;
    EXPECT_TRUE((both.a.velocity.array() != 0).any()) << i;
    const Collision driven = unit::case_of("driven_wall", i).collision;
    EXPECT_NE(driven.a.immovable, driven.b.immovable) << i;
    const Body& wall = driven.a.immovable ? driven.a : driven.b;
    EXPECT_TRUE((wall.velocity.array() != 0).any() && (wall.angular_velocity.array() != 0).any()) << i;
    wall_is_a += driven.a.immovable ? 1 : 0;
  }
  // 150 of 300, ± five standard deviations of √(300/4) = 8.7.
  EXPECT_GT(wall_is_a, 106U);
  EXPECT_LT(wall_is_a, 194U);
}

TEST(Families, PutTheContactAtTheCentreOfMassInZeroLever) {
  int of_a = 0;
  int of_b = 0;
  int of_both = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Collision c = unit::case_of("zero_lever", i).collision;
    const bool a = c.point == c.a.position;
    const bool b = c.point == c.b.position;
    EXPECT_TRUE(a || b) << i;
    (a && b ? of_both : (a ? of_a : of_b)) += 1;
  }
  // 100 of 300 each, ± five standard deviations of √(300·2/9) = 8.2.
  for (const int count : {of_a, of_b, of_both}) {
    EXPECT_GT(count, 59);
    EXPECT_LT(count, 141);
  }
}

TEST(Families, ReachTheExtremesThatTheyPromise) {
  double largest_ratio = 0;
  double longest_normal = 0;
  double shortest_normal = 1;
  double longest_quaternion = 0;
  double farthest = 0;
  double fastest = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Collision heavy = unit::case_of("mass_ratio", i).collision;
    largest_ratio = std::max({largest_ratio, heavy.a.mass / heavy.b.mass, heavy.b.mass / heavy.a.mass});
    const double normal = unit::case_of("long_normal", i).collision.normal.norm();
    longest_normal = std::max(longest_normal, normal);
    shortest_normal = std::min(shortest_normal, normal);
    longest_quaternion =
        std::max(longest_quaternion, unit::case_of("long_quaternion", i).collision.a.orientation.norm());
    farthest = std::max(farthest, unit::case_of("far_from_origin", i).collision.point.norm());
    fastest = std::max(fastest, unit::case_of("common_velocity", i).collision.a.velocity.norm());
  }
  // In a factor 10^k, each k has a probability of at least 1/61. 300 cases miss the two largest k with a probability of
  // at most (59/61)^300 < 5e-5.
  EXPECT_GT(largest_ratio, 1e7);
  EXPECT_GT(longest_normal, 1e28);
  EXPECT_LT(shortest_normal, 1e-28);
  EXPECT_GT(longest_quaternion, 1e28);
  EXPECT_GT(farthest, 1e10);
  EXPECT_GT(fastest, 1e10);
}

/// The sine of the angle between two vectors.
double sine(const Vector3<double>& u, const Vector3<double>& v) { return u.cross(v).norm() / (u.norm() * v.norm()); }

/// The body with the greater ratio of moments, and the contact on its tip. The other body may be a needle, too.
TEST(Families, StrikeNeedlesOnTheirTips) {
  double largest_ratio = 0;
  double smallest_angle = 1;
  std::uint64_t walls = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Case one = unit::case_of("needle_tip", i);
    EXPECT_TRUE(one.convex_uniform) << i;
    const Collision& c = one.collision;
    const Vector3<double> v = relative_velocity(c);
    EXPECT_LT(c.normal.dot(v), 0) << i;
    EXPECT_LT(sine(c.normal, v), 0.11) << i;
    double best = 1;
    for (const Body& body : {c.a, c.b}) {
      const Vector3<double> arm = c.point - body.position;
      const double ratio = moment_ratio(body);
      if (ratio < 2) {
        continue;
      }
      // N and the lever arm deviate from the long axis by at most a tenth each.
      best = std::min(best, sine(c.normal, arm));
      largest_ratio = std::max(largest_ratio, ratio);
    }
    EXPECT_LT(best, 0.22) << i;
    smallest_angle = std::min(smallest_angle, best);
    walls += c.a.immovable || c.b.immovable ? 1 : 0;
  }
  // The widths 10^-6 and 10^-5 have a probability of 1/3, and the angles up to 10^-6 of more than 1/2.
  EXPECT_GT(largest_ratio, 1e8);
  EXPECT_LT(smallest_angle, 1e-6);
  // 100 of 300, ± five standard deviations of √(300·2/9) = 8.2.
  EXPECT_GT(walls, 59U);
  EXPECT_LT(walls, 141U);
}

TEST(Families, CallOnlyConvexUniformBodiesConvexAndUniform) {
  for (const auto& [family, one] : unit::valid_cases(50)) {
    EXPECT_EQ(one.convex_uniform,
              family == "physical" || family == "collinear_spheres" || family == "spin_alone" || family == "chung_ooi")
        << family;
  }
}

TEST(Stream, NeverDrawsAZeroDirectionOrQuaternion) {
  Stream stream([] { return 0U; });  // every draw is the lowest
  EXPECT_TRUE((stream.direction().array() != 0).any());
  EXPECT_TRUE((stream.quaternion().array() != 0).any());
  Stream random = stream_from(8);
  for (int i = 0; i < 5000; ++i) {
    EXPECT_GE(random.direction().cwiseAbs().maxCoeff(), 1.0 / 16);
    EXPECT_GE(random.quaternion().cwiseAbs().maxCoeff(), 1.0 / 8);
  }
}

// Exact tests of what families promise about N, V and K. If each of n cases has a property with probability p, the
// count of cases with the property has a standard deviation of √(n p (1 − p)). The limits are five standard deviations
// from the mean.

using oracles::ContactState;
using oracles::ExactCase;
using unit::ExactVector;
using unit::Rational;

constexpr std::uint64_t exact_cases = 200;

int count(std::string_view family, ContactState approach) {
  int found = 0;
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
    found += ExactCase(unit::case_of(family, i).collision).state() == approach ? 1 : 0;
  }
  return found;
}

TEST(Families, ApproachAsTheyPromise) {
  EXPECT_EQ(count("resting", ContactState::resting), 200);
  EXPECT_EQ(count("both_immovable", ContactState::inert), 200);
  EXPECT_EQ(count("head_on", ContactState::colliding), 200);
  EXPECT_GE(count("near_head_on", ContactState::colliding), 198);  // in a few of 10⁴ cases, a feature makes it rest
  // Rounding may give N·V the wrong sign near 0.
  EXPECT_GE(count("separating", ContactState::separating), 198);
  for (const char* family :
       {"physical", "inelastic", "elastic", "mass_ratio", "immovable_a", "immovable_b", "driven_wall", "zero_lever",
        "common_velocity", "long_normal", "long_quaternion", "near_special", "needle_tip"}) {
    // One case in four gets features. A few of these features stop both bodies.
    EXPECT_GE(count(family, ContactState::colliding), 190) << family;
  }
  // p = 7/8: 175 ± 5 · 4.7.
  EXPECT_NEAR(count("generic", ContactState::colliding), 175, 24);
}

TEST(Families, AreExactlyHeadOnInAboutHalfOfHeadOn) {
  int exactly = 0;
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
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
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
    const ExactCase exact_case(unit::case_of("stick_or_slip", i).collision);
    if (exact_case.state() != ContactState::colliding) {
      continue;
    }
    const auto& c = exact_case.exact();
    const ExactVector& impulse = exact_case.truth(Law::sticking, ContactState::colliding).impulse;
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
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
    exactly += ExactCase(unit::case_of("near_head_on", i).collision).is_head_on() ? 1 : 0;
  }
  // Three of the 18 ratios 10^-1 … 10^-18 are at or below rounding. p = 3/18: 33 + 5 · 5.3.
  EXPECT_LE(exactly, 60);
}

TEST(Families, AreCollinearAndIsotropicInCollinearSpheres) {
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
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
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
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
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
    const auto exact = oracles::lift(unit::case_of("grazing", i).collision);
    const ExactVector v = unit::velocity_before(exact);
    const ExactVector& n = exact.normal;
    const Rational squared = n.dot(v) * n.dot(v);
    const Rational scale = n.dot(n) * v.dot(v);
    slight += squared * 1000000 <= scale ? 1 : 0;  // |N·V| ≤ 10^-3
  }
  // k ≥ 3 has p = 8/9: 178 − 5 · 4.4.
  EXPECT_GE(slight, 155);
  EXPECT_GT(count("grazing", ContactState::separating), 10);
  EXPECT_GT(count("grazing", ContactState::colliding), 100);
}

/// λI ⪯ K ⪯ 16 λI, with λ = 1/m_A + 1/m_B. The construction of each stored moment and coordinate has fewer than 64
/// roundings. These roundings move an eigenvalue by at most 64 u Σ‖∂K/∂q‖ ‖q‖ (Weyl).
TEST(Families, AreBoundedBySixteenLambdaInPhysical) {
  Rational largest(0);
  for (const char* family : {"physical", "collinear_spheres"}) {
    for (std::uint64_t i = 0; i < exact_cases; ++i) {
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
  for (std::uint64_t i = 0; i < exact_cases; ++i) {
    const ExactCase exact_case(unit::case_of("generic", i).collision);
    above += exact_case.is_bounded_by(16 * oracles::inverse_mass(exact_case.exact())) ? 0 : 1;
  }
  EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace carom::properties
