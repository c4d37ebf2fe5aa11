// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <memory>
#include <utility>

#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/judge/permitted_inputs.hpp>
#include <carom/oracles/judge/yardstick.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/laws/truth.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

namespace carom::oracles {

/// A valid collision, and facts about it: exact, or in arithmetic with error bounds. Each fact is computed on first
/// use. For one thread. λ is 1/m_A + 1/m_B. y_k are the vectors of an outcome, and y_k⁻ those before the impulse.
class ExactCase {
 public:
  /// If `filtered`, numbers with error bounds may decide a fact before ℚ. The facts are the same. Precondition: the
  /// collision is valid.
  explicit ExactCase(const Collision& collision, bool filtered = true);

  [[nodiscard]] const Collision& collision() const { return collision_; }
  [[nodiscard]] const BasicCollision<Rational>& exact() const;
  [[nodiscard]] const BasicCollision<Enclosure>& enclosed() const;
  [[nodiscard]] const DualInputs<double, collision_inputs>& differentiated() const;

  /// Whether the collision is moderate (moderate.hpp), so that its scales and sensitivities are finite.
  [[nodiscard]] bool is_moderate() const;

  struct NormalVelocity {
    double value;  // rounded, correct to six digits
    int sign;      // −1, 0 or 1
  };
  /// N·V⁻.
  [[nodiscard]] const NormalVelocity& normal_velocity() const;

  /// V⁻, rounded from enclosures, because cancellation in binary64 may leave V⁻ without a correct digit.
  [[nodiscard]] const Vector3<double>& relative_velocity() const;

  [[nodiscard]] ContactState state() const;

  /// Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖ over the quantities q (quantities.hpp).
  [[nodiscard]] double normal_velocity_sensitivity() const;

  /// The permitted inputs, if PermittedInputs::derivatives_fail and 0 < allowance < ½. Otherwise nullptr.
  [[nodiscard]] const PermittedInputs* permitted_inputs(double allowance) const;

  /// Whether the permitted inputs include both colliding and separating contacts.
  [[nodiscard]] bool is_grazing(double allowance) const;

  /// ‖y_k⁻‖, a lower bound of the sensitivity of y_k.
  [[nodiscard]] const Sensitivity& norms_before() const;

  /// ‖∂g/∂y_k‖ of an equation g for each k. `differentiate` computes these norms on first use.
  template <class Differentiate>
  [[nodiscard]] const PerVector<double>& slopes(AffineEquation equation, const Differentiate& differentiate) const {
    return slopes_[equation].get(differentiate);
  }

  /// The impulses P_I and P_II of the law `rough` (models/rough.hpp), rounded from enclosures.
  struct StopImpulses {
    Vector3<double> of_approach;  // P_I
    Vector3<double> of_point;     // P_II
  };
  /// Precondition: a body is movable.
  [[nodiscard]] const StopImpulses& stop_impulses() const;

  /// The formula by which the law answers if the contact collides. Preconditions: a body is movable; the law is one
  /// of `laws_with_truth`.
  [[nodiscard]] Branch branch(Law law) const;

  /// The law's answer. Throws JudgeError if the answer does not satisfy the defining equations exactly.
  /// Preconditions: the law is one of `laws_with_truth`; the contact does not collide, or `branch` is not `on_cone`, so
  /// that the answer is rational.
  [[nodiscard]] const Truth<Rational>& truth(Law law) const { return truth(law, state()); }

  /// The law's answer as if the contact had the approach `as`. The answer is checked in the same way.
  [[nodiscard]] const Truth<Rational>& truth(Law law, ContactState as) const;

  /// The answer in numbers p + q √s, checked in the same way. Precondition: `branch` is `on_cone`.
  [[nodiscard]] const Truth<Radical>& truth_on_cone(Law law) const;

  template <class Use>
  decltype(auto) with_truth(Law law, ContactState as, const Use& use) const {
    const ContactState answered = answered_as(law, as);
    return answered == ContactState::colliding && branch(law) == Branch::on_cone ? use(truth_on_cone(law))
                                                                                 : use(truth(law, answered));
  }

  /// The outcome of the truth, rounded to the nearest binary64 numbers.
  [[nodiscard]] Outcome<double> nearest_truth(Law law) const;

  /// The truth to about 100 bits, with error bounds.
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law) const { return enclosed_truth(law, state()); }
  [[nodiscard]] const Truth<Enclosure>& enclosed_truth(Law law, ContactState as) const;

  /// Throws JudgeError if `enclosed_truth(law, as)` certainly violates an equation that defines the law, or a condition
  /// of `first_refuted_of_rough`.
  void check_enclosed_truth(Law law, ContactState as) const;

  /// ‖y − y⁻‖ in the kinetic-energy norm (accuracy.hpp), for the outcome y of `enclosed_truth(law, as)`. `measure`
  /// computes the norm on first use.
  template <class Measure>
  [[nodiscard]] double size_of_change(Law law, ContactState as, const Measure& measure) const {
    return sizes_of_change_.get({law, as}, measure);
  }

  /// The sensitivity of the law's answer y: σ_k + α τ_k for each vector k, with the allowance α. The term σ_k is
  /// Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖ (sensitivity.hpp). The term τ_k is of second order: ‖y_k⁻‖ plus the largest change of
  /// vector k by an impulse of length 2 s / λ, with s ≥ ‖V⁻‖. If the contact collides, τ_k also has the change of
  /// vector k by a change of K that is quadratic in the lever arms. It matters if the derivatives vanish: for a central
  /// contact that grazes, and for one far from the origin.
  ///
  /// If the contact grazes (`is_grazing`), the function returns the sensitivity of the colliding answer, unless the law
  /// has two answers (`has_two_answers`). Near the surface of the friction cone, the larger of two sensitivities
  /// counts: that inside the cone and that on the surface. If PermittedInputs::derivatives_fail, the sensitivity of
  /// a colliding answer is at least PermittedInputs::distance_of_answers divided by the allowance.
  [[nodiscard]] Sensitivity sensitivity(Law law, double allowance) const;

  /// `sensitivity` plus `permitted_noise` divided by the allowance.
  [[nodiscard]] Sensitivity sensitivity_with_noise(Law law, const Yardstick& yardstick) const;

  /// The sensitivity of the answer for approach `as`, whether or not the contact grazes.
  [[nodiscard]] Sensitivity sensitivity_as(Law law, ContactState as, double allowance) const;

  /// Whether permitted inputs have answers that are far from each other. This holds if the contact grazes and the law
  /// acts at once: its impulse may differ from 0 in the limit N·V⁻ → 0. `rough` acts at once if D (models/rough.hpp)
  /// lies in the cone.
  [[nodiscard]] bool has_two_answers(Law law, double allowance) const;

  /// Whether the collision is moderate (moderate.hpp) and the law's sensitivity is certainly finite.
  [[nodiscard]] bool is_moderate(Law law) const;

  /// Whether permitted inputs lie on both sides of N·V⁻ = 0, and their impulses on both sides of the friction cone's
  /// surface. If so, `accuracy` decides nothing.
  [[nodiscard]] bool is_open(Law law, double allowance) const;

  /// Whether the sensitivity of `rough` on the cone's surface is certainly finite. Preconditions: is_moderate(); a body
  /// is movable.
  [[nodiscard]] bool has_clear_divisor() const;

  /// A cheap lower bound of `sensitivity`: ‖y_k⁻‖, plus ½ ‖y_k‖ for the answer y if the contact collides. It is ‖y_k⁻‖
  /// even if the contact grazes. y is homogeneous of degree one in the velocities. So the part of Σ_q ‖∂y_k/∂q‖ ‖q‖ by
  /// the velocities is at least ‖y_k‖ (Euler). The factor ½ covers the rounding of this bound and of the sensitivity.
  /// Precondition: is_moderate(law).
  [[nodiscard]] const Sensitivity& sensitivity_below(Law law) const;

  [[nodiscard]] const Matrix3<Rational>& collision_matrix() const;
  [[nodiscard]] const Matrix3<Enclosure>& enclosed_collision_matrix() const;

  /// Whether bounds show that the condition number of K is below 2²⁰. An inverse of K in binary64 then keeps ten
  /// digits.
  [[nodiscard]] bool is_well_conditioned() const;

  /// Σ_q ‖∂K/∂q‖ ‖q‖. If PermittedInputs::derivatives_fail, the sum includes the effect of the squared changes of
  /// the lever arms.
  [[nodiscard]] double collision_matrix_sensitivity(double allowance) const;
  /// A lower bound of Σ_q ‖∂K/∂q‖ ‖q‖ (exact_case_bounds.hpp): λ/2, or ‖K‖_F/2 if this is larger and ‖K‖_F exceeds its
  /// rounding errors. Precondition: is_moderate().
  [[nodiscard]] double collision_matrix_sensitivity_below() const;

  /// Whether λI ⪯ K, decided exactly. This always holds, because K − λI is the sum of [r]ᵀ J⁻¹ [r] ⪰ 0 over the movable
  /// bodies, with [r] y = r × y.
  [[nodiscard]] bool is_definite() const;

  /// Whether K ⪯ bound · I, decided exactly.
  [[nodiscard]] bool is_bounded_by(const Rational& bound) const;

  /// Whether r × N = 0 for each movable body, exactly.
  [[nodiscard]] bool is_collinear() const;

  /// Whether N × V⁻ = 0, exactly.
  [[nodiscard]] bool is_head_on() const;

 private:
  struct OfLaw {
    Lazy<Truth<Rational>> truth;
    Lazy<Truth<Radical>> truth_on_cone;
    Lazy<Truth<Enclosure>> enclosed_truth;
    PerBranch<Lazy<Sensitivity>> colliding_sensitivity;
    Lazy<Sensitivity> sensitivity_below;
    Lazy<Sensitivity> second_order_of_arms;
  };

  /// The law's answer to a contact that collides, to about 100 bits, with error bounds. Precondition: a body is
  /// movable.
  [[nodiscard]] const Truth<Enclosure>& colliding_truth(Law law) const;
  /// Its impulse, rounded.
  [[nodiscard]] Vector3<double> colliding_impulse(Law law) const;
  /// Whether no divisor of the law's formula on this branch may be zero. Precondition: is_moderate().
  [[nodiscard]] bool has_clear_divisor(Branch branch) const { return branch != Branch::on_cone || has_clear_divisor(); }
  [[nodiscard]] const Sensitivity& unchanged_sensitivity() const;
  /// The sensitivity of the colliding answer.
  [[nodiscard]] Sensitivity colliding_sensitivity(Law law, double allowance) const;
  [[nodiscard]] const Sensitivity& colliding_first_order(Law law, Branch branch) const;
  [[nodiscard]] bool is_inside_cone() const;
  [[nodiscard]] bool reaches_cone() const;
  /// Whether the law acts at once (`has_two_answers`) on its branch, or the contact is near the cone's surface.
  [[nodiscard]] bool acts_at_once_here(Law law, double allowance) const;
  /// Whether the answers to permitted inputs lie on both sides of the cone's surface.
  [[nodiscard]] bool is_near_cone_surface(Law law, double allowance) const;
  /// The approach whose answer counts for approach `as`: `as` itself, with one exception. If the contact does not
  /// collide and its colliding answer would lie on the cone's surface, the impulse of this answer tends to 0 with N·V⁻.
  /// Then the contact's own approach counts.
  [[nodiscard]] ContactState answered_as(Law law, ContactState as) const;
  [[nodiscard]] const Sensitivity& second_order() const;
  /// The part of τ_k by the change of K. Precondition: a body is movable.
  [[nodiscard]] const Sensitivity& second_order_of_arms(Law law) const;
  /// The part of τ_k by an impulse that rounding alone causes, and the first-order change of K. It matters if the
  /// contact grazes. Precondition: a body is movable.
  [[nodiscard]] const Sensitivity& second_order_from_rest() const;

  [[nodiscard]] const OfLaw& of(Law law) const {
    return of_law_.get(law, [] { return OfLaw(); });
  }

  Collision collision_;
  bool filtered_;
  Lazy<BasicCollision<Rational>> exact_;
  Lazy<BasicCollision<Enclosure>> enclosed_;
  Lazy<std::unique_ptr<DualInputs<double, collision_inputs>>> differentiated_;  // large and seldom used
  Lazy<bool> is_moderate_;
  Lazy<NormalVelocity> normal_velocity_;
  Lazy<double> normal_velocity_sensitivity_;
  Lazy<Vector3<double>> relative_velocity_;
  Lazy<Sensitivity> norms_before_;
  PerAffineEquation<Lazy<PerVector<double>>> slopes_;
  LazyMap<double, std::unique_ptr<PermittedInputs>> permitted_inputs_;
  Lazy<StopImpulses> stop_impulses_;
  Lazy<bool> is_inside_cone_;
  Lazy<bool> reaches_cone_;
  Lazy<bool> has_clear_divisor_;
  Lazy<ConeDistance> cone_distance_;
  LazyMap<Law, OfLaw> of_law_;
  LazyMap<std::pair<Law, ContactState>, double> sizes_of_change_;
  LazyMap<std::pair<Law, ContactState>, bool> is_enclosed_truth_checked_;
  Lazy<Truth<Rational>> unchanged_;
  Lazy<Truth<Enclosure>> enclosed_unchanged_;
  Lazy<Sensitivity> unchanged_sensitivity_;
  Lazy<Sensitivity> second_order_;
  Lazy<Sensitivity> second_order_from_rest_;
  Lazy<Matrix3<Rational>> collision_matrix_;
  Lazy<Matrix3<Enclosure>> enclosed_collision_matrix_;
  Lazy<double> collision_matrix_sensitivity_;
  Lazy<double> collision_matrix_sensitivity_below_;
  Lazy<bool> is_definite_;
  Lazy<bool> is_collinear_;
  Lazy<bool> is_head_on_;
};

}  // namespace carom::oracles

/// The inequalities by which ExactCase decides facts about a collision (docs/internals/bounds.md). u = 2⁻⁵³.
namespace carom::oracles::exact_case_bounds {

/// An `Enclosure` of N·V⁻ has six digits if its radius is below this share of |N·V⁻|.
inline constexpr double known_radius_of_normal_velocity = 0x1p-20;

/// A lower bound of the sensitivity Q = Σ_q ‖∂K/∂q‖ ‖q‖ of the collision matrix K. Q̂ is Q as the judge computes it in
/// binary64, and T is the sum of ‖r‖² / min I over the movable bodies:
///
///   (1) K is homogeneous of degree −1 in the masses and moments. So the masses and moments contribute at least ‖K‖_F
///       to Q (Euler). The masses alone contribute at least λ = 1/m_A + 1/m_B.
///   (2) Q̂ ≥ (1 − 2⁻⁴⁰) (Q − c u T), with c = `roundings_of_matrix_sensitivity`.
///   (3) If ‖K‖_F ≥ 2⁻²⁰ T, then ‖K‖_F − c u T is at least ¾ ‖K‖_F, so Q̂ exceeds ‖K‖_F / 2. Q̂ ≥ λ / 2 always holds.
inline constexpr double roundings_of_matrix_sensitivity = 0x1p+16;
inline constexpr double least_share_of_largest_terms = 0x1p-20;

/// On the cone's surface, the law `rough` (models/rough.hpp) divides by d = ‖N × D‖ − μ N·D. Without this division,
/// Σ_q ‖∂y_k/∂q‖ ‖q‖ of a moderate collision is at most 2⁶⁶⁰. If d is at least this share of ‖N × D‖ + μ |N·D|, the
/// division multiplies the sum by at most ‖D‖ / d ≤ 2⁴⁰ ‖K‖ / λ ≤ 2³⁰⁰. So the sum is finite.
inline constexpr double least_share_of_divisor = 0x1p-40;

}  // namespace carom::oracles::exact_case_bounds
