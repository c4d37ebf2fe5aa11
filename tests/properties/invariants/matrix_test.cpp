// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/gate/trial.hpp>

#include "support/cases.hpp"
#include "support/known_collisions.hpp"

namespace carom::properties {
namespace {

using Matrix = Matrix3<long double>;
using Vector = Vector3<long double>;

struct ShownSolve {
  Case one;
  ReportedOutcome outcome;

  [[nodiscard]] const Matrix& matrix() const { return *outcome.collision_matrix; }

  /// The impulse on A, from the change of momentum of the lighter movable body.
  [[nodiscard]] Vector impulse() const {
    const Collision& c = one.collision;
    const bool off_a = oracles::reads_impulse_off_a(c);
    const auto of = [](const Body& body, const BodyVelocity<long double>& after) -> Vector {
      return static_cast<long double>(body.mass) * (after.velocity - body.velocity.cast<long double>());
    };
    return off_a ? of(c.a, outcome.a) : Vector(-of(c.b, outcome.b));
  }
};

ShownSolve shown_solve(std::string_view family, std::uint64_t index, Law law = Law::reflection) {
  ShownSolve result{unit::case_of(family, index), {}};
  const oracles::ExactCase exact_case(result.one.collision);
  result.outcome = exact_case.state() == oracles::ContactState::colliding
                       ? unit::reported_outcome_with_matrix(exact_case, law)
                       : unit::reported_outcome(exact_case, law);
  return result;
}

std::vector<NamedVerdict> verdicts_on(const ShownSolve& one, const std::optional<Matrix>& matrix, bool filtered) {
  Subject subject;
  subject.law = Law::any;
  subject.precision = Precision::binary64;
  subject.shows_collision_matrix = true;
  Claim claim = claim_of(subject, {.filtered = filtered});
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return !invariant->is_of_matrix(); });
  ReportedOutcome outcome = one.outcome;
  outcome.collision_matrix = matrix;
  const JudgedCase judged_case(one.one, filtered);
  return try_case(judged_case, claim, [&](const Collision&) { return lift(outcome); }).verdicts;
}

Verdict verdict_of(std::string_view invariant, const ShownSolve& one, const Matrix& matrix, bool filtered) {
  for (const NamedVerdict& named : verdicts_on(one, matrix, filtered)) {
    if (named.invariant->name == invariant) {
      return named.verdict;
    }
  }
  return {};
}

std::set<std::string_view> violated(const ShownSolve& one, const std::optional<Matrix>& matrix, bool filtered) {
  std::set<std::string_view> names;
  for (const auto& [invariant, verdict] : verdicts_on(one, matrix, filtered)) {
    EXPECT_FALSE(verdict.is_undecided) << invariant->name;
    if (verdict.status == Status::violated) {
      names.insert(invariant->name);
    }
  }
  return names;
}

using Names = std::set<std::string_view>;

double inverse_mass_of(const ShownSolve& one) { return oracles::inverse_mass(one.one.collision); }

/// Reports the matrix `planted` for many contacts. With and without filters, the judge must find exactly `expected`
/// violated.
void expect_violated(const std::function<Matrix(const ShownSolve&)>& planted, const Names& expected) {
  for (const char* family : {"generic", "physical", "mass_ratio", "immovable_a"}) {
    int colliding = 0;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(unit::effort(25)); ++i) {
      const ShownSolve one = shown_solve(family, i);
      if (!one.outcome.collision_matrix) {
        continue;
      }
      ++colliding;
      for (const bool filtered : {true, false}) {
        EXPECT_EQ(violated(one, planted(one), filtered), expected) << family << ' ' << i << ' ' << filtered;
      }
    }
    EXPECT_GE(colliding, unit::effort(6)) << family;
  }
}

TEST(ShownMatrix, OfASoundSolverIsRight) {
  expect_violated([](const ShownSolve& one) { return one.matrix(); }, {});
}

/// Rounding does not explain an error of a thousandth, even if V⁻ is a small difference of large velocities.
TEST(ShownMatrix, ViolatesMatrixUsedIfItIsOffByAThousandth) {
  expect_violated([](const ShownSolve& one) -> Matrix { return one.matrix() * (1 + 1e-3L); }, {"matrix_used"});
}

/// Adds a multiple of the impulse's cross matrix [F]×. As [F]× F = 0, C F does not change.
Matrix asymmetric(const ShownSolve& one) {
  const Vector f = one.impulse().normalized() * (one.matrix().trace() / 1000);
  Matrix skew;
  skew << 0, -f[2], f[1], f[2], 0, -f[0], -f[1], f[0], 0;
  return one.matrix() + skew;
}

TEST(ShownMatrix, MustBeSymmetric) { expect_violated(asymmetric, {"matrix_used"}); }

TEST(ShownMatrix, IsPrintedBesideTheExactMatrix) {
  const ShownSolve one = shown_solve("physical", 3);
  const Matrix c = asymmetric(one);
  const Verdict verdict = verdict_of("matrix_used", one, c, true);
  EXPECT_EQ(verdict.detail, "C and K");
  EXPECT_NEAR(verdict.residual, static_cast<double>((c - one.matrix()).norm()), 1e-12 * verdict.residual);
  ASSERT_EQ(verdict.left.size(), 9U);
  ASSERT_EQ(verdict.right.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {  // printed numbers are rounded to binary64
    const auto row = static_cast<Eigen::Index>(i / 3);
    const auto column = static_cast<Eigen::Index>(i % 3);
    EXPECT_DOUBLE_EQ(verdict.left[i], static_cast<double>(c(row, column)));
    EXPECT_DOUBLE_EQ(verdict.right[i], static_cast<double>(one.matrix()(row, column)));
  }
}

/// Eq. 27 of the note. The planted error changes C, but not C N. Without friction, the impulse lies along N and does
/// not show the error.
TEST(ShownMatrix, MustHaveTheInverseMassOnceAcrossTheNormal) {
  for (std::uint64_t i = 0; i < 10; ++i) {
    const ShownSolve one = shown_solve("generic", i, Law::frictionless);
    if (!one.outcome.collision_matrix) {
      continue;
    }
    const Vector n = one.one.collision.normal.cast<long double>().normalized();
    const Matrix planted = one.matrix() + (Matrix::Identity() - n * n.transpose()) * inverse_mass_of(one);
    EXPECT_LT((planted * n - one.matrix() * n).norm(), 1e-15L * one.matrix().norm());
    for (const bool filtered : {true, false}) {
      EXPECT_EQ(verdict_of("matrix_used", one, one.matrix(), filtered).status, Status::holds) << i;
      EXPECT_EQ(verdict_of("matrix_used", one, planted, filtered).detail, "C and K") << i;
    }
  }
}

/// C may differ from K by exactly the permitted rounding.
TEST(ShownMatrix, IsExactUpToThePermittedRounding) {
  const ShownSolve one = shown_solve("generic", 0);
  const oracles::ExactCase exact_case(one.one.collision);
  const double allowance = oracles::default_limit_ulps * unit_roundoff(Precision::binary64);
  const long double rounding = allowance * exact_case.collision_matrix_sensitivity(allowance);
  const Matrix nearest = exact_case.collision_matrix().unaryExpr(&unit::to_extended);
  for (const bool filtered : {true, false}) {
    const auto status = [&](long double share) {
      Matrix matrix = nearest;
      matrix(0, 1) += share * rounding;
      return verdict_of("matrix_used", one, matrix, filtered);
    };
    EXPECT_NE(status(0.999L).detail, "C and K") << filtered;
    EXPECT_EQ(status(1.001L).detail, "C and K") << filtered;
  }
}

/// A colliding contact without a matrix violates each invariant of the matrix that applies to it.
TEST(ShownMatrix, MustNotBeMissingIfTheContactCollides) {
  for (const bool filtered : {true, false}) {
    const ShownSolve one = shown_solve("physical", 3);
    ASSERT_TRUE(one.outcome.collision_matrix);
    EXPECT_EQ(violated(one, std::nullopt, filtered), (Names{"definite", "matrix_used", "well_conditioned"}));
    for (const char* family : {"separating", "resting", "both_immovable"}) {
      EXPECT_EQ(violated(shown_solve(family, 0), std::nullopt, filtered), Names{}) << family;
    }
    const double allowance = oracles::default_limit_ulps * unit_roundoff(Precision::binary64);
    int grazing = 0;
    for (std::uint64_t i = 0; i < 40; ++i) {
      const ShownSolve near = shown_solve("grazing", i);
      const oracles::ExactCase exact_case(near.one.collision);
      if (exact_case.state() == oracles::ContactState::colliding && exact_case.is_grazing(allowance)) {
        EXPECT_EQ(violated(near, std::nullopt, filtered), Names{}) << i;
        ++grazing;
      }
    }
    EXPECT_GT(grazing, 0);
  }
}

/// C = x I has the eigenvalue x. The least x that is permitted is λ minus the permitted rounding of C.
TEST(ShownMatrix, IsDefiniteUpToThePermittedRounding) {
  const ShownSolve one = shown_solve("generic", 0);
  const oracles::ExactCase exact_case(one.one.collision);
  const double allowance = oracles::default_limit_ulps * unit_roundoff(Precision::binary64);
  const double rounding = allowance * exact_case.collision_matrix_sensitivity(allowance);
  const long double least = unit::to_extended(oracles::inverse_mass(exact_case.exact()) - oracles::Rational(rounding));
  for (const bool filtered : {true, false}) {
    const auto status = [&](long double x) {
      return verdict_of("definite", one, Matrix(Matrix::Identity() * x), filtered).status;
    };
    EXPECT_EQ(status(std::nextafter(std::nextafter(least, 0.0L), 0.0L)), Status::violated) << filtered;
    EXPECT_EQ(status(std::nextafter(std::nextafter(least, 1e9L), 1e9L)), Status::holds) << filtered;
  }
}

/// Uniform convex bodies have C ⪯ 16 λI.
TEST(ShownMatrix, HasNoEigenvalueAboveSixteenTimesTheInverseMass) {
  const ShownSolve one = shown_solve("physical", 3);
  ASSERT_TRUE(one.one.convex_uniform);
  for (const bool filtered : {true, false}) {
    const auto status = [&](long double times) {
      return verdict_of("well_conditioned", one, Matrix(Matrix::Identity() * times * inverse_mass_of(one)), filtered)
          .status;
    };
    EXPECT_EQ(status(15.9L), Status::holds) << filtered;
    EXPECT_EQ(status(16.1L), Status::violated) << filtered;
  }
}

TEST(ShownMatrix, ViolatesBothInvariantsIfANumberIsNotFinite) {
  for (const long double wrong :
       {std::numeric_limits<long double>::quiet_NaN(), std::numeric_limits<long double>::infinity()}) {
    const ShownSolve one = shown_solve("physical", 3);
    ASSERT_TRUE(one.outcome.collision_matrix);
    Matrix matrix = one.matrix();
    matrix(1, 2) = wrong;
    for (const bool filtered : {true, false}) {
      const Names names = violated(one, matrix, filtered);
      EXPECT_TRUE(names.contains("definite"));
      EXPECT_TRUE(names.contains("matrix_used"));
    }
  }
}

TEST(ShownMatrix, OfExtremeSizeIsNeverFoundRight) {
  const ShownSolve one = shown_solve("generic", 0);
  ASSERT_TRUE(one.outcome.collision_matrix);
  for (const long double scale : {1e100L, 1e300L, 1e-300L, 1e4000L, 1e-4900L}) {
    for (const bool filtered : {true, false}) {
      const Verdict verdict = verdict_of("matrix_used", one, one.matrix() * scale, filtered);
      EXPECT_TRUE(verdict.status == Status::violated || verdict.is_undecided) << static_cast<double>(scale);
    }
  }
}

}  // namespace
}  // namespace carom::properties
