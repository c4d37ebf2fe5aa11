// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/gate/witness.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

constexpr std::size_t ample = 100000;

bool collides_upward(const Collision& c) { return c.normal[1] > 0 && is_approaching(c); }

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

Verdict violated(double residual, double allowed) {
  return {.status = Status::violated, .residual = residual, .allowed = allowed};
}

/// Violated in each case. If A moves along x, the residual is gross. Otherwise, the residual is a rounding error, but
/// the permitted residual is 0.
Verdict wrong_where_a_moves_along_x(const Case& one) {
  return one.collision.a.velocity[0] != 0 ? violated(2.74, 1e-15) : violated(4e-29, 0);
}

TEST(SimplestViolation, IsAsGrossAsTheOneFound) {
  const Invariant& restitution = *invariant_named("restitution");
  int shrunk_cases = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Case found = unit::case_of("generic", i);
    if (found.collision.a.velocity[0] == 0) {
      continue;
    }
    const Case simplest =
        simplest_violation(found, restitution, wrong_where_a_moves_along_x(found), wrong_where_a_moves_along_x, 4000);
    EXPECT_NE(simplest.collision.a.velocity[0], 0) << i;
    shrunk_cases += simplest.collision.b.velocity.isZero(0) ? 1 : 0;
  }
  EXPECT_GT(shrunk_cases, 0) << "else nothing was simplified";
}

/// Violated in each case. If A moves along x, all digits are lost. Otherwise, only the last digit is lost, but the
/// permitted residual is far smaller than in the first case.
Verdict loses_all_digits_where_a_moves_along_x(const Case& one) {
  const bool loses_all = one.collision.a.velocity[0] != 0;
  Verdict verdict = loses_all ? violated(1, 1e-9) : violated(1e-16, 1e-30);
  verdict.left = {1};
  verdict.right = {loses_all ? 2 : 1 + 1e-16};
  return verdict;
}

TEST(SimplestViolation, LosesTheDigitsThatTheOneFoundLost) {
  const auto verdict_on = loses_all_digits_where_a_moves_along_x;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Case found = unit::case_of("generic", i);
    if (found.collision.a.velocity[0] != 0) {
      const Case simplest =
          simplest_violation(found, *invariant_named("homogeneous"), verdict_on(found), verdict_on, 4000);
      EXPECT_NE(simplest.collision.a.velocity[0], 0) << i;
    }
  }
}

TEST(SimplestViolation, SetsNumbersToZeroThatTheViolationDoesNotNeed) {
  const Case found = unit::case_of("generic", 1);
  const auto rounding = [](const Case&) { return violated(4e-29, 0); };
  const Case simplest = simplest_violation(found, *invariant_named("restitution"), rounding(found), rounding, 4000);
  EXPECT_TRUE(simplest.collision.b.angular_velocity.isZero(0));
}

/// The violation needs unequal moments. Without a limit, shrinking would make one moment far too large.
TEST(SimplestViolation, IsNoFurtherBeyondTheDomainThanTheOneFound) {
  const auto fails_for_unequal_moments = [](const Case& one) {
    const auto& moments = one.collision.a.principal_inertia;
    return moments[0] < moments[1] && moments[1] < moments[2] ? violated(1, 1e-15) : Verdict{};
  };
  int shrunk_cases = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Case found = unit::case_of("generic", i);
    if (found.collision.a.immovable || fails_for_unequal_moments(found).status != Status::violated) {
      continue;
    }
    const Case simplest = simplest_violation(found, *invariant_named("angular_momentum"),
                                             fails_for_unequal_moments(found), fails_for_unequal_moments, 4000);
    EXPECT_TRUE(is_no_further_beyond_domain(simplest.collision, found.collision)) << i;
    const auto& moments = simplest.collision.a.principal_inertia;
    const auto& drawn = found.collision.a.principal_inertia;
    EXPECT_LE(moments[2], moments[0] + moments[1]) << i;
    EXPECT_LE(moments[2] / moments[0], std::max(8.0, drawn[2] / drawn[0])) << i;
    ++shrunk_cases;
  }
  EXPECT_GT(shrunk_cases, 2);
}

}  // namespace
}  // namespace carom::properties
