// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/oracles/filters/bounded_case.hpp>
#include <carom/oracles/filters/lazy.hpp>
#include <carom/oracles/judge/permitted_inputs.hpp>

namespace carom::oracles {

/// A valid collision and what is exactly known of it, each worked out when first asked for. For one thread.
class ExactCase {
 public:
  /// Without the filter, facts that decide (the sign of N·V⁻, collinear, head-on, bounds of K) are worked out in ℚ
  /// alone; they are the same. Precondition: the collision is valid.
  explicit ExactCase(const Collision& collision, bool filtered = true);

  [[nodiscard]] const Collision& collision() const { return bounds_.collision(); }
  [[nodiscard]] const BasicCollision<Rational>& exact() const;

  /// What the filters know of it.
  [[nodiscard]] const BoundedCase& bounds() const { return bounds_; }

  [[nodiscard]] Approach approach() const;

  /// Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖.
  [[nodiscard]] double normal_velocity_sensitivity() const;

  /// The permitted inputs, if the first order is blind to what they do; nullptr elsewhere, and where nothing is
  /// allowed.
  [[nodiscard]] const PermittedInputs* permitted_inputs(double allowance) const;

  /// Whether inputs that differ relatively by `allowance` include both colliding and separating contacts.
  [[nodiscard]] bool is_grazing(double allowance) const;

  /// By which of its formulas the law answers where the contact collides. Preconditions: a body is movable; the law
  /// is one of `laws_with_truth`.
  [[nodiscard]] Branch branch(Law law) const;

  /// The law's answer, certified: both sides of each of its defining equations are the same.
  /// Throws std::logic_error where they are not. Precondition: the law is one of `laws_with_truth`, and its answer
  /// is rational: it does not lie on the cone.
  [[nodiscard]] const Truth<Rational>& truth(Law law) const { return truth(law, approach()); }

  /// The same as if the contact had this approach.
  [[nodiscard]] const Truth<Rational>& truth(Law law, Approach as) const;

  /// The same where it lies on the cone, in ℚ(√s).
  [[nodiscard]] const Truth<Radical>& truth_on_cone(Law law) const;

  /// use(truth), one of the two.
  template <class Use>
  decltype(auto) with_truth(Law law, Approach as, const Use& use) const {
    const Approach answered = answered_as(law, as);
    return answered == Approach::colliding && branch(law) == Branch::on_cone ? use(truth_on_cone(law))
                                                                             : use(truth(law, answered));
  }

  /// The outcome of the truth, each number rounded to the nearest of binary64.
  [[nodiscard]] Outcome<double> nearest_truth(Law law) const;

  /// The same to about 100 bits, with its bound; not certified, since no equation holds exactly for it.
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law) const { return enclosed_truth(law, approach()); }
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law, Approach as) const;

  /// The sensitivity of the law's answer, to second order: σ_k + a τ_k, with σ_k = Σ_q ‖∂y_k/∂q‖ ‖q‖, a the
  /// allowance, and τ_k what an impulse of 2 (‖V⁻‖ at most) / λ can change of vector k. Where the structure of a
  /// contact makes the first order vanish (a central one that grazes), products of two roundings are all that is left.
  /// Inside the grazing band it is that of the colliding answer, since inputs within the allowance collide; but not of
  /// a law that acts at once, whose two answers are judged apart. Near the cone's surface it is the larger one of both
  /// sides, whose answers meet there.
  ///
  /// If the first order is blind (PermittedInputs), it is at least the distance of the answers to permitted inputs,
  /// over the allowance.
  [[nodiscard]] Sensitivity sensitivity(Law law, double allowance) const;

  /// The same as if the contact had this approach, away from the band.
  [[nodiscard]] Sensitivity sensitivity_as(Law law, Approach as, double allowance) const;

  /// Whether inputs that differ relatively by `allowance` have answers that are far from each other: those of a law
  /// that acts at once, in the grazing band; of `rough` where friction by itself lies in the cone.
  [[nodiscard]] bool has_two_answers(Law law, double allowance) const;

  /// Whether no number is out of the ordinary, so that the sensitivity of the law is surely finite.
  [[nodiscard]] bool is_moderate(Law law) const;

  /// Whether they have answers of all kinds: they collide or not, and where they do friction lies inside its cone or on
  /// it, so that it acts at once or not at all. Nothing is then asked of an outcome by itself.
  [[nodiscard]] bool is_open(Law law, double allowance) const;

  /// A lower bound of `sensitivity`, at a small part of its cost: where the contact collides that of BoundedCase,
  /// elsewhere ‖y_k⁻‖, whether grazing or not. Precondition: is_moderate(law).
  [[nodiscard]] const Sensitivity& sensitivity_below(Law law) const;

  /// K, exactly (`response_matrix`).
  [[nodiscard]] const Matrix3<Rational>& collision_matrix() const;

  /// Σ_q ‖∂K/∂q‖ ‖q‖; if the first order is blind, with the squares of what lever arms are perturbed by.
  [[nodiscard]] double collision_matrix_sensitivity(double allowance) const;

  /// Whether λI ⪯ K, decided exactly. Where a body is movable it always is: K − λI is the sum of [r]ᵀ J⁻¹ [r] over the
  /// movable bodies, a congruence of a positive diagonal matrix each (an identity that the tests prove by exact random
  /// testing). Not asked by a filtered yardstick.
  [[nodiscard]] bool is_definite() const;

  /// Whether K ⪯ bound I, decided exactly.
  [[nodiscard]] bool is_bounded_by(const Rational& bound) const;

  /// The kinetic-energy norm of the change of the velocities by the law, rounded; worked out by `from_truth` when first
  /// asked for, once for each of the two judges: bounds may leave it unknown.
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
  /// What is known of one law.
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
  /// Whether the impulse does not vanish with N·V⁻. On the cone it does.
  [[nodiscard]] bool acts_at_once_here(Law law, double allowance) const;
  /// Whether inputs that differ relatively by `allowance` are answered on both sides of the cone's surface.
  [[nodiscard]] bool is_near_cone_surface(Law law, double allowance) const;
  /// What a contact that does not collide is answered as if it did: on the cone friction vanishes with N·V⁻, and there
  /// is no other answer.
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
