// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/gate/shrink.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

constexpr std::size_t ample = 100000;

double normal_velocity(const Collision& c) {
  const auto cross = [](const Vector3<double>& x, const Vector3<double>& y) {
    return Vector3<double>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  };
  return c.normal.dot((c.a.velocity + cross(c.a.angular_velocity, c.point - c.a.position)) -
                      (c.b.velocity + cross(c.b.angular_velocity, c.point - c.b.position)));
}

bool collides_upward(const Collision& c) { return c.normal[1] > 0 && normal_velocity(c) < 0; }

TEST(Simpler, GivesValidAndStrictlySimplerCollisionsOnly) {
  std::size_t candidates = 0;
  for (const auto& [family, one] : unit::valid_cases(5)) {
    const long before = complexity(one.collision);
    for (const Collision& candidate : simpler(one.collision)) {
      EXPECT_LT(complexity(candidate), before) << family;
      EXPECT_EQ(describe(validate(candidate)), "") << family;
      ++candidates;
    }
  }
  EXPECT_GT(candidates, 1000U);
}

/// `simpler` rounds and doubles numbers. It must not return a collision in which such a number overflows. Runs in
/// another process, because `complexity` might not terminate for a number that is not finite.
void simplify_at_the_ends(double x) {
  constexpr unsigned seconds_until_it_counts_as_endless = 20;
  alarm(seconds_until_it_counts_as_endless);
  Collision c;
  c.a.mass = x;
  c.a.principal_inertia.setConstant(x);
  c.a.position = {x, -x, x};
  c.b.velocity = {-x, x, x};
  c.normal = {x, x, x};
  const std::vector<Collision> candidates = simpler(c);
  bool all_valid = !candidates.empty();
  for (const Collision& candidate : candidates) {
    all_valid = all_valid && validate(candidate).empty();
  }
  std::exit(all_valid ? 0 : 1);
}

TEST(Simpler, StaysValidAtTheEndsOfBinary64) {
  using Limits = std::numeric_limits<double>;
  for (const double x : {Limits::max(), Limits::max() / 2, Limits::min(), Limits::denorm_min()}) {
    EXPECT_EXIT(simplify_at_the_ends(x), testing::ExitedWithCode(0), "") << x;
  }
}

TEST(Complexity, CountsNothingForTheSimplestBody) {
  Collision c;
  c.normal.setZero();
  c.restitution = 0;
  EXPECT_EQ(complexity(c), 0);
}

TEST(Complexity, OrdersNumbersAsAReaderWould) {
  const auto of = [](double x) {
    Collision c;
    c.point[0] = x;
    return complexity(c);
  };
  EXPECT_LT(of(0), of(1));
  EXPECT_LT(of(1), of(-1));
  EXPECT_LT(of(1), of(2));
  EXPECT_LT(of(2), of(1024));
  EXPECT_LT(of(1), of(0.5));
  EXPECT_LT(of(0.5), of(0.75));
  EXPECT_LT(of(0.75), of(0.1));
  EXPECT_LT(of(1), of(std::numeric_limits<double>::denorm_min()));
}

TEST(Shrink, EndsWhereNothingSimplerFails) {
  int shrunk_cases = 0;
  for (const char* family : {"generic", "near_head_on", "driven_wall", "long_normal"}) {
    for (std::uint64_t i = 0; i < 5; ++i) {
      Collision c = unit::case_of(family, i).collision;
      if (c.normal[1] < 0) {
        c.normal[1] = -c.normal[1];
      }
      if (!collides_upward(c)) {
        continue;
      }
      ++shrunk_cases;
      const Collision shrunk = shrink(c, collides_upward, ample);
      EXPECT_TRUE(collides_upward(shrunk)) << family;
      EXPECT_EQ(describe(validate(shrunk)), "") << family;
      for (const Collision& candidate : simpler(shrunk)) {
        EXPECT_FALSE(collides_upward(candidate)) << family;
      }
    }
  }
  EXPECT_GT(shrunk_cases, 5);
}

/// A case shrinks to one body, a normal and a velocity with one component each, as in a textbook.
TEST(Shrink, ReachesSmallDyadicNumbers) {
  int shrunk_cases = 0;
  for (std::uint64_t i = 0; i < 30; ++i) {
    const Collision c = unit::case_of("generic", i).collision;
    if (!collides_upward(c)) {
      continue;
    }
    ++shrunk_cases;
    const Collision shrunk = shrink(c, collides_upward, ample);
    for_each_number(
        [&](const FieldPath& path, const double& number) {
          EXPECT_TRUE(std::abs(number) <= 8 && number * 8 == std::round(number * 8))
              << i << ": " << path.text() << " = " << number;
        },
        shrunk);
    // Only a few numbers remain besides one component of a normal and one of a velocity.
    EXPECT_LE(complexity(shrunk), 24) << i;
  }
  EXPECT_GT(shrunk_cases, 4);
}

TEST(Shrink, GivesTheSimplestCollisionOfAllWhereEverythingFails) {
  const Collision shrunk = shrink(
      unit::case_of("generic", 0).collision, [](const Collision&) { return true; }, ample);
  EXPECT_TRUE(shrunk.a.immovable && shrunk.b.immovable);
  int nonzero = 0;
  for_each_number([&](const FieldPath&, const double& number) { nonzero += number != 0 ? 1 : 0; }, shrunk);
  EXPECT_EQ(nonzero, 1);  // the normal cannot be zero
}

TEST(Shrink, KeepsACollisionThatNothingSimplerReplaces) {
  const Collision c = unit::case_of("generic", 3).collision;
  const Collision shrunk = shrink(
      c, [](const Collision&) { return false; }, ample);
  for_each_number([](const FieldPath& path, const double& x,
                     const double& y) { EXPECT_TRUE(unit::same_bits(x, y)) << path.text(); },
                  c, shrunk);
}

TEST(Shrink, CallsThePredicateNoMoreThanItMay) {
  const Collision c = unit::case_of("generic", 0).collision;
  for (const std::size_t most : {0U, 1U, 7U, 100U}) {
    std::size_t calls = 0;
    (void)shrink(
        c,
        [&](const Collision&) {
          ++calls;
          return calls % 3 == 0;
        },
        most);
    EXPECT_EQ(calls, most);
  }
}

}  // namespace
}  // namespace carom::properties
