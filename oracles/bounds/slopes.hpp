// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/laws/equations.hpp>

/// The derivatives of an equation g(x, y) with respect to the inputs x and the outcome y.
namespace carom::oracles {

/// ∂g_i/∂x_j with g = left − right, i = `component` and j = `input`.
template <class S, std::size_t N, int Size>
[[nodiscard]] S derivative_of(const Sides<Dual<S, N>, Size>& sides, std::size_t component, std::size_t input) {
  const auto row = static_cast<Eigen::Index>(component);
  return sides.left[row].derivative[input] - sides.right[row].derivative[input];
}

/// ‖∂g/∂ŷ_k‖, in the Frobenius norm, for each of the four vectors of an outcome ŷ. Precondition: N ≥ 12, the count of
/// the numbers in ŷ.
template <class S, std::size_t N, class OneEquation, class R>
[[nodiscard]] PerVector<S> output_slopes(const OneEquation& equation, const Collision& collision,
                                         const Outcome<R>& outcome) {
  using T = Dual<S, N>;
  std::size_t next = 0;
  const auto sides = equation(map_numbers<T>(collision, [](double x) { return T(static_cast<S>(x)); }),
                              map_outcome<T>(outcome, [&](const R& x) { return T::input(static_cast<S>(x), next++); }));
  PerVector<S> slopes{};
  std::size_t first = 0;
  for (const OutcomeVector k : all_outcome_vectors) {
    slopes[k] = root_of_squares(3 * static_cast<std::size_t>(sides.left.size()),
                                [&](std::size_t i) -> S { return derivative_of(sides, i / 3, first + i % 3); });
    first += 3;
  }
  return slopes;
}

/// Σ_q ‖∂g/∂q‖ ‖q‖ over the quantities of the collision (quantities.hpp).
template <class S, class OneEquation, class R>
[[nodiscard]] S part_by_inputs(const OneEquation& equation, const DualInputs<S, collision_inputs>& inputs,
                               const Outcome<R>& outcome) {
  using T = Dual<S, collision_inputs>;
  const auto sides =
      equation(inputs.collision, map_outcome<T>(outcome, [](const R& x) { return T(static_cast<S>(x)); }));
  return sum_over_quantities(inputs.quantities, static_cast<std::size_t>(sides.left.size()),
                             [&](std::size_t i, std::size_t j) -> S { return derivative_of(sides, i, j); });
}

/// ‖∂g/∂ŷ_k‖ of an equation g that is affine in the outcome, so that these norms do not depend on ŷ. Precondition:
/// name_of(equation) has a value.
[[nodiscard]] PerVector<double> slopes_of(const Equation& equation, const Collision& collision);

/// ‖∂g/∂ŷ_k‖ of g = (V⁺ − V⁻) − C F (`change_by_matrix`), with the bits of `output_slopes`, in a tenth of its time. C
/// is `matrix`, and F is `impulse_on_a` with `read_off_a`. Preconditions: those of `impulse_on_a`; products with the
/// numbers of C and of the collision are finite.
[[nodiscard]] PerVector<double> slopes_of_change(const Matrix3<double>& matrix, bool read_off_a,
                                                 const Collision& collision);

}  // namespace carom::oracles
