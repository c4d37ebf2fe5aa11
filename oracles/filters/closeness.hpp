// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/lifted_outcome.hpp>

namespace carom::oracles {

/// An outcome ŷ that is close to the truth y keeps every law within what is allowed, and no law has to be evaluated for
/// it. The truth satisfies each law g exactly (ExactCase::truth is certified, the tests prove the inequalities), g is
/// affine in the outcome, or convex: the kinetic energy, and what is missed of it is at most Σ_k ‖∂g/∂ŷ_k‖ ‖ŷ_k − y_k‖.
/// Why that is within what is allowed, rounding and all, is said in inequalities in closeness_bounds.hpp.
class Closeness {
 public:
  /// Close to nothing.
  Closeness() = default;

  /// `error_above` is at least ‖ŷ_k − y_k‖. Preconditions: the law is one of `laws_with_truth`; the allowance is
  /// that of a yardstick that uses bounds; collision and outcome are moderate.
  Closeness(const BoundedCase& bounds, Law law, const LiftedOutcome& outcome, const PerVector<double>& error_above,
            double allowance);

  /// Whether it shows that the equation holds. Precondition: the equation speaks of this collision.
  [[nodiscard]] bool shows(const Equation& equation) const;

  /// Whether it shows that the energy grows by no more than the work of a driven wall.
  [[nodiscard]] bool shows_energy() const;

  /// Whether it shows that the vectors are as before the impulse, to within a · ‖y_k⁻‖. Precondition: so are those of
  /// the truth.
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
