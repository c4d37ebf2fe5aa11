// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/filters/lazy.hpp>
#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/laws/truth.hpp>
#include <carom/oracles/models/sensitivity.hpp>
#include <carom/oracles/numbers/inputs.hpp>

namespace carom::oracles {

/// Facts about a valid collision, in arithmetic with error bounds. Each fact is computed on first use. For one thread.
/// y_k are the vectors of an outcome, and y_k⁻ those before the impulse.
class BoundedCase {
 public:
  /// Precondition: validate(collision) is empty.
  explicit BoundedCase(const Collision& collision) : collision_(collision) {
    CAROM_EXPECTS(validate(collision).empty(), describe(validate(collision)));
  }

  [[nodiscard]] const Collision& collision() const { return collision_; }
  [[nodiscard]] const BasicCollision<Enclosure>& enclosed() const;

  /// Whether the collision is moderate (moderate.hpp), so that its scales and sensitivities are finite.
  [[nodiscard]] bool is_moderate() const;

  struct NormalVelocity {
    double value;  // rounded, correct to six digits
    int sign;      // −1, 0 or 1
  };
  /// N·V⁻. No value if the bounds do not give six digits.
  [[nodiscard]] std::optional<NormalVelocity> normal_velocity() const;

  /// V⁻, rounded from enclosures, because cancellation in binary64 may leave V⁻ without a correct digit.
  [[nodiscard]] const Vector3<double>& relative_velocity() const;

  /// The impulses P_I and P_II of the law `rough` (models/rough.hpp), rounded from enclosures.
  struct StopImpulses {
    Vector3<double> of_approach;  // P_I
    Vector3<double> of_point;     // P_II
  };
  /// Precondition: a body is movable.
  [[nodiscard]] const StopImpulses& stop_impulses() const;

  /// ‖y_k⁻‖, a lower bound of the sensitivity of y_k.
  [[nodiscard]] const Sensitivity& norms_before() const;

  /// ‖∂g/∂y_k‖ of an equation g for each k. `differentiate` computes these norms on first use.
  template <class Differentiate>
  [[nodiscard]] const PerVector<double>& slopes(AffineEquation equation, const Differentiate& differentiate) const {
    return slopes_[equation].get(differentiate);
  }

  [[nodiscard]] const DualInputs<double, collision_inputs>& differentiated() const;

  /// The law's answer to a contact that collides, to about 100 bits, with error bounds. Preconditions: those of the
  /// function `colliding_truth` (models.hpp).
  [[nodiscard]] const Truth<Enclosure>& colliding_truth(Law law, Branch branch) const;

  /// ‖y_k⁻‖ + ½ ‖y_k‖, a cheap lower bound of the sensitivity of the answer y of `colliding_truth`. y is homogeneous of
  /// degree one in the velocities. So the part of Σ_q ‖∂y_k/∂q‖ ‖q‖ by the velocities is at least ‖y_k‖ (Euler). The
  /// factor ½ covers the rounding of this bound and of the sensitivity. Preconditions: is_moderate();
  /// has_clear_divisor() if `branch` is `on_cone`; those of `colliding_truth`.
  [[nodiscard]] const Sensitivity& colliding_sensitivity_below(Law law, Branch branch) const;

  /// Whether the impulse F of the law `rough` lies inside the friction cone (models.hpp). No value if the bounds do not
  /// decide it. Precondition: a body is movable.
  [[nodiscard]] std::optional<bool> is_inside_cone() const;
  /// Whether some κ > 0 of `rough` (models/rough.hpp) puts F on the cone's surface. Precondition: a body is movable.
  [[nodiscard]] std::optional<bool> reaches_cone() const;

  /// Whether the sensitivity of `rough` on the cone's surface is certainly finite. Preconditions: is_moderate(); a body
  /// is movable.
  [[nodiscard]] bool has_clear_divisor() const;

  /// Whether bounds show that the condition number of K is below 2²⁰. An inverse of K in binary64 then keeps ten
  /// digits.
  [[nodiscard]] bool is_well_conditioned() const;

  [[nodiscard]] const Matrix3<Enclosure>& collision_matrix() const;

  /// A lower bound of Σ_q ‖∂K/∂q‖ ‖q‖ (bounded_case_bounds.hpp): λ/2, or ‖K‖_F/2 if this is larger and ‖K‖_F exceeds
  /// its rounding errors. Precondition: is_moderate().
  [[nodiscard]] double collision_matrix_sensitivity_below() const;

 private:
  struct OfLaw {
    PerBranch<Lazy<Truth<Enclosure>>> truth;
    PerBranch<Lazy<Sensitivity>> sensitivity_below;
  };

  [[nodiscard]] const OfLaw& of(Law law) const {
    return of_law_.get(law, [] { return OfLaw(); });
  }

  Lazy<bool> is_moderate_;
  Lazy<bool> has_clear_divisor_;
  LazyMap<Law, OfLaw> of_law_;
  Lazy<Sensitivity> norms_before_;
  Collision collision_;
  Lazy<BasicCollision<Enclosure>> enclosed_;
  Lazy<std::unique_ptr<DualInputs<double, collision_inputs>>> differentiated_;  // large and seldom used
  Lazy<Vector3<double>> relative_velocity_;
  Lazy<StopImpulses> stop_impulses_;
  PerAffineEquation<Lazy<PerVector<double>>> slopes_;
  Lazy<double> collision_matrix_sensitivity_below_;
  Lazy<Matrix3<Enclosure>> collision_matrix_;
};

}  // namespace carom::oracles
