// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/lifted_outcome.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

using unit::ExactMatrix;
using unit::ratio;

ExactMatrix symmetric(const Rational& m00, const Rational& m10, const Rational& m11, const Rational& m20,
                      const Rational& m21, const Rational& m22) {
  ExactMatrix m;
  m << m00, m10, m20, m10, m11, m21, m20, m21, m22;
  return m;
}

ExactMatrix diagonal(const Rational& x, const Rational& y, const Rational& z) { return symmetric(x, 0, y, 0, 0, z); }

/// L D Lᵀ with a unit lower triangular L has the definiteness of D (Sylvester's law of inertia).
ExactMatrix congruent_to(const ExactMatrix& d, properties::Stream& stream) {
  ExactMatrix l = ExactMatrix::Identity();
  for (const auto& [row, column] : {std::pair{1, 0}, std::pair{2, 0}, std::pair{2, 1}}) {
    l(row, column) = unit::exact_eighths(stream, 30);
  }
  // A second congruence, by Lᵀ, ends the special role of the first axis.
  const ExactMatrix lower = l;
  return lower.transpose() * (lower * d * lower.transpose()) * lower;
}

Matrix3<Enclosure> enclosed(const ExactMatrix& matrix) {
  Matrix3<Enclosure> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = Enclosure(matrix(i, j));
    }
  }
  return result;
}

/// The signs of the three diagonal entries determine definiteness, even after a congruence. The test takes all 27
/// combinations of signs.
TEST(Definiteness, FollowsFromTheSignsOfTheDiagonalByTheLawOfInertia) {
  properties::Stream stream = properties::stream_from(11);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const bool definite = x > 0 && y > 0 && z > 0;
        const bool semidefinite = x >= 0 && y >= 0 && z >= 0;
        for (int i = 0; i < 30; ++i) {
          const ExactMatrix d = diagonal(x * ratio(stream.integer(1, 50), 9), y * ratio(stream.integer(1, 50), 7),
                                         z * ratio(stream.integer(1, 50), 1 << 20));
          const ExactMatrix m = congruent_to(d, stream) * Rational(1).times_power_of_two(stream.integer(-60, 0));
          EXPECT_EQ(is_positive_definite(m), definite) << unit::to_text(m);
          EXPECT_EQ(is_positive_semidefinite(m), semidefinite) << unit::to_text(m);
          const std::optional<bool> by_enclosures = is_positive_semidefinite(enclosed(m));
          EXPECT_EQ(by_enclosures.value_or(semidefinite), semidefinite) << unit::to_text(m);
        }
      }
    }
  }
}

TEST(Definiteness, IsDecidedByEnclosuresWhereNoMinorVanishes) {
  EXPECT_EQ(is_positive_semidefinite(enclosed(symmetric(4, 1, 3, 1, 1, 2))), true);
  EXPECT_EQ(is_positive_semidefinite(enclosed(symmetric(4, 1, -3, 1, 1, 2))), false);
  // The minor 1/3 · 1/3 − 1/3 · 1/3 is 0, and no enclosure can prove this.
  const Rational third = ratio(1, 3);
  EXPECT_EQ(is_positive_semidefinite(enclosed(symmetric(third, third, third, 0, 0, 1))), std::nullopt);
}

TEST(PositiveSemidefinite, IsNotFooledByLeadingMinorsThatVanish) {
  // The first two leading minors are 0.
  EXPECT_FALSE(is_positive_semidefinite(diagonal(0, 0, -1)));
  EXPECT_FALSE(is_positive_semidefinite(diagonal(0, -1, 0)));
  EXPECT_FALSE(is_positive_semidefinite(diagonal(0, 1, -1)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(0, 0, 1, 1, 0, 1)));
  // The second leading minor is 0.
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 1, 1, 0, 1, 1)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 1, 1, 1, 1, 0)));
  // The diagonal is nonnegative.
  EXPECT_FALSE(is_positive_semidefinite(symmetric(0, 1, 0, 0, 0, 0)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 2, 1, 0, 0, 1)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 0, 1, 2, 0, 1)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 0, 1, 0, 2, 1)));
  // Only one minor of two axes is negative.
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 2, 1, 0, 0, 0)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, 0, 0, 2, 0, 1)));
  EXPECT_FALSE(is_positive_semidefinite(symmetric(0, 0, 1, 0, 2, 1)));
  // All 2×2 minors are positive, but the determinant is negative. The eigenvalues are 1 + 2c = −1/5, and 1 − c twice.
  const Rational c = ratio(-3, 5);
  EXPECT_FALSE(is_positive_semidefinite(symmetric(1, c, 1, c, c, 1)));
}

TEST(PositiveSemidefinite, AcceptsSingularMatrices) {
  EXPECT_TRUE(is_positive_semidefinite(ExactMatrix(ExactMatrix::Zero())));
  EXPECT_TRUE(is_positive_semidefinite(diagonal(0, 0, 1)));
  EXPECT_TRUE(is_positive_semidefinite(symmetric(1, 1, 1, 1, 1, 1)));
  const Rational c = ratio(-1, 2);  // eigenvalues 0, 3/2, 3/2
  EXPECT_TRUE(is_positive_semidefinite(symmetric(1, c, 1, c, c, 1)));
  EXPECT_FALSE(is_positive_definite(symmetric(1, c, 1, c, c, 1)));
}

TEST(Definiteness, ReadsTheLowerTriangleAlone) {
  ExactMatrix m = diagonal(1, 2, 3);
  m(0, 1) = m(0, 2) = m(1, 2) = 1000;
  EXPECT_TRUE(is_positive_definite(m));
  EXPECT_TRUE(is_positive_semidefinite(m));
}

TEST(Definiteness, BeyondABoundIsDecidedExactlyAtTheEigenvalue) {
  // Eigenvalues 2/3 (twice) and 8/3.
  const Rational off = ratio(2, 3);
  const ExactMatrix m = symmetric(ratio(4, 3), off, ratio(4, 3), off, off, ratio(4, 3));
  const Rational hair = Rational(1) / Rational(std::ldexp(1.0, 200));
  EXPECT_TRUE(is_at_least(m, ratio(2, 3)));
  EXPECT_FALSE(is_at_least(m, ratio(2, 3) + hair));
  EXPECT_TRUE(is_at_least(m, ratio(2, 3) - hair));
  EXPECT_TRUE(is_at_most(m, ratio(8, 3)));
  EXPECT_FALSE(is_at_most(m, ratio(8, 3) - hair));
  EXPECT_TRUE(is_at_most(m, ratio(8, 3) + hair));
}

}  // namespace
}  // namespace carom::oracles
