// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/geometry.hpp>

#include "support/cases.hpp"
#include "support/message_of.hpp"

namespace carom::properties {
namespace {

/// Lever arms of 5 and 2, radii of gyration of √(8 / 4) and 3, and an approach of 6 m/s along a normal of length 2.
Collision known() {
  Collision c;
  c.point = {3, 4, 0};
  c.normal = {0, 2, 0};
  c.a.mass = 2;
  c.a.principal_inertia = {4, 3, 1};
  c.a.velocity = {0, -6, 8};
  c.a.angular_velocity = {0, 0, 0};
  c.b.position = {3, 6, 0};
  c.b.mass = 8;
  c.b.principal_inertia = {48, 48, 48};
  c.b.angular_velocity = {0, 5, 0};
  c.restitution = 0.25;
  c.friction = 3;
  c.tangential_restitution = -0.5;
  return c;
}

TEST(Domain, KnowsTheQuantitiesOfACollision) {
  const std::map<LimitedQuantity, std::vector<double>> expected{
      {LimitedQuantity::size, {5, std::sqrt(2), 2, 3}},
      {LimitedQuantity::mass, {2, 8}},
      {LimitedQuantity::mass_ratio, {4}},
      {LimitedQuantity::moment_ratio, {4, 1}},
      {LimitedQuantity::size_ratio, {3 / std::sqrt(2)}},
      {LimitedQuantity::speed, {10}},
      {LimitedQuantity::approach, {6}},
      {LimitedQuantity::spin, {1.5}},
      {LimitedQuantity::distance, {5 / std::sqrt(2)}},
      {LimitedQuantity::restitution, {0.25}},
      {LimitedQuantity::friction, {3}},
      {LimitedQuantity::tangential_restitution, {-0.5}},
  };
  ASSERT_EQ(expected.size(), all_limited_quantities.size());
  for (const auto& [quantity, values] : expected) {
    const std::vector<double> found = values_of(known(), quantity);
    ASSERT_EQ(found.size(), values.size()) << name_of(quantity);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_DOUBLE_EQ(found[i], values[i]) << name_of(quantity) << ' ' << i;
    }
  }
}

TEST(Domain, LeavesOutWhatACollisionDoesNotHave) {
  Collision c = known();
  c.a = Body{.immovable = true};
  c.b.position = c.point;
  c.b.angular_velocity.setZero();
  c.point.setZero();
  c.b.position.setZero();
  EXPECT_EQ(values_of(c, LimitedQuantity::size), std::vector<double>{3});
  EXPECT_EQ(values_of(c, LimitedQuantity::mass), std::vector<double>{8});
  for (const LimitedQuantity quantity :
       {LimitedQuantity::mass_ratio, LimitedQuantity::size_ratio, LimitedQuantity::speed, LimitedQuantity::approach,
        LimitedQuantity::spin, LimitedQuantity::distance}) {
    EXPECT_TRUE(values_of(c, quantity).empty()) << name_of(quantity);
  }
}

TEST(Domain, LimitsHowFarAndHowFastAWallIs) {
  Collision c = known();
  c.a.velocity.setZero();
  c.b = Body{.immovable = true};
  c.point.setZero();
  c.b.position = {0, 100, 0};
  c.b.angular_velocity = {0, 0, 0.5};
  const double radius = values_of(c, LimitedQuantity::size).back();
  EXPECT_EQ(values_of(c, LimitedQuantity::speed), std::vector<double>{50});
  EXPECT_EQ(values_of(c, LimitedQuantity::distance), std::vector<double>{100 / radius});
}

// The spin of a wall that turns about the contact point moves no point of contact, but an engine still integrates it.
TEST(Domain, LimitsTheSpinAndTheShortLeverArmOfAWall) {
  Collision c = known();
  c.a.velocity.setZero();
  c.b = Body{.immovable = true};
  c.b.position = c.point;
  c.b.angular_velocity = {0, 0, 0.5};
  const std::vector<double> sizes = values_of(c, LimitedQuantity::size);
  EXPECT_EQ(values_of(c, LimitedQuantity::speed), std::vector<double>{sizes.back() / 2});
  c.b.position.x() += 0x1p-20;
  EXPECT_EQ(values_of(c, LimitedQuantity::size).size(), sizes.size() + 1);
  EXPECT_EQ(values_of(c, LimitedQuantity::size).back(), 0x1p-20);
  c.b.position.x() += 1000;
  EXPECT_EQ(values_of(c, LimitedQuantity::size), sizes);
}

TEST(Domain, LimitsSpinsBySpeedIfNoCentreMoves) {
  Collision c = known();
  c.a.velocity.setZero();
  EXPECT_EQ(values_of(c, LimitedQuantity::speed), std::vector<double>{15});
  EXPECT_TRUE(values_of(c, LimitedQuantity::spin).empty());
}

TEST(Domain, ContainsACollisionUpToTheEndsOfEachRange) {
  for (const LimitedQuantity quantity : all_limited_quantities) {
    const std::vector<double> values = values_of(known(), quantity);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const double whole = whole_range(quantity).most;
    const auto names_quantity = [&](double from, double to) {
      Domain domain;
      domain.ranges[quantity] = {from, to};
      return name_outside(domain, known()) == name_of(quantity);
    };
    EXPECT_FALSE(names_quantity(*least, *greatest)) << name_of(quantity);
    EXPECT_TRUE(names_quantity(std::nextafter(*least, whole), whole)) << name_of(quantity);
    EXPECT_TRUE(names_quantity(whole_range(quantity).least, std::nextafter(*greatest, -1))) << name_of(quantity);
  }
}

TEST(Domain, ContainsInvalidCollisions) {
  Collision c = known();
  c.a.mass = -1;
  EXPECT_TRUE(contains(domain_from("mass=1:2"), c));
}

TEST(Domain, IsReadFromItsText) {
  for (const char* text :
       {"everything", "size=0.1:10,mass_ratio=:100", "speed=1e-05:", "restitution=0.5:0.5", "tangential_restitution=:0",
        "plane=xy", "size=0.1:10,bodies=solid_spheres,movable=one,walls=resting,plane=zx"}) {
    EXPECT_EQ(to_text(domain_from(text)), text);
  }
  EXPECT_EQ(domain_from("restitution=0.5"), domain_from("restitution=0.5:0.5"));
  EXPECT_EQ(domain_from("friction=0:"), Domain());
  for (const NamedDomain& named : named_domains()) {
    EXPECT_EQ(domain_from(to_text(domain_from(named.ranges))), domain_from(named.ranges)) << named.name;
    EXPECT_EQ(domain_from(named.name), domain_from(named.ranges));
  }
  EXPECT_EQ(domain_from(R"({"size": [0.1, 10], "mass_ratio": [null, 100]})"),
            domain_from("size=0.1:10,mass_ratio=:100"));
  EXPECT_EQ(domain_from(R"({"plane": "xy", "size": [0.1, 10]})"), domain_from("size=0.1:10,plane=xy"));
  EXPECT_EQ(domain_from("{}"), Domain());
  EXPECT_EQ(domain_from("plane=xy,games,speed=:50"),
            domain_from("size=0.1:10,speed=:50,distance=:500,friction=:1,plane=xy"));
}

TEST(Domain, NamesTheWrongPartOfAText) {
  const std::map<std::string, std::string> expected{
      {"colour=1:2", "'colour=1:2' names no quantity"},
      {"size=1:2,", "'' names no quantity"},
      {"size", "size: expected LEAST:MOST with finite numbers, found ''"},
      {"size=", "size: expected LEAST:MOST with finite numbers, found ''"},
      {"size=1:two", "size: expected LEAST:MOST with finite numbers, found '1:two'"},
      {"size=:inf", "size: expected LEAST:MOST with finite numbers, found ':inf'"},
      {"size=nan:", "size: expected LEAST:MOST with finite numbers, found 'nan:'"},
      {"size=2:1", "size: expected two numbers from 0 to infinity, the lesser first, found 2:1"},
      {"size=-1:1", "size: expected two numbers from 0 to infinity, the lesser first, found -1:1"},
      {"restitution=:2", "restitution: expected two numbers from 0 to 1, the lesser first, found :2"},
      {"mass_ratio=0.5:", "mass_ratio: expected two numbers from 1 to infinity, the lesser first, found 0.5:"},
      {"size=1:2,size=1:3", "size occurs twice"},
      {"plane=xz", "plane: expected one of xy, yz, zx, found 'xz'"},
      {"movable", "movable: expected one of both, one, a, b, found ''"},
      {"walls=0:1", "walls: expected one of resting, found '0:1'"},
      {"bodies=spheres,bodies=spheres", "bodies occurs twice"},
      {"{\"plane\": \"\"}",
       "/plane: expected two numbers, the least and the greatest value, with null for no limit; or"},
      {"{\"plane\": \"x\"}", "plane: expected one of xy, yz, zx, found 'x'"},
      {"{\"plane\": [0, 1]}", "plane: expected one of xy, yz, zx, found '0:1'"},
      {"{\"size\": \"big\"}", "size: expected LEAST:MOST with finite numbers, found 'big'"},
      {"games,robotics", "expected one of the domains games and robotics"},
      {"game", "'game' names no quantity; expected QUANTITY=LEAST:MOST"},
      {"{\"size\": [1]}", "/size: expected two numbers, the least and the greatest value"},
      {"{\"size\": [2, 1]}", "size: expected two numbers from 0 to infinity, the lesser first, found 2:1"},
      {"{\"size\"", "not JSON"},
  };
  for (const auto& [text, said] : expected) {
    const std::string message = unit::message_of<std::invalid_argument>([&text = text] { return domain_from(text); });
    EXPECT_EQ(message.substr(0, said.size()), said) << text;
  }
}

constexpr std::uint64_t seed_of_cases = 3;

std::string text_of(const Case& one) { return collision_to_json(one.collision).dump(); }

/// A narrow range of each quantity, all ranges together, kinds, and the domains that ship with Carom.
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
      "distance=:100,restitution=:0.9,friction=0.1:1,tangential_restitution=0:1",
      "bodies=spheres",
      "bodies=solid_spheres,movable=a,walls=resting",
      "movable=both",
      "movable=one",
      "movable=b,walls=resting,plane=zx",
      "plane=xy",
      "size=0.1:10,mass=1:2,mass_ratio=:1.5,speed=1:100,distance=:10,bodies=solid_spheres,movable=both,plane=yz",
      "size=0.1:10,moment_ratio=2:8,spin=:1,friction=0.1:1,movable=one,walls=resting,plane=xy"};
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
        const Case one = drawn_case_within(domain, family, seed_of_cases, static_cast<std::uint64_t>(i));
        const std::optional<std::string_view> outside = name_outside(domain, one.collision);
        EXPECT_FALSE(outside) << text << ' ' << family.name << ' ' << i << ' ' << *outside;
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
      if (!is_limited && family.name != "spin_alone" && (is_any(domain.kinds) || family.is_still == nullptr)) {
        EXPECT_TRUE(has_cases_within(domain, family, seed_of_cases)) << text << ' ' << family.name;
      }
    }
  }
}

TEST(DrawWithin, DrawsTheCasesOfTheGateIntoEverything) {
  const Family& family = *family_named("structured");
  for (std::uint64_t i = 0; i < 50; ++i) {
    EXPECT_EQ(text_of(drawn_case_within(Domain(), family, seed_of_cases, i)),
              text_of(drawn_case(family, seed_of_cases, i)))
        << i;
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
        for (Body Collision::*const body : {&Collision::a, &Collision::b}) {
          const auto overreach = [&](const Collision& c) { return features::overreach(c, c.*body); };
          constexpr double rounding = 1 + 0x1p-46;  // fewer than 2⁷ roundings of 2⁻⁵³
          EXPECT_LE(overreach(fitted.collision), std::max(1.0, overreach(one.collision)) * rounding)
              << text << ' ' << family << ' ' << i;
        }
      }
    }
  }
}

TEST(DrawWithin, KeepsLeverArmsOfSpheresAlongTheNormal) {
  const Domain domain = domain_from("size=0.1:0.2,mass=1:2,speed=1:2");
  int along = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Collision c = drawn_case_within(domain, *family_named("collinear_spheres"), seed_of_cases, i).collision;
    for (const Body* body : {&c.a, &c.b}) {
      along += body->immovable || features::are_parallel(features::lever_arm(c, *body), c.normal) ? 1 : 0;
    }
  }
  EXPECT_EQ(along, 200);
}

/// Lever arms must not be exact by a contact at the origin alone.
TEST(DrawWithin, LeavesMostContactsAwayFromTheOrigin) {
  for (const char* text :
       {"size=0.01:0.1", "distance=1e3:1e6", "size=0.1:10,mass=1:100,moment_ratio=:8", "bodies=spheres", "plane=xy"}) {
    int at_origin = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      at_origin +=
          drawn_case_within(domain_from(text), *family_named("generic"), seed_of_cases, i).collision.point.isZero(0)
              ? 1
              : 0;
    }
    EXPECT_LT(at_origin, 20) << text;
  }
}

TEST(DrawWithin, KeepsApproachesAndSeparations) {
  const Domain domain = domain_from("size=0.1:0.2,mass=1:2,mass_ratio=:1.5,speed=1:2,spin=:1");
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_TRUE(is_approaching(drawn_case_within(domain, *family_named("elastic"), seed_of_cases, i).collision)) << i;
    EXPECT_FALSE(is_approaching(drawn_case_within(domain, *family_named("resting"), seed_of_cases, i).collision)) << i;
    EXPECT_FALSE(is_approaching(drawn_case_within(domain, *family_named("separating"), seed_of_cases, i).collision))
        << i;
  }
}

TEST(DrawWithin, DrawsOtherCasesForAFamilyWithoutCases) {
  const Domain domain = domain_from("restitution=0.25:0.5");
  const Family& elastic = *family_named("elastic");
  EXPECT_FALSE(has_cases_within(domain, elastic, seed_of_cases));
  const Case one = drawn_case_within(domain, elastic, seed_of_cases, 0);
  EXPECT_EQ(text_of(one), text_of(drawn_case_within(domain, *family_named("generic"), seed_of_cases, 0)));
}

TEST(DrawWithin, FailsIfNoCollisionLiesInTheDomain) {
  const Domain empty = domain_from("size=1:2,size_ratio=3:");
  EXPECT_FALSE(has_cases_within(empty, *family_named("generic"), seed_of_cases));
  EXPECT_EQ(unit::message_of<std::invalid_argument>(
                [&] { return drawn_case_within(empty, *family_named("head_on"), seed_of_cases, 0); }),
            "no case of `head_on` lies within size=1:2,size_ratio=3:");
}

}  // namespace
}  // namespace carom::properties
