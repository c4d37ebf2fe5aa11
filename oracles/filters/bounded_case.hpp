// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/filters/lazy.hpp>
#include <carom/oracles/filters/refined_truth.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/models/sensitivity.hpp>
#include <carom/oracles/numbers/inputs.hpp>

namespace carom::oracles {

/// What the filters know of a valid collision: approximations with bounds, each worked out when first asked for. For
/// one thread.
class BoundedCase {
 public:
  /// Precondition: the collision is valid.
  explicit BoundedCase(const Collision& collision) : collision_(collision) {
    CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  }

  [[nodiscard]] const Collision& collision() const { return collision_; }
  [[nodiscard]] const BasicCollision<Enclosure>& enclosed() const;
  [[nodiscard]] const BasicCollision<Approximation>& approximate() const;

  /// Whether no number is out of the ordinary (moderate.hpp): scales and sensitivities are then surely finite.
  [[nodiscard]] bool is_moderate() const;

  struct NormalVelocity {
    double value;  // rounded, to six digits
    int sign;      // −1, 0 or 1
  };
  /// N·V⁻, where the bounds decide it.
  [[nodiscard]] std::optional<NormalVelocity> normal_velocity() const;

  /// At least Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖.
  [[nodiscard]] double normal_velocity_sensitivity_above() const;

  /// ‖y_k⁻‖; also a lower bound of any sensitivity, of which it is a term.
  [[nodiscard]] const Sensitivity& norms_before() const;

  /// The norms of the derivatives of an equation by the vectors of an outcome; worked out by `differentiate` when first
  /// asked for.
  template <class Differentiate>
  [[nodiscard]] const PerVector<double>& slopes(AffineEquation equation, const Differentiate& differentiate) const {
    return slopes_[equation].get(differentiate);
  }

  /// The collision with its numbers as inputs of differentiation.
  [[nodiscard]] const DualInputs<double, collision_inputs>& differentiated() const;

  /// The law's answer to a contact that collides, to about 100 bits, with its bound; not certified, since no equation
  /// holds exactly for it. Preconditions: as of colliding_truth.
  [[nodiscard]] const Truth<Enclosure>& colliding_truth(Law law, Branch branch) const;

  /// A lower bound of the sensitivity of that answer, at a small part of its cost: ‖y_k⁻‖ + ½ ‖y_k‖. The law's answer
  /// is homogeneous of degree one in the velocities, so the sum over these alone is at least ‖y_k‖ (Euler); the half
  /// covers the rounding of the sum, of which ten digits are kept, and its own. Preconditions: is_moderate(), and as of
  /// colliding_truth.
  [[nodiscard]] const Sensitivity& colliding_sensitivity_below(Law law, Branch branch) const;

  /// Whether the law `rough` answers inside the cone, and whether its answer may lie on the surface (models.hpp), where
  /// bounds decide it. Precondition: a body is movable.
  [[nodiscard]] std::optional<bool> is_inside_cone() const;
  [[nodiscard]] std::optional<bool> reaches_cone() const;

  /// Whether on the cone's surface the sensitivity of `rough` is surely finite. Preconditions: is_moderate(); a body is
  /// movable.
  [[nodiscard]] bool has_clear_divisor() const;

  /// Whether κ(K) < 2²⁰: binary64 loses about κ(K) u of the sensitivities, and then keeps ten digits.
  [[nodiscard]] bool is_well_conditioned() const;

  /// K and λ with bounds.
  [[nodiscard]] const Matrix3<Approximation>& collision_matrix() const { return approximate_response().matrix; }
  [[nodiscard]] Approximation approximate_inverse_mass() const { return inverse_mass(approximate()); }
  [[nodiscard]] const Enclosure& enclosed_inverse_mass() const;

  /// A lower bound of Σ_q ‖∂K/∂q‖ ‖q‖: half of ‖K‖_F where binary64 cannot have lost it, and of λ
  /// (bounded_case_bounds.hpp). Precondition: is_moderate().
  [[nodiscard]] double collision_matrix_sensitivity_below() const;

  /// The inertia tensor of a body in world coordinates, rounded; zero where the body is immovable.
  [[nodiscard]] const Matrix3<double>& inertia_of_a() const { return inertia_tensors().a; }
  [[nodiscard]] const Matrix3<double>& inertia_of_b() const { return inertia_tensors().b; }

 private:
  /// What is known of one law.
  struct OfLaw {
    Lazy<Truth<Enclosure>> truth;
    Lazy<Sensitivity> sensitivity_below;
  };
  struct InertiaTensors {
    Matrix3<double> a;
    Matrix3<double> b;
  };

  [[nodiscard]] const ApproximateResponse& approximate_response() const;
  [[nodiscard]] const InertiaTensors& inertia_tensors() const;

  Collision collision_;
  Lazy<bool> is_moderate_;
  Lazy<BasicCollision<Enclosure>> enclosed_;
  Lazy<BasicCollision<Approximation>> approximate_;
  Lazy<ApproximateResponse> approximate_response_;
  Lazy<std::unique_ptr<DualInputs<double, collision_inputs>>> differentiated_;  // large, and seldom asked for
  Lazy<double> normal_velocity_sensitivity_above_;
  Lazy<Sensitivity> norms_before_;
  PerAffineEquation<Lazy<PerVector<double>>> slopes_;
  PerLaw<OfLaw> of_law_;
  Lazy<bool> has_clear_divisor_;
  Lazy<double> collision_matrix_sensitivity_below_;
  Lazy<Enclosure> enclosed_inverse_mass_;
  Lazy<InertiaTensors> inertia_tensors_;
};

}  // namespace carom::oracles
