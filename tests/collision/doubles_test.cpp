// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>

#include "support/cases.hpp"

namespace carom {
namespace {

/// The collision whose number at each place of for_each_double is the place.
Collision numbered() {
  Collision collision;
  detail::for_each_double(
      [](const FieldPath&, std::size_t place, double& number) { number = static_cast<double>(place); }, collision);
  return collision;
}

TEST(Doubles, OfACollisionHaveTheDocumentedOrder) {
  std::vector<std::string> paths;
  for (std::size_t place = 0; place < doubles_of_a_collision; ++place) {
    paths.push_back(path_of_double(place).text());
  }
  std::vector<std::string> expected;
  const auto expect = [&](const std::string& field, int size) {
    for (int i = 0; i < size; ++i) {
      expected.push_back(size == 1 ? field : field + '[' + std::to_string(i) + ']');
    }
  };
  for (const std::string body : {"a.", "b."}) {
    expect(body + "immovable", 1);
    expect(body + "mass", 1);
    expect(body + "principal_inertia", 3);
    expect(body + "orientation", 4);
    expect(body + "position", 3);
    expect(body + "velocity", 3);
    expect(body + "angular_velocity", 3);
  }
  expect("point", 3);
  expect("normal", 3);
  expect("restitution", 1);
  expect("friction", 1);
  expect("tangential_restitution", 1);
  EXPECT_EQ(paths, expected);
}

TEST(Doubles, OfACollisionStandAtTheirPlaces) {
  const auto doubles = doubles_of(numbered());
  for (std::size_t place = 0; place < doubles.size(); ++place) {
    const bool is_flag = path_of_double(place).field == "immovable";
    EXPECT_EQ(doubles[place], is_flag ? 0 : static_cast<double>(place));
  }
}

TEST(Doubles, OfAnImmovableBodyHaveNoMassInertiaAndOrientation) {
  for (const bool is_a : {true, false}) {
    Collision collision = numbered();
    (is_a ? collision.a : collision.b).immovable = true;
    const auto doubles = doubles_of(collision);
    const std::size_t flag = is_a ? 0 : 18;
    EXPECT_EQ(doubles[flag], 1);
    EXPECT_EQ(doubles[is_a ? 18 : 0], 0);
    for (std::size_t i = 1; i <= 8; ++i) {
      EXPECT_EQ(doubles[flag + i], 0);
    }
    EXPECT_EQ(doubles[flag + 9], static_cast<double>(flag + 9));
    const Collision read = collision_of(doubles);
    EXPECT_EQ((is_a ? read.a : read.b).mass, 1) << "as if it had been read from JSON";
    EXPECT_EQ(doubles_of(read), doubles);
  }
}

TEST(Doubles, GiveTheSameCollision) {
  for (const auto& [family, one] : unit::valid_cases(20)) {
    const Collision read = collision_of(doubles_of(one.collision));
    EXPECT_EQ(collision_to_json(read), collision_to_json(one.collision)) << family;
  }
}

TEST(Doubles, GiveTheSameOutcomeAndMatrix) {
  std::array<double, doubles_of_an_outcome> outcome{};
  std::array<double, doubles_of_a_matrix> matrix{};
  for (std::size_t i = 0; i < outcome.size(); ++i) {
    outcome[i] = static_cast<double>(i) / 7;
  }
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    matrix[i] = static_cast<double>(i) / 11;
  }
  const auto read = outcome_of<long double>(outcome);
  EXPECT_EQ(static_cast<double>(read.a.velocity[1]), outcome[1]);
  EXPECT_EQ(static_cast<double>(read.a.angular_velocity[0]), outcome[3]);
  EXPECT_EQ(static_cast<double>(read.b.velocity[2]), outcome[8]);
  EXPECT_EQ(static_cast<double>(read.b.angular_velocity[2]), outcome[11]);
  EXPECT_EQ(doubles_of(read), outcome);
  EXPECT_EQ(matrix_of<double>(matrix)(0, 2), matrix[2]);
  EXPECT_EQ(doubles_of(matrix_of<long double>(matrix)), matrix);
}

}  // namespace
}  // namespace carom
