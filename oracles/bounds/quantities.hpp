// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/oracles/bounds/dual.hpp>
#include <carom/oracles/bounds/norm.hpp>

/// The quantities of a collision (docs/reference/yardstick.md).
namespace carom::oracles {

/// A scalar or a vector among the numbers of a collision. `for_each_number` defines the order of the numbers.
struct Quantity {
  std::size_t first;  // index of its first number
  std::size_t count;  // number of its components: 1, 3 or 4
  double length;      // its absolute value or Euclidean norm; ‖X‖ + s for the position of a movable body
};

/// The extent s of a body [m]: s² = min_i (J_j + J_k − J_i) / (2m) with the principal moments J. The extent is 0 if the
/// minimum is negative or the body is immovable.
[[nodiscard]] double extent_of(const Body& body);

/// The length ‖q‖ of the position q = X of a body: ‖X‖ + s, with the extent s.
[[nodiscard]] inline double length_of_position(const Body& body) { return norm_of(body.position) + extent_of(body); }

/// ‖P‖ plus the length of the position: if both are rounded by a relative η, the lever arm r = P − X moves by at most η
/// times this length. Both lengths count, not the length of the difference.
[[nodiscard]] inline double length_of_lever_arm(const Body& body, const Vector3<double>& point) {
  return norm_of(point) + length_of_position(body);
}

[[nodiscard]] std::vector<Quantity> quantities_of(const Collision& collision);

/// Σ_q ‖∂y/∂q‖ ‖q‖ over the quantities q, with Frobenius norms, for a vector y with `components` components.
/// `derivative(i, j)` is ∂y_i/∂x_j, with x_j the j-th number of the collision. A quantity that is zero contributes
/// nothing, even if its derivative is infinite.
template <class Derivative>
[[nodiscard]] auto sum_over_quantities(const std::vector<Quantity>& quantities, std::size_t components,
                                       const Derivative& derivative) {
  using S = decltype(derivative(std::size_t{0}, std::size_t{0}));
  S sum(0);
  for (const Quantity& q : quantities) {
    if (q.length != 0) {
      const S norm = root_of_squares(
          components * q.count, [&](std::size_t i) -> S { return derivative(i / q.count, q.first + i % q.count); });
      sum += norm * static_cast<S>(q.length);
    }
  }
  return sum;
}

/// The lengths of derivative arrays. A collision has up to 43 numbers and an outcome 12; the lengths are multiples of
/// four.
inline constexpr std::size_t collision_inputs = 44;
inline constexpr std::size_t outcome_inputs = 12;

template <class S, std::size_t N>
struct DualInputs {
  BasicCollision<Dual<S, N>> collision;
  std::vector<Quantity> quantities;
};

/// The collision in dual numbers, with its j-th number as input j. `convert` maps a double to S.
template <class S, std::size_t N, class Convert>
[[nodiscard]] DualInputs<S, N> dual_inputs(const Collision& collision, Convert&& convert) {
  DualInputs<S, N> inputs;
  std::size_t next = 0;
  inputs.collision =
      map_numbers<Dual<S, N>>(collision, [&](double number) { return Dual<S, N>::input(convert(number), next++); });
  inputs.quantities = quantities_of(collision);
  return inputs;
}

}  // namespace carom::oracles
