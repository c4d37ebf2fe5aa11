// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <carom/oracles/filters/case_bounds.hpp>
#include <carom/oracles/filters/lifted_outcome.hpp>

namespace carom::oracles {

/// An outcome ŷ that is close to the truth y keeps every law within what is allowed, and no law has to be evaluated for
/// it. The truth satisfies each law g exactly, g(y) = 0 or g(y) ≤ 0 (ExactCase::truth is certified, the tests prove the
/// inequalities), and g is affine in the outcome, or convex: the kinetic energy. So
///
///   ‖g(ŷ)‖, or what is missed of g(ŷ) ≤ 0,  ≤  Σ_k ‖∂g/∂ŷ_k‖ ‖ŷ_k − y_k‖.
///
/// Where ‖ŷ_k − y_k‖ ≤ a (‖ŷ_k‖ + ‖y_k⁻‖) for each vector that the law speaks of, that is at most the allowance a times
/// the scale of `compare`, of which Σ_k ‖∂g/∂ŷ_k‖ (‖ŷ_k‖ + ‖y_k⁻‖) is a part. The scale is computed in binary64: a
/// millionth of `a` is set aside for what its slopes may lose, which is less than 2⁻⁴⁰ of each, for they are lengths of
/// numbers of the collision (N, m, r, J, and their products, each without cancellation) but for r × N and ∂E/∂ŷ, which
/// are looked at. The collision is moderate, so that none of it leaves the range of numbers.
class Closeness {
 public:
  /// Close to nothing.
  Closeness() = default;

  /// `error_above` is at least ‖ŷ_k − y_k‖. Preconditions: the model is one of `models_with_truth`; the allowance is
  /// that of a yardstick that uses bounds; collision and outcome are moderate.
  Closeness(const CaseBounds& bounds, Model model, const LiftedOutcome& outcome, const PerVector<double>& error_above,
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

  const CaseBounds* bounds_ = nullptr;
  Model model_ = Model::any;
  const LiftedOutcome* outcome_ = nullptr;
  PerVector<double> error_above_{};
  PerVector<double> sizes_{};  // ‖ŷ_k‖ + ‖y_k⁻‖
  PerVector<bool> is_close_{};
  double allowance_ = 0;
};

}  // namespace carom::oracles
