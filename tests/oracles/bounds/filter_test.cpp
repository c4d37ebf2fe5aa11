// SPDX-License-Identifier: BSL-1.0
#include <limits>

#include <gtest/gtest.h>

#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/mechanics.hpp>

#include "support/exact.hpp"

namespace carom::oracles {
namespace {

TEST(LiftedOutcome, IsModerateIfEachNumberIs) {
  EXPECT_TRUE(LiftedOutcome(ReportedOutcome{}).is_moderate());
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      ReportedOutcome reported;
      (*vectors(reported)[k])[i] = -static_cast<long double>(largest_moderate_outcome);
      EXPECT_TRUE(LiftedOutcome(reported).is_moderate()) << i;
      (*vectors(reported)[k])[i] *= 2;
      EXPECT_FALSE(LiftedOutcome(reported).is_moderate()) << i;
      (*vectors(reported)[k])[i] = std::numeric_limits<long double>::quiet_NaN();
      EXPECT_FALSE(LiftedOutcome(reported).is_moderate()) << i;
    }
  }
}

TEST(LiftedOutcome, IsExactlyRoundedIfEachNumberIsADouble) {
  EXPECT_TRUE(LiftedOutcome(ReportedOutcome{}).is_exactly_rounded());
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      ReportedOutcome reported;
      (*vectors(reported)[k])[i] = 1 + 0x1p-52L;
      EXPECT_TRUE(LiftedOutcome(reported).is_exactly_rounded()) << i;
      (*vectors(reported)[k])[i] += 0x1p-60L;
      EXPECT_FALSE(LiftedOutcome(reported).is_exactly_rounded()) << i;
    }
  }
}

TEST(LiftedMatrix, IsTheReportedOneInEachNumber) {
  Matrix3<long double> reported;
  reported << 1, 2, 3, 4, 5, 6, 7, 8, 1 + 0x1p-60L;
  const LiftedMatrix lifted(reported);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(lifted.exact()(i, j), lift(reported(i, j))) << i << ' ' << j;
    }
  }
  EXPECT_EQ(lifted.exact()(2, 2) - Rational(1), unit::two_to(-60));
  EXPECT_TRUE(lifted.is_finite());
}

TEST(LazyMap, ComputesEachValueOnceAndKeepsItInPlace) {
  LazyMap<int, int> squares;
  int computed = 0;
  const auto square = [&](int key) -> const int& {
    return squares.get(key, [&] {
      ++computed;
      return key * key;
    });
  };
  const int& first = square(3);
  for (int key = 0; key < 100; ++key) {
    EXPECT_EQ(square(key), key * key);
  }
  EXPECT_EQ(&square(3), &first);
  EXPECT_EQ(computed, 100);
}

/// V⁺ − V⁻ and C F in dual numbers.
struct ChangeByMatrix {
  Matrix3<double> matrix;
  bool read_off_a;

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return change_by_matrix<T>(c, after, matrix.unaryExpr([](double x) { return T(x); }),
                               impulse_on_a(c, after, read_off_a));
  }
};

TEST(Slopes, OfAChangeByAMatrixHaveTheBitsOfForwardDifferentiation) {
  int compared = 0;
  for (const auto& [family, one] : unit::sampled_cases(20)) {
    const Collision& c = one.collision;
    const ExactCase exact_case(c);
    if (!has_movable_body(c) || !exact_case.is_moderate()) {
      continue;
    }
    Matrix3<double> matrix =
        exact_case.enclosed_collision_matrix().unaryExpr([](const Enclosure& x) { return x.middle(); });
    matrix(0, 1) *= 1.25;  // the subject may be wrong
    for (const bool read_off_a : {true, false}) {
      if (read_off_a ? c.a.immovable : c.b.immovable) {
        continue;
      }
      EXPECT_EQ(slopes_of_change(matrix, read_off_a, c),
                (output_slopes<double, outcome_inputs>(ChangeByMatrix{matrix, read_off_a}, c, unchanged(c))))
          << family;
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace carom::oracles
