// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <carom/oracles/filters/refined_truth.hpp>
#include <carom/oracles/judge/judged_laws.hpp>
#include <carom/oracles/models/sensitivity.hpp>
#include <carom/oracles/numbers/approximation.hpp>
#include <carom/oracles/numbers/enclosure.hpp>
#include <carom/oracles/numbers/inputs.hpp>

namespace carom::oracles {

/// A valid collision and what is exactly known of it, each worked out when first asked for. For one thread.
class ExactCase {
 public:
  /// Precondition: the collision is valid.
  explicit ExactCase(const Collision& collision);

  [[nodiscard]] const Collision& collision() const { return collision_; }
  [[nodiscard]] const BasicCollision<Rational>& exact() const;
  [[nodiscard]] const BasicCollision<Enclosure>& enclosed() const;
  [[nodiscard]] const BasicCollision<Approximation>& approximate() const;
  [[nodiscard]] Approach approach() const;

  /// Whether no number is out of the ordinary (moderate.hpp): scales and sensitivities are then surely finite.
  [[nodiscard]] bool is_moderate() const;

  /// ‖y_k⁻‖; also a lower bound of any `sensitivity`, of which it is a term.
  [[nodiscard]] const std::array<double, 4>& norms_before() const;

  /// The norms of the derivatives of an affine law by the vectors of an outcome; worked out by `differentiate` when
  /// first asked for.
  template <class Differentiate>
  [[nodiscard]] const std::array<double, 4>& slopes(AffineLaw law, const Differentiate& differentiate) const {
    std::optional<std::array<double, 4>>& known = slopes_[static_cast<std::size_t>(law)];
    if (!known) {
      known = differentiate();
    }
    return *known;
  }

  /// The collision with its numbers as inputs of differentiation.
  [[nodiscard]] const DualInputs<double, collision_inputs>& differentiated() const;

  /// Whether inputs that differ relatively by `allowance` include both colliding and separating contacts.
  [[nodiscard]] bool is_grazing(double allowance) const;

  /// The law's answer, certified: each residual of the defining equations is exactly zero.
  /// Throws std::logic_error where it is not. Precondition: the model is one of `models_with_truth`.
  [[nodiscard]] const Truth<Rational>& truth(Model model) const;

  /// The same to about 100 bits, with its bound; not certified, since no equation holds exactly for it.
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Model model) const;

  /// The sensitivity of the law's answer. Inside the grazing band it is that of the colliding answer, since inputs
  /// within the allowance collide.
  [[nodiscard]] const Sensitivity& sensitivity(Model model, double allowance) const;

  /// A lower bound of `sensitivity`, at a small part of its cost: where the contact collides ‖y_k⁻‖ + ½ ‖y_k‖.
  /// The law's answer is homogeneous of degree one in the velocities, so the sum over these alone is at least ‖y_k‖
  /// (Euler); the half covers the rounding of the sum, of which ten digits are kept, and its own. Elsewhere ‖y_k⁻‖,
  /// whether grazing or not.
  [[nodiscard]] const Sensitivity& sensitivity_below(Model model) const;

  /// K, exactly (`response_matrix`), and Σ_j ‖∂K/∂x_j‖_F |x_j|.
  [[nodiscard]] const Matrix3<Rational>& collision_matrix() const;
  [[nodiscard]] double collision_matrix_sensitivity() const;

  /// K and λ with bounds.
  [[nodiscard]] const Matrix3<Approximation>& approximate_collision_matrix() const;
  [[nodiscard]] Approximation approximate_inverse_mass() const;
  [[nodiscard]] const Enclosure& enclosed_inverse_mass() const;

  /// A lower bound of `collision_matrix_sensitivity`: half of ‖K‖_F where binary64 cannot have lost it, and of λ
  /// (case_bounds.hpp). Precondition: is_moderate().
  [[nodiscard]] double collision_matrix_sensitivity_below() const;

  /// Whether λI ⪯ K, decided exactly. Where a body is movable it always is: K − λI is the sum of [r]ᵀ J⁻¹ [r] over the
  /// movable bodies, a congruence of a positive diagonal matrix each (an identity that the tests prove by exact random
  /// testing). Not asked by a filtered yardstick.
  [[nodiscard]] bool is_definite() const;

  /// Whether K ⪯ bound I, decided exactly.
  [[nodiscard]] bool is_bounded_by(const Rational& bound) const;

  /// The inertia tensor of a body in world coordinates, rounded; zero where the body is immovable.
  [[nodiscard]] const Matrix3<double>& inertia_of_a() const { return inertia_tensors()[0]; }
  [[nodiscard]] const Matrix3<double>& inertia_of_b() const { return inertia_tensors()[1]; }

  /// The kinetic-energy norm of the change of the velocities by the law, rounded; worked out by `from_truth` when first
  /// asked for, once for each of the two judges: bounds may leave it unknown.
  template <class FromTruth>
  [[nodiscard]] double energy_norm_of_change(Model model, bool exactly, const FromTruth& from_truth) const {
    std::optional<double>& known = of(model).energy_norm_of_change[exactly ? 1 : 0];
    if (!known) {
      known = from_truth();
    }
    return *known;
  }

  /// Whether r × N = 0 for each movable body, exactly.
  [[nodiscard]] bool is_collinear() const;

  /// Whether N × V⁻ = 0, exactly.
  [[nodiscard]] bool is_head_on() const;

  /// λ = 1/m_A + 1/m_B.
  [[nodiscard]] Rational inverse_mass() const;

  /// Whether the impulse is best read off A: the lighter movable body. Precondition: a body is movable.
  [[nodiscard]] bool reads_impulse_off_a() const;

 private:
  /// What is known of one model.
  struct OfModel {
    std::optional<Truth<Rational>> truth;
    std::optional<Truth<Enclosure>> enclosed_truth;
    std::optional<Sensitivity> colliding_sensitivity;
    std::optional<Sensitivity> sensitivity_below;
    std::array<std::optional<double>, 2> energy_norm_of_change;
  };
  struct NormalVelocity {
    double value;  // rounded
    int sign;
  };

  [[nodiscard]] OfModel& of(Model model) const { return of_model_[static_cast<std::size_t>(model)]; }
  [[nodiscard]] const NormalVelocity& normal_velocity() const;
  [[nodiscard]] double sensitivity_above_of_normal_velocity() const;
  [[nodiscard]] const ApproximateResponse& approximate_response() const;
  [[nodiscard]] const Sensitivity& unchanged_sensitivity() const;
  [[nodiscard]] const std::array<Matrix3<double>, 2>& inertia_tensors() const;

  Collision collision_;
  mutable std::optional<BasicCollision<Enclosure>> enclosed_;
  mutable std::optional<BasicCollision<Approximation>> approximate_;
  mutable std::optional<NormalVelocity> normal_velocity_;
  mutable std::optional<BasicCollision<Rational>> exact_;
  mutable std::unique_ptr<DualInputs<double, collision_inputs>> differentiated_;  // large, and seldom asked for
  mutable std::optional<double> normal_velocity_sensitivity_;
  mutable std::optional<double> sensitivity_above_of_normal_velocity_;
  mutable std::optional<std::array<double, 4>> norms_before_;
  mutable std::array<std::optional<std::array<double, 4>>, affine_law_count> slopes_;
  mutable std::array<OfModel, models_with_truth.size()> of_model_;
  mutable std::optional<Sensitivity> unchanged_sensitivity_;
  mutable std::optional<Matrix3<Rational>> collision_matrix_;
  mutable std::optional<double> collision_matrix_sensitivity_;
  mutable std::optional<ApproximateResponse> approximate_response_;
  mutable std::optional<double> collision_matrix_sensitivity_below_;
  mutable std::optional<Enclosure> enclosed_inverse_mass_;
  mutable std::optional<std::array<Matrix3<double>, 2>> inertia_tensors_;
  mutable std::optional<bool> is_moderate_;
  mutable std::optional<bool> is_definite_;
  mutable std::optional<bool> is_collinear_;
  mutable std::optional<bool> is_head_on_;
};

/// The residuals of the defining equations for a given outcome; each is exactly zero where the outcome is the law's.
/// Throws std::logic_error that names the equation where one is not.
void certify(const BasicCollision<Rational>& collision, Model model, Approach approach,
             const Outcome<Rational>& outcome);

}  // namespace carom::oracles
