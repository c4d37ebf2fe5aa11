// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/bounds/enclosure.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

/// For each vector y_k of an outcome: Σ_q ‖∂y_k/∂q‖ ‖q‖ + ‖y_k⁻‖. q are the quantities (quantities.hpp), and y_k⁻ is
/// the vector before the impulse. The backward error is the error of y_k, divided by u times this sum
/// (docs/reference/yardstick.md). Because of the term ‖y_k⁻‖, this is a mixed forward-backward error (N. Higham,
/// Accuracy and Stability of Numerical Algorithms, §1.5).
using Sensitivity = PerVector<double>;

/// Between these limits, binary64 computes the sum Σ_q ‖∂y/∂q‖ ‖q‖ by squares. Below the lower limit, the underflow of
/// squares could reach the tenth digit (docs/internals/bounds.md). Above the upper limit, squares could overflow.
inline constexpr double least_sum_by_squares = 0x1p-380;
inline constexpr double largest_sum_by_squares = 0x1p+400;

inline constexpr double ten_digits = 0x1p-34;

/// ‖y_k⁻‖.
[[nodiscard]] Sensitivity norms_before(const Collision& collision);

/// The sensitivity of the law's answer to a contact that collides, by implicit differentiation in binary64
/// (implicit_differentiation.hpp). If the law inverts K, the relative error is about u times the condition number of K.
/// No value if a sum is outside the limits above, or if rounding of r × F may leave fewer than three digits, as for
/// needles of 1 : 10¹⁰ (`growth_of_roundings`). If the terms of a derivative cancel and its quantity is large, as for a
/// position far from the origin, the sum may keep only two digits.
///
/// Preconditions: the collision is moderate (moderate.hpp); a body is movable; the law is one of `laws_with_truth`;
/// ExactCase::is_well_conditioned(), except for the frictionless law. For `on_cone`, also
/// ExactCase::has_clear_divisor().
[[nodiscard]] std::optional<Sensitivity> colliding_sensitivity(const Collision& collision, Law law, Branch branch);

/// `colliding_sensitivity` in double-double arithmetic, for any valid collision with a movable body. No value if the
/// error radii exceed a thousandth of the sensitivity, unless the collision is moderate and its rounding errors grow
/// little (`largest_growth` in sensitivity.cpp).
[[nodiscard]] std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Law law, Branch branch,
                                                              bool is_moderate);

/// T / λ. The terms of K are at most T = λ + Σ ‖r‖² / min I over the movable bodies, and K ⪰ λI. So T / λ bounds the
/// condition number of K, and the cancellation in r × F. Precondition: a body is movable.
[[nodiscard]] double growth_in_collision_matrix(const Collision& collision);

/// An estimate of the growth of rounding errors in the derivatives of the law's answer: `growth_in_collision_matrix`,
/// and for `rough` a further factor. On the cone's surface, `rough` divides by d = ‖N × D‖ − μ N·D. The two terms of d
/// may cancel, which adds the factor (1 + μ) ‖N‖ ‖D‖ / d. ‖D‖ is at most Σ (‖v‖ + ‖w‖ ‖r‖) / λ. `enclosed` is the same
/// collision. The result may be infinite. Precondition: a body is movable.
[[nodiscard]] double growth_of_roundings(const Collision& collision, const BasicCollision<Enclosure>& enclosed, Law law,
                                         Branch branch);

/// `colliding_sensitivity` by exact differentiation of the whole law.
[[nodiscard]] Sensitivity exact_sensitivity(const Collision& collision, Law law, Branch branch);

/// The distance of an impulse F from the surface of the friction cone, and the first-order effect of the inputs on this
/// distance. F is the impulse of `rough` with κ = 1 + e_t (rough.hpp). Both numbers are rounded, and NaN if unknown.
struct ConeDistance {
  double distance;     // a lower bound of |μ N·F − ‖N × F‖|, by enclosures
  double sensitivity;  // Σ_q ‖∂(μ N·F)/∂q‖ ‖q‖ + Σ_q ‖∂(N × F)/∂q‖ ‖q‖

  /// Whether permitted inputs have answers on both sides of the surface, to first order. True if unknown.
  [[nodiscard]] bool is_within(double allowance) const { return !(distance > allowance * sensitivity); }
};

/// The cone distance in binary64. Preconditions: those of colliding_sensitivity.
[[nodiscard]] ConeDistance cone_distance(const Collision& collision);

/// The cone distance in double-double arithmetic. Precondition: a body is movable.
[[nodiscard]] ConeDistance enclosed_cone_distance(const Collision& collision);

namespace detail {

[[nodiscard]] inline double as_double(double number) { return number; }
[[nodiscard]] inline double as_double(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double as_double(const Radical& number) { return to_double(number); }

}  // namespace detail

/// Σ_q ‖∂y/∂q‖ ‖q‖ for the vector y with these components.
template <class S, std::size_t N>
[[nodiscard]] double sensitivity_of(std::initializer_list<const Dual<S, N>*> components,
                                    const std::vector<Quantity>& quantities) {
  return sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return detail::as_double(components.begin()[i]->derivative[j]);
  });
}

// The parts of a sensitivity of second order (ExactCase::sensitivity). A part beyond the range of numbers is 0.

/// ‖y_k⁻‖ plus the largest change of vector k by an impulse of length 2 s / λ, with s ≥ ‖V⁻‖.
[[nodiscard]] Sensitivity second_order(const Collision& collision);

/// The largest changes by [δr]ᵀ J⁻¹ [δr], the change of K of second order, for an impulse that is the sum of these. The
/// first order vanishes if r × N = 0. Precondition: a body is movable.
[[nodiscard]] Sensitivity second_order_of_arms(const Collision& collision,
                                               std::initializer_list<Vector3<double>> impulses);

/// The largest changes by an impulse that rounding alone causes, and by the first-order change of K. It matters if the
/// contact grazes. `normal_velocity_sensitivity` is Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖. Precondition: a body is movable.
[[nodiscard]] Sensitivity second_order_from_rest(const Collision& collision, double normal_velocity_sensitivity);

}  // namespace carom::oracles
