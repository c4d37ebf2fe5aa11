// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <carom/collision/validate.hpp>

#include "support/cases.hpp"

namespace carom {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

/// The defect that the change causes: "field: expected …", "none" or "several: …".
template <class Change>
std::string defect_of(const Change& change) {
  Collision collision;
  change(collision);
  const std::vector<Defect> defects = validate(collision);
  if (defects.empty()) {
    return "none";
  }
  return (defects.size() > 1 ? "several: " : "") + describe(defects);
}

TEST(Validate, AcceptsTheDefaultCollision) { EXPECT_EQ(describe(validate(Collision{})), ""); }

TEST(Validate, NamesEachNumberThatIsNotFinite) {
  for (const double bad : {nan, infinity, -infinity}) {
    int count = 0;
    Collision shape;
    for_each_number([&](const FieldPath&, double&) { ++count; }, shape);
    for (int chosen = 0; chosen < count; ++chosen) {
      Collision collision;
      std::string place;
      int index = 0;
      for_each_number(
          [&](const FieldPath& path, double& number) {
            if (index++ == chosen) {
              number = bad;
              place = path.text();
            }
          },
          collision);
      const std::vector<Defect> defects = validate(collision);
      ASSERT_FALSE(defects.empty()) << place << " = " << bad;
      EXPECT_EQ(defects[0].field, place);
      EXPECT_EQ(defects[0].expected, "a finite number");
      // An infinite number may also be out of range.
      EXPECT_LE(defects.size(), std::isnan(bad) ? 1U : 2U) << describe(defects);
      for (const Defect& defect : defects) {
        EXPECT_EQ(defect.field, place) << bad;
      }
    }
  }
}

TEST(Validate, NamesAMassThatIsNotPositive) {
  for (const double bad : {0.0, -0.0, -tiny, -1.0}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.a.mass = bad; }), "a.mass: expected greater than 0");
    EXPECT_EQ(defect_of([=](Collision& c) { c.b.mass = bad; }), "b.mass: expected greater than 0");
  }
  EXPECT_EQ(defect_of([](Collision& c) { c.a.mass = tiny; }), "none");
}

TEST(Validate, NamesThePrincipalMomentThatIsNotPositive) {
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {0.0, -tiny}) {
      const auto expected = [i](char body) {
        return fmt::format("{}.principal_inertia[{}]: expected greater than 0", body, i);
      };
      EXPECT_EQ(defect_of([=](Collision& c) { c.a.principal_inertia[i] = bad; }), expected('a'));
      EXPECT_EQ(defect_of([=](Collision& c) { c.b.principal_inertia[i] = bad; }), expected('b'));
    }
  }
}

TEST(Validate, NamesAnOrientationOfNoLength) {
  EXPECT_EQ(defect_of([](Collision& c) { c.a.orientation.setZero(); }),
            "a.orientation: expected a quaternion of nonzero length");
  EXPECT_EQ(defect_of([](Collision& c) { c.b.orientation.setZero(); }),
            "b.orientation: expected a quaternion of nonzero length");
  EXPECT_EQ(defect_of([](Collision& c) { c.b.orientation = {0, 0, 0, tiny}; }), "none");
}

TEST(Validate, NamesANormalOfNoLength) {
  EXPECT_EQ(defect_of([](Collision& c) { c.normal.setZero(); }), "normal: expected a vector of nonzero length");
  EXPECT_EQ(defect_of([](Collision& c) { c.normal = {tiny, 0, 0}; }), "none");
}

TEST(Validate, NamesCoefficientsOutOfRange) {
  const double above_one = std::nextafter(1.0, 2.0);
  for (const double bad : {-tiny, above_one}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.restitution = bad; }), "restitution: expected a number from 0 to 1");
  }
  EXPECT_EQ(defect_of([](Collision& c) { c.friction = -tiny; }), "friction: expected at least 0");
  for (const double bad : {-above_one, above_one}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.tangential_restitution = bad; }),
              "tangential_restitution: expected a number from -1 to 1");
  }
}

TEST(Validate, AcceptsTheEndsOfEachRange) {
  for (const double end : {0.0, 1.0}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.restitution = end; }), "none");
  }
  for (const double end : {0.0, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.friction = end; }), "none");
  }
  for (const double end : {-1.0, 1.0}) {
    EXPECT_EQ(defect_of([=](Collision& c) { c.tangential_restitution = end; }), "none");
  }
}

TEST(Validate, DoesNotReadTheMassInertiaAndOrientationOfAnImmovableBody) {
  for (Body Collision::*body : {&Collision::a, &Collision::b}) {
    Collision collision;
    Body& wall = collision.*body;
    wall.immovable = true;
    wall.mass = nan;
    wall.principal_inertia.setConstant(nan);
    wall.orientation.setConstant(nan);
    EXPECT_EQ(describe(validate(collision)), "");
    wall.mass = -1;
    wall.principal_inertia.setZero();
    wall.orientation.setZero();
    EXPECT_EQ(describe(validate(collision)), "");
    wall.immovable = false;
    EXPECT_EQ(validate(collision).size(), 5U) << describe(validate(collision));
  }
}

TEST(Validate, StillReadsThePlaceAndMotionOfAnImmovableBody) {
  for (Vector3<double> Body::*field : {&Body::position, &Body::velocity, &Body::angular_velocity}) {
    Collision collision;
    collision.b.immovable = true;
    (collision.b.*field)[1] = nan;
    EXPECT_EQ(validate(collision).size(), 1U);
  }
}

TEST(Validate, FindsEveryDefectAtOnce) {
  Collision collision;
  collision.a.mass = 0;
  collision.b.velocity[2] = nan;
  collision.normal.setZero();
  collision.restitution = 2;
  EXPECT_EQ(describe(validate(collision)),
            "b.velocity[2]: expected a finite number; a.mass: expected greater than 0; "
            "normal: expected a vector of nonzero length; restitution: expected a number from 0 to 1");
}

}  // namespace
}  // namespace carom
