// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/trial/trial.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/cases.hpp"

namespace carom::properties {
namespace {

using Matrix = Matrix3<long double>;
using Vector = Vector3<long double>;

struct Solved {
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

Solved solved(std::string_view family, std::uint64_t index, const Subject& subject) {
  Solved result{unit::case_of(family, index), {}};
  Session session = subject.open();
  result.outcome = std::get<ReportedOutcome>(session(std::span(&result.one.collision, 1)).at(0));
  return result;
}

std::vector<NamedVerdict> verdicts_on(const Solved& solved, const Matrix& matrix, bool filtered) {
  oracles::Yardstick yardstick;
  yardstick.filtered = filtered;
  Claim claim = claim_of(*subjects::subject_named("reflection-double"), yardstick);
  std::erase_if(claim.invariants, [](const Invariant* invariant) { return !invariant->is_of_matrix(); });
  ReportedOutcome outcome = solved.outcome;
  outcome.collision_matrix = matrix;
  const JudgedCase judged_case(solved.one, filtered);
  return try_case(judged_case, claim, [&](const Collision&) { return lift(outcome); }).verdicts;
}

Verdict verdict_of(std::string_view invariant, const Solved& solved, const Matrix& matrix, bool filtered) {
  for (const NamedVerdict& named : verdicts_on(solved, matrix, filtered)) {
    if (named.invariant->name == invariant) {
      return named.verdict;
    }
  }
  return {};
}

std::set<std::string_view> violated(const Solved& solved, const Matrix& matrix, bool filtered) {
  std::set<std::string_view> names;
  for (const auto& [invariant, verdict] : verdicts_on(solved, matrix, filtered)) {
    EXPECT_FALSE(verdict.is_undecided) << invariant->name;
    if (verdict.status == Status::violated) {
      names.insert(invariant->name);
    }
  }
  return names;
}

using Names = std::set<std::string_view>;

/// Reports `planted` for many contacts. The judges with and without filters must agree.
void expect_violated(const std::function<Matrix(const Solved&)>& planted, const Names& expected) {
  const Subject subject = *subjects::subject_named("reflection-double");
  for (const char* family : {"generic", "physical", "mass_ratio", "immovable_a"}) {
    int colliding = 0;
    for (std::uint64_t i = 0; i < 25; ++i) {
      const Solved one = solved(family, i, subject);
      if (!one.outcome.collision_matrix) {
        continue;
      }
      ++colliding;
      for (const bool filtered : {true, false}) {
        EXPECT_EQ(violated(one, planted(one), filtered), expected) << family << ' ' << i << ' ' << filtered;
      }
    }
    EXPECT_GT(colliding, 5) << family;
  }
}

TEST(ShownMatrix, OfASoundSolverIsRight) {
  expect_violated([](const Solved& one) { return one.matrix(); }, {});
}

/// The rounding of the inputs covers one ulp of each entry.
TEST(ShownMatrix, MayBeRounded) {
  expect_violated(
      [](const Solved& one) -> Matrix {
        return one.matrix().unaryExpr(
            [](long double x) { return static_cast<long double>(std::nextafter(static_cast<double>(x), 1e300)); });
      },
      {});
}

/// Rounding does not explain an error of a thousandth, even if V⁻ is a small difference of large velocities.
TEST(ShownMatrix, IsNotUsedWhereItIsOffByAThousandth) {
  expect_violated([](const Solved& one) -> Matrix { return one.matrix() * (1 + 1e-3L); }, {"matrix_used"});
}

/// The matrix of a contact whose bodies have half the mass and the same moments of inertia.
TEST(ShownMatrix, IsNotUsedWhereItIsOfAnotherContact) {
  expect_violated(
      [](const Solved& one) -> Matrix {
        const Collision& c = one.one.collision;
        const double lambda = (c.a.immovable ? 0 : 1 / c.a.mass) + (c.b.immovable ? 0 : 1 / c.b.mass);
        return one.matrix() + Matrix::Identity() * lambda;
      },
      {"matrix_used"});
}

/// Adds a multiple of the cross matrix [F]×. As [F]× F = 0, C F does not change.
Matrix asymmetric(const Solved& one) {
  const Vector f = one.impulse().normalized() * (one.matrix().trace() / 1000);
  Matrix skew;
  skew << 0, -f[2], f[1], f[2], 0, -f[0], -f[1], f[0], 0;
  return one.matrix() + skew;
}

TEST(ShownMatrix, IsToBeSymmetric) { expect_violated(asymmetric, {"matrix_used"}); }

TEST(ShownMatrix, IsPrintedBesideItsTranspose) {
  const Solved one = solved("physical", 3, *subjects::subject_named("reflection-double"));
  const Matrix c = asymmetric(one);
  const Verdict verdict = verdict_of("matrix_used", one, c, true);
  const Vector left(c(2, 1), c(0, 2), c(1, 0));
  const Vector right(c(1, 2), c(2, 0), c(0, 1));
  ASSERT_EQ(verdict.left.size(), 3U);
  ASSERT_EQ(verdict.right.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {  // printed numbers are rounded to binary64
    EXPECT_DOUBLE_EQ(verdict.left[i], static_cast<double>(left[static_cast<Eigen::Index>(i)]));
    EXPECT_DOUBLE_EQ(verdict.right[i], static_cast<double>(right[static_cast<Eigen::Index>(i)]));
  }
}

/// C changes, but C F does not.
TEST(ShownMatrix, IsToBeDefiniteAlsoAcrossTheImpulse) {
  expect_violated(
      [](const Solved& one) -> Matrix {
        const Vector f = one.impulse().normalized();
        const Vector across = f.cross(std::abs(f[0]) < 0.5L ? Vector::UnitX() : Vector::UnitY()).normalized();
        return one.matrix() - across * across.transpose() * (2 * across.dot(one.matrix() * across));
      },
      {"definite"});
}

TEST(ShownMatrix, IsNothingWhereItIsNotFinite) {
  for (const long double wrong :
       {std::numeric_limits<long double>::quiet_NaN(), std::numeric_limits<long double>::infinity()}) {
    const Solved one = solved("physical", 3, *subjects::subject_named("reflection-double"));
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

/// Extreme numbers never pass.
TEST(ShownMatrix, MayHoldAnyNumber) {
  const Solved one = solved("generic", 0, *subjects::subject_named("reflection-double"));
  ASSERT_TRUE(one.outcome.collision_matrix);
  for (const long double scale : {1e100L, 1e300L, 1e-300L, 1e4000L, 1e-4900L}) {
    for (const bool filtered : {true, false}) {
      const Verdict verdict = verdict_of("matrix_used", one, one.matrix() * scale, filtered);
      EXPECT_TRUE(verdict.status == Status::violated || verdict.is_undecided) << static_cast<double>(scale);
    }
  }
}

/// A built-in solver that shows its matrix shows it in every colliding case.
TEST(ShownMatrix, IsThatOfTheSolve) {
  for (const Subject& subject : subjects::built_in_subjects()) {
    int shown = 0;
    int changed = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Solved one = solved("sliding", i, subject);
      const oracles::ExactCase exact_case(one.one.collision);
      shown += one.outcome.collision_matrix ? 1 : 0;
      changed += exact_case.approach() == oracles::Approach::colliding ? 1 : 0;
    }
    EXPECT_GT(changed, 5);
    EXPECT_EQ(shown, subject.shows_collision_matrix ? changed : 0) << subject.name;
    const bool forms_none = subject.law == Law::frictionless || subject.name.find("-batch-") != std::string::npos;
    EXPECT_EQ(subject.shows_collision_matrix, !forms_none) << subject.name;
  }
}

/// Without friction, `coulomb` needs no matrix.
TEST(ShownMatrix, IsNoneWhereTheSolveFormsNone) {
  const Subject subject = *subjects::subject_named("coulomb-double");
  Case one = unit::case_of("sliding", 0);
  Session session = subject.open();
  one.collision.friction = 0.5;
  EXPECT_TRUE(std::get<ReportedOutcome>(session(std::span(&one.collision, 1)).at(0)).collision_matrix.has_value());
  one.collision.friction = 0;
  EXPECT_FALSE(std::get<ReportedOutcome>(session(std::span(&one.collision, 1)).at(0)).collision_matrix.has_value());
}

}  // namespace
}  // namespace carom::properties
