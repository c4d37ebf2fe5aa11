// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/lifted_outcome.hpp>

namespace carom::oracles {

/// Shows that an outcome ŷ satisfies equations because ŷ is close to the truth y.
///
/// The truth satisfies each equation exactly: `certify` checks the equations that define the law, and
/// closeness_test.cpp the others. Each equation g is affine in the outcome, or convex (the kinetic energy). So the
/// residual of g at ŷ is at most Σ_k ‖∂g/∂ŷ_k‖ ‖ŷ_k − y_k‖ over the vectors k. closeness_bounds.hpp shows that the
/// permitted residual covers this sum and all rounding.
class Closeness {
 public:
  /// A closeness that shows nothing.
  Closeness() = default;

  /// `error_above` is at least ‖ŷ_k − y_k‖, and `allowance` is Yardstick::allowance(). Preconditions: the law is one of
  /// `laws_with_truth`; Yardstick::uses_bounds(), BoundedCase::is_moderate() and LiftedOutcome::is_moderate() are true.
  Closeness(const BoundedCase& bounds, Law law, const LiftedOutcome& outcome, const PerVector<double>& error_above,
            double allowance);

  /// Whether closeness shows that the equation holds. Precondition: the equation applies to this collision.
  [[nodiscard]] bool shows(const Equation& equation) const;

  [[nodiscard]] bool shows_energy() const;

  /// Whether closeness shows ‖ŷ_k − y_k⁻‖ ≤ allowance · ‖y_k⁻‖ for each of these vectors, with y_k⁻ the vector before
  /// the impulse. Precondition: the truth leaves these vectors unchanged.
  [[nodiscard]] bool shows_untouched(std::span<const OutcomeVector> which) const;

 private:
  [[nodiscard]] bool knows_normal_velocity() const;

  const BoundedCase* bounds_ = nullptr;
  Law law_ = Law::any;
  const LiftedOutcome* outcome_ = nullptr;
  PerVector<double> error_above_{};
  PerVector<double> sizes_{};  // ‖ŷ_k‖ + ‖y_k⁻‖
  PerVector<bool> is_close_{};
  double allowance_{};
};

}  // namespace carom::oracles
