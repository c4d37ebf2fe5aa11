// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <vector>

#include <carom/collision/law.hpp>
#include <carom/oracles/exact/radical.hpp>
#include <carom/oracles/laws/branch.hpp>
#include <carom/oracles/numbers/dual.hpp>
#include <carom/oracles/numbers/enclosure.hpp>
#include <carom/oracles/numbers/norm.hpp>
#include <carom/oracles/numbers/quantities.hpp>

namespace carom::oracles {

/// For each vector y_k of an outcome the sum over the quantities q of ‖∂y_k/∂q‖ ‖q‖ (quantities.hpp), and ‖y_k⁻‖: the
/// denominator of the backward error, without the unit roundoff. The last term stands for the rounding of the sum y_k⁻
/// + Δy_k. No change of the inputs explains that rounding if the sum nearly vanishes and the law is insensitive (a ball
/// that hits a wall head-on at ε = 0): mixed forward-backward error, N. Higham, Accuracy and Stability of Numerical
/// Algorithms, §1.5.
using Sensitivity = PerVector<double>;

/// Sums Σ_q ‖∂y/∂q‖ ‖q‖ from here to there are taken by squares in binary64: what these lose below its range, times
/// ‖q‖, is no ten-digit part of the first (docs/internals/bounds.md); what overflows is larger than the other.
inline constexpr double least_sum_by_squares = 0x1p-380;
inline constexpr double largest_sum_by_squares = 0x1p+400;

/// Ten digits of a sum.
inline constexpr double ten_digits = 0x1p-34;

/// ‖y_k⁻‖.
[[nodiscard]] Sensitivity norms_before(const Collision& collision);

/// Of the law's answer to a contact that collides, by implicit differentiation (implicit_differentiation.hpp), in
/// binary64. It loses about κ(K) u of the reflection law. None if a sum is extreme. Preconditions: the collision is
/// moderate (moderate.hpp); a body is movable; the law is one of `laws_with_truth`; for all but the frictionless
/// law κ(K) is well below 1/u; on the cone the divisor of κ keeps some of its terms.
[[nodiscard]] std::optional<Sensitivity> colliding_sensitivity(const Collision& collision, Law law, Branch branch);

/// The same in double-double arithmetic, of any valid collision with a movable body. It is known if its radii are at
/// most a thousandth of it. If the collision is moderate, it is also known where roundings grow little enough, as κ(K)
/// says. Otherwise none.
[[nodiscard]] std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Law law, Branch branch,
                                                              bool is_moderate);

/// The same with the whole law differentiated, exactly.
[[nodiscard]] Sensitivity exact_sensitivity(const Collision& collision, Law law, Branch branch);

/// How far the law `rough` with κ = 1 + e_t answers from the cone's surface, and how far inputs move that, to first
/// order, rounded as the sensitivities are; no number where it is not known.
struct ConeDistance {
  double distance;     // |μ N·F − ‖N × F‖|, from below, by enclosures
  double sensitivity;  // Σ_q ‖∂(μ N·F)/∂q‖ ‖q‖ + Σ_q ‖∂(N × F)/∂q‖ ‖q‖

  /// Whether inputs that differ relatively by `allowance` have answers on both sides of the surface; true where it is
  /// not known.
  [[nodiscard]] bool is_within(double allowance) const { return !(distance > allowance * sensitivity); }
};

/// In binary64. Preconditions: those of colliding_sensitivity.
[[nodiscard]] ConeDistance cone_distance(const Collision& collision);

/// The same in double-double arithmetic. Precondition: a body is movable.
[[nodiscard]] ConeDistance enclosed_cone_distance(const Collision& collision);

namespace detail {

[[nodiscard]] inline double as_double(double number) { return number; }
[[nodiscard]] inline double as_double(const Rational& number) { return to_double(number); }
[[nodiscard]] inline double as_double(const Radical& number) { return to_double(number); }

}  // namespace detail

/// Σ_q ‖∂y/∂q‖ ‖q‖ for the components of y.
template <class S, std::size_t N>
[[nodiscard]] double sensitivity_of(std::initializer_list<const Dual<S, N>*> components,
                                    const std::vector<Quantity>& quantities) {
  return sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return detail::as_double(components.begin()[i]->derivative[j]);
  });
}

}  // namespace carom::oracles
