// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <gtest/gtest.h>

#include <carom/properties/cases/beyond_domain.hpp>
#include <carom/properties/gate/witness.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

Verdict violated(double residual, double allowed) {
  Verdict verdict;
  verdict.status = Status::violated;
  verdict.residual = residual;
  verdict.allowed = allowed;
  return verdict;
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
