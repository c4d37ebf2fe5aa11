// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>

#include <carom/oracles/enclosure.hpp>
#include <carom/oracles/truth.hpp>

namespace carom::oracles {

/// For each vector y_k of an outcome the sum over the stored numbers x_j of ‖∂y_k/∂x_j‖ |x_j|, and ‖y_k⁻‖: the
/// denominator of the backward error, without the unit roundoff. The last term stands for the rounding of the sum y_k⁻
/// + Δy_k, which no change of the inputs explains where the sum nearly vanishes and the law is insensitive (a ball that
/// hits a wall head-on at ε = 0): mixed forward-backward error, N. Higham, Accuracy and Stability of Numerical
/// Algorithms, §1.5.
using Sensitivity = std::array<double, 4>;

/// A valid collision and what is exactly known of it, each worked out when first asked for. For one thread.
class ExactCase {
 public:
  /// Precondition: the collision is valid.
  explicit ExactCase(const Collision& collision);

  [[nodiscard]] const Collision& collision() const { return collision_; }
  [[nodiscard]] const BasicCollision<Rational>& exact() const;
  [[nodiscard]] const BasicCollision<Enclosure>& enclosed() const { return enclosed_; }
  [[nodiscard]] Approach approach() const { return approach_; }

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

  /// A lower bound of `sensitivity`, at a fifth of the cost: ½ ‖y_k‖. The law's answer is homogeneous of degree one in
  /// the velocities, so the sum over these alone is at least ‖y_k‖ (Euler); the half covers the grazing band, where the
  /// colliding answer counts and differs from the velocities before by rounding.
  [[nodiscard]] Sensitivity sensitivity_below(Model model) const;

  /// K, exactly (`response_matrix`), and Σ_j ‖∂K/∂x_j‖_F |x_j|.
  [[nodiscard]] const Matrix3<Rational>& collision_matrix() const;
  [[nodiscard]] double collision_matrix_sensitivity() const;

  /// Whether λI ⪯ K, decided exactly.
  [[nodiscard]] bool is_definite() const;

  /// Whether K ⪯ bound I, decided exactly.
  [[nodiscard]] bool is_bounded_by(const Rational& bound) const;

  /// Whether r × N = 0 for each movable body, exactly.
  [[nodiscard]] bool is_collinear() const;

  /// Whether N × V⁻ = 0, exactly.
  [[nodiscard]] bool is_head_on() const;

  /// λ = 1/m_A + 1/m_B.
  [[nodiscard]] Rational inverse_mass() const;

  /// Whether the impulse is best read off A: the lighter movable body. Precondition: a body is movable.
  [[nodiscard]] bool reads_impulse_off_a() const;

 private:
  Collision collision_;
  BasicCollision<Enclosure> enclosed_;
  double normal_velocity_ = 0;  // rounded
  Approach approach_ = Approach::inert;
  mutable std::optional<BasicCollision<Rational>> exact_;
  mutable std::optional<double> normal_velocity_sensitivity_;
  mutable std::map<Model, Truth<Rational>> truth_;
  mutable std::map<Model, Truth<Enclosure>> enclosed_truth_;
  mutable std::map<Model, Sensitivity> colliding_sensitivity_;
  mutable std::optional<Sensitivity> unchanged_sensitivity_;
  mutable std::optional<Matrix3<Rational>> collision_matrix_;
  mutable std::optional<double> collision_matrix_sensitivity_;
  mutable std::optional<bool> is_definite_;
};

/// The residuals of the defining equations for a given outcome; each is exactly zero where the outcome is the law's.
/// Throws std::logic_error that names the equation where one is not.
void certify(const BasicCollision<Rational>& collision, Model model, Approach approach,
             const Outcome<Rational>& outcome);

}  // namespace carom::oracles
