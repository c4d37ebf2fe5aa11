// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/collision.hpp>
#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/outcome.hpp>

#include "support/cases.hpp"

namespace carom {
namespace {

std::vector<std::string> paths_of(const Collision& collision) {
  std::vector<std::string> paths;
  for_each_number([&](const FieldPath& path, const double&) { paths.push_back(path.text()); }, collision);
  return paths;
}

std::vector<std::string> numbered(const std::string& field, int count) {
  std::vector<std::string> paths;
  for (int i = 0; i < count; ++i) {
    paths.push_back(field + '[' + std::to_string(i) + ']');
  }
  return paths;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

std::vector<std::string> body_paths(const std::string& name, bool immovable) {
  std::vector<std::string> paths;
  if (!immovable) {
    paths.push_back(name + ".mass");
    append(paths, numbered(name + ".principal_inertia", 3));
    append(paths, numbered(name + ".orientation", 4));
  }
  append(paths, numbered(name + ".position", 3));
  append(paths, numbered(name + ".velocity", 3));
  append(paths, numbered(name + ".angular_velocity", 3));
  return paths;
}

std::vector<std::string> contact_paths() {
  std::vector<std::string> paths = numbered("point", 3);
  append(paths, numbered("normal", 3));
  append(paths, {"restitution", "friction", "tangential_restitution"});
  return paths;
}

TEST(ForEachNumber, VisitsEveryNumberOnceInTheOrderOfTheRecord) {
  for (const bool a_is_fixed : {false, true}) {
    for (const bool b_is_fixed : {false, true}) {
      Collision collision;
      collision.a.immovable = a_is_fixed;
      collision.b.immovable = b_is_fixed;
      std::vector<std::string> expected = body_paths("a", a_is_fixed);
      append(expected, body_paths("b", b_is_fixed));
      append(expected, contact_paths());
      EXPECT_EQ(paths_of(collision), expected);
    }
  }
}

TEST(ForEachNumber, GivesThePathOfTheNumberThatItGives) {
  Collision c;
  c.a.mass = 1.5;
  c.a.principal_inertia = {2, 3, 4};
  c.a.orientation = {5, 6, 7, 8};
  c.b.angular_velocity = {9, 10, 11};
  c.normal = {12, 13, 14};
  c.tangential_restitution = -0.25;
  std::vector<std::string> found;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        if (number == 1.5 || number == -0.25 || number >= 2) {
          found.push_back(path.text() + "=" + std::to_string(number).substr(0, 5));
        }
      },
      c);
  EXPECT_EQ(found, (std::vector<std::string>{
                       "a.mass=1.500", "a.principal_inertia[0]=2.000", "a.principal_inertia[1]=3.000",
                       "a.principal_inertia[2]=4.000", "a.orientation[0]=5.000", "a.orientation[1]=6.000",
                       "a.orientation[2]=7.000", "a.orientation[3]=8.000", "b.angular_velocity[0]=9.000",
                       "b.angular_velocity[1]=10.00", "b.angular_velocity[2]=11.00", "normal[0]=12.00",
                       "normal[1]=13.00", "normal[2]=14.00", "tangential_restitution=-0.25"}));
}

TEST(ForEachNumber, WalksSeveralCollisionsSideBySide) {
  const Collision from = unit::case_of("generic", 1).collision;
  Collision to;
  for_each_number([](const FieldPath&, const double& x, double& y) { y = x; }, from, to);
  for_each_number([](const FieldPath& path, const double& x,
                     const double& y) { EXPECT_TRUE(unit::same_bits(x, y)) << path.text(); },
                  from, to);
}

TEST(ForEachNumber, SkipsTheNumbersThatTheFirstCollisionDoesNotHave) {
  Collision first;
  first.b.immovable = true;
  Collision second;
  second.a.immovable = true;
  int masses_of_a = 0;
  int masses_of_b = 0;
  for_each_number(
      [&](const FieldPath& path, double&, double&) {
        masses_of_a += path.text() == "a.mass" ? 1 : 0;
        masses_of_b += path.text() == "b.mass" ? 1 : 0;
      },
      first, second);
  EXPECT_EQ(masses_of_a, 1);
  EXPECT_EQ(masses_of_b, 0);
}

TEST(MapNumbers, ConvertsEveryNumberAndKeepsWhichBodiesAreImmovable) {
  for (const auto& [family, one] : unit::valid_cases(5)) {
    const Collision& c = one.collision;
    const auto wide = map_numbers<long double>(c, [](double x) { return 3 * static_cast<long double>(x); });
    EXPECT_EQ(wide.a.immovable, c.a.immovable) << family;
    EXPECT_EQ(wide.b.immovable, c.b.immovable) << family;
    for_each_number([](const FieldPath& path, const double& x,
                       const long double& y) { EXPECT_EQ(y, 3 * static_cast<long double>(x)) << path.text(); },
                    c, wide);
  }
}

TEST(MapNumbers, SkipsTheMassInertiaAndOrientationOfAnImmovableBody) {
  Collision c;
  c.a.immovable = true;
  c.a.mass = std::numeric_limits<double>::quiet_NaN();
  c.a.orientation.setConstant(std::numeric_limits<double>::quiet_NaN());
  const auto mapped = map_numbers<double>(c, [](double x) {
    EXPECT_FALSE(std::isnan(x));
    return x;
  });
  EXPECT_FALSE(std::isnan(mapped.a.mass));
}

TEST(MapOutcome, ConvertsTheFourVectorsInTheirOrder) {
  const Outcome<double> outcome{{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}};
  const auto doubled = map_outcome<int>(outcome, [](double x) { return static_cast<int>(2 * x); });
  std::vector<int> numbers;
  for (const auto* vector : vectors(doubled)) {
    numbers.insert(numbers.end(), {(*vector)[0], (*vector)[1], (*vector)[2]});
  }
  EXPECT_EQ(numbers, (std::vector<int>{2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24}));
}

TEST(WithVelocities, PutsTheOutcomeInPlaceOfTheVelocitiesAndNothingElse) {
  const Collision c = unit::case_of("generic", 2).collision;
  const Outcome<double> outcome{{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}};
  const Collision after = with_velocities(c, outcome);
  EXPECT_EQ(doubles_of(unchanged(after)), doubles_of(outcome));
  for_each_number(
      [](const FieldPath& path, const double& x, const double& y) {
        if (path.field != "velocity" && path.field != "angular_velocity") {
          EXPECT_TRUE(unit::same_bits(x, y)) << path.text();
        }
      },
      c, after);
}

/// The collision whose number at each place of for_each_double is the place.
Collision with_places() {
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
  std::vector<std::string> expected{"a.immovable"};
  append(expected, body_paths("a", false));
  append(expected, {"b.immovable"});
  append(expected, body_paths("b", false));
  append(expected, contact_paths());
  EXPECT_EQ(paths, expected);
}

TEST(Doubles, OfACollisionStandAtTheirPlaces) {
  const auto doubles = doubles_of(with_places());
  for (std::size_t place = 0; place < doubles.size(); ++place) {
    const bool is_flag = path_of_double(place).field == "immovable";
    EXPECT_EQ(doubles[place], is_flag ? 0 : static_cast<double>(place));
  }
}

TEST(Doubles, OfAnImmovableBodyHaveNoMassInertiaAndOrientation) {
  for (const bool is_a : {true, false}) {
    Collision collision = with_places();
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
  std::iota(outcome.begin(), outcome.end(), 1.0 / 7);
  std::iota(matrix.begin(), matrix.end(), 1.0 / 11);
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
