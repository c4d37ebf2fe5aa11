// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/oracles/filters/lifted_outcome.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/judge/yardstick.hpp>

namespace carom::oracles {

/// How far an outcome is from the truth.
struct Accuracy {
  PerVector<double> error{};                 // ‖ŷ_k − y_k‖
  PerVector<double> error_above = infinite;  // at least the error; infinite where the judge is not filtered
  Sensitivity sensitivity{};                 // Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖
  bool is_decided = true;  // false where the sensitivity, or what is allowed of it, leaves the range of numbers: then
                           // nothing else here means anything
  PerVector<bool> allowed{true, true, true, true};  // whether the error is within the yardstick
  bool has_digits = true;   // relative_error ≤ 10^−digits, decided exactly; where the yardstick gives digits
  bool is_of_truth = true;  // false where the outcome passes by the other of two answers
  double relative_error = 0;  // ‖Δ − Δ_exact‖ / ‖Δ_exact‖ in the kinetic-energy norm, Δ the change of the velocities;
                              // infinite where Δ_exact = 0 and Δ is not

  /// Whether the error of every vector is within the yardstick.
  [[nodiscard]] bool is_allowed() const { return allowed == PerVector<bool>{true, true, true, true}; }

  /// η = max_k of error over u times sensitivity: by how many ulps the inputs would have to move to make it exact.
  [[nodiscard]] double backward_error(double unit_roundoff) const;

  /// Correct digits of the change of the velocities; at most 40, which stands for exact.
  [[nodiscard]] double digits() const;

 private:
  static constexpr PerVector<double> infinite{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

/// Correct digits of the change of the velocities, as Accuracy::digits, of an outcome beside an exact one.
[[nodiscard]] double digits_of(const BasicCollision<Rational>& collision, const Outcome<Rational>& exact,
                               const Outcome<Rational>& computed);

/// Where the case has two answers by this law, that of the answer by which the outcome passes; of the truth where
/// there is none. Precondition: the law is one of `laws_with_truth`. Where the backward error is surely at most
/// `known`, by a filtered yardstick, the sensitivity may be a lower bound in place of the number itself, at a small
/// part of the cost: the backward error then comes out too large, but at most `known`.
[[nodiscard]] Accuracy accuracy(const ExactCase& exact_case, Law law, const LiftedOutcome& outcome,
                                const Yardstick& yardstick, double known = 0);

}  // namespace carom::oracles
