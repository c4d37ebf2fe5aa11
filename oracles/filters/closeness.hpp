// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include <carom/oracles/judge/judge.hpp>

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
