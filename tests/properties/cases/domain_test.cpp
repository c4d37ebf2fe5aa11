// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/cases/domain.hpp>

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
      return quantity_outside(domain, known()) == quantity;
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
  for (const char* text : {"everything", "size=0.1:10,mass_ratio=:100", "speed=1e-05:", "restitution=0.5:0.5",
                           "tangential_restitution=:0"}) {
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
  EXPECT_EQ(domain_from("{}"), Domain());
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
      {"game", "'game' names no quantity; expected QUANTITY=LEAST:MOST"},
      {"{\"size\": [1]}", "/size: expected two numbers, the least and the greatest value"},
      {"{\"size\": [2, 1]}", "size: expected two numbers from 0 to infinity, the lesser first, found 2:1"},
      {"{\"size\"", "not JSON"},
  };
  for (const auto& [text, said] : expected) {
    try {
      (void)domain_from(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, said.size()), said);
    }
  }
}

}  // namespace
}  // namespace carom::properties
