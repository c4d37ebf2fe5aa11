// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/outcome.hpp>

/// Compares values that were written and read again. Any NaN equals any other NaN.
namespace carom::fuzz {

template <class S>
[[nodiscard]] bool same_number(S x, S y) {
  return x == y || (std::isnan(x) && std::isnan(y));
}

[[nodiscard]] inline bool same_numbers(const Collision& x, const Collision& y) {
  bool same = x.a.immovable == y.a.immovable && x.b.immovable == y.b.immovable;
  for_each_number([&](const FieldPath&, const double& of_x, const double& of_y) { same &= same_number(of_x, of_y); }, x,
                  y);
  return same;
}

[[nodiscard]] inline bool same_numbers(const ReportedOutcome& x, const ReportedOutcome& y) {
  bool same = true;
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      same &= same_number((*of_x[k])[i], (*of_y[k])[i]);
    }
  }
  if (x.collision_matrix && y.collision_matrix) {
    for (int i = 0; i < 9; ++i) {
      same &= same_number((*x.collision_matrix)(i / 3, i % 3), (*y.collision_matrix)(i / 3, i % 3));
    }
  }
  return same && x.collision_matrix.has_value() == y.collision_matrix.has_value();
}

}  // namespace carom::fuzz
