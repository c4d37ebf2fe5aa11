// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/geometry.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

constexpr std::uint64_t seed = 3;

std::string text_of(const Case& one) { return collision_to_json(one.collision).dump(); }

/// A narrow range of each quantity, all ranges together, and the domains that ship with Carom.
std::vector<std::string> some_domains() {
  std::vector<std::string> texts{
      "size=1e-6:1e-5",
      "size=1:2",
      "mass=1:1",
      "mass_ratio=:1.5",
      "mass_ratio=100:200",
      "moment_ratio=:1.01",
      "moment_ratio=4:",
      "size_ratio=:1.1",
      "size_ratio=5:50",
      "speed=10:20",
      "approach=0.1:0.2",
      "spin=2:3",
      "spin=:0.001",
      "distance=:0.01",
      "distance=1e3:1e6",
      "restitution=0.5",
      "friction=0.1:0.2",
      "friction=2:",
      "tangential_restitution=0",
      "size=0.1:10,mass=1:100,mass_ratio=:10,moment_ratio=:8,size_ratio=:10,speed=0.01:100,approach=0.001:50,spin=:10,"
      "distance=:100,restitution=:0.9,friction=0.1:1,tangential_restitution=0:1"};
  for (const NamedDomain& named : named_domains()) {
    texts.emplace_back(named.ranges);
  }
  return texts;
}

TEST(DrawWithin, DrawsEachFamilyIntoTheDomain) {
  for (const std::string& text : some_domains()) {
    const Domain domain = domain_from(text);
    for (const Family& family : all_families()) {
      for (int i = 0; i < unit::effort(20); ++i) {
        const Case one = drawn_case_within(domain, family, seed, static_cast<std::uint64_t>(i));
        const std::optional<LimitedQuantity> outside = quantity_outside(domain, one.collision);
        EXPECT_FALSE(outside) << text << ' ' << family.name << ' ' << i << ' ' << name_of(*outside);
        EXPECT_EQ(validate(one.collision).empty(), family.is_valid) << text << ' ' << family.name << ' ' << i;
      }
    }
  }
}

TEST(DrawWithin, LeavesNoFamilyWithoutCasesIfOnlyMagnitudesAreLimited) {
  for (const std::string& text : some_domains()) {
    const Domain domain = domain_from(text);
    for (const Family& family : all_families()) {
      const bool is_limited = family.keeps && domain.ranges[*family.keeps] != whole_range(*family.keeps);
      // Bodies of spin_alone do not move, so they have no approach of their own.
      if (!is_limited && family.name != "spin_alone") {
        EXPECT_TRUE(has_cases_within(domain, family, seed)) << text << ' ' << family.name;
      }
    }
  }
}

TEST(DrawWithin, DrawsTheCasesOfTheGateIntoEverything) {
  const Family& family = *family_named("structured");
  for (std::uint64_t i = 0; i < 50; ++i) {
    EXPECT_EQ(text_of(drawn_case_within(Domain(), family, seed, i)), text_of(drawn_case(family, seed, i))) << i;
  }
}

TEST(DrawWithin, LeavesACaseWithinTheDomainAsItIs) {
  const Domain domain = domain_from("size=1e-3:1e3,speed=1e-3:1e3");
  int inside = 0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Case one = unit::case_of("generic", i);
    if (contains(domain, one.collision)) {
      ++inside;
      Case fitted = one;
      Stream empty([]() -> std::uint64_t { throw std::logic_error("a draw"); });
      EXPECT_TRUE(fit_into(domain, {}, empty, fitted));
      EXPECT_EQ(text_of(fitted), text_of(one)) << i;
    }
  }
  EXPECT_GT(inside, 20);
}

/// The gate would otherwise find violations by every solver in a narrow domain.
TEST(DrawWithin, PutsNoContactFurtherOutsideOfABody) {
  for (const std::string& text : some_domains()) {
    const Domain domain = domain_from(text);
    for (const char* family : {"structured", "generic", "physical"}) {
      for (int i = 0; i < unit::effort(100); ++i) {
        const Case one = unit::case_of(family, static_cast<std::uint64_t>(i));
        Case fitted = one;
        Stream stream = stream_from(static_cast<std::uint64_t>(i));
        if (!fit_into(domain, {}, stream, fitted)) {
          continue;
        }
        const auto overreach = [](const Collision& c, const Body& body) { return features::overreach(c, body); };
        constexpr double rounding = 1 + 0x1p-46;  // fewer than 2⁷ roundings of 2⁻⁵³
        EXPECT_LE(overreach(fitted.collision, fitted.collision.a),
                  std::max(1.0, overreach(one.collision, one.collision.a)) * rounding)
            << text << ' ' << family << ' ' << i;
        EXPECT_LE(overreach(fitted.collision, fitted.collision.b),
                  std::max(1.0, overreach(one.collision, one.collision.b)) * rounding)
            << text << ' ' << family << ' ' << i;
      }
    }
  }
}

TEST(DrawWithin, KeepsLeverArmsOfSpheresAlongTheNormal) {
  const Domain domain = domain_from("size=0.1:0.2,mass=1:2,speed=1:2");
  int along = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Collision c = drawn_case_within(domain, *family_named("collinear_spheres"), seed, i).collision;
    for (const Body* body : {&c.a, &c.b}) {
      along += body->immovable || features::are_parallel(features::lever_arm(c, *body), c.normal) ? 1 : 0;
    }
  }
  EXPECT_EQ(along, 200);
}

/// Lever arms must not be exact by a contact at the origin alone.
TEST(DrawWithin, LeavesMostContactsAwayFromTheOrigin) {
  for (const char* text : {"size=0.01:0.1", "distance=1e3:1e6", "size=0.1:10,mass=1:100,moment_ratio=:8"}) {
    int at_origin = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      at_origin +=
          drawn_case_within(domain_from(text), *family_named("generic"), seed, i).collision.point.isZero(0) ? 1 : 0;
    }
    EXPECT_LT(at_origin, 20) << text;
  }
}

TEST(DrawWithin, KeepsApproachesAndSeparations) {
  const Domain domain = domain_from("size=0.1:0.2,mass=1:2,mass_ratio=:1.5,speed=1:2,spin=:1");
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_TRUE(is_approaching(drawn_case_within(domain, *family_named("elastic"), seed, i).collision)) << i;
    EXPECT_FALSE(is_approaching(drawn_case_within(domain, *family_named("resting"), seed, i).collision)) << i;
    EXPECT_FALSE(is_approaching(drawn_case_within(domain, *family_named("separating"), seed, i).collision)) << i;
  }
}

TEST(DrawWithin, DrawsOtherCasesForAFamilyWithoutCases) {
  const Domain domain = domain_from("restitution=0.25:0.5");
  const Family& elastic = *family_named("elastic");
  EXPECT_FALSE(has_cases_within(domain, elastic, seed));
  const Case one = drawn_case_within(domain, elastic, seed, 0);
  EXPECT_EQ(text_of(one), text_of(drawn_case_within(domain, *family_named("generic"), seed, 0)));
}

TEST(DrawWithin, FailsIfNoCollisionLiesInTheDomain) {
  const Domain empty = domain_from("size=1:2,size_ratio=3:");
  EXPECT_FALSE(has_cases_within(empty, *family_named("generic"), seed));
  try {
    (void)drawn_case_within(empty, *family_named("head_on"), seed, 0);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "no case of `head_on` lies within size=1:2,size_ratio=3:");
  }
}

}  // namespace
}  // namespace carom::properties
