// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <carom/oracles/definiteness.hpp>
#include <carom/properties/invariants/checks.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

using oracles::Rational;

Verdict bound_missed(const char* what, const Matrix3<Rational>& matrix, const Rational& bound) {
  Verdict verdict{Status::violated, what, 0, 0, {}, {}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      verdict.left.push_back(oracles::to_double(matrix(row, column)));
      verdict.right.push_back(row == column ? oracles::to_double(bound) : 0);
    }
  }
  return verdict;
}

/// What the rounding of the inputs can move an eigenvalue of the computed matrix by, at most its Frobenius norm (Weyl).
Rational eigenvalue_rounding(const Evidence& e) {
  return e.allowance() > 0 ? Rational(e.allowance() * e.exact_case.collision_matrix_sensitivity()) : Rational(0);
}

}  // namespace

Verdict check_definite(const Evidence& e) {
  if (e.exact_case.approach() == oracles::Approach::inert) {
    return outside_domain("both bodies are immovable");
  }
  if (!std::isfinite(e.allowance() * e.exact_case.collision_matrix_sensitivity())) {
    return beyond_range();
  }
  const Rational lambda = e.exact_case.inverse_mass();
  if (!e.exact_case.is_definite()) {
    return bound_missed("the exact C and λI", e.exact_case.collision_matrix(), lambda);
  }
  if (e.collision_matrix != nullptr && !oracles::is_at_least(*e.collision_matrix, lambda - eigenvalue_rounding(e))) {
    return bound_missed("the computed C and λI", *e.collision_matrix, lambda);
  }
  return {};
}

Verdict check_well_conditioned(const Evidence& e) {
  if (!e.convex_uniform || e.exact_case.approach() == oracles::Approach::inert) {
    return outside_domain("the bodies are not known to be convex and uniform");
  }
  if (!std::isfinite(e.allowance() * e.exact_case.collision_matrix_sensitivity())) {
    return beyond_range();
  }
  const Rational bound = 16 * e.exact_case.inverse_mass();
  // The bound is sharp, and the stored moments and lever arms are rounded.
  const Rational rounding = eigenvalue_rounding(e);
  if (!e.exact_case.is_bounded_by(bound + rounding)) {
    return bound_missed("the exact C and 16 λI", e.exact_case.collision_matrix(), bound);
  }
  if (e.collision_matrix != nullptr && !oracles::is_at_most(*e.collision_matrix, bound + rounding)) {
    return bound_missed("the computed C and 16 λI", *e.collision_matrix, bound);
  }
  return {};
}

}  // namespace carom::properties
