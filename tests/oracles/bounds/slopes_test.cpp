// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>

#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/mechanics.hpp>

#include "support/cases.hpp"

namespace carom::oracles {
namespace {

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
