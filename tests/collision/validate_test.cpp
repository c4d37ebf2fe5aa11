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
constexpr double above_one = 1 + std::numeric_limits<double>::epsilon();

using Change = void (*)(Collision&);

struct Row {
  Change change;
  const char* errors;  // "field: expected …; …", empty if there is none
};

void expect_errors(std::initializer_list<Row> rows) {
  for (const auto& [change, expected] : rows) {
    Collision collision;
    change(collision);
    EXPECT_EQ(describe(validate(collision)), expected);
  }
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
      const std::vector<InputError> errors = validate(collision);
      ASSERT_FALSE(errors.empty()) << place << " = " << bad;
      EXPECT_EQ(errors[0].field, place);
      EXPECT_EQ(errors[0].expected, "a finite number");
      // An infinite number may also be out of range.
      EXPECT_LE(errors.size(), std::isnan(bad) ? 1U : 2U) << describe(errors);
      for (const InputError& error : errors) {
        EXPECT_EQ(error.field, place) << bad;
      }
    }
  }
}

TEST(Validate, NamesEachNumberThatIsOutOfRange) {
  expect_errors({
      {[](Collision& c) { c.a.mass = 0; }, "a.mass: expected greater than 0"},
      {[](Collision& c) { c.a.mass = -0.0; }, "a.mass: expected greater than 0"},
      {[](Collision& c) { c.b.mass = -tiny; }, "b.mass: expected greater than 0"},
      {[](Collision& c) { c.a.principal_inertia[0] = 0; }, "a.principal_inertia[0]: expected greater than 0"},
      {[](Collision& c) { c.a.principal_inertia[1] = -tiny; }, "a.principal_inertia[1]: expected greater than 0"},
      {[](Collision& c) { c.b.principal_inertia[2] = 0; }, "b.principal_inertia[2]: expected greater than 0"},
      {[](Collision& c) { c.a.orientation.setZero(); }, "a.orientation: expected a quaternion of nonzero length"},
      {[](Collision& c) { c.b.orientation.setZero(); }, "b.orientation: expected a quaternion of nonzero length"},
      {[](Collision& c) { c.normal.setZero(); }, "normal: expected a vector of nonzero length"},
      {[](Collision& c) { c.restitution = -tiny; }, "restitution: expected a number from 0 to 1"},
      {[](Collision& c) { c.restitution = above_one; }, "restitution: expected a number from 0 to 1"},
      {[](Collision& c) { c.friction = -tiny; }, "friction: expected at least 0"},
      {[](Collision& c) { c.tangential_restitution = -above_one; },
       "tangential_restitution: expected a number from -1 to 1"},
      {[](Collision& c) { c.tangential_restitution = above_one; },
       "tangential_restitution: expected a number from -1 to 1"},
  });
}

TEST(Validate, AcceptsTheEndsOfEachRange) {
  expect_errors({{[](Collision& c) { c.a.mass = tiny; }, ""},
                 {[](Collision& c) {
                    c.b.orientation = {0, 0, 0, tiny};
                  },
                  ""},
                 {[](Collision& c) {
                    c.normal = {tiny, 0, 0};
                  },
                  ""},
                 {[](Collision& c) { c.restitution = 0; }, ""},
                 {[](Collision& c) { c.restitution = 1; }, ""},
                 {[](Collision& c) { c.friction = 0; }, ""},
                 {[](Collision& c) { c.friction = std::numeric_limits<double>::max(); }, ""},
                 {[](Collision& c) { c.tangential_restitution = -1; }, ""},
                 {[](Collision& c) { c.tangential_restitution = 1; }, ""}});
}

TEST(Validate, DoesNotReadWhatAnImmovableBodyHasNot) {
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

TEST(Validate, NamesEveryErrorAtOnce) {
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
