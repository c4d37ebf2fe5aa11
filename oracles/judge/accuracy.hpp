// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <optional>

#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

/// The distance of an outcome ŷ from the truth y. y_k⁻ are the vectors before the impulse.
struct Accuracy {
  PerVector<double> error{};  // ‖ŷ_k − y_k‖
  Sensitivity sensitivity{};  // Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖, or a lower bound of it (see `accuracy`)
  bool is_decided = true;     // false if the sensitivity, or the allowance times it, leaves the range of numbers; no
                              // other member then has a meaning
  PerVector<bool> allowed{true, true, true, true};  // whether the error is within the yardstick
  /// Whether relative_error ≤ 10^−digits, decided exactly. No value without digits to compare.
  std::optional<bool> has_digits = {};
  bool is_of_truth = true;  // false if the outcome passes by the other of two answers
  double relative_error = 0;  // ‖Δ − Δ_exact‖ / ‖Δ_exact‖ in the kinetic-energy norm, with Δ the change of the
                              // velocities; infinite if Δ_exact = 0 and Δ ≠ 0

  [[nodiscard]] bool is_allowed() const { return allowed == PerVector<bool>{true, true, true, true}; }

  /// η = max_k error_k / (u · sensitivity_k): the least number of ulps that the inputs must move to explain the errors.
  [[nodiscard]] double backward_error(double unit_roundoff) const;

  /// Correct decimal digits of the change of the velocities. The maximum, 40, means exact.
  [[nodiscard]] double digits() const;
};

/// Accuracy::digits of a computed outcome, compared with an exact outcome.
[[nodiscard]] double digits_of(const BasicCollision<Rational>& collision, const Outcome<Rational>& exact,
                               const Outcome<Rational>& computed);

/// The accuracy of an outcome by this law. If the law has two answers (ExactCase::has_two_answers), the accuracy refers
/// to the nearest answer by which the outcome passes. If the outcome passes by none, the accuracy refers to the truth.
///
/// `known` [ulps] saves time if the yardstick is filtered. If the backward error is certainly at most `known`,
/// `accuracy` may use a lower bound of the sensitivity. The backward error of the result is then too large, but at most
/// `known`. Precondition: the law is one of `laws_with_truth`.
[[nodiscard]] Accuracy accuracy(const ExactCase& exact_case, Law law, const LiftedOutcome& outcome,
                                const Yardstick& yardstick, double known = 0);

}  // namespace carom::oracles
