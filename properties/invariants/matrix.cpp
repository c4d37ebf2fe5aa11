// SPDX-License-Identifier: BSL-1.0
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <carom/oracles/filters/definiteness_bounds.hpp>
#include <carom/oracles/filters/stage.hpp>
#include <carom/properties/invariants/invariant_groups.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

using oracles::Approximation;
using oracles::less_multiple_of_identity;
using oracles::LiftedMatrix;
using oracles::Rational;

Verdict bound_missed(const char* what, const Matrix3<Rational>& matrix, const Rational& bound) {
  Verdict verdict{.status = Status::violated, .detail = what};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      verdict.left.push_back(oracles::to_double(matrix(row, column)));
      verdict.right.push_back(row == column ? oracles::to_double(bound) : 0);
    }
  }
  return verdict;
}

/// The sensitivity of the collision matrix C: the largest change ‖ΔC‖_F (Frobenius norm) by permitted inputs, divided
/// by the allowance.
double sensitivity(const Evidence& e) { return e.exact_case.collision_matrix_sensitivity(e.allowance()); }

/// A bound of the change of an eigenvalue of C by permitted inputs: ‖ΔC‖_F (Weyl's inequality).
Rational eigenvalue_rounding(const Evidence& e) {
  return e.allowance() > 0 ? Rational(e.allowance() * sensitivity(e)) : Rational(0);
}

/// Almost all reported matrices are symmetric to the last bit.
bool is_surely_symmetric(const LiftedMatrix& shown) {
  const Matrix3<long double>* m = shown.reported();
  return m != nullptr && (*m)(1, 0) == (*m)(0, 1) && (*m)(2, 0) == (*m)(0, 2) && (*m)(2, 1) == (*m)(1, 2);
}

/// (C + Cᵀ) / 2, which has the same xᵀ C x.
Matrix3<Rational> symmetric_part(const LiftedMatrix& shown) {
  return (shown.exact() + shown.exact().transpose()) / Rational(2);
}

bool may_be_filtered(const Evidence& e, const LiftedMatrix& shown) {
  return is_surely_symmetric(shown) && e.yardstick.uses_bounds() && e.exact_case.bounds().is_moderate();
}

/// Whether bounds show λI ⪯ C for the shown C, within a lower bound of the permitted rounding. The exact C needs no
/// check (`ExactCase::is_definite`).
bool is_surely_definite(const Evidence& e, const LiftedMatrix& shown) {
  const double rounding = e.allowance() * e.exact_case.bounds().collision_matrix_sensitivity_below();
  const auto is_surely_above = [&]<class T>(const T& lambda) {
    return is_positive_semidefinite(less_multiple_of_identity<T>(shown.in<T>(), lambda - T(rounding))).value_or(false);
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

/// Whether bounds show C ⪯ 16 λI for the exact C and for the shown C, with no permitted rounding.
bool is_surely_well_conditioned(const Evidence& e, const LiftedMatrix& shown) {
  const Approximation bound = Approximation(16) * e.exact_case.bounds().approximate_inverse_mass();
  const auto is_below = [&](const Matrix3<Approximation>& matrix) {
    return is_positive_semidefinite(less_multiple_of_identity<Approximation>(-matrix, -bound)).value_or(false);
  };
  if (is_below(e.exact_case.bounds().collision_matrix()) && is_below(shown.in<Approximation>())) {
    count(oracles::Stage::approximation);
    return true;
  }
  return false;
}

/// Applies `check` to the C that the subject shows. Without a shown C, nothing is tested, because theorems prove these
/// invariants for the exact C.
template <Verdict (*check)(const Evidence&, const LiftedMatrix&)>
Verdict of_shown_matrix(const Evidence& e) {
  if (e.exact_case.approach() == oracles::Approach::inert) {
    return outside_domain("both bodies are immovable");
  }
  const LiftedMatrix* shown = e.outcome.collision_matrix();
  if (shown == nullptr) {
    return outside_domain("the subject shows no collision matrix for this contact");
  }
  if (!shown->is_finite()) {
    return {.status = Status::violated, .detail = "the shown C contains infinities or NaN"};
  }
  return check(e, *shown);
}

Verdict check_definite(const Evidence& e, const LiftedMatrix& shown) {
  if (may_be_filtered(e, shown) && is_surely_definite(e, shown)) {
    return {};
  }
  if (!e.yardstick.allowed(sensitivity(e))) {
    return beyond_range();
  }
  const Rational lambda = inverse_mass(e.exact_case.exact());
  count(oracles::Stage::rational);
  if (!e.exact_case.is_definite()) {
    return bound_missed("the exact C and λI", e.exact_case.collision_matrix(), lambda);
  }
  if (!oracles::is_at_least(symmetric_part(shown), lambda - eigenvalue_rounding(e))) {
    return bound_missed("the computed C and λI", shown.exact(), lambda);
  }
  return {};
}

Verdict check_well_conditioned(const Evidence& e, const LiftedMatrix& shown) {
  if (may_be_filtered(e, shown) && is_surely_well_conditioned(e, shown)) {
    return {};
  }
  if (!e.yardstick.allowed(sensitivity(e))) {
    return beyond_range();
  }
  count(oracles::Stage::rational);
  const Rational bound = 16 * inverse_mass(e.exact_case.exact());
  // The bound 16 λ is sharp, so rounded moments and lever arms can exceed it.
  const Rational rounding = eigenvalue_rounding(e);
  if (!e.exact_case.is_bounded_by(bound + rounding)) {
    return bound_missed("the exact C and 16 λI", e.exact_case.collision_matrix(), bound);
  }
  if (!oracles::is_at_most(symmetric_part(shown), bound + rounding)) {
    return bound_missed("the computed C and 16 λI", shown.exact(), bound);
  }
  return {};
}

/// `convex_uniform` is stronger than necessary: uniform bodies that are star-shaped from the contact point suffice.
Verdict check_well_conditioned_if_convex(const Evidence& e) {
  return e.convex_uniform
             ? of_shown_matrix<check_well_conditioned>(e)
             : outside_domain("the bodies are not known to be uniform and star-shaped from the contact point");
}

/// Checks C = Cᵀ. The permitted error E of C has ‖E‖_F ≤ R, with R the allowance times the sensitivity of C. As (E_ij −
/// E_ji)² ≤ 2 (E_ij² + E_ji²), the norm of the three differences C_ij − C_ji is at most √2 R.
Verdict check_symmetric(const Evidence& e, const LiftedMatrix& shown) {
  if (e.yardstick.filtered && is_surely_symmetric(shown)) {
    count(oracles::Stage::same_bits);
    return {};
  }
  const Matrix3<Rational>& c = shown.exact();
  const std::vector<Rational> missed{c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1)};
  const std::optional<double> allowed = e.yardstick.allowed(std::numbers::sqrt2 * sensitivity(e));
  count(oracles::Stage::rational);
  if (oracles::norm_at_most(missed, 0)) {
    return {};
  }
  if (!allowed) {
    return beyond_range();
  }
  if (oracles::norm_at_most(missed, *allowed)) {
    return {};
  }
  const double residual =
      oracles::root_of_squares(missed.size(), [&](std::size_t i) { return oracles::to_double(missed[i]); });
  Verdict verdict{
      .status = Status::violated, .detail = "C and its transpose", .residual = residual, .allowed = *allowed};
  for (const auto& [row, column] : {std::pair{2, 1}, std::pair{0, 2}, std::pair{1, 0}}) {
    verdict.left.push_back(oracles::to_double(c(row, column)));
    verdict.right.push_back(oracles::to_double(c(column, row)));
  }
  return verdict;
}

Verdict check_matrix_used(const Evidence& e, const LiftedMatrix& shown) {
  return both(check_symmetric(e, shown),
              verdict_of(compare_change_by(shown, e.exact_case, e.outcome, e.yardstick), "V⁺ − V⁻ and C F"));
}

}  // namespace

std::vector<Invariant> matrix_invariants() {
  return {
      Invariant{"definite", "The collision matrix is positive definite, and its least eigenvalue is at least λ.",
                R"(\lambda I \preceq C,\quad \lambda = 1/m_A + 1/m_B)",
                "note eq. 27, with QᵀJ⁻¹Q positive semidefinite",
                "contacts with a movable body, if the subject shows its C", every_law(),
                AboutMatrix{of_shown_matrix<check_definite>},
                Proof{ProvedOf::every_impulse, {{"definite", "collision_matrix.v"}}}, 8},
      Invariant{
          "well_conditioned",
          "If the bodies are uniform and star-shaped from the contact point, the condition number of C is at most 16. "
          "A convex body is star-shaped from each of its points.",
          R"(C \preceq 16\, \lambda I)",
          "rrᵀ ⪯ 15 S for the second moments S about the centre of mass: Jensen's inequality over the boundary, "
          "seen from the contact point; of convex bodies R. Kannan, L. Lovász, M. Simonovits, Discrete Comput. "
          "Geom. 13 (1995), Thm 4.1, with n = 3",
          "bodies that are known to be uniform and star-shaped from the contact point, if the subject shows its C",
          every_law(), AboutMatrix{check_well_conditioned_if_convex, true},
          Proof{ProvedOf::every_impulse,
                {{"well_conditioned", "well_conditioned.v"},
                 {"star_shaped_well_conditioned", "star_shaped.v"},
                 {"star_shaped_condition_number", "star_shaped.v"},
                 {"bound_is_sharp", "star_shaped.v"}}}},
      Invariant{
          "matrix_used",
          "The shown collision matrix is symmetric, and maps the impulse to the change of the relative velocity.",
          R"(C = C^\top,\quad V^+ - V^- = C F)", "note eq. 24, with C = K in world axes",
          "contacts with a movable body, if the subject shows its C", every_law(),
          AboutMatrix{of_shown_matrix<check_matrix_used>},
          Proof{ProvedOf::every_impulse,
                {{"velocity_change", "collision_matrix.v"}, {"collision_matrix_symmetric", "collision_matrix.v"}}}}};
}

}  // namespace carom::properties
