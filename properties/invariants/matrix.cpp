// SPDX-License-Identifier: BSL-1.0
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/bounds/stage.hpp>
#include <carom/properties/invariants/invariant_groups.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

using oracles::Enclosure;
using oracles::less_multiple_of_identity;
using oracles::LiftedMatrix;
using oracles::Rational;

/// The entries of a matrix row by row, for print.
template <class T>
std::vector<double> entries(const Matrix3<T>& matrix) {
  std::vector<double> rounded;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rounded.push_back(rounded_for_print(matrix(row, column)));
    }
  }
  return rounded;
}

Verdict bound_missed(const char* what, const Matrix3<Rational>& matrix, const Rational& bound) {
  const double b = oracles::to_double(bound);
  return {.status = Status::violated, .detail = what, .left = entries(matrix), .right = {b, 0, 0, 0, b, 0, 0, 0, b}};
}

/// The sensitivity of the collision matrix C: the largest change ‖ΔC‖_F (Frobenius norm) by permitted inputs, divided
/// by the allowance.
double sensitivity(const Evidence& e) { return e.exact_case.collision_matrix_sensitivity(e.allowance()); }

/// A bound of the change of an eigenvalue of C by permitted inputs: ‖ΔC‖_F (Weyl's inequality).
Rational eigenvalue_rounding(const Evidence& e) {
  return e.allowance() > 0 ? Rational(e.allowance() * sensitivity(e)) : Rational(0);
}

/// (C + Cᵀ) / 2, which has the same xᵀ C x.
template <class T>
Matrix3<T> symmetric_part(const LiftedMatrix& shown) {
  const Matrix3<T> matrix = shown.in<T>();
  return (matrix + matrix.transpose()) / T(2);
}

/// ‖M‖_F ≤ bound. No value if error bounds do not decide it.
template <class T>
auto norm_at_most(const Matrix3<T>& matrix, double bound) {
  return oracles::norm_at_most(std::span<const T>(matrix.data(), 9), bound);
}

/// Whether bounds may decide a statement about the shown C.
bool may_use_bounds(const Evidence& e, const LiftedMatrix& shown) {
  return e.yardstick.uses_bounds() && e.exact_case.is_moderate() && shown.is_moderate();
}

/// `by_bounds()` if bounds decide the statement about the shown C. Otherwise `by_rationals()`.
template <class ByBounds, class ByRationals>
auto decided(const Evidence& e, const LiftedMatrix& shown, const ByBounds& by_bounds, const ByRationals& by_rationals) {
  if (may_use_bounds(e, shown)) {
    if (const auto decision = by_bounds()) {
      count(oracles::Stage::enclosure);
      return *decision;
    }
  }
  count(oracles::Stage::rational);
  return by_rationals();
}

/// bound · I ⪯ M for a symmetric M. No value if error bounds do not decide it.
std::optional<bool> is_at_least(const Matrix3<Enclosure>& matrix, const Enclosure& bound) {
  return is_positive_semidefinite(less_multiple_of_identity<Enclosure>(matrix, bound));
}

/// Whether bounds show that the shown C is near the exact K: ‖C − K‖_F is at most `allowance` times a lower bound of
/// the sensitivity. K ⪰ λI (`ExactCase::is_definite`), so each eigenvalue of C is then at least λ, within the permitted
/// rounding.
bool is_surely_exact(const Evidence& e, const LiftedMatrix& shown) {
  const oracles::ExactCase& exact_case = e.exact_case;
  if (!may_use_bounds(e, shown)) {
    return false;
  }
  const double allowed = e.allowance() * exact_case.collision_matrix_sensitivity_below();
  const bool is_near =
      norm_at_most<Enclosure>(shown.in<Enclosure>() - exact_case.enclosed_collision_matrix(), allowed).value_or(false);
  if (is_near) {
    count(oracles::Stage::enclosure);
  }
  return is_near;
}

/// Whether bounds show K ⪯ 16 λI, with no permitted rounding.
bool is_surely_well_conditioned(const oracles::ExactCase& exact_case) {
  const Enclosure bound = Enclosure(16) * inverse_mass(exact_case.enclosed());
  return is_at_least(-exact_case.enclosed_collision_matrix(), -bound).value_or(false);
}

/// Whether the subject owes its matrix: the contact collides. If rounding of the inputs can make the contact separate,
/// the subject may see no approach, and owes none.
bool owes_matrix(const Evidence& e) {
  return e.exact_case.state() == oracles::ContactState::colliding && !e.exact_case.is_grazing(e.allowance());
}

/// Applies `check` to the C that the subject shows.
template <Verdict (*check)(const Evidence&, const LiftedMatrix&)>
Verdict of_shown_matrix(const Evidence& e) {
  if (e.exact_case.state() == oracles::ContactState::inert) {
    return does_not_apply("both bodies are immovable");
  }
  const LiftedMatrix* shown = e.outcome.collision_matrix();
  if (shown == nullptr) {
    return owes_matrix(e) ? violation(ViolationKind::matrix_missing)
                          : does_not_apply("the subject need not show C, because the contact does not surely collide");
  }
  if (!shown->is_finite()) {
    return violation(ViolationKind::matrix_not_finite);
  }
  return check(e, *shown);
}

Verdict check_definite(const Evidence& e, const LiftedMatrix& shown) {
  if (is_surely_exact(e, shown)) {
    return {};
  }
  if (!e.yardstick.allowed(sensitivity(e))) {
    return beyond_range();
  }
  const Rational lambda = inverse_mass(e.exact_case.exact());
  if (!e.exact_case.is_definite()) {
    count(oracles::Stage::rational);
    return bound_missed("the exact C and λI", e.exact_case.collision_matrix(), lambda);
  }
  const Rational least = lambda - eigenvalue_rounding(e);
  const bool is_definite = decided(
      e, shown, [&] { return is_at_least(symmetric_part<Enclosure>(shown), Enclosure(least)); },
      [&] { return oracles::is_at_least(symmetric_part<Rational>(shown), least); });
  if (!is_definite) {
    return bound_missed("the computed C and λI", shown.exact(), lambda);
  }
  return {};
}

Verdict check_well_conditioned(const Evidence& e, const LiftedMatrix& shown) {
  if (is_surely_exact(e, shown) && is_surely_well_conditioned(e.exact_case)) {
    return {};
  }
  if (!e.yardstick.allowed(sensitivity(e))) {
    return beyond_range();
  }
  const Rational bound = 16 * inverse_mass(e.exact_case.exact());
  // The bound 16 λ is sharp, so rounded moments and lever arms can exceed it.
  const Rational most = bound + eigenvalue_rounding(e);
  if (!e.exact_case.is_bounded_by(most)) {
    count(oracles::Stage::rational);
    return bound_missed("the exact C and 16 λI", e.exact_case.collision_matrix(), bound);
  }
  const bool is_bounded = decided(
      e, shown, [&] { return is_at_least(-symmetric_part<Enclosure>(shown), Enclosure(Rational(-most))); },
      [&] { return oracles::is_at_most(symmetric_part<Rational>(shown), most); });
  if (!is_bounded) {
    return bound_missed("the computed C and 16 λI", shown.exact(), bound);
  }
  return {};
}

/// `convex_uniform` is stronger than necessary: uniform bodies that are star-shaped from the contact point suffice.
Verdict check_well_conditioned_if_convex(const Evidence& e) {
  return e.convex_uniform
             ? of_shown_matrix<check_well_conditioned>(e)
             : does_not_apply("the bodies are not known to be uniform and star-shaped from the contact point");
}

/// Checks C = K: the permitted error of C is the allowance times the sensitivity of K.
Verdict check_exact(const Evidence& e, const LiftedMatrix& shown) {
  if (is_surely_exact(e, shown)) {
    return {};
  }
  const std::optional<double> allowed = e.yardstick.allowed(sensitivity(e));
  const auto verdict = [&]<class T>(const Matrix3<T>& missed, const Matrix3<T>& exact) -> Verdict {
    return {.status = Status::violated,
            .detail = "C and K",
            .residual = oracles::root_of_squares(9, [&](std::size_t i) { return oracles::rounded(missed.data()[i]); }),
            .allowed = *allowed,
            .left = entries(shown.in<T>()),
            .right = entries(exact)};
  };
  const auto by_bounds = [&]() -> std::optional<Verdict> {
    const Matrix3<Enclosure>& exact = e.exact_case.enclosed_collision_matrix();
    const Matrix3<Enclosure> missed = shown.in<Enclosure>() - exact;
    const std::optional<bool> is_near = allowed ? norm_at_most(missed, *allowed) : std::nullopt;
    return is_near ? std::optional(*is_near ? Verdict{} : verdict(missed, exact)) : std::nullopt;
  };
  const auto by_rationals = [&]() -> Verdict {
    const Matrix3<Rational>& exact = e.exact_case.collision_matrix();
    const Matrix3<Rational> missed = shown.exact() - exact;
    if (norm_at_most(missed, allowed.value_or(0))) {
      return {};
    }
    return allowed ? verdict(missed, exact) : beyond_range();
  };
  return decided(e, shown, by_bounds, by_rationals);
}

Verdict check_matrix_used(const Evidence& e, const LiftedMatrix& shown) {
  return both(check_exact(e, shown),
              verdict_of(compare_change_by(shown, e.exact_case, e.outcome, e.yardstick), "V⁺ − V⁻ and C F"));
}

}  // namespace

std::vector<Invariant> matrix_invariants() {
  return {
      Invariant{"definite", "The collision matrix is positive definite, and its least eigenvalue is at least λ.",
                R"(\lambda I \preceq C,\quad \lambda = 1/m_A + 1/m_B)",
                "note eq. 27, with QᵀJ⁻¹Q positive semidefinite",
                "contacts with a movable body, if the subject shows its C", every_law(),
                AboutMatrix{of_shown_matrix<check_definite>, false, true},
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
          every_law(), AboutMatrix{check_well_conditioned_if_convex, true, true},
          Proof{ProvedOf::every_impulse,
                {{"well_conditioned", "well_conditioned.v"},
                 {"star_shaped_well_conditioned", "star_shaped.v"},
                 {"star_shaped_condition_number", "star_shaped.v"},
                 {"bound_is_sharp", "star_shaped.v"}}}},
      Invariant{
          "matrix_used",
          "The shown collision matrix is that of the contact, and maps the impulse to the change of the relative "
          "velocity.",
          R"(C = K,\quad V^+ - V^- = C F)", "note eq. 24, with C = K in world axes",
          "contacts with a movable body, if the subject shows its C", every_law(),
          AboutMatrix{of_shown_matrix<check_matrix_used>},
          Proof{ProvedOf::every_impulse,
                {{"velocity_change", "collision_matrix.v"}, {"collision_matrix_symmetric", "collision_matrix.v"}}}}};
}

}  // namespace carom::properties
