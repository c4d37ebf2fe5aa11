// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include <carom/oracles/judge/judge.hpp>

namespace carom::oracles {

/// An outcome ŷ that is close to the truth y keeps every law within what is allowed, and no law has to be evaluated for
/// it. The truth satisfies each law g exactly (ExactCase::truth is certified, the tests prove the inequalities), g is
/// affine in the outcome, or convex: the kinetic energy, and what is missed of it is at most Σ_k ‖∂g/∂ŷ_k‖ ‖ŷ_k − y_k‖.
/// Why that is within what is allowed, rounding and all, is said in inequalities in closeness_bounds.hpp.
class Closeness {
 public:
  /// Close to nothing.
  Closeness() = default;

  /// Preconditions: the yardstick uses bounds, collision and outcome are moderate; the accuracy is of this outcome.
  Closeness(const ExactCase& exact_case, const LiftedOutcome& outcome, const Accuracy& accuracy, double allowance);

  /// Whether it shows that the law holds.
  [[nodiscard]] bool shows(AffineLaw law) const;

  /// Whether it shows that the energy grows by no more than the work of a driven wall. Of an outcome by the
  /// frictionless law, whose truth does not.
  [[nodiscard]] bool shows_energy() const;

  /// Whether it shows that the vectors are as before the impulse, to within a · ‖y_k⁻‖. Precondition: so are those of
  /// the truth.
  [[nodiscard]] bool shows_untouched(std::initializer_list<std::size_t> which) const;

 private:
  [[nodiscard]] bool is_close(std::initializer_list<std::size_t> which) const;
  [[nodiscard]] bool knows_normal_velocity() const;

  const ExactCase* exact_case_ = nullptr;
  const LiftedOutcome* outcome_ = nullptr;
  std::array<double, 4> error_above_{};
  std::array<double, 4> sizes_{};  // ‖ŷ_k‖ + ‖y_k⁻‖
  std::array<bool, 4> is_close_{};
  double allowance_ = 0;
};

}  // namespace carom::oracles
