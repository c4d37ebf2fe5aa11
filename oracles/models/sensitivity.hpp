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

/// For each vector y_k of an outcome, the sum of ‖∂y_k/∂q‖ ‖q‖ over the quantities q (quantities.hpp), plus ‖y_k⁻‖.
/// y_k⁻ is the vector before the impulse. The sensitivity is the denominator of the backward error, without the unit
/// roundoff. The term ‖y_k⁻‖ stands for the rounding of the sum y_k⁻ + Δy_k. No change of the inputs explains this
/// rounding if the sum nearly vanishes and the law is insensitive. An example is a ball that hits a wall head-on at ε =
/// 0. So the backward error is a mixed forward-backward error: N. Higham, Accuracy and Stability of Numerical
/// Algorithms, §1.5.
using Sensitivity = PerVector<double>;

/// Sums Σ_q ‖∂y/∂q‖ ‖q‖ between these limits are computed by squares in binary64. The underflow of the squares, times
/// ‖q‖, does not reach the tenth digit of the smaller limit (docs/internals/bounds.md). A sum that overflows is above
/// the larger limit.
inline constexpr double least_sum_by_squares = 0x1p-380;
inline constexpr double largest_sum_by_squares = 0x1p+400;

/// The relative precision of ten digits of a sum.
inline constexpr double ten_digits = 0x1p-34;

/// ‖y_k⁻‖.
[[nodiscard]] Sensitivity norms_before(const Collision& collision);

/// The sensitivity of the law's answer to a contact that collides, in binary64. It uses implicit differentiation
/// (implicit_differentiation.hpp), and loses about κ(K) u if the law inverts K. κ(K) is the condition number of the
/// collision matrix. No value if a sum is outside the limits above. Preconditions: the collision is moderate
/// (moderate.hpp); a body is movable; the law is one of `laws_with_truth`. BoundedCase::is_well_conditioned() is true,
/// except for the frictionless law. For `on_cone`, BoundedCase::has_clear_divisor() is true.
[[nodiscard]] std::optional<Sensitivity> colliding_sensitivity(const Collision& collision, Law law, Branch branch);

/// The sensitivity of `colliding_sensitivity` in double-double arithmetic, for any valid collision with a movable body.
/// It has a value if its error radii are at most a thousandth of it. If the collision is moderate, a small bound of the
/// growth of rounding errors suffices too.
[[nodiscard]] std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Law law, Branch branch,
                                                              bool is_moderate);

/// The sensitivity of `colliding_sensitivity` by exact differentiation of the whole law.
[[nodiscard]] Sensitivity exact_sensitivity(const Collision& collision, Law law, Branch branch);

/// The distance of the answer of `rough` with κ = 1 + e_t from the cone's surface, and the first-order effect of the
/// inputs on this distance. Both numbers are rounded as sensitivities are, and NaN if unknown.
struct ConeDistance {
  double distance;     // a lower bound of |μ N·F − ‖N × F‖|, by enclosures
  double sensitivity;  // Σ_q ‖∂(μ N·F)/∂q‖ ‖q‖ + Σ_q ‖∂(N × F)/∂q‖ ‖q‖

  /// Whether inputs that differ relatively by `allowance` have answers on both sides of the surface. True if unknown.
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

/// Σ_q ‖∂y/∂q‖ ‖q‖ for the components of y.
template <class S, std::size_t N>
[[nodiscard]] double sensitivity_of(std::initializer_list<const Dual<S, N>*> components,
                                    const std::vector<Quantity>& quantities) {
  return sum_over_quantities(quantities, components.size(), [&](std::size_t i, std::size_t j) {
    return detail::as_double(components.begin()[i]->derivative[j]);
  });
}

}  // namespace carom::oracles
