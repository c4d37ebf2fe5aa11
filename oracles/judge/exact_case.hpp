// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/lazy.hpp>
#include <carom/oracles/judge/permitted_inputs.hpp>

namespace carom::oracles {

/// A valid collision and exact facts about it. Each fact is computed on first use. For one thread. N is the normal, V⁻
/// the relative velocity before the impulse, F the impulse, K the collision matrix, and λ = 1/m_A + 1/m_B.
class ExactCase {
 public:
  /// If `filtered` is false, the facts that decide (the sign of N·V⁻, collinear, head-on, bounds of K) are computed in
  /// ℚ alone. The facts are identical. Precondition: the collision is valid.
  explicit ExactCase(const Collision& collision, bool filtered = true);

  [[nodiscard]] const Collision& collision() const { return bounds_.collision(); }
  [[nodiscard]] const BasicCollision<Rational>& exact() const;

  /// The same facts in arithmetic with bounds, for the filters.
  [[nodiscard]] const BoundedCase& bounds() const { return bounds_; }

  [[nodiscard]] Approach approach() const;

  /// Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖ over the quantities q (quantities.hpp).
  [[nodiscard]] double normal_velocity_sensitivity() const;

  /// The permitted inputs, if the first order is blind (PermittedInputs::first_order_is_blind). nullptr otherwise, and
  /// also if the allowance is 0 or at least ½.
  [[nodiscard]] const PermittedInputs* permitted_inputs(double allowance) const;

  /// Whether the inputs that differ relatively by `allowance` include both colliding and separating contacts.
  [[nodiscard]] bool is_grazing(double allowance) const;

  /// The formula by which the law answers if the contact collides. Preconditions: a body is movable; the law is one
  /// of `laws_with_truth`.
  [[nodiscard]] Branch branch(Law law) const;

  /// The law's answer, certified: both sides of each defining equation are equal. Throws std::logic_error if they are
  /// not. Preconditions: the law is one of `laws_with_truth`; its answer is rational, because the contact does not
  /// collide or `branch` is not `on_cone`.
  [[nodiscard]] const Truth<Rational>& truth(Law law) const { return truth(law, approach()); }

  /// The certified answer that the law would give if the contact had approach `as`.
  [[nodiscard]] const Truth<Rational>& truth(Law law, Approach as) const;

  /// The certified answer in ℚ(√s), if `branch` is `on_cone`.
  [[nodiscard]] const Truth<Radical>& truth_on_cone(Law law) const;

  /// Calls use(truth) with the rational truth or with the truth on the cone.
  template <class Use>
  decltype(auto) with_truth(Law law, Approach as, const Use& use) const {
    const Approach answered = answered_as(law, as);
    return answered == Approach::colliding && branch(law) == Branch::on_cone ? use(truth_on_cone(law))
                                                                             : use(truth(law, answered));
  }

  /// The outcome of the truth, each number rounded to the nearest binary64 number.
  [[nodiscard]] Outcome<double> nearest_truth(Law law) const;

  /// The truth to about 100 bits, with error bounds. `certify` cannot check it, because rounded numbers satisfy no
  /// equation exactly.
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law) const { return enclosed_truth(law, approach()); }
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law, Approach as) const;

  /// The sensitivity of the law's answer, to second order: σ_k + a τ_k, with σ_k = Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖
  /// (sensitivity.hpp) and a the allowance. τ_k is ‖y_k⁻‖ plus the largest change of vector k by an impulse of 2 s / λ,
  /// with s an upper bound of ‖V⁻‖. The first order vanishes for some contacts, such as a central contact that grazes.
  /// Only products of two roundings then remain.
  ///
  /// In the grazing band (`is_grazing`), the sensitivity is that of the colliding answer, because some inputs within
  /// the allowance collide. The exception is a law that acts at once (`has_two_answers`), because its two answers are
  /// judged separately. Near the surface of the friction cone, the answers inside the cone and on it meet. The
  /// sensitivity is then the larger of the two.
  ///
  /// If the first order is blind (PermittedInputs::first_order_is_blind), the sensitivity is at least
  /// PermittedInputs::distance_of_answers divided by the allowance.
  [[nodiscard]] Sensitivity sensitivity(Law law, double allowance) const;

  /// The sensitivity that the answer would have if the contact had approach `as` and did not graze.
  [[nodiscard]] Sensitivity sensitivity_as(Law law, Approach as, double allowance) const;

  /// Whether inputs that differ relatively by `allowance` have answers that are far from each other. This is so in the
  /// grazing band (`is_grazing`) for a law that acts at once, whose impulse does not tend to 0 with N·V⁻. `rough` acts
  /// at once if its impulse of friction D (models/rough.hpp) by itself lies in the cone.
  [[nodiscard]] bool has_two_answers(Law law, double allowance) const;

  /// Whether the collision is moderate (moderate.hpp) and the law's sensitivity is certainly finite.
  [[nodiscard]] bool is_moderate(Law law) const;

  /// Whether inputs that differ relatively by `allowance` have answers of every kind. Some inputs collide and some do
  /// not. Among the colliding inputs, F lies inside the friction cone for some, and on it for others. `accuracy` then
  /// decides nothing.
  [[nodiscard]] bool is_open(Law law, double allowance) const;

  /// A lower bound of `sensitivity` that costs much less. If the contact collides, it is
  /// BoundedCase::colliding_sensitivity_below. Otherwise it is ‖y_k⁻‖, even if the contact grazes. Precondition:
  /// is_moderate(law).
  [[nodiscard]] const Sensitivity& sensitivity_below(Law law) const;

  /// K, exactly (`response_matrix`).
  [[nodiscard]] const Matrix3<Rational>& collision_matrix() const;

  /// Σ_q ‖∂K/∂q‖ ‖q‖. If the first order is blind (PermittedInputs::first_order_is_blind), the sum includes the squares
  /// of the perturbations of the lever arms.
  [[nodiscard]] double collision_matrix_sensitivity(double allowance) const;

  /// Whether λI ⪯ K, decided exactly. If a body is movable, this is always true, because K − λI is the sum of [r]ᵀ J⁻¹
  /// [r] over the movable bodies. Each term is a congruence of a positive diagonal matrix. The tests prove this
  /// identity by exact random testing. The judge calls the function only if bounds do not decide.
  [[nodiscard]] bool is_definite() const;

  /// Whether K ⪯ bound · I, decided exactly.
  [[nodiscard]] bool is_bounded_by(const Rational& bound) const;

  /// The kinetic-energy norm of the change of the velocities by the law, rounded. `from_truth` computes it on first
  /// use. The exact judge and the filtered judge each have a value of their own, because bounds may leave it unknown.
  template <class FromTruth>
  [[nodiscard]] double energy_norm_of_change(Law law, bool exactly, const FromTruth& from_truth) const {
    const OfLaw& of_law = of_law_[law];
    return (exactly ? of_law.exact_energy_norm_of_change : of_law.bounded_energy_norm_of_change).get(from_truth);
  }

  /// Whether r × N = 0 for each movable body, exactly.
  [[nodiscard]] bool is_collinear() const;

  /// Whether N × V⁻ = 0, exactly.
  [[nodiscard]] bool is_head_on() const;

 private:
  struct OfLaw {
    Lazy<Truth<Rational>> truth;
    Lazy<Truth<Radical>> truth_on_cone;
    PerBranch<Lazy<Sensitivity>> colliding_sensitivity;
    Lazy<double> exact_energy_norm_of_change;
    Lazy<double> bounded_energy_norm_of_change;
  };

  [[nodiscard]] const BoundedCase::NormalVelocity& normal_velocity() const;
  [[nodiscard]] const Sensitivity& unchanged_sensitivity() const;
  [[nodiscard]] const Sensitivity& colliding_first_order(Law law, Branch branch) const;
  [[nodiscard]] bool is_inside_cone() const;
  [[nodiscard]] bool reaches_cone() const;
  /// Whether the law acts at once, so that its impulse does not tend to 0 with N·V⁻. On the cone the impulse tends to
  /// 0.
  [[nodiscard]] bool acts_at_once_here(Law law, double allowance) const;
  /// Whether the answers to inputs that differ relatively by `allowance` lie on both sides of the cone's surface.
  [[nodiscard]] bool is_near_cone_surface(Law law, double allowance) const;
  /// The approach of the answer if the contact is treated as if it had approach `as`. A contact that does not collide,
  /// and whose answer as a colliding contact would lie on the cone, keeps its own approach. On the cone the impulse
  /// tends to 0 with N·V⁻, so there is no other answer.
  [[nodiscard]] Approach answered_as(Law law, Approach as) const;
  [[nodiscard]] const Sensitivity& second_order() const;

  BoundedCase bounds_;
  bool filtered_;
  Lazy<BasicCollision<Rational>> exact_;
  Lazy<BoundedCase::NormalVelocity> normal_velocity_;
  Lazy<double> normal_velocity_sensitivity_;
  LazyMap<double, std::optional<PermittedInputs>> permitted_inputs_;
  PerLaw<OfLaw> of_law_;
  Lazy<bool> is_inside_cone_;
  Lazy<bool> reaches_cone_;
  Lazy<ConeDistance> cone_distance_;
  Lazy<Truth<Rational>> unchanged_;
  Lazy<Truth<Enclosure>> enclosed_unchanged_;
  Lazy<Sensitivity> unchanged_sensitivity_;
  Lazy<Sensitivity> second_order_;
  Lazy<Matrix3<Rational>> collision_matrix_;
  Lazy<double> collision_matrix_sensitivity_;
  Lazy<bool> is_definite_;
  Lazy<bool> is_collinear_;
  Lazy<bool> is_head_on_;
};

}  // namespace carom::oracles
