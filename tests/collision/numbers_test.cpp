// SPDX-License-Identifier: BSL-1.0
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>

#include "support/cases.hpp"

namespace carom {
namespace {

TEST(ForEachNumber, LetsTheFirstCollisionDecideWhatIsPassedOver) {
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

TEST(MapNumbers, DoesNotConvertWhatAnImmovableBodyHasNot) {
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
  const Outcome<double> read_back = unchanged(after);
  for (const OutcomeVector k : all_outcome_vectors) {
    EXPECT_EQ(*vectors(read_back)[k], *vectors(outcome)[k]) << name_of(k);
  }
  for_each_number(
      [](const FieldPath& path, const double& x, const double& y) {
        if (path.field != "velocity" && path.field != "angular_velocity") {
          EXPECT_TRUE(unit::same_bits(x, y)) << path.text();
        }
      },
      c, after);
}

}  // namespace
}  // namespace carom
