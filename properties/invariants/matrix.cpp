// SPDX-License-Identifier: GPL-3.0-or-later

#include <carom/oracles/filters/definiteness_bounds.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/invariants/groups.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

using oracles::Approximation;
using oracles::less_multiple_of_identity;
using oracles::Rational;

/// Of the exact C they are theorems, which say nothing of the subject.
constexpr const char* no_matrix = "the subject shows no collision matrix";

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
  return e.allowance() > 0 ? Rational(e.allowance() * e.exact_case.collision_matrix_sensitivity(e.allowance()))
                           : Rational(0);
}

bool may_be_filtered(const Evidence& e) {
  const bool is_reported = e.collision_matrix->reported() != nullptr;
  return is_reported && e.yardstick.uses_bounds() && e.exact_case.bounds().is_moderate();
}

template <class T>
Matrix3<T> shown_matrix(const Evidence& e) {
  return e.collision_matrix->reported()->unaryExpr([](long double x) { return T(x); });
}

/// Whether bounds show that λI ⪯ C for the computed C, but for less rounding than is allowed. The exact C needs no
/// check (`ExactCase::is_definite`).
bool is_surely_definite(const Evidence& e) {
  const double rounding = e.allowance() * e.exact_case.bounds().collision_matrix_sensitivity_below();
  const auto is_surely_above = [&]<class T>(const T& lambda) {
    return is_positive_semidefinite(less_multiple_of_identity<T>(shown_matrix<T>(e), lambda - T(rounding)))
        .value_or(false);
  };
  if (e.allowance() >= oracles::least_allowance_for_approximations &&
      is_surely_above(e.exact_case.bounds().approximate_inverse_mass())) {
    count(oracles::Stage::approximation);
    return true;
  }
  if (is_surely_above(e.exact_case.bounds().enclosed_inverse_mass())) {
    count(oracles::Stage::enclosure);
    return true;
  }
  return false;
}

/// Whether bounds show that C ⪯ 16 λI, without any rounding, for the exact C and for the computed one.
bool is_surely_well_conditioned(const Evidence& e) {
  const Approximation bound = Approximation(16) * e.exact_case.bounds().approximate_inverse_mass();
  const auto is_below = [&](const Matrix3<Approximation>& matrix) {
    return is_positive_semidefinite(less_multiple_of_identity<Approximation>(-matrix, -bound)).value_or(false);
  };
  if (is_below(e.exact_case.bounds().collision_matrix()) && is_below(shown_matrix<Approximation>(e))) {
    count(oracles::Stage::approximation);
    return true;
  }
  return false;
}

Verdict check_definite(const Evidence& e) {
  if (e.exact_case.approach() == oracles::Approach::inert) {
    return outside_domain("both bodies are immovable");
  }
  if (e.collision_matrix == nullptr) {
    return outside_domain(no_matrix);
  }
  if (may_be_filtered(e) && is_surely_definite(e)) {
    return {};
  }
  if (!e.yardstick.allowed(e.exact_case.collision_matrix_sensitivity(e.allowance()))) {
    return beyond_range();
  }
  const Rational lambda = inverse_mass(e.exact_case.exact());
  count(oracles::Stage::rational);
  if (!e.exact_case.is_definite()) {
    return bound_missed("the exact C and λI", e.exact_case.collision_matrix(), lambda);
  }
  if (!oracles::is_at_least(e.collision_matrix->exact(), lambda - eigenvalue_rounding(e))) {
    return bound_missed("the computed C and λI", e.collision_matrix->exact(), lambda);
  }
  return {};
}

/// `convex_uniform` says less than could be: that a body is star-shaped from the contact point is enough.
Verdict check_well_conditioned(const Evidence& e) {
  if (!e.convex_uniform || e.exact_case.approach() == oracles::Approach::inert) {
    return outside_domain("the bodies are not known to be uniform and star-shaped from the contact point");
  }
  if (e.collision_matrix == nullptr) {
    return outside_domain(no_matrix);
  }
  if (may_be_filtered(e) && is_surely_well_conditioned(e)) {
    return {};
  }
  if (!e.yardstick.allowed(e.exact_case.collision_matrix_sensitivity(e.allowance()))) {
    return beyond_range();
  }
  count(oracles::Stage::rational);
  const Rational bound = 16 * inverse_mass(e.exact_case.exact());
  // The bound is sharp, and the stored moments and lever arms are rounded.
  const Rational rounding = eigenvalue_rounding(e);
  if (!e.exact_case.is_bounded_by(bound + rounding)) {
    return bound_missed("the exact C and 16 λI", e.exact_case.collision_matrix(), bound);
  }
  if (!oracles::is_at_most(e.collision_matrix->exact(), bound + rounding)) {
    return bound_missed("the computed C and 16 λI", e.collision_matrix->exact(), bound);
  }
  return {};
}

}  // namespace

std::vector<Invariant> matrix_invariants() {
  return {Invariant{"definite", "The collision matrix is positive definite, with the margin λ.",
                    R"(\lambda I \preceq C,\quad \lambda = 1/m_A + 1/m_B)",
                    "note eq. 27, with QᵀJ⁻¹Q positive semidefinite", "a movable body, and a subject that shows its C",
                    every_model(), AboutOutcome{check_definite}},
          Invariant{
              "well_conditioned",
              "For uniform bodies that are star-shaped from the contact point, as convex ones touched inside are, the "
              "condition number of C is at most 16.",
              R"(C \preceq 16\, \lambda I)",
              "rrᵀ ⪯ 15 S for the second moments S about the centre of mass: Jensen's inequality over the boundary, "
              "seen from the contact point; of convex bodies R. Kannan, L. Lovász, M. Simonovits, Discrete Comput. "
              "Geom. 13 (1995), Thm 4.1, with n = 3",
              "bodies known to be uniform and star-shaped from the contact point, and a subject that shows its C",
              every_model(), AboutOutcome{check_well_conditioned}}};
}

}  // namespace carom::properties
