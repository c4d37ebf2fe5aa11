// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/lifted_outcome.hpp>

namespace carom::oracles {

/// If an outcome ŷ is close to the truth y, it satisfies every equation within the allowance, and no equation has to be
/// evaluated. The truth satisfies each equation g exactly: ExactCase::truth is certified, and tests prove the
/// inequalities. g is affine in the outcome, or convex (the kinetic energy). The residual of g is therefore at most Σ_k
/// ‖∂g/∂ŷ_k‖ ‖ŷ_k − y_k‖. The inequalities in closeness_bounds.hpp show that this is within the allowance, including
/// all rounding.
class Closeness {
 public:
  /// A closeness that shows nothing.
  Closeness() = default;

  /// `error_above` is at least ‖ŷ_k − y_k‖. Preconditions: the law is one of `laws_with_truth`; the allowance
  /// belongs to a yardstick that uses bounds; collision and outcome are moderate.
  Closeness(const BoundedCase& bounds, Law law, const LiftedOutcome& outcome, const PerVector<double>& error_above,
            double allowance);

  /// Whether closeness shows that the equation holds. Precondition: the equation applies to this collision.
  [[nodiscard]] bool shows(const Equation& equation) const;

  /// Whether closeness shows that the energy grows by at most the work of a driven wall.
  [[nodiscard]] bool shows_energy() const;

  /// Whether closeness shows that the vectors are unchanged by the impulse, to within a · ‖y_k⁻‖. Precondition: the
  /// truth leaves these vectors unchanged.
  [[nodiscard]] bool shows_untouched(std::span<const OutcomeVector> which) const;

 private:
  [[nodiscard]] bool knows_normal_velocity() const;

  const BoundedCase* bounds_ = nullptr;
  Law law_ = Law::any;
  const LiftedOutcome* outcome_ = nullptr;
  PerVector<double> error_above_{};
  PerVector<double> sizes_{};  // ‖ŷ_k‖ + ‖y_k⁻‖
  PerVector<bool> is_close_{};
  double allowance_ = 0;
};

}  // namespace carom::oracles
