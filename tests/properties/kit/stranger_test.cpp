// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <gtest/gtest.h>

#include <carom/properties/three_properties.hpp>
#include <carom/rapidcheck.hpp>

#include "consumer/my_solver.hpp"

/// A user's solver with a defect, written without Carom.
namespace carom {
namespace {

Outcome<double> without_rotation(const Collision& collision) { return textbook(collision, true); }

bool fails(const Collision& collision) {
  return !properties::non_penetrating_post_velocity(without_rotation, collision);
}

/// Repeatedly takes the first simpler value that fails, as RapidCheck does.
Collision shrunk(rc::Shrinkable<Collision> failing) {
  auto shrinks = failing.shrinks();
  while (auto next = shrinks.next()) {
    if (fails(next->value())) {
      failing = *next;
      shrinks = failing.shrinks();
    }
  }
  return failing.value();
}

/// The count of numbers that are neither 0 nor a default of `Body`. An orientation (w, 0, 0, 0) counts as a default.
int numbers_to_write(const Collision& collision) {
  int count = 0;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        const bool is_unit = (number == 1 && (path.field == "mass" || path.field == "principal_inertia")) ||
                             (path.field == "orientation" && path.component == 0);
        count += number == 0 || is_unit ? 0 : 1;
      },
      collision);
  return count;
}

/// The solver is wrong if a spin w moves one body towards the other. This needs only one nonzero component of each of
/// N, r and w.
constexpr int most_numbers = 3;

TEST(StrangersSolver, IsShrunkToACollisionThatFitsOnPaper) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    rc::Random random(seed);
    for (int size = 0; size <= 100; ++size) {
      const rc::Shrinkable<Collision> drawn = gen::any_family()(random.split(), size);
      if (fails(drawn.value())) {
        const Collision simple = shrunk(drawn);
        ++found;
        EXPECT_LE(numbers_to_write(simple), most_numbers) << rc::toString(simple);
        for_each_number(
            [&](const FieldPath& path, const double& number) {
              EXPECT_LE(std::abs(number), 8) << path.text() << rc::toString(simple);
              EXPECT_EQ(number * 64, std::round(number * 64)) << path.text() << rc::toString(simple);
            },
            simple);
        break;
      }
    }
  }
  EXPECT_EQ(found, 20);
}

}  // namespace
}  // namespace carom
